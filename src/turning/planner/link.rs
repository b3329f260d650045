//! Ways through air.

use super::chain::Chain;
use super::path::Path;
use super::piece::{Piece, SAME_MM};
use crate::geometry::Point;

/// Height that a tool keeps above the stock on its way, mm.
pub(super) const CLEARANCE_MM: f64 = 0.5;

/// How much a tool leans away from the wall that it cut when it goes straight out: more than its edge does, which leaves
/// slivers on the wall that a rapid move must not touch.
pub(super) const LEAN: f64 = 0.12;

/// How far a way may go below what counts as free, mm: rounding, for ways begin and end on cut surfaces.
const TOUCH_MM: f64 = 1e-6;

/// Goes to `to` through air. `air` is the lowest free place of the programmed point at every z, `ceiling` a height that is
/// free everywhere.
pub(super) fn link(path: &mut Path<'_>, to: Point, air: &Chain, ceiling: f64) {
    for way in ways(path.at, to, air, ceiling) {
        let corners: Vec<Point> = [path.at].into_iter().chain(way.iter().copied()).collect();
        if corners.windows(2).all(|w| is_free(w[0], w[1], air)) {
            for place in way {
                path.rapid(place);
            }
            return;
        }
    }
    // Nothing shorter is free: over everything.
    path.rapid(Point::new(path.at.z, ceiling));
    path.rapid(Point::new(to.z, ceiling));
    path.rapid(to);
}

/// Ways in order of blocks: straight, round one corner, over what lies between.
fn ways(from: Point, to: Point, air: &Chain, ceiling: f64) -> [Vec<Point>; 6] {
    let (low, high) = (from.z.min(to.z), from.z.max(to.z));
    let over = (air.highest(low, high) + CLEARANCE_MM).max(from.r).max(to.r).min(ceiling.max(from.r).max(to.r));
    let leaning = |r: f64| Point::new(from.z + LEAN * (r - from.r).max(0.0), r);
    [
        vec![to],
        vec![leaning(to.r), to],
        vec![Point::new(to.z, from.r), to],
        vec![leaning(over), Point::new(to.z, over), to],
        vec![Point::new(from.z, to.r), to],
        vec![Point::new(from.z, over), Point::new(to.z, over), to],
    ]
}

/// True if the straight way between two points stays on or above `air`.
pub(super) fn is_free(from: Point, to: Point, air: &Chain) -> bool {
    if (from.z - to.z).abs() <= SAME_MM {
        // Beside a wall the lower side counts: the tool may touch it.
        let here = air.over(from.z - 2.0 * SAME_MM, from.z + 2.0 * SAME_MM).map(|p| p.at(from.z.clamp(p.z0, p.z1)));
        return here.fold(f64::INFINITY, f64::min) <= from.r.min(to.r) + TOUCH_MM || air.at(from.z).is_none();
    }
    let (a, b) = if from.z < to.z { (from, to) } else { (to, from) };
    let way = Chain { pieces: vec![Piece::line(a, b)] };
    air.clipped(a.z + TOUCH_MM, b.z - TOUCH_MM).runs_over(&way, TOUCH_MM).iter().all(|r| r.width() <= TOUCH_MM)
}
