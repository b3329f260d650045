//! Plunges with a blade where no turning tool could go.

use super::chain::{Chain, Run};
use super::link::{CLEARANCE_MM, go};
use super::path::Path;
use super::work::Limit;
use crate::geometry::{Point, Segment};

/// Stock lower than this over what the blade can reach is left to the pass along the contour, mm.
const WORTH_MM: f64 = 0.3;

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

/// Makes the plunges that nothing is in the way of.
pub(super) fn cut(path: &mut Path<'_>, plunges: &[f64], limit: &Limit) {
    for &z in plunges {
        let Some(bottom) = limit.chain.at(z) else { continue };
        let top = path.air(z, z, bottom).at(z).map_or(bottom, |r| r.max(bottom));
        let (above, below) = (Point::new(z, top + CLEARANCE_MM), Point::new(z, bottom));
        if path.blocked(&[Segment::line(above, below)]).is_none() {
            go(path, above);
            path.line(below);
            go(path, above);
        }
    }
}
