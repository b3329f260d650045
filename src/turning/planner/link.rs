//! Ways through air.

use super::chain::Chain;
use super::path::Path;
use super::piece::{Piece, SAME_MM};
use super::work::AIR_MM;
use crate::geometry::{Point, Vector};
use std::cell::LazyCell;

/// Height that a tool keeps above the stock on its way, mm.
pub(super) const CLEARANCE_MM: f64 = 0.5;

/// How much a tool leans away from the wall that it cut when it goes straight out: more than its edge does, which leaves
/// slivers on the wall that a rapid move must not touch.
pub(super) const LEAN: f64 = 0.12;

/// How far a way may go below what counts as free, mm: rounding, for ways begin and end on cut surfaces.
const TOUCH_MM: f64 = 1e-6;

/// Distance that ways keep from what they pass, mm: two roundings of a control's smallest step, and as much again.
const BESIDE_MM: f64 = 0.003;

/// Where a way begins the tool may still touch what it cut; from here on it keeps its distance, mm.
const LEAVING_MM: f64 = 0.3;

/// A rising way rises by so much more than a control's limit of tapers asks: its ends are rounded.
const TAPER_KEPT: f64 = 1.02;

/// Ways that leave an axis by less than this are parallel to it, mm: below half of a control's smallest step.
const AXIS_PARALLEL_MM: f64 = 0.0004;

/// Goes to `to` through air. If there is no air it goes at the feed of cutting.
pub(super) fn go(path: &mut Path<'_>, to: Point) {
    let from = path.at;
    let (low, high) = (from.z.min(to.z), from.z.max(to.z));
    let lean = LEAN * (path.ceiling - from.r).max(0.0);
    let (z0, z1, above) = (low - BESIDE_MM, high + path.lean(lean) + BESIDE_MM, from.r.min(to.r) - BESIDE_MM);
    let air = path.air(z0, z1, above);
    let here = LazyCell::new(|| path.air_here(z0, z1, above));
    let leaves = |to: Point| {
        let hanging = || path.has_hanging(from.z.min(to.z) - BESIDE_MM, from.z.max(to.z) + BESIDE_MM);
        leaves(path, to, &air) || (hanging() && leaves(path, to, &here))
    };
    let found = ways(from, to, &air, lean, path.taper).into_iter().find(|way| all_clear(path, way, &air, leaves));
    let Some(way) = found else {
        return over_everything(path, to, &air);
    };
    for place in way {
        path.rapid(place);
    }
}

/// Ways in order of blocks: straight, round one corner, over what lies between. Where a way rises along z it rises by as much
/// as the control's `taper` asks.
fn ways(from: Point, to: Point, air: &Chain, lean: f64, taper: f64) -> [Vec<Point>; 7] {
    let (low, high) = (from.z.min(to.z), from.z.max(to.z));
    let over = (air.highest(low, high) + CLEARANCE_MM).max(from.r).max(to.r);
    let rising = over.max(from.r + TAPER_KEPT * (high - low) / taper);
    let leaning = |r: f64| Point::new(from.z + (LEAN * (r - from.r)).clamp(0.0, lean), r);
    [
        vec![to],
        vec![leaning(to.r), to],
        vec![Point::new(to.z, from.r), to],
        vec![Point::new(to.z, rising), to],
        vec![leaning(over), Point::new(to.z, over), to],
        vec![Point::new(from.z, to.r), to],
        vec![Point::new(from.z, over), Point::new(to.z, over), to],
    ]
}

/// True if a control with this limit of tapers can go straight between two points.
fn can_go(from: Point, to: Point, taper: f64) -> bool {
    let (dz, dr) = ((to.z - from.z).abs(), (to.r - from.r).abs());
    let least = dz.min(dr);
    least <= AXIS_PARALLEL_MM || dz.max(dr) < least * taper
}

/// True if a way is free, the first part of which `leaves` the place where the tool is.
fn all_clear(path: &Path<'_>, way: &[Point], air: &Chain, leaves: impl Fn(Point) -> bool) -> bool {
    let corners: Vec<Point> = std::iter::once(path.at).chain(way.iter().copied()).collect();
    corners.windows(2).enumerate().all(|(k, w)| {
        if !can_go(w[0], w[1], path.taper) {
            return false;
        }
        if k == 0 { leaves(w[1]) } else { is_free(w[0], w[1], air) && is_apart(w[0], w[1], air, false) }
    })
}

/// True if the tool can leave the place where it is straight to `to`.
pub(super) fn leaves(path: &Path<'_>, to: Point, here: &Chain) -> bool {
    let from = path.at;
    // Straight out nothing can come nearer but what hangs over.
    let out = from.z == to.z && to.r >= from.r;
    (out || (is_free(from, to, here) && is_apart(from, to, here, true))) && !path.hangs_over(to)
}

/// True if the way keeps its distance from what it passes, but for where the tool leaves a cut surface.
fn is_apart(from: Point, to: Point, air: &Chain, leaves: bool) -> bool {
    let length = from.distance(to);
    if leaves && length <= LEAVING_MM {
        return true;
    }
    let start = if leaves { from + (to - from) * (LEAVING_MM / length) } else { from };
    [-BESIDE_MM, BESIDE_MM].into_iter().all(|dz| {
        let beside = Vector::new(dz, -BESIDE_MM);
        is_free(start + beside, to + beside, air)
    })
}

/// Up, along above everything, and down again as far as there is air; from there at the feed of cutting.
fn over_everything(path: &mut Path<'_>, to: Point, air: &Chain) {
    let top = air.highest(f64::NEG_INFINITY, f64::INFINITY) + CLEARANCE_MM;
    let height = path.ceiling.max(top).max(path.at.r).max(to.r);
    let up = Point::new(path.at.z, height);
    if path.hangs_over(up) {
        let near = air.highest(path.at.z - AIR_MM, path.at.z + AIR_MM) + CLEARANCE_MM;
        path.line(Point::new(path.at.z, near.max(path.at.r)));
    }
    path.rapid(up);
    path.rapid(Point::new(to.z, height));
    let low = air.highest(to.z - BESIDE_MM, to.z + BESIDE_MM).max(to.r);
    path.rapid(Point::new(to.z, if low > to.r { low + CLEARANCE_MM } else { to.r }));
    path.line(to);
}

/// True if the straight way between two points stays on or above `air`.
pub(super) fn is_free(from: Point, to: Point, air: &Chain) -> bool {
    if air.pieces.is_empty() {
        return true;
    }
    if (from.z - to.z).abs() <= SAME_MM {
        // Beside a wall the lower side counts: the tool may touch it.
        let sides = [-2.0 * SAME_MM, 2.0 * SAME_MM].map(|dz| air.at(from.z + dz).unwrap_or(f64::NEG_INFINITY));
        return sides[0].min(sides[1]) <= from.r.min(to.r) + TOUCH_MM;
    }
    let (a, b) = if from.z < to.z { (from, to) } else { (to, from) };
    let way = Chain { pieces: vec![Piece::line(a, b)] };
    air.clipped(a.z + TOUCH_MM, b.z - TOUCH_MM).runs_over(&way, TOUCH_MM).iter().all(|r| r.width() <= TOUCH_MM)
}
