//! Two finishing passes with the right-hand tool from the free end to the clamped end.

use super::plan::{FINISHING_PASSES, Plan};
use crate::geometry::Segment;
use crate::turning::CutMove;

/// The moves of right-hand finishing, from the datum to the datum. Each pass begins on the axis, and the last one runs on
/// the contour itself; where the tool cannot go it follows the 45-degree line.
pub(super) fn finish_right(plan: &Plan) -> Vec<CutMove> {
    let contour: Vec<Segment> =
        plan.right.finished(&plan.surface).segments().iter().rev().map(Segment::reversed).collect();
    let Some(first_radius) = contour.first().map(|s| s.start().r) else { return Vec::new() };
    let depth = plan.finish_depth;
    let above = depth * f64::from(FINISHING_PASSES - 1);
    let (center_rpm, datum_rpm) = (plan.rpm(0.0), plan.rpm(plan.datum.r));
    let mut moves = plan.moves();
    moves.travel_z(plan.face_z(), datum_rpm);
    moves.travel_r(plan.allowance(), center_rpm);
    moves.repeat(FINISHING_PASSES, -depth, |moves| {
        moves.cut_r(above, center_rpm);
        moves.cut_r(first_radius + above, plan.rpm(first_radius));
        for segment in &contour {
            moves.cut_along(segment, above);
        }
        // At the feed of cutting: the leading edge takes a last sliver off the wall that the pass ended at.
        moves.cut_r(plan.datum.r, datum_rpm);
        moves.travel_z(plan.face_z(), datum_rpm);
        moves.travel_r(above, center_rpm);
    });
    moves.home();
    moves.done()
}
