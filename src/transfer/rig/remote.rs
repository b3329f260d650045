//! A run on a rig behind a line, as far as the rig tells of it.

use super::host::Position;
use super::line::RigEvent;
use crate::spinning::control::Plan;
use crate::spinning::published::{MM_PER_PULSE, MM_PER_STEP};
use crate::spinning::run::{ActualPoint, RunErrors};

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RemoteEnd {
    /// As planned.
    Completed,
    /// Stopped.
    Stopped {
        /// Why, as a sentence.
        reason: String,
        /// The roller has reached its datum.
        drawn_back: bool,
    },
    /// The rig cannot be reached any more; a sentence.
    Lost(String),
}

/// A run with what the rig told of it.
#[derive(Debug, Clone)]
pub struct RemoteRun {
    plan: Plan,
    latest: Option<Position>,
    actual: Vec<ActualPoint>,
    end: Option<RemoteEnd>,
}

impl RemoteRun {
    /// A run of which nothing is known yet.
    #[must_use]
    pub const fn new(plan: Plan) -> Self {
        Self { plan, latest: None, actual: Vec::new(), end: None }
    }

    /// Takes what the rig tells.
    pub fn take(&mut self, event: &RigEvent) {
        match event {
            RigEvent::At(at) => self.at(*at),
            RigEvent::Completed => self.end = Some(RemoteEnd::Completed),
            RigEvent::Stopped { reason, drawn_back } => {
                self.end = Some(RemoteEnd::Stopped { reason: reason.clone(), drawn_back: *drawn_back });
            }
            RigEvent::Lost(reason) => self.end = Some(RemoteEnd::Lost(reason.clone())),
            RigEvent::Ready(_) | RigEvent::AtDatum => {}
        }
    }

    fn at(&mut self, at: Position) {
        self.latest = Some(at);
        if at.state != 'F' {
            return;
        }
        let passed = self.plan.targets.partition_point(|t| t.pulses <= at.pulses);
        let driven = passed.checked_sub(1).and_then(|i| self.plan.targets.get(i)).map_or(0, |t| t.steps);
        let point = ActualPoint {
            time_s: self.time_s(),
            carriage_mm: self.carriage_mm(),
            retreat_mm: self.retreat_mm(),
            driven_mm: f64::from(driven) * MM_PER_STEP,
        };
        let same = |last: &ActualPoint| (last.carriage_mm, last.retreat_mm) == (point.carriage_mm, point.retreat_mm);
        if !self.actual.last().is_some_and(same) {
            self.actual.push(point);
        }
    }

    /// What the run is to do.
    #[must_use]
    pub const fn plan(&self) -> &Plan {
        &self.plan
    }

    /// How it ended; `None` while it goes on.
    #[must_use]
    pub const fn end(&self) -> Option<&RemoteEnd> {
        self.end.as_ref()
    }

    /// The newest state letter; a blank before the first.
    #[must_use]
    pub fn state(&self) -> char {
        self.latest.map_or(' ', |at| at.state)
    }

    /// The rig's time since the run began, s.
    #[must_use]
    pub fn time_s(&self) -> f64 {
        self.latest.map_or(0.0, |at| at.ms as f64 / 1000.0)
    }

    /// Carriage travel past the tip as counted, mm.
    #[must_use]
    pub fn carriage_mm(&self) -> f64 {
        self.latest.filter(|at| at.state != 'U').map_or(0.0, |at| f64::from(at.pulses) * MM_PER_PULSE)
    }

    /// Distance of the roller from its start, away from the axis, as read, mm.
    #[must_use]
    pub fn retreat_mm(&self) -> f64 {
        self.latest.map_or(0.0, |at| f64::from(self.plan.roller_position - i32::from(at.steps)) * MM_PER_STEP)
    }

    /// The path along the contour, as far as it was told.
    #[must_use]
    pub fn actual(&self) -> &[ActualPoint] {
        &self.actual
    }

    /// How far the run was off.
    #[must_use]
    pub fn errors(&self) -> RunErrors {
        RunErrors::of(&self.plan, &self.actual)
    }
}
