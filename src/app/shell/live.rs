//! The operator's sequence with the simulated rig behind it, and the runs that it made.

use super::shell;
use crate::document::RigChoices;
use crate::session::Session;
use crate::spinning::control::{Moves, Phase, Plan, Watch};
use crate::spinning::operator::{Command, Event, Job, Key, Sequence};
use crate::spinning::published::Arithmetic;
use crate::spinning::rig::{Fault, Rig, RigModel, SimulatedRig};
use crate::spinning::run::{Run, RunErrors};
use egui::Ui;
use std::time::Duration;

/// Longest time that one frame lets pass, s: after a pause the rig does not leap.
const LONGEST_FRAME_S: f64 = 0.1;
/// Runs that are kept; the oldest goes first.
const MOST_RUNS: usize = 24;

/// How fast the rig's time passes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Pace {
    /// As on the shop floor.
    Real,
    /// Ten times as fast.
    #[default]
    Tenfold,
    /// To the end at once.
    AtOnce,
}

/// What is chosen for the next run.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Setting {
    pub(super) pace: Pace,
    pub(super) moves: Moves,
    pub(super) arithmetic: Arithmetic,
    pub(super) fault: Option<Fault>,
    pub(super) unwatched: bool,
}

/// A run that is over, or going on.
#[derive(Debug)]
pub(super) struct Made {
    pub(super) number: usize,
    pub(super) name: String,
    pub(super) job: Job,
    pub(super) run: Run,
    pub(super) shown: bool,
}

impl Made {
    pub(super) fn errors(&self) -> RunErrors {
        self.run.errors()
    }

    /// How it ended.
    pub(super) fn verdict(&self) -> String {
        match self.run.controller().phase() {
            Phase::Completed => "completed".to_owned(),
            Phase::Stopped { reason, drawn_back: true } => format!("stopped: {reason}"),
            Phase::Stopped { reason, .. } => format!("stopped, roller not drawn back: {reason}"),
            _ => "running".to_owned(),
        }
    }
}

/// The sequence, its rig and its runs.
#[derive(Debug)]
pub(super) struct Live {
    pub(super) sequence: Sequence,
    pub(super) setting: Setting,
    pub(super) runs: Vec<Made>,
    running: bool,
    count: usize,
    frame: u64,
}

impl Default for Live {
    fn default() -> Self {
        Self {
            sequence: Sequence::new(true),
            setting: Setting::default(),
            runs: Vec::new(),
            running: false,
            count: 0,
            frame: 0,
        }
    }
}

impl Live {
    /// True while the rig runs.
    pub(super) const fn is_running(&self) -> bool {
        self.running
    }

    /// The newest run.
    pub(super) fn newest(&self) -> Option<&Made> {
        self.runs.last()
    }

    /// Lets the rig's time pass and reads the operator's keys, once a frame.
    pub(super) fn tick(&mut self, ui: &Ui, session: &Session) {
        let frame = ui.ctx().cumulative_frame_nr();
        if std::mem::replace(&mut self.frame, frame) == frame {
            return;
        }
        self.sequence.set_design(session.derived().is_some_and(|d| d.shell.is_some()));
        self.keys(ui, session);
        if !self.running {
            return;
        }
        let passed = f64::from(ui.input(|i| i.stable_dt)).min(LONGEST_FRAME_S);
        let seconds = match self.setting.pace {
            Pace::Real => passed,
            Pace::Tenfold => 10.0 * passed,
            Pace::AtOnce => f64::MAX,
        };
        self.advance(seconds);
        ui.ctx().request_repaint_after(Duration::from_millis(16));
    }

    fn advance(&mut self, seconds: f64) {
        let Some(made) = self.runs.last_mut() else { return };
        made.run.advance(seconds);
        if made.run.is_over() {
            self.running = false;
            let event = match made.run.controller().phase() {
                Phase::Stopped { reason, drawn_back: true } => Event::Stopped(reason.to_string()),
                Phase::Stopped { reason, .. } => {
                    Event::Stopped(format!("{reason} The roller could not be drawn back: do it by hand."))
                }
                _ => Event::Completed,
            };
            self.sequence.take(event);
        }
    }

    /// Keys go to the sequence while no text is edited; Escape is emergency stop while the rig runs, whatever is edited.
    fn keys(&mut self, ui: &Ui, session: &Session) {
        if self.running && ui.input(|i| i.key_pressed(egui::Key::Escape)) {
            self.press(Key::Emergency, session);
            return;
        }
        if ui.memory(|m| m.focused().is_some()) {
            return;
        }
        for event in ui.input(|i| i.events.clone()) {
            let key = match event {
                egui::Event::Text(text) => match text.chars().next() {
                    Some(' ') => Key::Space,
                    Some(c) if c.is_ascii_alphanumeric() => Key::Char(c),
                    _ => continue,
                },
                egui::Event::Key { key: egui::Key::Enter, pressed: true, .. } => Key::Return,
                egui::Event::Key { key: egui::Key::Backspace | egui::Key::Delete, pressed: true, .. } => Key::Delete,
                _ => continue,
            };
            self.press(key, session);
        }
    }

    /// Presses a key of the operator's keyboard.
    pub(super) fn press(&mut self, key: Key, session: &Session) {
        match self.sequence.take(Event::Key(key)) {
            Some(Command::SeekDatum) => self.seek_datum(),
            Some(Command::Run(job)) => self.start(job, session),
            Some(Command::EmergencyStop) => self.stop(),
            Some(Command::Bell | Command::StartPump) | None => {}
        }
    }

    /// The simulated roller is drawn back in an instant.
    fn seek_datum(&mut self) {
        /// More looks than a full stroke takes.
        const LOOKS: u32 = 20_000;
        let mut rig = SimulatedRig::new(RigModel::new(1.0, 1.0), Vec::new());
        rig.set_pump(true);
        rig.set_valve(crate::spinning::rig::valve::RETRACT);
        if (0..LOOKS).any(|_| rig.read().at_datum) {
            self.sequence.take(Event::AtDatum);
        }
    }

    fn start(&mut self, job: Job, session: &Session) {
        let Some((plan, model)) = self.plan(job, session) else {
            self.sequence.take(Event::Stopped("The shell is not ready; correct its figures first.".to_owned()));
            return;
        };
        self.count += 1;
        let faults: Vec<Fault> = self.setting.fault.into_iter().collect();
        let run = Run::new(plan, SimulatedRig::new(model, faults));
        let mut name = job.name();
        if self.setting.moves == Moves::Relative {
            name.push_str(", relative");
        }
        if self.setting.arithmetic == Arithmetic::AsPublished && job != Job::Design {
            name.push_str(", 16 bits");
        }
        if let Some(fault) = self.setting.fault {
            name = format!("{name}, {fault}");
        }
        if self.runs.len() >= MOST_RUNS {
            self.runs.remove(0);
        }
        self.runs.push(Made { number: self.count, name, job, run, shown: true });
        self.running = true;
    }

    fn plan(&self, job: Job, session: &Session) -> Option<(Plan, RigModel)> {
        let made = session.derived()?.shell.as_ref()?;
        let wrong = |d: &crate::diagnostic::Diagnostic| d.code == "rig" || d.code == "shell-figure";
        if session.problems().iter().any(wrong) {
            return None;
        }
        let rig: &RigChoices = &made.shell.rig;
        let model = RigModel::new(rig.rpm, rig.feed_per_rev);
        let watch = Watch { limit_mm: rig.path_limit, carriage_mm_per_s: model.carriage_mm_per_s() };
        let watch = (!self.setting.unwatched).then_some(watch);
        let plan = job.plan(&made.set_points, self.setting.arithmetic, watch);
        let usable = shell(session).is_some() && !plan.targets.is_empty();
        usable.then_some((Plan { moves: self.setting.moves, ..plan }, model))
    }

    /// Emergency stop: the run is let run out at once, which draws back and switches off.
    fn stop(&mut self) {
        let Some(made) = self.runs.last_mut().filter(|_| self.running) else { return };
        made.run.emergency_stop();
        made.run.advance(60.0);
        self.running = false;
    }
}
