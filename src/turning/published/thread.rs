//! Threads by the control's own cycle.

use super::plan::Plan;
use super::span::SAME_MM;
use crate::part::ThreadSpec;
use crate::turning::CutMove;

/// Distance that the tool starts before the thread, in pitches, where the part leaves room: the slide must be up to speed
/// when the thread begins.
const RUN_IN_PITCHES: f64 = 1.0;

/// Longest chamfer or rounding at the thread's beginning, in pitches, that the point passes on its way in.
const LONGEST_LEAD_PITCHES: f64 = 2.0;

/// The moves of all threads; none without threads.
pub(super) fn cut_threads(plan: &Plan, threads: &[ThreadSpec]) -> Vec<CutMove> {
    let mut moves = plan.moves();
    let mut last_rpm = None;
    for thread in threads {
        let rpm = rpm(plan, thread.pitch);
        moves.travel_z(thread.z2 + run_in(plan, thread), rpm);
        moves.travel_r(thread.crest_radius + plan.machine.datum.radial_clearance_mm, rpm);
        moves.push(CutMove::Thread {
            to_z: thread.z1,
            outside_radius: thread.crest_radius,
            base_radius: thread.base_radius,
            pitch: thread.pitch,
            depth_per_cut: plan.material.depth_thread,
            rpm,
        });
        moves.travel_r(plan.datum.r, rpm);
        last_rpm = Some(rpm);
    }
    let Some(rpm) = last_rpm else { return Vec::new() };
    moves.travel_z(plan.datum.z, rpm);
    moves.done()
}

/// Speed for a pitch: the machine's feed for threads, never above its highest speed or its highest feed.
fn rpm(plan: &Plan, pitch: f64) -> f64 {
    let limits = &plan.machine.limits;
    let feed = plan.machine.spindle.thread_feed_mm_per_min.min(limits.feed_max_mm_per_min);
    (feed / pitch).min(limits.spindle_max_rpm)
}

/// Distance before the thread at which the tool starts: over a chamfer or the like into the open, and the run-in from there;
/// none if the part beside the thread is thicker than the thread's base.
fn run_in(plan: &Plan, thread: &ThreadSpec) -> f64 {
    let length = thread.pitch * RUN_IN_PITCHES;
    let lead_end = thread.z2 + thread.pitch * LONGEST_LEAD_PITCHES;
    let beside = plan.surface.clipped(thread.z2, lead_end + length);
    let open = beside.runs_below(thread.base_radius + SAME_MM);
    let free_end = std::iter::once(plan.face_z()).filter(|&face| face <= lead_end);
    let starts = open.iter().filter(|run| run.z1 - run.z0 >= length - SAME_MM || run.z1 >= plan.face_z() - SAME_MM);
    let nearest = starts.map(|run| run.z0).chain(free_end).filter(|&z| z <= lead_end).fold(f64::INFINITY, f64::min);
    let over = plan.surface.clipped(thread.z2, nearest.min(lead_end)).largest_radius();
    if nearest.is_finite() && over <= thread.crest_radius + SAME_MM { nearest - thread.z2 + length } else { 0.0 }
}
