//! Places for labels that must not stand on one another.

/// Places as near as possible (least squares) to those wanted, in their order, none closer than `gap` to the next.
///
/// `wanted` must be in rising order. The sum of squared shifts is least by pooling neighbours that would overlap (isotonic
/// regression of the places less `gap` each).
pub(super) fn spread(wanted: &[f64], gap: f64) -> Vec<f64> {
    // Runs of labels that stand side by side: sum of their shifted places, and how many.
    let mut runs: Vec<(f64, usize)> = Vec::new();
    let mut shift = 0.0;
    for &place in wanted {
        let mut run = (place - shift, 1);
        shift += gap;
        while let Some(&(sum, count)) = runs.last() {
            if mean((sum, count)) <= mean(run) {
                break;
            }
            runs.pop();
            run = (run.0 + sum, run.1 + count);
        }
        runs.push(run);
    }
    let flat = runs.into_iter().flat_map(|run| std::iter::repeat_n(mean(run), run.1));
    flat.scan(0.0, |shift, place| {
        let placed = place + *shift;
        *shift += gap;
        Some(placed)
    })
    .collect()
}

/// The places of [`spread`] moved and squeezed into the range `from..=to`; `None` if there are more labels than have room.
pub(super) fn spread_within(wanted: &[f64], gap: f64, from: f64, to: f64) -> Option<Vec<f64>> {
    let mut places = spread(wanted, gap);
    let mut lowest = from;
    for place in &mut places {
        *place = place.max(lowest);
        lowest = *place + gap;
    }
    let mut highest = to;
    for place in places.iter_mut().rev() {
        *place = place.min(highest);
        highest = *place - gap;
    }
    places.first().is_none_or(|first| *first >= from - gap * 1e-6).then_some(places)
}

fn mean((sum, count): (f64, usize)) -> f64 {
    sum / count.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn crowded_labels_are_spread_around_their_middle_and_others_stay() {
        assert_eq!(spread(&[0.0, 10.0, 10.0, 30.0], 4.0), [0.0, 8.0, 12.0, 30.0]);
        assert_eq!(spread_within(&[0.0, 1.0], 4.0, 0.0, 20.0), Some(vec![0.0, 4.0]));
        assert_eq!(spread_within(&[0.0, 1.0, 2.0], 4.0, 0.0, 7.0), None);
    }

    proptest! {
        #[test]
        fn labels_keep_their_order_and_their_distance(mut wanted in proptest::collection::vec(0.0..100.0_f64, 0..20)) {
            wanted.sort_by(f64::total_cmp);
            let places = spread_within(&wanted, 4.0, 0.0, 100.0).expect("room for 26");
            prop_assert_eq!(places.len(), wanted.len());
            prop_assert!(places.windows(2).all(|w| w[1] - w[0] >= 4.0 - 1e-9));
            prop_assert!(places.iter().all(|p| (-1e-9..=100.0 + 1e-9).contains(p)));
        }
    }
}
