//! The upper boundary of a closed contour as pieces over z, and contours turned over.

use super::piece::{Piece, SAME_MM};
use crate::geometry::{Contour, Point, Segment};

/// How a contour is turned over before its upper boundary is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Turn {
    /// As it is.
    None,
    /// Both coordinates change sign: what a tool touches from above is limited by this.
    Both,
    /// The radius changes sign: what a tool leaves below it is found with this.
    Radius,
}

/// The parts of a closed, counter-clockwise contour that face upwards, in the order of its segments run backwards, which is
/// the order of z where it does not overhang. A hollow arc is bridged by its chord, which lies on the safe side.
pub(super) fn upper_pieces(contour: &Contour, turn: Turn) -> Vec<Piece> {
    let turned = contour.segments.iter().map(|s| turned(s, turn));
    let in_order: Vec<Segment> = match turn {
        Turn::None | Turn::Both => turned.collect(),
        Turn::Radius => turned.rev().map(|s| s.reversed()).collect(),
    };
    in_order
        .iter()
        .rev()
        .flat_map(|s| one_way(s).into_iter().rev())
        .filter(faces_up)
        .filter_map(|s| piece(&s))
        .collect()
}

fn turned(segment: &Segment, turn: Turn) -> Segment {
    let (sz, sr) = match turn {
        Turn::None => (1.0, 1.0),
        Turn::Both => (-1.0, -1.0),
        Turn::Radius => (1.0, -1.0),
    };
    let map = |p: Point| Point::new(sz * p.z, sr * p.r);
    match *segment {
        Segment::Line { start, end } => Segment::line(map(start), map(end)),
        Segment::Arc { start, end, center, ccw } => {
            Segment::Arc { start: map(start), end: map(end), center: map(center), ccw: ccw != (turn == Turn::Radius) }
        }
    }
}

fn faces_up(segment: &Segment) -> bool {
    segment.start().z - segment.end().z > SAME_MM
}

fn piece(segment: &Segment) -> Option<Piece> {
    match *segment {
        Segment::Arc { start, end, ccw: false, .. } => Piece::of(&Segment::line(start, end)),
        _ => Piece::of(segment),
    }
}

/// An arc parted where it turns back along z; a line as it is.
pub(super) fn one_way(segment: &Segment) -> Vec<Segment> {
    let Segment::Arc { start, end, center, ccw } = *segment else { return vec![*segment] };
    let radius = start.distance(center);
    let from = (start - center).y.atan2((start - center).x);
    let sweep = segment.sweep();
    let mut turns: Vec<(f64, Point)> = (-2..=3)
        .map(|k| {
            let side = if k % 2 == 0 { radius } else { -radius };
            ((f64::from(k) * std::f64::consts::PI - from) / sweep, Point::new(center.z + side, center.r))
        })
        .filter(|(t, _)| t.is_finite() && *t > SAME_MM && *t < 1.0 - SAME_MM)
        .collect();
    turns.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ends: Vec<Point> = [start].into_iter().chain(turns.iter().map(|t| t.1)).chain([end]).collect();
    ends.windows(2).map(|w| Segment::Arc { start: w[0], end: w[1], center, ccw }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nose_turned_over_is_half_a_circle() {
        let p = Point::new;
        let nose = Segment::Arc { start: p(0.0, 1.0), end: p(1.9, 0.6), center: p(1.0, 1.0), ccw: true };
        let insert =
            Contour::new(vec![nose, Segment::line(p(1.9, 0.6), p(3.0, 5.0)), Segment::line(p(3.0, 5.0), p(0.0, 1.0))]);
        let upper = upper_pieces(&insert, Turn::Both);
        assert_eq!(upper.len(), 2, "{upper:?}");
        assert!((upper[0].z0 + 3.0).abs() < 1e-12 && (upper[1].z1).abs() < 1e-12);
        assert_eq!(upper_pieces(&insert, Turn::None).len(), 1, "the back");
        assert_eq!(upper_pieces(&insert, Turn::Radius).len(), 2);
    }
}
