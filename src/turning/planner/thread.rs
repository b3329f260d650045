//! Where threads begin and end.

use super::chain::Chain;
use super::piece::{Piece, SAME_MM};
use super::tool::Cutter;
use super::work::Work;
use crate::diagnostic::{Diagnostic, Place};
use crate::machine::Machine;
use crate::part::ThreadSpec;
use crate::turning::CutMove;

/// Distance that the tool starts before the thread, in pitches, where the part leaves room: the slide must be up to speed
/// when the thread begins.
const RUN_IN_PITCHES: f64 = 1.0;

/// Longest chamfer or rounding at the thread's beginning, in pitches, that the point passes on its way in.
const LONGEST_LEAD_PITCHES: f64 = 2.0;

/// Where a thread is cut, on the planner's radii, mm.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reach {
    /// Where the tool starts.
    pub(super) start: f64,
    /// True if it goes down to the thread's depth there without cutting.
    pub(super) in_air: bool,
    /// Where the full depth ends.
    pub(super) to_z: f64,
    /// Length over which the thread runs out from there.
    pub(super) run_out: f64,
    /// What is to be said about it.
    pub(super) said: Option<Diagnostic>,
}

impl Reach {
    /// Finds where a thread begins and ends. Where no groove lets the tool out it runs out over `run_out` mm.
    pub(super) fn of(thread: &ThreadSpec, work: &Work, cutter: &Cutter, run_out: f64, row: Place) -> Self {
        let run_in = run_in(thread, work, cutter);
        let start = thread.z2 + run_in;
        let (end, said) = far_end(thread, work, cutter, start, row);
        let beside = work.part.highest(thread.z1 - thread.pitch / 2.0, thread.z1 - SAME_MM);
        let relieved = beside <= thread.base_radius + SAME_MM;
        let run_out = if relieved { 0.0 } else { run_out.min((thread.z2 - end) / 2.0).max(0.0) };
        Self { start, in_air: run_in > 0.0, to_z: end + run_out, run_out, said }
    }

    /// True if there is no thread to be cut.
    pub(super) fn is_empty(&self, thread: &ThreadSpec) -> bool {
        self.to_z >= thread.z2 - SAME_MM
    }
}

/// The thread by the control's own cycle, from the present point.
pub(super) fn cycle(thread: &ThreadSpec, reach: &Reach, machine: &Machine, depth_per_cut: f64) -> CutMove {
    CutMove::Thread {
        to_z: reach.to_z,
        outside_radius: thread.crest_radius,
        base_radius: thread.base_radius,
        pitch: thread.pitch,
        depth_per_cut,
        rpm: rpm(machine, thread.pitch),
    }
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
