//! The control cycle as a state machine: one call, one turn of the loop.
//!
//! Order of the published cycle (Mohamad 1988, chapter 5): advance to the start (4-5), carriage to the tip's switch (5-1),
//! contour (1-2), retract to the datum (2-3), wait until the leadscrew stands.

use super::plan::{Moves, Plan, Target};
use super::watch::{self, Creep, StopReason};
use crate::spinning::published::LARGEST_STEP;
use crate::spinning::rig::valve::STOP;
use crate::spinning::rig::{Reading, Rig};

/// Where a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Phase {
    /// The roller is drawn back to its datum.
    ToDatum,
    /// The roller advances to its start.
    Advance,
    /// The carriage runs to the switch at the former's tip.
    RunUp,
    /// The contour is followed.
    Follow,
    /// The roller is drawn back.
    Retract,
    /// The leadscrew comes to rest.
    Settle,
    /// The run has ended as planned.
    Completed,
    /// The roller is drawn back because of a fault.
    Stopping(StopReason),
    /// Everything is off because of a fault.
    Stopped {
        /// Why.
        reason: StopReason,
        /// The roller has reached its datum.
        drawn_back: bool,
    },
}

impl Phase {
    /// True if nothing more will happen.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        matches!(self, Self::Completed | Self::Stopped { .. })
    }
}

/// One moment of a run as the controller saw it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceSample {
    /// Time, s.
    pub time_s: f64,
    /// Counted carriage travel, pulses.
    pub pulses: u32,
    /// Distance of the roller from its start, steps, as read.
    pub steps: i32,
    /// Distance that it was last sent to, steps.
    pub commanded: i32,
}

/// Longest time for any way of the roller or for the carriage to the tip, s: three times a full stroke at the slowest speed.
const LONGEST_WAY_S: f64 = 36.0;
/// Longest time for the roller to be drawn back in an emergency before the pump is switched off, s.
const LONGEST_RETREAT_S: f64 = 4.0;
/// Time between two looks at the leadscrew, s, and how often it must stand.
const SETTLE_S: f64 = 0.5;
const SETTLE_READINGS: u32 = 10;

/// A run.
#[derive(Debug, Clone)]
pub struct Controller {
    plan: Plan,
    phase: Phase,
    began: bool,
    /// Time at which the phase, or the step of it, began.
    since_s: f64,
    /// Time at which the tip's switch closed.
    tip_s: f64,
    next: usize,
    /// The reading that the roller is on its way to.
    going_to: Option<i32>,
    commanded: i32,
    /// Distance from the start that the roller was last driven to.
    driven: i32,
    creep: Creep,
    settled: (u32, u32),
    skipped: usize,
    trace: Vec<TraceSample>,
}

impl Controller {
    /// A run that has not begun.
    #[must_use]
    pub fn new(plan: Plan) -> Self {
        Self {
            plan,
            phase: Phase::ToDatum,
            began: false,
            since_s: 0.0,
            tip_s: 0.0,
            next: 0,
            going_to: None,
            commanded: 0,
            driven: 0,
            creep: Creep::default(),
            settled: (0, 0),
            skipped: 0,
            trace: Vec::new(),
        }
    }

    /// What the run is to do.
    #[must_use]
    pub const fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Where the run is.
    #[must_use]
    pub const fn phase(&self) -> &Phase {
        &self.phase
    }

    /// What the controller saw while it followed the contour.
    #[must_use]
    pub fn trace(&self) -> &[TraceSample] {
        &self.trace
    }

    /// Targets at which the roller had already gone further, so that nothing was done.
    #[must_use]
    pub const fn skipped(&self) -> usize {
        self.skipped
    }

    /// Draws the roller back and switches everything off, now.
    pub fn emergency_stop(&mut self, rig: &mut dyn Rig) {
        if !self.phase.is_over() {
            let reading = rig.read();
            self.stop(rig, &reading, StopReason::Emergency);
        }
    }

    /// Distance from its start that the roller was last driven to, steps: what lies beyond is overshoot.
    #[must_use]
    pub const fn driven(&self) -> i32 {
        self.driven
    }

    /// One turn of the loop: reads, decides, commands.
    pub fn step(&mut self, rig: &mut dyn Rig) -> &Phase {
        if self.phase.is_over() {
            return &self.phase;
        }
        let reading = rig.read();
        if !self.began {
            self.begin(rig, &reading);
        }
        match self.phase {
            Phase::ToDatum => self.draw_back(rig, &reading, Phase::Advance),
            Phase::Advance => self.advance(rig, &reading),
            Phase::RunUp => self.run_up(rig, &reading),
            Phase::Follow => self.follow(rig, &reading),
            Phase::Retract => self.draw_back(rig, &reading, Phase::Settle),
            Phase::Settle => self.settle(&reading),
            Phase::Stopping(reason) => self.stopping(rig, &reading, reason),
            Phase::Completed | Phase::Stopped { .. } => {}
        }
        &self.phase
    }

    fn begin(&mut self, rig: &mut dyn Rig, reading: &Reading) {
        self.began = true;
        rig.set_lathe(false);
        rig.set_valve(STOP);
        rig.reset_counter();
        rig.set_pump(true);
        self.since_s = reading.time_s;
        if let Some(wrong) = self.out_of_reach() {
            self.stop(rig, reading, wrong);
        }
    }

    /// A start or target that the transducer cannot read: nothing is moved for it.
    fn out_of_reach(&self) -> Option<StopReason> {
        let start = self.plan.roller_position;
        let readings = self.plan.targets.iter().map(|t| start.saturating_sub(t.steps));
        let wrong = std::iter::once(start).chain(readings).find(|r| !(0..=i32::from(LARGEST_STEP)).contains(r))?;
        Some(StopReason::OutOfReach { reading: wrong, limit: LARGEST_STEP })
    }

    fn enter(&mut self, phase: Phase, reading: &Reading) {
        self.phase = phase;
        self.since_s = reading.time_s;
    }

    fn draw_back(&mut self, rig: &mut dyn Rig, reading: &Reading, then: Phase) {
        if reading.at_datum {
            rig.set_valve(STOP);
            self.enter(then, reading);
        } else {
            rig.set_valve(self.plan.retract);
            self.stop_if_late(rig, reading, "Drawing the roller back");
        }
    }

    fn advance(&mut self, rig: &mut dyn Rig, reading: &Reading) {
        if i32::from(reading.steps) >= self.plan.roller_position {
            rig.set_valve(STOP);
            rig.set_lathe(true);
            self.enter(Phase::RunUp, reading);
        } else {
            rig.set_valve(self.plan.advance);
            self.stop_if_late(rig, reading, "Advancing the roller");
        }
    }

    fn run_up(&mut self, rig: &mut dyn Rig, reading: &Reading) {
        if reading.at_tip {
            rig.reset_counter();
            self.tip_s = reading.time_s;
            self.enter(Phase::Follow, reading);
        } else {
            self.stop_if_late(rig, reading, "The carriage's way to the tip");
        }
    }

    fn follow(&mut self, rig: &mut dyn Rig, reading: &Reading) {
        if let Some(reason) = self.watched(reading) {
            self.stop(rig, reading, reason);
            return;
        }
        if let Some(goal) = self.going_to {
            if i32::from(reading.steps) <= goal {
                rig.set_valve(STOP);
                self.going_to = None;
            }
        } else {
            match self.plan.targets.get(self.next).copied() {
                Some(target) if reading.pulses >= target.pulses => self.begin_move(rig, reading, target),
                Some(_) => {}
                None => {
                    rig.set_lathe(false);
                    self.enter(Phase::Retract, reading);
                }
            }
        }
        self.record(reading);
    }

    /// Sends the roller to a target, unless it has already gone further.
    fn begin_move(&mut self, rig: &mut dyn Rig, reading: &Reading, target: Target) {
        let before = self.next.checked_sub(1).and_then(|i| self.plan.targets.get(i)).map_or(0, |t| t.steps);
        let here = i32::from(reading.steps);
        let goal = match self.plan.moves {
            Moves::Absolute => self.plan.roller_position - target.steps,
            Moves::Relative => here - (target.steps - before),
        };
        self.next += 1;
        self.commanded = target.steps;
        if here > goal {
            rig.set_valve(self.plan.retract);
            self.creep.opened();
            self.going_to = Some(goal);
            self.driven = self.plan.roller_position - goal;
        } else if target.steps > before {
            self.skipped += 1;
        }
    }

    fn watched(&mut self, reading: &Reading) -> Option<StopReason> {
        let watch = self.plan.watch?;
        let wanted = f64::from(self.plan.roller_position) - self.plan.wanted(reading.pulses);
        let creeping =
            if self.going_to.is_none() { self.creep.shut(&watch, reading.time_s, reading.steps) } else { None };
        // A carriage counted wrong puts the roller off its path, too: the cause is told, not what follows from it.
        watch::carriage(&watch, reading.pulses, reading.time_s - self.tip_s)
            .or_else(|| watch::off_path(&watch, reading.steps, wanted))
            .or(creeping)
    }

    fn settle(&mut self, reading: &Reading) {
        if reading.time_s - self.since_s < SETTLE_S {
            return;
        }
        self.since_s = reading.time_s;
        let (last, times) = self.settled;
        self.settled = if reading.pulses == last { (last, times + 1) } else { (reading.pulses, 0) };
        if self.settled.1 >= SETTLE_READINGS {
            self.phase = Phase::Completed;
        }
    }

    fn stop_if_late(&mut self, rig: &mut dyn Rig, reading: &Reading, what: &'static str) {
        let waited_s = reading.time_s - self.since_s;
        if waited_s > LONGEST_WAY_S {
            self.stop(rig, reading, StopReason::Late { what, waited_s, limit_s: LONGEST_WAY_S });
        }
    }

    /// Draws back and stops the carriage at once; [`Self::stopping`] switches the rest off.
    fn stop(&mut self, rig: &mut dyn Rig, reading: &Reading, reason: StopReason) {
        rig.set_valve(self.plan.retract);
        rig.set_lathe(false);
        self.record(reading);
        self.enter(Phase::Stopping(reason), reading);
    }

    fn stopping(&mut self, rig: &mut dyn Rig, reading: &Reading, reason: StopReason) {
        if reading.at_datum || reading.time_s - self.since_s > LONGEST_RETREAT_S {
            rig.set_valve(STOP);
            rig.set_lathe(false);
            rig.set_pump(false);
            self.enter(Phase::Stopped { reason, drawn_back: reading.at_datum }, reading);
        }
    }

    /// Keeps what is new.
    fn record(&mut self, reading: &Reading) {
        let sample = TraceSample {
            time_s: reading.time_s,
            pulses: reading.pulses,
            steps: self.plan.roller_position - i32::from(reading.steps),
            commanded: self.commanded,
        };
        let same = |last: &TraceSample| {
            (last.pulses, last.steps, last.commanded) == (sample.pulses, sample.steps, sample.commanded)
        };
        if !self.trace.last().is_some_and(same) {
            self.trace.push(sample);
        }
    }
}
