//! Threads.

use super::chain::Chain;
use super::link;
use super::path::Path;
use super::piece::{Piece, SAME_MM};
use super::tool::Cutter;
use super::work::Work;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::Point;
use crate::machine::Machine;
use crate::part::ThreadSpec;
use crate::turning::CutMove;

/// Distance that the tool starts before the thread, in pitches, where the part leaves room: the slide must be up to speed
/// when the thread begins.
const RUN_IN_PITCHES: f64 = 1.0;

/// Longest chamfer or rounding at the thread's beginning, in pitches, that the point passes on its way in.
const LONGEST_LEAD_PITCHES: f64 = 2.0;

/// The moves of one thread by the control's own cycle, and what is to be said about it.
#[allow(
    clippy::too_many_arguments,
    reason = "a thread is cut from the part, the tool, the machine and the path so far"
)]
pub(super) fn cut(
    path: &mut Path<'_>,
    thread: &ThreadSpec,
    work: &Work,
    cutter: &Cutter,
    machine: &Machine,
    depth_per_cut: f64,
    ceiling: f64,
    row: Place,
) -> Option<Diagnostic> {
    let start = thread.z2 + run_in(thread, work, cutter);
    let (to_z, said) = far_end(thread, work, cutter, start, row);
    if to_z >= thread.z2 - SAME_MM {
        return said;
    }
    let clear = Point::new(start, thread.crest_radius + machine.datum.radial_clearance_mm);
    link::link(path, clear, &work.air(cutter), ceiling);
    path.push(CutMove::Thread {
        to_z,
        outside_radius: thread.crest_radius,
        base_radius: thread.base_radius,
        pitch: thread.pitch,
        depth_per_cut,
        rpm: rpm(machine, thread.pitch),
    });
    said
}

/// Speed for a pitch: the machine's feed for threads, never above its highest speed or its highest feed.
fn rpm(machine: &Machine, pitch: f64) -> f64 {
    let feed = machine.spindle.thread_feed_mm_per_min.min(machine.limits.feed_max_mm_per_min);
    (feed / pitch).min(machine.limits.spindle_max_rpm)
}

/// How low the point may go if the thread's groove is not counted as part.
fn limit(thread: &ThreadSpec, work: &Work, cutter: &Cutter) -> Chain {
    let lead = thread.z2 + LONGEST_LEAD_PITCHES * thread.pitch;
    let beside = work.part.clipped(f64::NEG_INFINITY, thread.z1).max(&work.part.clipped(lead, f64::INFINITY));
    let base = Chain { pieces: vec![Piece::level(thread.z1, lead, 0.0)] };
    let low = work.part.clipped(thread.z1, lead).min(&base);
    cutter.body.over(&beside.max(&low).max(&work.jaws))
}

/// Where the thread ends: its own end, or before it where the tool would run into what stands beside it.
fn far_end(thread: &ThreadSpec, work: &Work, cutter: &Cutter, start: f64, row: Place) -> (f64, Option<Diagnostic>) {
    let limit = limit(thread, work, cutter).clipped(thread.z1, start);
    let free = |runs: Vec<super::chain::Run>| runs.last().filter(|r| r.z1 >= start - 1e-6).map(|r| r.z0);
    let end = free(limit.runs_below(thread.base_radius + SAME_MM)).unwrap_or(start).max(thread.z1);
    let short = end - thread.z1;
    if short <= thread.pitch {
        return (end, None);
    }
    let message = format!(
        "The thread of {:.3} mm pitch ends {short:.3} mm before its row does: the tool would run into the part beside it; {:.3} mm is allowed.",
        thread.pitch, thread.pitch
    );
    let said = Diagnostic::warning("thread-short", row, message).with_hint("Add a relief groove beside the thread.");
    (end, Some(said))
}

/// Distance before the thread at which the tool starts: over a chamfer or the like into the open, and the run-in from there;
/// none if the part beside the thread is thicker than the thread's base.
fn run_in(thread: &ThreadSpec, work: &Work, cutter: &Cutter) -> f64 {
    let length = thread.pitch * RUN_IN_PITCHES;
    let lead_end = thread.z2 + thread.pitch * LONGEST_LEAD_PITCHES;
    let limit = limit(thread, work, cutter);
    let free_end = (work.face_z <= lead_end).then_some(work.face_z);
    let open = work.part.clipped(thread.z2, lead_end + length).runs_below(thread.base_radius + SAME_MM);
    let starts = open.iter().filter(|run| run.width() >= length - SAME_MM || run.z1 >= work.face_z - SAME_MM);
    let nearest = starts.map(|run| run.z0).chain(free_end).filter(|&z| z <= lead_end).fold(f64::INFINITY, f64::min);
    let over = work.part.highest(thread.z2, nearest.min(lead_end));
    let reach = nearest - thread.z2 + length;
    let fits = limit.highest(thread.z2, thread.z2 + reach.min(lead_end)) <= thread.base_radius + 1e-6;
    if nearest.is_finite() && over <= thread.crest_radius + SAME_MM && fits { reach } else { 0.0 }
}
