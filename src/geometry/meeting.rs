//! Where the unbounded lines and circles behind two segments meet.

use super::{Point, Segment, Vector};

/// Lines at a smaller angle than this have no meeting that rounding leaves alone, radians.
const PARALLEL_RAD: f64 = 1e-9;

impl Segment {
    /// Where this segment and `other` meet nearest to `near`, both prolonged without end; `None` if they never do.
    #[must_use]
    pub fn prolonged_meeting(&self, other: &Self, near: Point) -> Option<Point> {
        let candidates = candidates(self, other)?;
        candidates.into_iter().min_by(|p, q| p.distance(near).total_cmp(&q.distance(near)))
    }
}

/// The meetings of the carriers of two segments.
fn candidates(a: &Segment, b: &Segment) -> Option<Vec<Point>> {
    Some(match (Carrier::of(a)?, Carrier::of(b)?) {
        (Carrier::Line(p, u), Carrier::Line(q, v)) => lines(p, u, q, v).into_iter().collect(),
        (Carrier::Line(p, u), Carrier::Circle(c, r)) | (Carrier::Circle(c, r), Carrier::Line(p, u)) => {
            let foot = p + u * (c - p).dot(&u);
            either_side(foot, u, r * r - (foot - c).norm_squared())
        }
        (Carrier::Circle(c, r), Carrier::Circle(d, s)) => circles(c, r, d, s),
    })
}

/// The unbounded shape behind a segment.
enum Carrier {
    /// A point and the direction of unit length.
    Line(Point, Vector),
    /// Centre and radius.
    Circle(Point, f64),
}

impl Carrier {
    /// `None` for a line without length.
    fn of(segment: &Segment) -> Option<Self> {
        match *segment {
            Segment::Line { start, end } => Some(Self::Line(start, (end - start).try_normalize(0.0)?)),
            Segment::Arc { start, center, .. } => Some(Self::Circle(center, start.distance(center))),
        }
    }
}

fn lines(p: Point, u: Vector, q: Point, v: Vector) -> Option<Point> {
    let cross = u.perp(&v);
    (cross.abs() > PARALLEL_RAD).then(|| p + u * ((q - p).perp(&v) / cross))
}

fn circles(c: Point, r: f64, d: Point, s: f64) -> Vec<Point> {
    let Some(along) = (d - c).try_normalize(0.0) else { return Vec::new() };
    let apart = c.distance(d);
    let to_chord = f64::midpoint(apart, (r - s) * (r + s) / apart);
    either_side(c + along * to_chord, Vector::new(-along.y, along.x), r * r - to_chord * to_chord)
}

/// The points at the root of `square` on both sides of `foot`.
fn either_side(foot: Point, along: Vector, square: f64) -> Vec<Point> {
    if square < 0.0 {
        return Vec::new();
    }
    let half = along * square.sqrt();
    vec![foot - half, foot + half]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(z: f64, r: f64) -> Point {
        Point::new(z, r)
    }

    fn arc(center: Point, radius: f64) -> Segment {
        let (start, end) = (center + Vector::new(radius, 0.0), center + Vector::new(0.0, radius));
        Segment::Arc { start, end, center, ccw: true }
    }

    fn meeting(a: &Segment, b: &Segment, near: Point) -> Option<Point> {
        a.prolonged_meeting(b, near)
    }

    #[test]
    fn segments_are_prolonged_to_the_nearest_meeting() {
        let line = Segment::line(p(0.0, 0.0), p(1.0, 0.0));
        assert_eq!(meeting(&line, &Segment::line(p(5.0, 5.0), p(5.0, 4.0)), p(0.0, 0.0)), Some(p(5.0, 0.0)));
        assert_eq!(meeting(&arc(p(9.0, 3.0), 5.0), &line, p(0.0, 0.0)), Some(p(5.0, 0.0)));
        assert_eq!(meeting(&line, &arc(p(9.0, 3.0), 5.0), p(20.0, 0.0)), Some(p(13.0, 0.0)));
        let both = meeting(&arc(p(0.0, 0.0), 5.0), &arc(p(6.0, 0.0), 5.0), p(3.0, -1.0)).unwrap();
        assert!(both.distance(p(3.0, -4.0)) < 1e-12);
    }

    #[test]
    fn what_never_meets_has_no_meeting() {
        let line = Segment::line(p(0.0, 0.0), p(1.0, 0.0));
        assert_eq!(meeting(&line, &Segment::line(p(0.0, 1.0), p(1.0, 1.0)), p(0.0, 0.0)), None);
        assert_eq!(meeting(&line, &arc(p(0.0, 6.0), 5.0), p(0.0, 0.0)), None);
        assert_eq!(meeting(&arc(p(0.0, 0.0), 1.0), &arc(p(6.0, 0.0), 2.0), p(0.0, 0.0)), None);
        assert_eq!(meeting(&line, &Segment::line(p(0.0, 1.0), p(0.0, 1.0)), p(0.0, 0.0)), None);
    }
}
