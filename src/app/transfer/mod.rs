//! The way to the lathe: port, line settings, progress, outcome and log.

mod log;
mod panel;
mod settings;

use crate::cancel::Cancel;
use crate::machine::{Delivery, Machine};
use crate::session::{Session, Verdict};
use crate::transfer::log::LogLine;
use crate::transfer::ports::VIRTUAL;
use crate::transfer::virtual_lathe::VirtualLathe;
use crate::transfer::{Event, Job, Outcome, PortChoice, Progress, Request, State, Target, Task, ports};
pub(crate) use panel::show;
use std::collections::VecDeque;
use std::time::Duration;

/// Log lines that are kept: a program of 99 pages twice over.
const LOG_KEPT: usize = 2000;

/// What the panel keeps, and the transfer that runs.
pub(crate) struct TransferPanel {
    profile: Option<(String, Delivery)>,
    port: String,
    ports: Vec<PortChoice>,
    lathe: VirtualLathe,
    job: Option<Job>,
    state: State,
    progress: Progress,
    log: VecDeque<LogLine>,
    outcome: Option<Outcome>,
    /// The program that was sent last, by name.
    sent: Option<(String, String)>,
    /// A program whose proof fails waits for the second step.
    asked_to_insist: bool,
    show_settings: bool,
    /// Keep to the speed of the line.
    pub(crate) paced: bool,
}

impl Default for TransferPanel {
    fn default() -> Self {
        Self {
            profile: None,
            port: VIRTUAL.to_owned(),
            ports: Vec::new(),
            lathe: VirtualLathe::default(),
            job: None,
            state: State::Opening,
            progress: Progress::default(),
            log: VecDeque::new(),
            outcome: None,
            sent: None,
            asked_to_insist: false,
            show_settings: false,
            paced: true,
        }
    }
}

impl TransferPanel {
    /// True while a transfer runs.
    pub(crate) const fn is_running(&self) -> bool {
        self.job.is_some()
    }

    /// How the last transfer ended.
    pub(crate) const fn outcome(&self) -> Option<&Outcome> {
        self.outcome.as_ref()
    }

    /// Name and text of the program that reached the lathe with the last transfer, as far as is known.
    pub(crate) fn reached(&self) -> Option<(String, String)> {
        let outcome = self.outcome.as_ref()?;
        let good = matches!(outcome, Outcome::SentNotVerified | Outcome::Saved(_) | Outcome::Verified);
        self.sent.clone().filter(|_| good)
    }

    /// How far the transfer is.
    pub(crate) const fn progress(&self) -> &Progress {
        &self.progress
    }

    /// True while the second step of sending a program whose proof fails is open.
    pub(crate) const fn waits_for_second_step(&self) -> bool {
        self.asked_to_insist
    }

    /// Takes what the running transfer has told since the last call; an outcome when it has just ended.
    pub(crate) fn receive(&mut self) -> Option<&Outcome> {
        let job = self.job.as_mut()?;
        let mut outcome = None;
        while let Some(event) = job.next(Duration::ZERO) {
            match event {
                Event::State(state) => self.state = state,
                Event::Progress(progress) => self.progress = progress,
                Event::Log(line) => {
                    if self.log.len() == LOG_KEPT {
                        self.log.pop_front();
                    }
                    self.log.push_back(line);
                }
                Event::Done(done) => outcome = Some(done),
            }
        }
        let done = outcome?;
        self.job = None;
        self.outcome = Some(done);
        self.outcome.as_ref()
    }

    /// Why nothing can be sent now; `None` if it can.
    pub(crate) fn hindrance(&self, session: &Session) -> Option<String> {
        if self.is_running() {
            return Some("A transfer is under way. Wait for its end or abort it.".to_owned());
        }
        if self.port.trim().is_empty() {
            return Some("No port is chosen. Choose one in the Transfer panel.".to_owned());
        }
        if let Some(reason) = session.outdated() {
            return Some(reason.to_owned());
        }
        match session.verdict() {
            Verdict::Pending => Some("The proof of this program is not finished.".to_owned()),
            Verdict::NoProgram => Some("There is no program to send yet.".to_owned()),
            Verdict::Failed { .. } if session.program().is_none() => {
                Some("There is no program to send: put the errors right first.".to_owned())
            }
            Verdict::Failed { .. } | Verdict::Proved { .. } => None,
        }
    }

    /// Sends the program that is shown; one whose proof fails only if a person `insists` in a second step.
    pub(crate) fn send(&mut self, session: &Session, insists: bool, notify: impl Fn() + Send + 'static) {
        if self.hindrance(session).is_some() {
            return;
        }
        if matches!(session.verdict(), Verdict::Failed { .. }) && !insists {
            self.asked_to_insist = true;
            return;
        }
        let Some(program) = session.program() else { return };
        self.sent = Some((program.name.clone(), program.text.clone()));
        let task = Task::Send { name: program.name.clone(), text: program.text.clone(), verify: false };
        self.start(task, session, notify);
    }

    fn receive_program(&mut self, session: &Session, notify: impl Fn() + Send + 'static) {
        self.start(Task::Receive, session, notify);
    }

    fn compare(&mut self, session: &Session, notify: impl Fn() + Send + 'static) {
        if let Some((name, sent)) = self.sent.clone() {
            self.start(Task::Compare { name, sent }, session, notify);
        }
    }

    fn start(&mut self, task: Task, session: &Session, notify: impl Fn() + Send + 'static) {
        let Some(machine) = session.derived().and_then(|d| d.machine.clone()) else { return };
        let delivery = self.profile_for(&machine).clone();
        let target = Target::named(&self.port, &delivery, &self.lathe);
        let request = Request { unpaced: !self.paced, ..Request::new(task, target) };
        self.asked_to_insist = false;
        self.outcome = None;
        self.progress = Progress::default();
        self.state = State::Opening;
        self.job = Some(Job::start(request, &Cancel::default(), notify));
    }

    /// The settings for a machine: its own until they are edited.
    fn profile_for(&mut self, machine: &Machine) -> &mut Delivery {
        if self.profile.as_ref().is_some_and(|(id, _)| *id != machine.id) {
            self.profile = None;
        }
        if self.profile.is_none() {
            self.list_ports(machine);
        }
        &mut self.profile.get_or_insert_with(|| (machine.id.clone(), machine.serial.clone())).1
    }

    /// Lists what a machine's programs can go to; a choice that another machine left gives way to the first.
    fn list_ports(&mut self, machine: &Machine) {
        let former = std::mem::replace(&mut self.ports, ports(&machine.serial));
        let is_in = |choices: &[PortChoice]| choices.iter().any(|choice| choice.name == self.port);
        if (former.is_empty() || is_in(&former)) && !is_in(&self.ports) {
            self.port = self.ports.first().map(|choice| choice.name.clone()).unwrap_or_default();
        }
    }
}
