//! The contour at a distance from the former that may change with the angle of the wall: outside of the shell, path of the
//! roller's centre.

use super::chain::Chain;
use super::fit;
use super::law;
use crate::document::Forming;
use crate::geometry::{Contour, Point, Segment, Vector};

/// Points closer than this are the same, mm; angles closer than this many radians are, too.
pub(super) const SAME_MM: f64 = 1e-9;

/// A distance from the former, square to it: the wall and something more.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Distance {
    /// What becomes of the wall.
    pub forming: Forming,
    /// Thickness of the blank, mm.
    pub thickness: f64,
    /// Added to the wall, mm.
    pub more: f64,
}

impl Distance {
    /// At a wall that stands at this angle to the axis, mm.
    pub(super) fn at(self, half_angle: f64) -> f64 {
        law::wall(self.forming, self.thickness, half_angle) + self.more
    }

    /// Change with the angle, mm per radian.
    pub(super) fn slope(self, half_angle: f64) -> f64 {
        match self.forming {
            Forming::Shear if half_angle > 0.0 => self.thickness * half_angle.cos(),
            Forming::Shear | Forming::Spinning => 0.0,
        }
    }
}

/// Angle of a wall to the axis by its direction of travel from tip to base, radians; negative where it turns back in.
pub(super) fn half_angle(direction: Vector) -> f64 {
    direction.y.atan2(-direction.x)
}

/// Direction of travel from tip to base.
pub(super) fn along(half_angle: f64) -> Vector {
    Vector::new(-half_angle.cos(), half_angle.sin())
}

/// Away from the former.
pub(super) fn outward(half_angle: f64) -> Vector {
    Vector::new(half_angle.sin(), half_angle.cos())
}

/// A hollow corner of the moved contour: both its sides were cut there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    /// Where they meet.
    pub at: Point,
    /// Index of the segment that the side before it follows.
    pub before: usize,
    /// Index of the segment that the side behind it follows.
    pub behind: usize,
}

/// A moved contour with its hollow corners.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Offset {
    /// The contour.
    pub contour: Contour,
    /// Its hollow corners, in order.
    pub cuts: Vec<Cut>,
}

/// The contour at `distance` from `contour`, which runs from tip to base. Lines stay lines and arcs arcs where the distance
/// is constant; elsewhere arcs stay within `tolerance` mm. Convex corners are rounded, hollow ones cut.
pub(super) fn offset(contour: &Contour, distance: Distance, tolerance: f64) -> Offset {
    let mut chain = Chain::default();
    let mut last: Option<(Point, f64)> = None;
    for (source, segment) in contour.segments.iter().enumerate() {
        let (from, to) = (half_angle(segment.direction_at(0.0)), half_angle(segment.direction_at(1.0)));
        let moved = of_segment(segment, distance, tolerance);
        match last {
            Some((corner, before)) if before - from > SAME_MM => {
                chain.append(around(corner, before, from, distance, tolerance), source);
                chain.append(moved, source);
            }
            _ => chain.join(moved, source),
        }
        last = Some((segment.end(), to));
    }
    chain.finished()
}

fn of_segment(segment: &Segment, distance: Distance, tolerance: f64) -> Vec<Segment> {
    let from = half_angle(segment.direction_at(0.0));
    match *segment {
        Segment::Line { start, end } => {
            let by = outward(from) * distance.at(from);
            vec![Segment::line(start + by, end + by)]
        }
        Segment::Arc { start, end, center, ccw } => {
            let turn = -segment.sweep();
            let length = segment.length();
            let d_of = |share: f64| distance.at(from + turn * share);
            // A hollow too narrow for the distance has no offset.
            if [0.0, 0.5, 1.0].iter().any(|share| d_of(*share) * turn >= length) {
                return Vec::new();
            }
            let moved = |p: Point, share: f64| p + outward(from + turn * share) * d_of(share);
            if (d_of(0.0) - d_of(1.0)).abs() < SAME_MM && (d_of(0.0) - d_of(0.5)).abs() < SAME_MM {
                return vec![Segment::Arc { start: moved(start, 0.0), end: moved(end, 1.0), center, ccw }];
            }
            let curve = |share: f64| {
                let angle = from + turn * share;
                let direction =
                    along(angle) * (length - d_of(share) * turn) + outward(angle) * (distance.slope(angle) * turn);
                (moved(segment.point_at(share), share), direction.normalize())
            };
            fit::arcs(&curve, 0.0, 1.0, tolerance)
        }
    }
}

/// Round a convex corner from the wall before it to the wall behind it.
fn around(corner: Point, before: f64, after: f64, distance: Distance, tolerance: f64) -> Vec<Segment> {
    let place = |angle: f64| corner + outward(angle) * distance.at(angle);
    if (distance.at(before) - distance.at(after)).abs() < SAME_MM
        && (distance.at(before) - distance.at(f64::midpoint(before, after))).abs() < SAME_MM
    {
        return vec![Segment::Arc { start: place(before), end: place(after), center: corner, ccw: true }];
    }
    let curve = |share: f64| {
        let angle = before + (after - before) * share;
        let direction = along(angle) * distance.at(angle) - outward(angle) * distance.slope(angle);
        (place(angle), direction.normalize())
    };
    fit::arcs(&curve, 0.0, 1.0, tolerance)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: f64 = 0.0005;

    fn moved(contour: &Contour, distance: Distance, tolerance: f64) -> Contour {
        offset(contour, distance, tolerance).contour
    }

    fn shear(more: f64) -> Distance {
        Distance { forming: Forming::Shear, thickness: 2.0, more }
    }

    fn p(z: f64, r: f64) -> Point {
        Point::new(z, r)
    }

    #[test]
    fn a_cone_keeps_its_line() {
        let cone = Contour::new(vec![Segment::line(p(50.0, 20.0), p(0.0, 20.0 + 50.0 * 30.0_f64.to_radians().tan()))]);
        let moved = moved(&cone, shear(9.0), TOLERANCE);
        assert_eq!(moved.segments.len(), 1);
        assert!((cone.distance_to(moved.segments[0].point_at(0.5)) - 10.0).abs() < 1e-9);
    }

    #[test]
    fn in_a_hollow_corner_every_wall_keeps_its_distance() {
        let lines = [Segment::line(p(45.0, 30.0), p(20.0, 45.0)), Segment::line(p(20.0, 45.0), p(0.0, 60.0))];
        let moved = moved(&Contour::new(lines.to_vec()), shear(6.0), TOLERANCE);
        assert_eq!((moved.segments.len(), moved.largest_gap()), (2, 0.0));
        for line in lines {
            let wall = 2.0 * half_angle(line.direction_at(0.0)).sin();
            for k in 0..=100 {
                let share = f64::from(k) / 100.0;
                for segment in &moved.segments {
                    let distance = line.distance_to(segment.point_at(share));
                    assert!(distance > 6.0 + wall - 1e-9, "{distance} of {}", 6.0 + wall);
                }
            }
        }
    }

    /// A quarter of a ball, its pole cut off, and the cylinder angle not reached.
    fn ball() -> Contour {
        let at = |deg: f64| p(50.0 * deg.to_radians().cos(), 50.0 * deg.to_radians().sin());
        Contour::new(vec![Segment::Arc { start: at(20.0), end: at(70.0), center: p(0.0, 0.0), ccw: true }])
    }

    #[test]
    fn a_ball_has_the_sine_wall_everywhere() {
        let moved = moved(&ball(), shear(0.0), TOLERANCE);
        assert!(moved.largest_gap() < 1e-9);
        for deg in 20..=70 {
            let angle = f64::from(deg).to_radians();
            let wall = 2.0 * angle.cos();
            let at = p((50.0 + wall) * angle.cos(), (50.0 + wall) * angle.sin());
            assert!(moved.distance_to(at) < TOLERANCE, "{deg}: {}", moved.distance_to(at));
        }
    }

    #[test]
    fn a_constant_wall_keeps_arcs_exact() {
        let moved = moved(&ball(), Distance { forming: Forming::Spinning, thickness: 2.0, more: 8.0 }, TOLERANCE);
        assert_eq!(moved.segments.len(), 1);
        assert!((moved.segments[0].radius().unwrap() - 60.0).abs() < 1e-9);
    }

    #[test]
    fn corners_are_rounded_outside_and_cut_inside() {
        // Steep, then shallow, then steep again.
        let corners = [p(60.0, 20.0), p(50.0, 40.0), p(20.0, 50.0), p(10.0, 70.0)];
        let contour = Contour::new(corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect());
        for distance in [shear(5.0), Distance { forming: Forming::Spinning, thickness: 2.0, more: 5.0 }] {
            let moved = moved(&contour, distance, TOLERANCE);
            assert!(moved.largest_gap() < 1e-6, "{}", moved.largest_gap());
            for segment in &moved.segments {
                for k in 0..=20 {
                    let at = segment.point_at(f64::from(k) / 20.0);
                    let gap = contour.distance_to(at);
                    assert!(gap >= 5.0 + 2.0 * 18.0_f64.to_radians().sin() - TOLERANCE, "{gap} at {at:?}");
                }
            }
        }
    }

    #[test]
    fn a_hollow_narrower_than_the_roller_is_left_out() {
        let hollow = Contour::new(vec![Segment::Arc {
            start: p(50.0, 20.0),
            end: p(43.0, 23.0),
            center: p(50.0, 30.0),
            ccw: false,
        }]);
        assert!(moved(&hollow, shear(12.0), TOLERANCE).segments.is_empty());
        assert!(!moved(&hollow, shear(2.0), TOLERANCE).segments.is_empty());
    }
}
