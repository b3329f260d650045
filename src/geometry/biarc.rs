//! Two tangent arcs between two points with given directions.

use super::{Point, Segment, Vector};

/// An arc that bulges less than this is written as a line, mm.
const STRAIGHT_MM: f64 = 1e-9;

/// Two arcs from `start` in direction `a` to `end` in direction `b` (unit lengths), with one direction where they meet.
///
/// Of the one-parameter family the one with equal tangent lengths d: |v|² = 2 d v·(a + b) + 2 d² (1 − a·b), v from
/// end to end (Bolton, Biarc curves, 1975).
#[must_use]
pub fn biarc(start: Point, a: Vector, end: Point, b: Vector) -> [Segment; 2] {
    let v = end - start;
    let along = v.dot(&(a + b));
    // 1 − a·b as half the squared difference: no cancellation when the directions are nearly the same.
    let turn = (a - b).norm_squared();
    let squared = v.norm_squared();
    let d = squared / (along + (along * along + turn * squared).sqrt());
    let joint = Point::new(f64::midpoint(start.z, end.z), f64::midpoint(start.r, end.r)) + (a - b) * (d / 2.0);
    [tangent_arc(start, a, joint), tangent_arc(end, -b, joint).reversed()]
}

/// The arc from `start` in `direction` to `end`, or a line if it hardly bulges.
fn tangent_arc(start: Point, direction: Vector, end: Point) -> Segment {
    let chord = end - start;
    let normal = Vector::new(-direction.y, direction.x);
    let rise = normal.dot(&chord);
    if rise.abs() / 4.0 <= STRAIGHT_MM {
        return Segment::line(start, end);
    }
    let center = start + normal * (chord.norm_squared() / (2.0 * rise));
    Segment::Arc { start, end, center, ccw: rise > 0.0 }
}
