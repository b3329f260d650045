//! Areas cut off at a rectangle.

use crate::geometry::{Bounds, Point, Segment};

/// The part of a polygon within a rectangle.
pub(super) fn within(points: &[Point], boxed: Bounds) -> Vec<Point> {
    let points = cut(points, |p| p.z - boxed.min.z);
    let points = cut(&points, |p| boxed.max.z - p.z);
    let points = cut(&points, |p| p.r - boxed.min.r);
    cut(&points, |p| boxed.max.r - p.r)
}

/// The part of a polygon where `inside` is not negative (Sutherland and Hodgman, 1974).
fn cut(polygon: &[Point], inside: impl Fn(Point) -> f64) -> Vec<Point> {
    let next = polygon.iter().cycle().skip(1);
    let mut kept = Vec::new();
    for (&a, &b) in polygon.iter().zip(next) {
        let (at_a, at_b) = (inside(a), inside(b));
        if at_a >= 0.0 {
            kept.push(a);
        }
        if (at_a >= 0.0) != (at_b >= 0.0) {
            kept.push(Segment::line(a, b).point_at(at_a / (at_a - at_b)));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_cut_off_at_the_sides_of_the_rectangle() {
        let corners = [(0.0, 0.0), (20.0, 0.0), (0.0, 20.0)].map(|(z, r)| Point::new(z, r));
        let boxed = Bounds { min: Point::new(-5.0, -5.0), max: Point::new(15.0, 10.0) };
        let expected = [(0.0, 0.0), (15.0, 0.0), (15.0, 5.0), (10.0, 10.0), (0.0, 10.0)].map(|(z, r)| Point::new(z, r));
        assert_eq!(within(&corners, boxed), expected);
        let away = Bounds { min: Point::new(30.0, 0.0), max: Point::new(40.0, 10.0) };
        assert_eq!(within(&corners, away), []);
    }
}
