//! The integer grid of tools and paths: points, rings, convex hulls and exact tests on them.
//!
//! One unit is 10 nm. The corners of everything that cuts lie on this grid, so a tool that goes back over its own path finds
//! exactly the surface that it left, and nothing drifts however often the stock is cut.

use crate::geometry::Point;

/// A point of the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(in crate::proof) struct GridPoint {
    /// Along z.
    pub x: i32,
    /// Along r.
    pub y: i32,
}

impl GridPoint {
    /// The point at the given coordinates.
    pub(in crate::proof) const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }
}

/// A closed ring; material lies to the left.
pub(in crate::proof) type Ring = Vec<GridPoint>;

/// Grid units in one mm.
pub(super) const UNITS_PER_MM: f64 = 100_000.0;
/// Positions beyond this, mm, are taken as being there; it is far outside any lathe of this size and keeps sums of
/// positions and tool outlines, and products of their differences, inside the range of the integers.
const FARTHEST_MM: f64 = 4_000.0;
/// What is thinner than this, grid units, only touches: rounding moves a corner by less than one unit.
pub(super) const TOUCH: f64 = 3.0;

/// The nearest point of the grid.
#[allow(clippy::cast_possible_truncation, reason = "clamped to the grid")]
pub(in crate::proof) fn to_grid(p: Point) -> GridPoint {
    let unit = |mm: f64| (mm.clamp(-FARTHEST_MM, FARTHEST_MM) * UNITS_PER_MM).round() as i32;
    GridPoint::new(unit(p.z), unit(p.r))
}

/// The point in mm.
pub(in crate::proof) fn from_grid(p: GridPoint) -> Point {
    Point::new(f64::from(p.x) / UNITS_PER_MM, f64::from(p.y) / UNITS_PER_MM)
}

pub(super) fn plus(a: GridPoint, b: GridPoint) -> GridPoint {
    GridPoint::new(a.x + b.x, a.y + b.y)
}

/// Twice the area of the triangle, positive if counter-clockwise. Exact.
pub(super) fn turn(a: GridPoint, b: GridPoint, c: GridPoint) -> i64 {
    let (ux, uy) = (i64::from(b.x) - i64::from(a.x), i64::from(b.y) - i64::from(a.y));
    let (vx, vy) = (i64::from(c.x) - i64::from(a.x), i64::from(c.y) - i64::from(a.y));
    ux * vy - uy * vx
}

/// Edges of a closed ring.
pub(in crate::proof) fn edges(ring: &[GridPoint]) -> impl Iterator<Item = (GridPoint, GridPoint)> {
    let closing = ring.last().copied().zip(ring.first().copied());
    ring.windows(2).map(|w| (w[0], w[1])).chain(closing)
}

/// Area inside a ring, mm², negative if it runs clockwise.
pub(super) fn area_mm2(ring: &[GridPoint]) -> f64 {
    let Some(&first) = ring.first() else { return 0.0 };
    let doubled: f64 = ring.windows(2).map(|w| turn(first, w[0], w[1]) as f64).sum();
    doubled / 2.0 / (UNITS_PER_MM * UNITS_PER_MM)
}

/// Area of rings together, mm²; holes run clockwise and count negative.
pub(super) fn area_of(rings: &[Ring]) -> f64 {
    rings.iter().map(|ring| area_mm2(ring)).sum()
}

/// Way around a ring, mm.
pub(super) fn around_mm(ring: &[GridPoint]) -> f64 {
    edges(ring).map(|(a, b)| length(a, b)).sum::<f64>() / UNITS_PER_MM
}

/// True if a ring is as thin as the rounding of the grid, so that it is no material.
pub(super) fn is_sliver(ring: &[GridPoint]) -> bool {
    let thick = area_mm2(ring).abs() * UNITS_PER_MM;
    // The way around along the axes is longer and needs no roots.
    let longest = edges(ring).map(|(a, b)| f64::from(a.x.abs_diff(b.x)) + f64::from(a.y.abs_diff(b.y))).sum::<f64>();
    thick < TOUCH * longest / UNITS_PER_MM && thick < TOUCH * around_mm(ring)
}

fn length(a: GridPoint, b: GridPoint) -> f64 {
    let (x, y) = (f64::from(b.x) - f64::from(a.x), f64::from(b.y) - f64::from(a.y));
    (x * x + y * y).sqrt()
}

/// A rectangle on the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Window {
    /// Corner with the smallest coordinates.
    pub min: GridPoint,
    /// Corner with the largest coordinates.
    pub max: GridPoint,
}

impl Window {
    /// The rectangle around points; one at the origin without any.
    pub(super) fn around(points: &[GridPoint]) -> Self {
        let first = points.first().copied().unwrap_or(GridPoint::new(0, 0));
        points.iter().fold(Self { min: first, max: first }, |w, p| Self {
            min: GridPoint::new(w.min.x.min(p.x), w.min.y.min(p.y)),
            max: GridPoint::new(w.max.x.max(p.x), w.max.y.max(p.y)),
        })
    }

    /// True if the rectangles share a point.
    pub(super) fn meets(&self, other: &Self) -> bool {
        self.min.x <= other.max.x && other.min.x <= self.max.x && self.min.y <= other.max.y && other.min.y <= self.max.y
    }

    /// What an outline in this rectangle may cover while it is moved to every point of `path`.
    pub(super) fn moved(&self, path: &Self) -> Self {
        Self { min: plus(self.min, path.min), max: plus(self.max, path.max) }
    }
}

/// The convex hull, counter-clockwise, without points on straight edges.
pub(super) fn hull(mut points: Vec<GridPoint>) -> Ring {
    points.sort_unstable_by_key(|p| (p.x, p.y));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut ring = half_hull(points.iter());
    ring.extend(half_hull(points.iter().rev()));
    ring
}

/// One chain of the hull without its last point.
fn half_hull<'a>(points: impl Iterator<Item = &'a GridPoint>) -> Ring {
    let mut chain: Ring = Vec::new();
    for &p in points {
        while let [.., a, b] = chain[..] {
            if turn(a, b, p) > 0 {
                break;
            }
            chain.pop();
        }
        chain.push(p);
    }
    chain.pop();
    chain
}

/// True if an odd number of edges lies above the point.
pub(in crate::proof) fn above_odd(edges: impl Iterator<Item = (GridPoint, GridPoint)>, p: GridPoint) -> bool {
    let above = |&(a, b): &(GridPoint, GridPoint)| (a.x <= p.x) != (b.x <= p.x) && (turn(a, b, p) < 0) == (a.x < b.x);
    edges.filter(above).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[(i32, i32)]) -> Ring {
        points.iter().map(|&(x, y)| GridPoint::new(x, y)).collect()
    }

    #[test]
    fn hull_drops_inner_and_straight_points() {
        let points = ring(&[(0, 0), (100, 0), (200, 0), (200, 200), (0, 200), (100, 100), (0, 0)]);
        assert_eq!(hull(points), ring(&[(0, 0), (200, 0), (200, 200), (0, 200)]));
    }

    #[test]
    fn area_and_points_inside() {
        let square = ring(&[(0, 0), (100_000, 0), (100_000, 100_000), (0, 100_000)]);
        assert!((area_mm2(&square) - 1.0).abs() < 1e-12);
        assert!(above_odd(edges(&square), GridPoint::new(5, 5)));
        assert!(!above_odd(edges(&square), GridPoint::new(5, 100_001)));
        assert!(is_sliver(&ring(&[(0, 0), (100_000, 0), (100_000, 1)])) && !is_sliver(&square));
    }
}
