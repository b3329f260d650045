//! Roughing and finishing with the left-hand tool, which cuts away from the chuck what the right-hand tool leaves.
//!
//! Areas are cut in order of z. Roughing takes the same levels as the right-hand tool; behind a wall on its own side the
//! left-hand tool needs the same room, so what neither tool reaches stays.

use super::envelope::Shadow;
use super::plan::{FINISHING_PASSES, Moves, Plan};
use super::surface::{Run, Surface};
use crate::geometry::{Point, Segment};
use crate::turning::CutMove;

/// The moves of left-hand roughing; none if there is nothing to cut.
pub(super) fn rough_left(plan: &Plan) -> Vec<CutMove> {
    let left_over = plan.left.mirrored_surface().raised(plan.allowance());
    let mut moves = plan.moves();
    let mut last_rpm = None;
    for area in plan.left_areas() {
        for (level, run) in strokes(plan, area, &left_over) {
            cut(plan, &mut moves, level, run);
            last_rpm = Some(plan.rpm(level));
        }
    }
    let Some(rpm) = last_rpm else { return Vec::new() };
    moves.travel_z(plan.datum.z, rpm);
    moves.done()
}

/// Strokes of one area from the highest level down: where the surface is not above the level and the right-hand tool's
/// 45-degree line is.
fn strokes(plan: &Plan, area: &Shadow, left_over: &Surface) -> Vec<(f64, Run)> {
    let within = left_over.clipped(area.z0, area.z1);
    let top = area.z1 + area.k + plan.allowance();
    let levels = (0..).map(|k| plan.level(k)).take_while(|&level| level > 0.0).filter(|&level| level < top);
    let strokes = levels.flat_map(|level| {
        let line_z = level - plan.allowance() - area.k;
        within.clipped(line_z, area.z1).runs_below(level).into_iter().map(move |run| (level, run))
    });
    strokes.collect()
}

fn cut(plan: &Plan, moves: &mut Moves, level: f64, run: Run) {
    let rpm = plan.rpm(level);
    moves.travel_z(run.z0, rpm);
    moves.cut_r(level, rpm);
    moves.cut_z(run.z1, rpm);
    moves.travel_z(run.z0, rpm);
    moves.travel_r(plan.datum.r, rpm);
}

/// The moves of left-hand finishing; none if there is nothing to cut. Every pass goes over all areas.
pub(super) fn finish_left(plan: &Plan) -> Vec<CutMove> {
    let areas: Vec<Vec<Segment>> = plan.left_areas().map(|a| contour(plan, a)).filter(|c| !c.is_empty()).collect();
    let Some(first) = areas.first().and_then(|a| a.first()).map(Segment::start) else { return Vec::new() };
    let depth = plan.finish_depth;
    let above = depth * f64::from(FINISHING_PASSES - 1);
    let datum_rpm = plan.rpm(plan.datum.r);
    let mut moves = plan.moves();
    moves.travel_z(first.z, datum_rpm);
    moves.travel_r(first.r + plan.allowance(), plan.rpm(first.r));
    moves.repeat(FINISHING_PASSES, -depth, |moves| {
        moves.cut_r(first.r + above, plan.rpm(first.r));
        for (k, area) in areas.iter().enumerate() {
            if k > 0 {
                approach(plan, moves, area, above);
            }
            for segment in area {
                moves.cut_along(segment, above);
            }
            // At the feed of cutting, as on the right.
            moves.cut_r(plan.datum.r, datum_rpm);
        }
        moves.travel_z(first.z, datum_rpm);
        moves.travel_r(first.r + above, plan.rpm(first.r));
    });
    moves.home();
    moves.done()
}

/// From the datum's radius down to the start of an area, where roughing has left the depth of this pass.
fn approach(plan: &Plan, moves: &mut Moves, area: &[Segment], above: f64) {
    let Some(start) = area.first().map(Segment::start) else { return };
    moves.travel_z(start.z, plan.rpm(plan.datum.r));
    moves.cut_r(start.r + above, plan.rpm(start.r));
}

/// The contour of an area from left to right, up to the corner of the wall that hides it.
fn contour(plan: &Plan, area: &Shadow) -> Vec<Segment> {
    /// A wall lower than this above the area's last point is none, mm: half of the control's smallest step.
    const LOWEST_WALL_MM: f64 = 0.0005;
    let finished = plan.left.finished(&plan.surface.mirrored()).mirrored();
    let mut segments = finished.clipped(area.z0, area.z1).segments();
    let corner = Point::new(area.z1, area.z1 + area.k);
    if let Some(end) = segments.last().map(Segment::end)
        && corner.r - end.r >= LOWEST_WALL_MM
    {
        segments.push(Segment::line(end, corner));
    }
    segments
}
