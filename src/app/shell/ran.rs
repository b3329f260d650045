//! A run as the panels see it, on the simulated rig or on one behind a line.

use crate::spinning::control::{Phase, Plan};
use crate::spinning::run::{ActualPoint, Run, RunErrors};
use crate::transfer::rig::{RemoteEnd, RemoteRun, RigEvent};

/// A run on either rig.
#[derive(Debug)]
pub(super) enum Ran {
    Simulated(Box<Run>),
    OnLine(Box<RemoteRun>),
}

impl Ran {
    pub(super) fn plan(&self) -> &Plan {
        match self {
            Self::Simulated(run) => run.controller().plan(),
            Self::OnLine(run) => run.plan(),
        }
    }

    pub(super) fn actual(&self) -> &[ActualPoint] {
        match self {
            Self::Simulated(run) => run.actual(),
            Self::OnLine(run) => run.actual(),
        }
    }

    pub(super) fn errors(&self) -> RunErrors {
        RunErrors::of(self.plan(), self.actual())
    }

    pub(super) fn time_s(&self) -> f64 {
        match self {
            Self::Simulated(run) => run.time_s(),
            Self::OnLine(run) => run.time_s(),
        }
    }

    pub(super) fn carriage_mm(&self) -> f64 {
        match self {
            Self::Simulated(run) => run.rig().carriage_mm(),
            Self::OnLine(run) => run.carriage_mm(),
        }
    }

    pub(super) fn retreat_mm(&self) -> f64 {
        match self {
            Self::Simulated(run) => run.retreat_mm(),
            Self::OnLine(run) => run.retreat_mm(),
        }
    }

    pub(super) fn is_completed(&self) -> bool {
        match self {
            Self::Simulated(run) => matches!(run.controller().phase(), Phase::Completed),
            Self::OnLine(run) => run.end() == Some(&RemoteEnd::Completed),
        }
    }

    /// True while it goes on.
    pub(super) fn is_running(&self) -> bool {
        match self {
            Self::Simulated(run) => !run.is_over(),
            Self::OnLine(run) => run.end().is_none(),
        }
    }

    /// Takes what a rig behind a line tells.
    pub(super) fn take(&mut self, event: &RigEvent) {
        if let Self::OnLine(run) = self {
            run.take(event);
        }
    }

    /// How it ended.
    pub(super) fn verdict(&self) -> String {
        let stopped = |reason: &dyn std::fmt::Display, drawn_back: bool| {
            let how = if drawn_back { "" } else { ", roller not drawn back" };
            format!("stopped{how}: {reason}")
        };
        match self {
            Self::Simulated(run) => match run.controller().phase() {
                Phase::Completed => "completed".to_owned(),
                Phase::Stopped { reason, drawn_back } => stopped(reason, *drawn_back),
                _ => "running".to_owned(),
            },
            Self::OnLine(run) => match run.end() {
                None => "running".to_owned(),
                Some(RemoteEnd::Completed) => "completed".to_owned(),
                Some(RemoteEnd::Stopped { reason, drawn_back }) => stopped(reason, *drawn_back),
                Some(RemoteEnd::Lost(reason)) => format!("lost: {reason}"),
            },
        }
    }

    /// Where it is, in few words.
    pub(super) fn phase(&self) -> &'static str {
        match self {
            Self::Simulated(run) => of_phase(run.controller().phase()),
            Self::OnLine(run) if matches!(run.end(), Some(RemoteEnd::Lost(_))) => "line lost",
            Self::OnLine(run) => of_state(run.state()),
        }
    }
}

const fn of_phase(phase: &Phase) -> &'static str {
    match phase {
        Phase::ToDatum => "to the datum",
        Phase::Advance => "roller advances",
        Phase::RunUp => "carriage to the tip",
        Phase::Follow => "follows the contour",
        Phase::Retract => "roller back",
        Phase::Settle => "leadscrew settles",
        Phase::Completed => "completed",
        Phase::Stopping(_) => "stopping",
        Phase::Stopped { .. } => "stopped",
    }
}

/// Of the state letter on the line.
const fn of_state(state: char) -> &'static str {
    match state {
        'T' => "to the datum",
        'A' => "roller advances",
        'U' => "carriage to the tip",
        'F' => "follows the contour",
        'R' => "roller back",
        'W' => "leadscrew settles",
        'C' => "completed",
        'X' => "stopping",
        'D' | 'N' => "stopped",
        _ => "table is sent",
    }
}
