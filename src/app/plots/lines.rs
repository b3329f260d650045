//! Polylines on the screen: thinned to what the eye can see, clipped and dashed.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2};

/// Points closer than this to the last one kept are dropped, in points of the screen.
const THIN: f32 = 0.7;
/// Dash and gap of a construction line, points.
pub(super) const DASHED: &[f32] = &[4.0, 3.0];
/// Dashes and gaps of a centre line, points.
pub(super) const CENTRE_LINE: &[f32] = &[14.0, 3.0, 2.0, 3.0];

/// Drops points that lie less than [`THIN`] from the last one kept. First and last point stay.
pub(super) fn thinned(points: impl IntoIterator<Item = Pos2>) -> Vec<Pos2> {
    let mut kept: Vec<Pos2> = Vec::new();
    let mut dropped = None;
    for p in points {
        if kept.last().is_none_or(|last| last.distance_sq(p) >= THIN * THIN) {
            kept.push(p);
            dropped = None;
        } else {
            dropped = Some(p);
        }
    }
    kept.extend(dropped);
    kept
}

/// The part of the line from `a` to `b` within `rect` (Liang and Barsky), or `None` outside.
pub(super) fn clipped(a: Pos2, b: Pos2, rect: Rect) -> Option<[Pos2; 2]> {
    let d = b - a;
    let edges = [(-d.x, a.x - rect.min.x), (d.x, rect.max.x - a.x), (-d.y, a.y - rect.min.y), (d.y, rect.max.y - a.y)];
    let (mut from, mut to) = (0.0_f32, 1.0_f32);
    for (p, q) in edges {
        if p == 0.0 && q < 0.0 {
            return None;
        } else if p < 0.0 {
            from = from.max(q / p);
        } else if p > 0.0 {
            to = to.min(q / p);
        }
    }
    (from <= to).then(|| [a + d * from, a + d * to])
}

/// The dashes of a polyline with the given lengths of dash and gap in turn, within `clip`.
///
/// The pattern runs on through the corners. What lies outside `clip` costs nothing, however long it is.
pub(super) fn dashes(points: &[Pos2], pattern: &[f32], clip: Rect) -> Vec<[Pos2; 2]> {
    let period: f32 = pattern.iter().sum();
    let mut result = Vec::new();
    if period <= 0.0 {
        return result;
    }
    let mut travelled = 0.0;
    for pair in points.windows(2) {
        let &[a, b] = pair else { continue };
        let length = a.distance(b);
        if let Some([from, to]) = clipped(a, b, clip) {
            dash_line(&mut result, [from, to], travelled + a.distance(from), pattern, period);
        }
        travelled = (travelled + length) % period;
    }
    result
}

fn dash_line(result: &mut Vec<[Pos2; 2]>, [a, b]: [Pos2; 2], travelled: f32, pattern: &[f32], period: f32) {
    let length = a.distance(b);
    let direction = if length > 0.0 { (b - a) / length } else { Vec2::ZERO };
    let mut at = -(travelled % period);
    while at < length {
        for (k, &part) in pattern.iter().enumerate() {
            let (from, to) = (at.max(0.0), (at + part).min(length));
            if k % 2 == 0 && to > from {
                result.push([a + direction * from, a + direction * to]);
            }
            at += part;
        }
    }
}

/// Draws a polyline dashed.
pub(super) fn dashed(painter: &Painter, points: &[Pos2], pattern: &[f32], stroke: Stroke) {
    let clip = painter.clip_rect().expand(stroke.width);
    painter.extend(dashes(points, pattern, clip).into_iter().map(|dash| Shape::line_segment(dash, stroke)));
}

/// The distance of `p` from the line between `a` and `b`, points.
pub(super) fn distance_to_line(p: Pos2, a: Pos2, b: Pos2) -> f32 {
    let along = b - a;
    let t = if along.length_sq() > 0.0 { ((p - a).dot(along) / along.length_sq()).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + along * t)
}

/// The distance of `p` from a polyline, points; infinite without points.
pub(super) fn distance_to_polyline(p: Pos2, points: &[Pos2]) -> f32 {
    match points {
        [only] => p.distance(*only),
        _ => points.windows(2).map(|w| distance_to_line(p, w[0], w[1])).fold(f32::INFINITY, f32::min),
    }
}

/// `color` at a part of its strength.
pub(super) fn faded(color: Color32, strength: f32) -> Color32 {
    color.gamma_multiply(strength)
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;
    use proptest::prelude::*;

    const SQUARE: Rect = Rect { min: pos2(0.0, 0.0), max: pos2(100.0, 100.0) };

    #[test]
    fn thinning_keeps_ends_and_drops_what_cannot_be_seen() {
        let many = (0..=10_000_u16).map(|k| pos2(f32::from(k) / 100.0, 0.0));
        let kept = thinned(many);
        assert!(kept.len() < 160);
        assert_eq!(kept.first(), Some(&pos2(0.0, 0.0)));
        assert_eq!(kept.last(), Some(&pos2(100.0, 0.0)));
    }

    #[test]
    fn clipping_cuts_at_the_edges() {
        assert_eq!(clipped(pos2(-50.0, 50.0), pos2(150.0, 50.0), SQUARE), Some([pos2(0.0, 50.0), pos2(100.0, 50.0)]));
        assert_eq!(clipped(pos2(-50.0, -1.0), pos2(150.0, -1.0), SQUARE), None);
        assert_eq!(clipped(pos2(-10.0, 5.0), pos2(5.0, -10.0), SQUARE), None);
    }

    #[test]
    fn dashes_run_on_through_corners() {
        let corner = [pos2(0.0, 0.0), pos2(5.0, 0.0), pos2(5.0, 5.0)];
        let found = dashes(&corner, &[4.0, 3.0], SQUARE);
        assert_eq!(found, vec![[pos2(0.0, 0.0), pos2(4.0, 0.0)], [pos2(5.0, 2.0), pos2(5.0, 5.0)]]);
    }

    #[test]
    fn a_line_far_longer_than_the_screen_costs_only_what_is_seen() {
        let long = [pos2(-1e7, 50.0), pos2(1e7, 50.0)];
        assert!(dashes(&long, &[4.0, 3.0], SQUARE).len() <= 17);
    }

    #[test]
    fn distances_count_from_the_nearest_point() {
        assert_eq!(distance_to_line(pos2(5.0, 3.0), pos2(0.0, 0.0), pos2(10.0, 0.0)), 3.0);
        assert_eq!(distance_to_line(pos2(13.0, 4.0), pos2(0.0, 0.0), pos2(10.0, 0.0)), 5.0);
        assert_eq!(distance_to_polyline(pos2(0.0, 0.0), &[]), f32::INFINITY);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn dashes_cover_their_share_of_the_line(x in 0.0..100.0_f32, y in 0.0..100.0_f32) {
            let line = [pos2(0.0, 0.0), pos2(x, y)];
            let length = line[0].distance(line[1]);
            let drawn: f32 = dashes(&line, &[4.0, 3.0], SQUARE).iter().map(|d| d[0].distance(d[1])).sum();
            prop_assert!((drawn - length * 4.0 / 7.0).abs() <= 4.0);
        }

        #[test]
        fn thinned_points_are_apart_but_for_the_last(xs in prop::collection::vec(0.0..50.0_f32, 2..200)) {
            let kept = thinned(xs.iter().map(|&x| pos2(x, 0.0)));
            for pair in kept.windows(2).take(kept.len().saturating_sub(2)) {
                prop_assert!(pair[0].distance(pair[1]) >= THIN);
            }
        }
    }
}
