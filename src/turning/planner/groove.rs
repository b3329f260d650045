//! Plunges with a blade where no turning tool could go.

use super::chain::{Chain, Run};
use super::link::{self, CLEARANCE_MM};
use super::path::Path;
use super::piece::SAME_MM;
use super::work::Limit;
use crate::geometry::Point;

/// Stock lower than this over what the blade can reach is left to the pass along the contour, mm.
const WORTH_MM: f64 = 0.3;

/// Walls lower than this are left to the pass along the contour, mm.
const SHORTEST_WALL_MM: f64 = 0.1;

/// A wall is cut if there is more stock than this at its foot, mm.
const LEAST_AT_WALL_MM: f64 = 0.005;

/// Width beside a wall in which stock is looked for, mm.
const BESIDE_WALL_MM: f64 = 0.1;

/// Plunges at most in one groove; a blade that needs more has no width.
const MOST_PLUNGES: u32 = 10_000;

/// Positions from right to left at which the blade plunges: half its width apart at most.
pub(super) fn plunges(limit: &Limit, touch: &Chain, width: f64) -> Vec<f64> {
    let mut runs: Vec<Run> = touch.clipped(limit.z0, limit.z1).runs_over(&limit.chain, WORTH_MM);
    runs.reverse();
    runs.iter().flat_map(|run| positions(*run, width / 2.0)).collect()
}

fn positions(run: Run, step: f64) -> impl Iterator<Item = f64> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_PLUNGES")]
    let count = (run.width() / step).ceil().clamp(1.0, f64::from(MOST_PLUNGES)) as u32;
    (0..=count).map(move |k| run.z1 - run.width() * f64::from(k) / f64::from(count))
}

/// The moves of the plunges.
pub(super) fn cut(path: &mut Path<'_>, plunges: &[f64], limit: &Limit, air: &Chain, ceiling: f64) {
    for &z in plunges {
        let (Some(bottom), Some(top)) = (limit.chain.at(z), air.at(z)) else { continue };
        let above = Point::new(z, top.max(bottom) + CLEARANCE_MM);
        link::link(path, above, air, ceiling);
        path.line(Point::new(z, bottom));
        path.rapid(above);
    }
}

/// The walls of grooves from right to left, each with the height of its foot: where the limit for the finished contour jumps,
/// with stock beside. A blade cuts them on its way down only; its sides do not cut on the way up.
pub(super) fn walls(limit: &Limit, touch: &Chain) -> Vec<Point> {
    let jumps = limit.chain.pieces.windows(2).map(|w| (w[0].right(), w[1].left()));
    let feet = jumps.filter(|(a, b)| (a.r - b.r).abs() > SHORTEST_WALL_MM).filter_map(|(a, b)| {
        // Stock on the open side of the wall.
        let (foot, stock) = if a.r < b.r {
            (a, touch.highest(a.z - BESIDE_WALL_MM, a.z - SAME_MM))
        } else {
            (b, touch.highest(b.z + SAME_MM, b.z + BESIDE_WALL_MM))
        };
        (stock > foot.r + LEAST_AT_WALL_MM).then_some(foot)
    });
    feet.rev().collect()
}

/// The moves down the walls.
pub(super) fn cut_walls(path: &mut Path<'_>, walls: &[Point], air: &Chain, ceiling: f64) {
    for &foot in walls {
        let above = Point::new(foot.z, air.at(foot.z).unwrap_or(foot.r).max(foot.r) + CLEARANCE_MM);
        link::link(path, above, air, ceiling);
        path.line(foot);
        path.rapid(above);
    }
}
