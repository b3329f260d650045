//! Where a contour crosses a level, and how high it rises.

use super::area::Direction;
use crate::geometry::{Point, Segment};

/// Points closer than this are the same, mm.
const SAME_MM: f64 = 1e-9;

/// A line across a segment reaches this far beyond it, mm.
const BEYOND_MM: f64 = 1.0;

/// Position beyond `from_z` in the direction of cutting where the contour first comes to radius `r`, mm.
pub(super) fn first_crossing(contour: &[Segment], r: f64, from_z: f64, direction: Direction) -> Option<f64> {
    let sign = direction.sign();
    let ahead = contour.iter().flat_map(|segment| crossings(segment, r)).filter(|z| (z - from_z) * sign > SAME_MM);
    ahead.min_by(|a, b| (a * sign).total_cmp(&(b * sign)))
}

/// Positions where a segment has radius `r`.
fn crossings(segment: &Segment, r: f64) -> Vec<f64> {
    let bounds = segment.bounds();
    if r < bounds.min.r - SAME_MM || r > bounds.max.r + SAME_MM {
        return Vec::new();
    }
    let level = Segment::line(Point::new(bounds.min.z - BEYOND_MM, r), Point::new(bounds.max.z + BEYOND_MM, r));
    segment.intersection(&level, SAME_MM).points().iter().map(|p| p.z).collect()
}

/// Largest radius of the contour from `z1` to `z2`, both included, mm; `None` if it is elsewhere.
pub(super) fn highest_between(contour: &[Segment], z1: f64, z2: f64) -> Option<f64> {
    contour.iter().flat_map(|segment| heights(segment, z1, z2)).reduce(f64::max)
}

/// Radii among which the largest one of a segment between two positions is.
fn heights(segment: &Segment, z1: f64, z2: f64) -> Vec<f64> {
    let within = |p: &Point| p.z >= z1 - SAME_MM && p.z <= z2 + SAME_MM;
    let bounds = segment.bounds();
    let across = [z1, z2].into_iter().flat_map(|z| {
        let low = Point::new(z, bounds.min.r - BEYOND_MM);
        segment.intersection(&Segment::line(low, Point::new(z, bounds.max.r + BEYOND_MM)), SAME_MM).points()
    });
    let top = match *segment {
        Segment::Arc { start, center, .. } => Some(Point::new(center.z, center.r + start.distance(center))),
        Segment::Line { .. } => None,
    };
    let top = top.filter(|p| segment.distance_to(*p) <= SAME_MM);
    let own = [segment.start(), segment.end()].into_iter().chain(top).filter(within);
    own.chain(across).map(|p| p.r).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flank down, a half circle of radius 2 standing up, a flank up.
    fn contour() -> Vec<Segment> {
        let p = Point::new;
        vec![
            Segment::line(p(0.0, 10.0), p(4.0, 2.0)),
            Segment::Arc { start: p(4.0, 2.0), end: p(8.0, 2.0), center: p(6.0, 2.0), ccw: false },
            Segment::line(p(8.0, 2.0), p(8.0, 10.0)),
        ]
    }

    #[test]
    fn the_first_crossing_depends_on_direction_and_start() {
        let at = |r, from, direction| first_crossing(&contour(), r, from, direction);
        assert_eq!(at(8.0, -1.0, Direction::TowardsFreeEnd), Some(1.0));
        assert_eq!(at(8.0, 2.0, Direction::TowardsFreeEnd), Some(8.0));
        assert_eq!(at(8.0, 9.0, Direction::TowardsClampedEnd), Some(8.0));
        assert_eq!(at(8.0, 7.0, Direction::TowardsClampedEnd), Some(1.0));
        assert_eq!(at(11.0, 7.0, Direction::TowardsClampedEnd), None);
    }

    #[test]
    fn the_highest_point_may_be_an_end_a_top_or_between() {
        let near = |found: Option<f64>, r: f64| found.is_some_and(|f| (f - r).abs() < 1e-9);
        assert!(near(highest_between(&contour(), 5.0, 7.0), 4.0));
        assert!(near(highest_between(&contour(), 7.0, 7.5), 2.0 + 3.0_f64.sqrt()));
        assert!(near(highest_between(&contour(), 7.0, 8.0), 10.0));
        assert_eq!(highest_between(&contour(), 9.0, 10.0), None);
    }
}
