//! Things sorted into strips of equal width along z, so that a place needs to look at a few of them only.

/// Strips at most; a longer contour has more in each.
const MOST: usize = 20_000;
/// A strip is at least this wide, mm.
const NARROWEST_MM: f64 = 0.01;

/// Items by the strips that they reach into.
#[derive(Debug, Clone)]
pub(super) struct Strips<T> {
    first: f64,
    width: f64,
    lists: Vec<Vec<T>>,
}

impl<T: Copy> Strips<T> {
    /// Sorts items that reach from one position to another, mm: about one for every strip.
    pub(super) fn of(items: &[(f64, f64, T)]) -> Self {
        let first = items.iter().map(|item| item.0).fold(f64::INFINITY, f64::min);
        let last = items.iter().map(|item| item.1).fold(f64::NEG_INFINITY, f64::max);
        let count = items.len().clamp(1, MOST);
        let width = ((last - first) / count as f64).max(NARROWEST_MM);
        let mut strips = Self { first, width, lists: Vec::new() };
        if !items.is_empty() {
            strips.lists.resize_with(strips.index(last) + 1, Vec::new);
        }
        for &(from, to, item) in items {
            let (from, to) = (strips.index(from), strips.index(to));
            strips.lists[from..=to].iter_mut().for_each(|strip| strip.push(item));
        }
        strips
    }

    /// The strip of a position, which may lie beyond the last; positions before the first belong to the first.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=MOST")]
    fn index(&self, z: f64) -> usize {
        ((z - self.first) / self.width).clamp(0.0, MOST as f64) as usize
    }

    /// What may lie at a position.
    pub(super) fn at(&self, z: f64) -> &[T] {
        self.lists.get(self.index(z)).map_or(&[], Vec::as_slice)
    }

    /// What may lie between two positions, strip by strip; what reaches over several strips comes several times.
    pub(super) fn between(&self, from: f64, to: f64) -> impl Iterator<Item = T> + '_ {
        let end = (self.index(to) + 1).min(self.lists.len());
        self.lists.get(self.index(from)..end).unwrap_or(&[]).iter().flatten().copied()
    }

    /// The smallest distance from a position that `distance` finds, mm, the nearest strips first; infinite without items.
    pub(super) fn nearest(&self, z: f64, mut distance: impl FnMut(T, f64) -> f64) -> f64 {
        let middle = self.index(z).min(self.lists.len().saturating_sub(1));
        let outside = (self.first - z).max(z - self.first - self.width * self.lists.len() as f64).max(0.0);
        let mut nearest = f64::INFINITY;
        for away in 0..self.lists.len() {
            if away > 0 && outside + (away as f64 - 1.0) * self.width >= nearest {
                break;
            }
            let sides = [middle.checked_sub(away), middle.checked_add(away).filter(|_| away > 0)];
            for strip in sides.into_iter().flatten().filter_map(|k| self.lists.get(k)) {
                for &item in strip {
                    nearest = nearest.min(distance(item, nearest));
                }
            }
        }
        nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_near_a_place_is_found_from_everywhere() {
        let items: Vec<(f64, f64, u32)> = (0..50_u32).map(|k| (f64::from(k), f64::from(k) + 0.5, k)).collect();
        let strips = Strips::of(&items);
        assert!(strips.at(7.2).contains(&7) && !strips.at(7.2).contains(&20));
        assert!(strips.between(7.0, 9.0).any(|k| k == 8) && strips.between(-3.0, -1.0).all(|k| k < 2));
        for z in [-30.0, 0.7, 24.75, 49.0, 80.0_f64] {
            let to = |k: u32| (f64::from(k) - z).max(z - f64::from(k) - 0.5).max(0.0);
            let all = (0..50).map(to).fold(f64::INFINITY, f64::min);
            assert!((strips.nearest(z, |k, _| to(k)) - all).abs() < 1e-12);
        }
        assert!(Strips::<u32>::of(&[]).at(0.0).is_empty());
        assert!(Strips::<u32>::of(&[]).nearest(0.0, |_, _| 0.0).is_infinite());
    }
}
