//! Where two segments meet.

use super::{Point, Segment, Vector};
use std::f64::consts::TAU;

/// How two segments meet. Ends belong to their segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Intersection {
    /// They have no common point.
    Apart,
    /// They have one common point, and their directions differ there.
    Crossing(Point),
    /// They have one common point, and the same or opposite directions there.
    Tangent(Point),
    /// They have two common points.
    TwoPoints(Point, Point),
    /// They run along each other; the common stretch has the direction of the first one.
    Overlap(Segment),
    /// Two arcs of one circle have two common stretches.
    TwoOverlaps(Segment, Segment),
}

impl Intersection {
    /// The common points; of a common stretch its ends.
    #[must_use]
    pub fn points(&self) -> Vec<Point> {
        match *self {
            Self::Apart => vec![],
            Self::Crossing(p) | Self::Tangent(p) => vec![p],
            Self::TwoPoints(p, q) => vec![p, q],
            Self::Overlap(s) => vec![s.start(), s.end()],
            Self::TwoOverlaps(s, t) => vec![s.start(), s.end(), t.start(), t.end()],
        }
    }
}

impl Segment {
    /// How this segment and `other` meet. Points closer than `tolerance` mm are the same.
    #[must_use]
    pub fn intersection(&self, other: &Self, tolerance: f64) -> Intersection {
        match (Shape::of(self), Shape::of(other)) {
            (Shape::Line(a), Shape::Line(b)) => lines(self, a, other, b, tolerance),
            (Shape::Line(line), Shape::Circle(center, radius)) => {
                let points = line_and_circle(self.start(), line, center, radius, tolerance);
                points.kept(self, other, tolerance)
            }
            (Shape::Circle(center, radius), Shape::Line(line)) => {
                let points = line_and_circle(other.start(), line, center, radius, tolerance);
                points.kept(self, other, tolerance)
            }
            (Shape::Circle(c1, r1), Shape::Circle(c2, r2)) => {
                if c1.distance(c2) <= tolerance && (r1 - r2).abs() <= tolerance {
                    return one_circle(self, other, tolerance);
                }
                circles(c1, r1, c2, r2, tolerance).kept(self, other, tolerance)
            }
        }
    }
}

/// The unbounded shape behind a segment.
enum Shape {
    /// Vector from start to end.
    Line(Vector),
    /// Centre and radius.
    Circle(Point, f64),
}

impl Shape {
    fn of(segment: &Segment) -> Self {
        match *segment {
            Segment::Line { start, end } => Self::Line(end - start),
            Segment::Arc { start, center, .. } => Self::Circle(center, start.distance(center)),
        }
    }
}

/// Common points of unbounded shapes.
enum Meeting {
    None,
    Tangent(Point),
    Two(Point, Point),
}

impl Meeting {
    /// What of the common points lies on both segments.
    fn kept(self, a: &Segment, b: &Segment, tolerance: f64) -> Intersection {
        let on_both = |p: &Point| a.distance_to(*p) <= tolerance && b.distance_to(*p) <= tolerance;
        match self {
            Self::None => Intersection::Apart,
            Self::Tangent(p) => Some(p).filter(on_both).map_or(Intersection::Apart, Intersection::Tangent),
            Self::Two(p, q) => match (on_both(&p), on_both(&q)) {
                (true, true) => Intersection::TwoPoints(p, q),
                (true, false) => Intersection::Crossing(p),
                (false, true) => Intersection::Crossing(q),
                (false, false) => Intersection::Apart,
            },
        }
    }
}

fn lines(a: &Segment, along_a: Vector, b: &Segment, along_b: Vector, tolerance: f64) -> Intersection {
    let (length_a, length_b) = (along_a.norm(), along_b.norm());
    let cross = along_a.perp(&along_b);
    // Parallel: over the length of the shorter one their distance changes by no more than the tolerance.
    if cross.abs() <= tolerance * length_a.max(length_b) {
        return parallel_lines(a, b, tolerance);
    }
    let p = a.start() + along_a * ((b.start() - a.start()).perp(&along_b) / cross);
    let on_both = a.distance_to(p) <= tolerance && b.distance_to(p) <= tolerance;
    if on_both { Intersection::Crossing(p) } else { Intersection::Apart }
}

/// The common stretch of two parallel lines: between those of their ends that lie on the other one.
fn parallel_lines(a: &Segment, b: &Segment, tolerance: f64) -> Intersection {
    let ends = [(a.start(), b), (a.end(), b), (b.start(), a), (b.end(), a)];
    let shared: Vec<Point> = ends.iter().filter(|(p, on)| on.distance_to(*p) <= tolerance).map(|(p, _)| *p).collect();
    let along = a.direction_at(0.0);
    let place = |p: &Point| (*p - a.start()).dot(&along);
    let first = shared.iter().copied().min_by(|p, q| place(p).total_cmp(&place(q)));
    let last = shared.iter().copied().max_by(|p, q| place(p).total_cmp(&place(q)));
    match (first, last) {
        (Some(first), Some(last)) if first.distance(last) <= tolerance => Intersection::Tangent(first),
        (Some(first), Some(last)) => Intersection::Overlap(Segment::line(first, last)),
        _ => Intersection::Apart,
    }
}

fn line_and_circle(start: Point, along: Vector, center: Point, radius: f64, tolerance: f64) -> Meeting {
    let Some(direction) = along.try_normalize(0.0) else {
        let on_circle = (start.distance(center) - radius).abs() <= tolerance;
        return if on_circle { Meeting::Tangent(start) } else { Meeting::None };
    };
    let foot = start + direction * (center - start).dot(&direction);
    either_side(foot, direction, radius, foot.distance(center), tolerance)
}

/// The points of a circle of `radius` on the line through `foot`, which has distance `distance` from the centre.
fn either_side(foot: Point, direction: Vector, radius: f64, distance: f64, tolerance: f64) -> Meeting {
    if distance > radius + tolerance {
        return Meeting::None;
    }
    let half = ((radius - distance) * (radius + distance)).max(0.0).sqrt();
    if radius - distance <= tolerance {
        Meeting::Tangent(foot)
    } else {
        Meeting::Two(foot - direction * half, foot + direction * half)
    }
}

fn circles(c1: Point, r1: f64, c2: Point, r2: f64, tolerance: f64) -> Meeting {
    let Some(direction) = (c2 - c1).try_normalize(0.0) else { return Meeting::None };
    let distance = c1.distance(c2);
    let (apart, inside) = (distance - (r1 + r2), (r1 - r2).abs() - distance);
    if apart > tolerance || inside > tolerance {
        return Meeting::None;
    }
    if apart >= -tolerance {
        return Meeting::Tangent(c1 + direction * r1);
    }
    if inside >= -tolerance {
        let (center, outward, radius) = if r1 >= r2 { (c1, direction, r1) } else { (c2, -direction, r2) };
        return Meeting::Tangent(center + outward * radius);
    }
    // Distance of the common chord from the first centre.
    let to_chord = f64::midpoint(distance, (r1 - r2) * (r1 + r2) / distance);
    let half = ((r1 - to_chord) * (r1 + to_chord)).max(0.0).sqrt();
    let foot = c1 + direction * to_chord;
    let across = Vector::new(-direction.y, direction.x) * half;
    Meeting::Two(foot - across, foot + across)
}

/// The common stretches of two arcs of one circle.
fn one_circle(a: &Segment, b: &Segment, tolerance: f64) -> Intersection {
    let (Segment::Arc { center, ccw, .. }, sweep) = (*a, a.sweep().abs()) else { return Intersection::Apart };
    let b = if b.sweep() * a.sweep() < 0.0 { b.reversed() } else { *b };
    let from = a.start() - center;
    let to = b.start() - center;
    let turn = from.perp(&to).atan2(from.dot(&to));
    let offset = (if ccw { turn } else { -turn }).rem_euclid(TAU);
    let radius = from.norm();
    let mut stretches = Vec::new();
    let mut touches = Vec::new();
    // The second arc as angles along the first one, where it may begin before the first one does.
    for begin in [offset, offset - TAU] {
        let (low, high) = (begin.max(0.0), (begin + b.sweep().abs()).min(sweep));
        match (high - low) * radius {
            length if length > tolerance => stretches.push(part_of(a, center, low / sweep, high / sweep)),
            length if length >= -tolerance => touches.push(a.point_at(low / sweep)),
            _ => {}
        }
    }
    match (stretches.as_slice(), touches.as_slice()) {
        (&[first, second, ..], _) => Intersection::TwoOverlaps(first, second),
        (&[only], _) => Intersection::Overlap(only),
        (_, &[first, second, ..]) => Intersection::TwoPoints(first, second),
        (_, &[only]) => Intersection::Tangent(only),
        _ => Intersection::Apart,
    }
}

/// The part of an arc from `t1` to `t2` of its length.
fn part_of(arc: &Segment, center: Point, t1: f64, t2: f64) -> Segment {
    Segment::Arc { start: arc.point_at(t1), end: arc.point_at(t2), center, ccw: arc.sweep() > 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: f64 = 1e-9;

    fn p(z: f64, r: f64) -> Point {
        Point::new(z, r)
    }

    fn line(a: (f64, f64), b: (f64, f64)) -> Segment {
        Segment::line(p(a.0, a.1), p(b.0, b.1))
    }

    /// Part of the circle of radius 5 about the origin, counter-clockwise, angles in degrees.
    fn arc(from: f64, to: f64) -> Segment {
        let at = |deg: f64| p(5.0 * deg.to_radians().cos(), 5.0 * deg.to_radians().sin());
        Segment::Arc { start: at(from), end: at(to), center: p(0.0, 0.0), ccw: true }
    }

    #[test]
    fn lines_cross_overlap_touch_or_miss() {
        let a = line((0.0, 0.0), (4.0, 4.0));
        assert_eq!(a.intersection(&line((0.0, 4.0), (4.0, 0.0)), TOLERANCE), Intersection::Crossing(p(2.0, 2.0)));
        assert_eq!(a.intersection(&line((0.0, 4.0), (1.0, 3.0)), TOLERANCE), Intersection::Apart);
        assert_eq!(a.intersection(&line((0.0, 1.0), (4.0, 5.0)), TOLERANCE), Intersection::Apart);
        let common = Intersection::Overlap(line((3.0, 3.0), (4.0, 4.0)));
        assert_eq!(a.intersection(&line((6.0, 6.0), (3.0, 3.0)), TOLERANCE), common);
        assert_eq!(a.intersection(&line((4.0, 4.0), (6.0, 6.0)), TOLERANCE), Intersection::Tangent(p(4.0, 4.0)));
    }

    #[test]
    fn a_line_meets_an_arc_in_two_points_one_or_none() {
        let upper = arc(0.0, 180.0);
        let found = line((-9.0, 3.0), (9.0, 3.0)).intersection(&upper, TOLERANCE);
        assert_eq!(found, Intersection::TwoPoints(p(-4.0, 3.0), p(4.0, 3.0)));
        let found = line((0.0, 3.0), (9.0, 3.0)).intersection(&upper, TOLERANCE);
        assert_eq!(found, Intersection::Crossing(p(4.0, 3.0)));
        let found = upper.intersection(&line((-9.0, 5.0), (9.0, 5.0)), TOLERANCE);
        assert_eq!(found, Intersection::Tangent(p(0.0, 5.0)));
        assert_eq!(line((-9.0, -3.0), (9.0, -3.0)).intersection(&upper, TOLERANCE), Intersection::Apart);
    }

    #[test]
    fn arcs_of_different_circles_meet_like_their_circles() {
        let other = |center: f64, radius: f64| Segment::Arc {
            start: p(center + radius, 0.0),
            end: p(center - radius, 0.0),
            center: p(center, 0.0),
            ccw: true,
        };
        let upper = arc(0.0, 180.0);
        assert_eq!(upper.intersection(&other(6.0, 5.0), TOLERANCE), Intersection::Crossing(p(3.0, 4.0)));
        assert_eq!(upper.intersection(&other(8.0, 3.0), TOLERANCE), Intersection::Tangent(p(5.0, 0.0)));
        assert_eq!(upper.intersection(&other(3.0, 2.0), TOLERANCE), Intersection::Tangent(p(5.0, 0.0)));
        assert_eq!(upper.intersection(&other(20.0, 3.0), TOLERANCE), Intersection::Apart);
        assert_eq!(upper.intersection(&other(0.0, 3.0), TOLERANCE), Intersection::Apart);
    }

    #[test]
    fn arcs_of_one_circle_share_stretches() {
        let near = |a: Segment, b: Segment| {
            a.start().distance(b.start()) < 1e-9 && a.end().distance(b.end()) < 1e-9 && a.length() - b.length() < 1e-9
        };
        let Intersection::Overlap(common) = arc(0.0, 90.0).intersection(&arc(45.0, 180.0), TOLERANCE) else {
            panic!("one stretch")
        };
        assert!(near(common, arc(45.0, 90.0)));
        let Intersection::TwoOverlaps(one, two) = arc(0.0, 300.0).intersection(&arc(270.0, 30.0), TOLERANCE) else {
            panic!("two stretches")
        };
        assert!(near(one, arc(270.0, 300.0)) && near(two, arc(0.0, 30.0)));
        assert!(matches!(arc(0.0, 90.0).intersection(&arc(90.0, 180.0), TOLERANCE), Intersection::Tangent(_)));
        assert!(matches!(arc(0.0, 180.0).intersection(&arc(180.0, 0.0), TOLERANCE), Intersection::TwoPoints(..)));
        assert_eq!(arc(0.0, 80.0).intersection(&arc(90.0, 180.0), TOLERANCE), Intersection::Apart);
    }
}
