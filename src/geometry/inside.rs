//! Whether a point lies inside a closed contour.

use super::{Contour, Point, Segment};
use std::f64::consts::TAU;

/// Where a point lies with respect to a closed contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Location {
    /// The contour runs around it.
    Inside,
    /// The contour does not run around it.
    Outside,
    /// On the contour.
    OnBorder,
}

impl Contour {
    /// Where `p` lies with respect to this closed contour of either sense. Within `tolerance` mm it is on the border.
    #[must_use]
    pub fn locate(&self, p: Point, tolerance: f64) -> Location {
        if self.distance_to(p) <= tolerance {
            return Location::OnBorder;
        }
        let turn: f64 = self.segments.iter().map(|segment| segment.turn_around(p)).sum();
        if turn.abs() > TAU / 2.0 { Location::Inside } else { Location::Outside }
    }
}

impl Segment {
    /// Angle by which the direction from `p` to a point on the segment turns from start to end, radians.
    fn turn_around(&self, p: Point) -> f64 {
        let (from, to) = (self.start() - p, self.end() - p);
        let chord = from.perp(&to).atan2(from.dot(&to));
        match *self {
            // Between arc and chord the arc passes on the other side of the point than the chord does.
            Self::Arc { start, center, ccw, .. } if p.distance(center) < start.distance(center) => match ccw {
                true if chord < 0.0 => chord + TAU,
                false if chord > 0.0 => chord - TAU,
                _ => chord,
            },
            _ => chord,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: f64 = 1e-9;

    /// A square of 10 mm with a half circle standing out of its right side and one cut into its left side.
    fn key() -> Contour {
        let p = Point::new;
        Contour::new(vec![
            Segment::line(p(0.0, 0.0), p(10.0, 0.0)),
            Segment::Arc { start: p(10.0, 0.0), end: p(10.0, 10.0), center: p(10.0, 5.0), ccw: true },
            Segment::line(p(10.0, 10.0), p(0.0, 10.0)),
            Segment::Arc { start: p(0.0, 10.0), end: p(0.0, 0.0), center: p(0.0, 5.0), ccw: false },
        ])
    }

    #[test]
    fn bulges_belong_to_the_inside_and_hollows_do_not() {
        for contour in [key(), key().reversed()] {
            let at = |z, r| contour.locate(Point::new(z, r), TOLERANCE);
            assert_eq!(at(14.0, 5.0), Location::Inside);
            assert_eq!(at(10.0, 5.0), Location::Inside);
            assert_eq!(at(7.0, 5.0), Location::Inside);
            assert_eq!(at(2.0, 5.0), Location::Outside);
            assert_eq!(at(15.1, 5.0), Location::Outside);
            assert_eq!(at(15.0, 5.0), Location::OnBorder);
            assert_eq!(at(3.0, 0.0), Location::OnBorder);
        }
    }
}
