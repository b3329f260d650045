//! The integer grid of the stock: points, rings, convex hulls and exact tests on them.
//!
//! One unit is 10 nm. Everything that is cut lies on this grid, so a tool that goes back over its own path finds exactly
//! the surface that it left, and nothing drifts however often the stock is cut.

use crate::geometry::Point;
use i_overlay::i_float::int::point::IntPoint;

/// A point of the grid; `x` is along z, `y` along r.
pub(in crate::proof) type GridPoint = IntPoint<i32>;
/// A closed ring; material lies to the left.
pub(in crate::proof) type Ring = Vec<GridPoint>;

/// Grid units in one mm.
const UNITS_PER_MM: f64 = 100_000.0;
/// Positions beyond this, mm, are taken as being there; it is far outside any lathe of this size and keeps sums of
/// positions and tool outlines inside the range of the polygon engine (10.7 m).
const FARTHEST_MM: f64 = 4_000.0;
/// Rings closer than this to one another, grid units, only touch: rounding moves a crossing by less than one unit.
const TOUCH: f64 = 3.0;

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
    ring.iter().copied().zip(ring.iter().copied().cycle().skip(1))
}

/// Area inside a ring, mm², negative if it runs clockwise.
pub(super) fn area_mm2(ring: &[GridPoint]) -> f64 {
    let Some(&first) = ring.first() else { return 0.0 };
    let doubled: f64 = ring.windows(2).map(|w| turn(first, w[0], w[1]) as f64).sum();
    doubled / 2.0 / (UNITS_PER_MM * UNITS_PER_MM)
}

/// Way around a ring, mm.
pub(super) fn around_mm(ring: &[GridPoint]) -> f64 {
    edges(ring).map(|(a, b)| length(a, b)).sum::<f64>() / UNITS_PER_MM
}

/// True if a ring is as thin as the rounding of the grid, so that it is no material.
pub(super) fn is_sliver(ring: &[GridPoint]) -> bool {
    area_mm2(ring).abs() * UNITS_PER_MM < TOUCH * around_mm(ring)
}

fn length(a: GridPoint, b: GridPoint) -> f64 {
    (f64::from(b.x) - f64::from(a.x)).hypot(f64::from(b.y) - f64::from(a.y))
}

/// A rectangle on the grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Window {
    /// Corner with the smallest coordinates.
    pub min: GridPoint,
    /// Corner with the largest coordinates.
    pub max: GridPoint,
}

impl Window {
    /// The rectangle around points; one at the origin without any.
    pub(super) fn around(points: &[GridPoint]) -> Self {
        let first = points.first().copied().unwrap_or(GridPoint::ZERO);
        points.iter().fold(Self { min: first, max: first }, |w, p| Self {
            min: GridPoint::new(w.min.x.min(p.x), w.min.y.min(p.y)),
            max: GridPoint::new(w.max.x.max(p.x), w.max.y.max(p.y)),
        })
    }

    /// True if the edge's own rectangle shares a point with this one.
    pub(super) fn meets_edge(&self, a: GridPoint, b: GridPoint) -> bool {
        a.x.min(b.x) <= self.max.x
            && a.x.max(b.x) >= self.min.x
            && a.y.min(b.y) <= self.max.y
            && a.y.max(b.y) >= self.min.y
    }

    /// The rectangle around both.
    pub(super) fn union(self, other: Self) -> Self {
        Self::around(&[self.min, self.max, other.min, other.max])
    }

    /// True if the rectangles share a point.
    pub(super) fn meets(&self, other: &Self) -> bool {
        self.meets_edge(other.min, other.max)
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

/// True if material of `rings` lies inside the convex ring `hull` by more than the rounding of the grid.
pub(super) fn overlaps(hull: &[GridPoint], rings: &[Ring]) -> bool {
    if hull.len() < 3 {
        return false;
    }
    let window = Window::around(hull);
    let enters = |&(a, b): &(GridPoint, GridPoint)| window.meets_edge(a, b) && enters_hull(a, b, hull);
    rings.iter().any(|ring| edges(ring).any(|edge| enters(&edge))) || contains(rings, inner_point(hull))
}

/// True if the edge passes through the inside of the convex ring: no side of the ring and not the edge itself separates them.
fn enters_hull(a: GridPoint, b: GridPoint, hull: &[GridPoint]) -> bool {
    let outside = |from, to, p| turn(from, to, p) as f64 <= TOUCH * length(from, to);
    if edges(hull).any(|(from, to)| outside(from, to, a) && outside(from, to, b)) {
        return false;
    }
    let reach = TOUCH * length(a, b);
    let (left, right) = hull.iter().fold((false, false), |(left, right), &p| {
        let side = turn(a, b, p) as f64;
        (left || side > reach, right || side < -reach)
    });
    left && right
}

fn inner_point(hull: &[GridPoint]) -> GridPoint {
    let count = i64::try_from(hull.len()).unwrap_or(1).max(1);
    let mean = |sum: i64| i32::try_from(sum / count).unwrap_or(0);
    GridPoint::new(mean(hull.iter().map(|p| i64::from(p.x)).sum()), mean(hull.iter().map(|p| i64::from(p.y)).sum()))
}

/// True if the point lies in the material (an odd number of ring edges lies above it).
pub(super) fn contains(rings: &[Ring], p: GridPoint) -> bool {
    above_odd(rings.iter().flat_map(|ring| edges(ring)), p)
}

/// True if an odd number of edges lies above the point.
pub(in crate::proof) fn above_odd(edges: impl Iterator<Item = (GridPoint, GridPoint)>, p: GridPoint) -> bool {
    let above = |&(a, b): &(GridPoint, GridPoint)| (a.x <= p.x) != (b.x <= p.x) && (turn(a, b, p) < 0) == (a.x < b.x);
    edges.filter(above).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn ring(points: &[(i32, i32)]) -> Ring {
        points.iter().map(|&(x, y)| GridPoint::new(x, y)).collect()
    }

    #[test]
    fn hull_drops_inner_and_straight_points() {
        let points = ring(&[(0, 0), (100, 0), (200, 0), (200, 200), (0, 200), (100, 100), (0, 0)]);
        assert_eq!(hull(points), ring(&[(0, 0), (200, 0), (200, 200), (0, 200)]));
    }

    #[test]
    fn touching_is_no_overlap_but_entering_is() {
        let hull = ring(&[(0, 0), (1000, 0), (1000, 1000), (0, 1000)]);
        let beside = vec![ring(&[(1000, -500), (2000, -500), (2000, 1500), (1000, 1500)])];
        let into = vec![ring(&[(990, -500), (2000, -500), (2000, 1500), (990, 1500)])];
        let around = vec![ring(&[(-9000, -9000), (9000, -9000), (9000, 9000), (-9000, 9000)])];
        let inside = vec![ring(&[(400, 400), (600, 400), (500, 600)])];
        assert!(!overlaps(&hull, &beside));
        assert!(overlaps(&hull, &into) && overlaps(&hull, &around) && overlaps(&hull, &inside));
        assert!(!overlaps(&hull, &[]));
    }

    #[test]
    fn area_and_points_inside() {
        let square = ring(&[(0, 0), (100_000, 0), (100_000, 100_000), (0, 100_000)]);
        assert!((area_mm2(&square) - 1.0).abs() < 1e-12);
        assert!(contains(std::slice::from_ref(&square), GridPoint::new(5, 5)));
        assert!(!contains(std::slice::from_ref(&square), GridPoint::new(5, 100_001)));
        assert!(is_sliver(&ring(&[(0, 0), (100_000, 0), (100_000, 1)])) && !is_sliver(&square));
    }
}
