//! The operator's sequence with the rig behind it, and the runs that it made.

use super::port::RigPort;
use super::ran::Ran;
use super::shell;
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::document::RigChoices;
use crate::session::Session;
use crate::spinning::control::{Moves, Phase, Plan, Watch};
use crate::spinning::operator::{Command, Event, Job, Key, Sequence};
use crate::spinning::published::Arithmetic;
use crate::spinning::rig::{Fault, Rig, RigModel, SimulatedRig};
use crate::spinning::run::Run;
use crate::transfer::rig::{RemoteRun, RigEvent};
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
    pub(super) run: Ran,
    pub(super) shown: bool,
}

/// The sequence, its rig and its runs.
#[derive(Debug)]
pub(super) struct Live {
    pub(super) sequence: Sequence,
    pub(super) setting: Setting,
    pub(super) runs: Vec<Made>,
    pub(super) port: RigPort,
    ctx: Option<egui::Context>,
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
            port: RigPort::default(),
            ctx: None,
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

    /// True while the rig runs, or the line to one is open: it may be told to stop at any moment.
    pub(super) const fn is_live(&self) -> bool {
        self.running || self.port.is_open()
    }

    /// Lets the rig's time pass and reads the operator's keys, once a frame. They are read while a shell is `shown`; the key
    /// of the emergency stop always.
    pub(super) fn tick(&mut self, ui: &Ui, shown: Option<&Session>) {
        let frame = ui.ctx().cumulative_frame_nr();
        if std::mem::replace(&mut self.frame, frame) == frame {
            return;
        }
        self.ctx.get_or_insert_with(|| ui.ctx().clone());
        if self.is_live() && ui.input(|i| i.key_pressed(egui::Key::Escape)) {
            self.emergency_stop();
        } else if let Some(session) = shown {
            self.sequence.set_design(session.derived().is_some_and(|d| d.shell.is_some()));
            self.keys(ui, session);
        }
        for event in self.port.events() {
            self.heard(&event);
        }
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

    /// What a rig behind a line tells.
    fn heard(&mut self, event: &RigEvent) {
        if self.running {
            self.runs.iter_mut().last().into_iter().for_each(|made| made.run.take(event));
        }
        match event {
            RigEvent::Ready(remarks) => self.port.remarks.clone_from(remarks),
            RigEvent::At(_) => {}
            RigEvent::AtDatum => _ = self.sequence.take(Event::AtDatum),
            RigEvent::Completed => self.over(Event::Completed),
            RigEvent::Stopped { reason, drawn_back: true } => self.over(Event::Stopped(reason.clone())),
            RigEvent::Stopped { reason, .. } => self.over(Event::Stopped(by_hand(reason))),
            RigEvent::Lost(reason) => {
                self.port.close();
                self.over(Event::Lost(reason.clone()));
            }
        }
    }

    fn over(&mut self, event: Event) {
        self.running = false;
        self.sequence.take(event);
    }

    fn advance(&mut self, seconds: f64) {
        let Some(Ran::Simulated(run)) = self.runs.last_mut().map(|made| &mut made.run) else { return };
        run.advance(seconds);
        if run.is_over() {
            self.running = false;
            let event = match run.controller().phase() {
                Phase::Stopped { reason, drawn_back: true } => Event::Stopped(reason.to_string()),
                Phase::Stopped { reason, .. } => Event::Stopped(by_hand(reason)),
                _ => Event::Completed,
            };
            self.sequence.take(event);
        }
    }

    /// Keys go to the sequence while no text is edited.
    fn keys(&mut self, ui: &Ui, session: &Session) {
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

    /// The operator's emergency stop, from wherever it is asked for.
    pub(super) fn emergency_stop(&mut self) {
        self.sequence.take(Event::Key(Key::Emergency));
        self.stop();
    }

    /// Another rig is chosen; it is set up from the beginning.
    pub(super) fn choose_rig(&mut self, port: Option<String>) {
        if !self.running {
            self.port.choose(port);
            self.sequence = Sequence::new(true);
        }
    }

    /// The simulated roller is drawn back in an instant.
    fn seek_datum(&mut self) {
        /// More looks than a full stroke takes.
        const LOOKS: u32 = 20_000;
        if self.port.name().is_some() {
            if let Err(reason) = self.port.seek_datum(self.ctx.as_ref()) {
                self.sequence.take(Event::Lost(reason));
            }
            return;
        }
        let mut rig = SimulatedRig::new(RigModel::new(1.0, 1.0), Vec::new());
        rig.set_pump(true);
        rig.set_valve(crate::spinning::rig::valve::RETRACT);
        if (0..LOOKS).any(|_| rig.read().at_datum) {
            self.sequence.take(Event::AtDatum);
        }
    }

    fn start(&mut self, job: Job, session: &Session) {
        let (plan, model) = match self.plan(job, session) {
            Ok(made) => made,
            Err(reason) => {
                self.sequence.take(Event::Stopped(reason));
                return;
            }
        };
        let mut name = job.name();
        if self.setting.arithmetic == Arithmetic::AsPublished && job != Job::Design {
            name.push_str(", 16 bits");
        }
        let run = match (self.port.name(), self.port.line()) {
            (None, _) => self.simulated(plan, model, &mut name),
            (Some(port), Some(line)) => {
                name = format!("{name}, on {port}");
                line.run(plan.clone());
                Ran::OnLine(Box::new(RemoteRun::new(plan)))
            }
            (Some(_), None) => {
                self.sequence.take(Event::Lost("The rig is not connected; set it up again.".to_owned()));
                return;
            }
        };
        if self.runs.len() >= MOST_RUNS {
            self.runs.remove(0);
        }
        self.count += 1;
        self.runs.push(Made { number: self.count, name, job, run, shown: true });
        self.running = true;
    }

    fn simulated(&self, plan: Plan, model: RigModel, name: &mut String) -> Ran {
        if self.setting.moves == Moves::Relative {
            name.push_str(", relative");
        }
        if let Some(fault) = self.setting.fault {
            *name = format!("{name}, {fault}");
        }
        let faults: Vec<Fault> = self.setting.fault.into_iter().collect();
        let plan = Plan { moves: self.setting.moves, ..plan };
        Ran::Simulated(Box::new(Run::new(plan, SimulatedRig::new(model, faults))))
    }

    /// The run of a job, or why there is none: figures that break a rule never reach a rig.
    fn plan(&self, job: Job, session: &Session) -> Result<(Plan, RigModel), String> {
        const NOT_READY: &str = "The shell is not ready; correct its figures first.";
        let made = session.derived().and_then(|d| d.shell.as_ref()).ok_or(NOT_READY)?;
        let of_the_rig = |d: &Diagnostic| d.code == "rig" || d.code == "shell-figure";
        let of_the_shell = |d: &Diagnostic| matches!(d.at, Place::Setting { .. }) && d.severity == Severity::Error;
        let wrong = |d: &&Diagnostic| of_the_rig(d) || (job == Job::Design && of_the_shell(d));
        if let Some(wrong) = session.problems().iter().find(wrong) {
            return Err(format!("Not started: {}", wrong.message));
        }
        let rig: &RigChoices = &made.shell.rig;
        let model = RigModel::new(rig.rpm, rig.feed_per_rev);
        let watch = Watch { limit_mm: rig.path_limit, carriage_mm_per_s: model.carriage_mm_per_s() };
        let watch = (!self.setting.unwatched).then_some(watch);
        let plan = job.plan(&made.set_points, self.setting.arithmetic, watch);
        let usable = session.is_current() && shell(session).is_some() && !plan.targets.is_empty();
        if usable { Ok((plan, model)) } else { Err(NOT_READY.to_owned()) }
    }

    /// Emergency stop. A rig behind a line goes on telling until its roller is back; the simulated one is let run out at
    /// once, which draws back and switches off.
    fn stop(&mut self) {
        if let Some(line) = self.port.line() {
            line.emergency_stop();
            return;
        }
        let newest = self.runs.last_mut().filter(|_| self.running);
        let Some(Ran::Simulated(run)) = newest.map(|made| &mut made.run) else { return };
        run.emergency_stop();
        run.advance(60.0);
        self.running = false;
    }
}

fn by_hand(reason: &dyn std::fmt::Display) -> String {
    format!("{reason} The roller could not be drawn back: do it by hand.")
}
