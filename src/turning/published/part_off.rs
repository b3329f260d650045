//! Parting off with the blade, whose programmed point is its corner towards the chuck.

use super::plan::Plan;
use crate::turning::CutMove;

/// Height above the material at which the feed of parting off begins and ends, mm.
const CLEARANCE_MM: f64 = 0.5;

/// The moves of parting off in the groove that begins at `groove_z` and is `width` wide.
pub(super) fn part_off(plan: &Plan, groove_z: f64, width: f64) -> Vec<CutMove> {
    let outside = plan.surface.clipped(groove_z, groove_z + width).largest_radius().max(plan.bar_radius) + CLEARANCE_MM;
    let (rpm, feed) = (plan.rpm(outside), plan.material.feed_part_off);
    let mut moves = plan.moves();
    moves.travel_z(groove_z, rpm);
    moves.travel_r(outside, rpm);
    moves.feed_r(0.0, feed, rpm);
    moves.feed_r(outside, feed, rpm);
    moves.travel_r(plan.datum.r, rpm);
    moves.travel_z(plan.datum.z, rpm);
    moves.done()
}
