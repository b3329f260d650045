//! Closed outlines of the material before a set-up.

use super::shape::SAME_PLACE_MM;
use super::{Piece, Profile, contour};
use crate::geometry::{Contour, Point, Segment};

/// How far the stock of a second clamping may lie from the parabolas that the first one left, mm.
const STOCK_TOLERANCE_MM: f64 = 1e-3;

/// Bar or tube from `z1` to `z2`, counter-clockwise.
pub(super) fn bar(z1: f64, z2: f64, radius: f64, hole_radius: f64) -> Contour {
    let line = |r| vec![Segment::line(Point::new(z1, r), Point::new(z2, r))];
    body(line(radius), line(hole_radius))
}

/// What is left of a surface after one end was finished up to `z`: the finished pieces and, beyond, the raw surface of
/// `radius` up to `to`. Both ends lie between `from`, where `radius` holds if nothing is finished there, and `to`.
pub(super) fn half_finished(pieces: &[Piece], z: f64, from: f64, to: f64, radius: f64) -> Vec<Segment> {
    let finished = pieces.iter().filter(|piece| piece.start().z < z).map(|piece| {
        let end_z = piece.end().z.min(z);
        if end_z < piece.end().z {
            Piece { curve: piece.curve.between(piece.start().z, end_z), ..*piece }
        } else {
            *piece
        }
    });
    let profile = Profile { pieces: finished.collect() };
    let mut segments = contour(&profile, STOCK_TOLERANCE_MM).contour.segments;
    let last = segments.last().map_or(Point::new(from, radius), Segment::end);
    let corner = Point::new(last.z, radius);
    segments.push(Segment::line(last, corner));
    segments.push(Segment::line(corner, Point::new(to, radius)));
    segments
}

/// The outline of the body between `outside` and `inside` (z growing along both), counter-clockwise. Where the outside
/// begins on the axis there is no body.
pub(super) fn body(outside: Vec<Segment>, inside: Vec<Segment>) -> Contour {
    let on_axis = |p: Point| p.r <= SAME_PLACE_MM;
    let outside: Vec<Segment> = outside
        .into_iter()
        .skip_while(|s| on_axis(s.start()) && on_axis(s.end()))
        .filter(|s| s.start() != s.end())
        .collect();
    let (Some(first), Some(last)) = (outside.first().map(Segment::start), outside.last().map(Segment::end)) else {
        return Contour::default();
    };
    let is_hole = inside.iter().any(|s| !on_axis(s.start()) || !on_axis(s.end()));
    let axis = || vec![Segment::line(Point::new(first.z, 0.0), Point::new(last.z, 0.0))];
    let inside = if is_hole { inside } else { axis() };
    let (from, to) = (inside.first().map_or(first, Segment::start), inside.last().map_or(last, Segment::end));
    let bottom = [Segment::line(first, from)].into_iter().chain(inside).chain([Segment::line(to, last)]);
    let all = bottom.chain(outside.iter().rev().map(Segment::reversed));
    Contour::new(all.filter(|s| s.start() != s.end()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tube_is_a_ring_and_a_bar_reaches_the_axis() {
        let tube = bar(0.0, 10.0, 8.0, 3.0);
        assert_eq!(tube.segments.len(), 4);
        assert_eq!(tube.bounds().map(|b| (b.min, b.max)), Some((Point::new(0.0, 3.0), Point::new(10.0, 8.0))));
        assert_eq!(bar(0.0, 10.0, 8.0, 0.0).bounds().map(|b| b.min.r), Some(0.0));
    }
}
