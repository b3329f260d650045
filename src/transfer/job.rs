//! One transfer on a thread of its own: progress, log, abort, and exactly one outcome.

mod worker;

use super::compare::{Blanks, Difference, Piece};
use super::folder;
use super::log::LogLine;
use super::ports::Target;
use super::sender::Patience;
use crate::cancel::Cancel;
use std::fmt;
use std::path::PathBuf;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// What to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Task {
    /// Send a program; with `verify`, wait until it comes back and compare.
    Send {
        /// Name of the program, for the log.
        name: String,
        /// The program: pages for an ORAC, blocks for other controls.
        text: String,
        /// Compare with what the control sends back.
        verify: bool,
    },
    /// Receive a program.
    Receive,
    /// Receive a program and compare it with one that was sent before.
    Compare {
        /// Name of the program.
        name: String,
        /// The program as it was sent.
        sent: String,
    },
}

/// A transfer to be started.
#[derive(Debug)]
pub struct Request {
    /// What to do.
    pub task: Task,
    /// Where to, and how.
    pub target: Target,
    /// Do not keep to the speed of the line; for pseudo-terminals and tests.
    pub unpaced: bool,
    /// Press the keys of a virtual control: a lone DC1 makes it send, a lone DC2 makes it read. Other controls ignore
    /// them, since they listen only after their operator has pressed the key.
    pub press_keys: bool,
    /// How blanks are compared.
    pub blanks: Blanks,
    /// How long to wait for what.
    pub timing: Timing,
}

impl Request {
    /// A paced transfer that presses the keys of a virtual control, compares exactly, and waits the usual times.
    #[must_use]
    pub fn new(task: Task, target: Target) -> Self {
        Self { task, target, unpaced: false, press_keys: true, blanks: Blanks::Exact, timing: Timing::default() }
    }
}

/// How long to wait before a transfer fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Timing {
    /// For the first character from the control: the operator has to walk there and press a key.
    pub first: Duration,
    /// For each later character from the control.
    pub idle: Duration,
    /// For the port to take another byte, the control to go on after DC3, or a folder to answer.
    pub stuck: Duration,
}

impl Default for Timing {
    fn default() -> Self {
        Self { first: Duration::from_mins(1), idle: Duration::from_secs(5), stuck: Duration::from_secs(10) }
    }
}

impl Timing {
    const fn patience(self) -> Patience {
        Patience { start: self.first, stuck: self.stuck }
    }
}

/// What a transfer is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// The port is being opened.
    Opening,
    /// The operator has to start reading at the control.
    WaitingForReader,
    /// The program goes out.
    Sending,
    /// The operator has to start the transfer at the control.
    WaitingForControl,
    /// A program comes in.
    Receiving,
    /// The program is saved to a folder.
    Saving,
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Opening => "Opening the port",
            Self::WaitingForReader => "Start reading the program at the control now",
            Self::Sending => "Sending",
            Self::WaitingForControl => "Start sending the program at the control now",
            Self::Receiving => "Receiving",
            Self::Saving => "Saving",
        })
    }
}

/// How far a transfer is. While receiving, totals are known only where the program was sent before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Progress {
    /// Bytes so far.
    pub bytes: usize,
    /// Bytes in all.
    pub bytes_total: Option<usize>,
    /// Blocks (pages) begun so far.
    pub block: usize,
    /// Blocks in all.
    pub blocks_total: Option<usize>,
    /// Time since the start of the transfer.
    pub elapsed: Duration,
    /// Time left, as far as it can be told.
    pub eta: Option<Duration>,
}

/// How a transfer ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// All bytes went out. Nothing is known about what arrived.
    SentNotVerified,
    /// The program was saved as this file, which reads back the same.
    Saved(PathBuf),
    /// What came back is what was sent.
    Verified,
    /// What came back is not what was sent.
    Different(Vec<Difference>),
    /// A program came.
    Received {
        /// Its text, without the end mark.
        text: String,
        /// What is wrong with its form; empty if it is well-formed.
        problems: Vec<String>,
    },
    /// Stopped on request.
    Aborted,
    /// It could not be done; a sentence.
    Failed(String),
}

impl Outcome {
    /// True if what was asked for was done and nothing is known to be wrong.
    #[must_use]
    pub fn is_good(&self) -> bool {
        match self {
            Self::SentNotVerified | Self::Saved(_) | Self::Verified => true,
            Self::Received { problems, .. } => problems.is_empty(),
            Self::Different(_) | Self::Aborted | Self::Failed(_) => false,
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SentNotVerified => f.write_str("Sent, not verified."),
            Self::Saved(path) => write!(f, "Saved as {}.", path.display()),
            Self::Verified => f.write_str("Verified: what came back is what was sent."),
            Self::Different(differences) => {
                let count = differences.len();
                let noun = if differences.first().is_some_and(|d| d.piece == Piece::Block) { "block" } else { "page" };
                let verb = if count == 1 { " differs" } else { "s differ" };
                write!(f, "Not verified: {count} {noun}{verb} from what was sent.")?;
                differences.iter().try_for_each(|difference| write!(f, "\n  {difference}"))
            }
            Self::Received { text, problems } => {
                write!(f, "Received {} bytes.", text.len())?;
                problems.iter().try_for_each(|problem| write!(f, "\n  {problem}"))
            }
            Self::Aborted => f.write_str("Aborted."),
            Self::Failed(reason) => f.write_str(reason),
        }
    }
}

/// What a transfer tells while it runs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Event {
    /// It does something else now.
    State(State),
    /// It got further.
    Progress(Progress),
    /// A line for the log.
    Log(LogLine),
    /// It ended. Exactly one, the last.
    Done(Outcome),
}

/// A running transfer. Dropping it aborts it.
#[derive(Debug)]
pub struct Job {
    events: Receiver<Event>,
    cancel: Cancel,
    done: bool,
}

impl Job {
    /// Starts a transfer. `notify` is called from its thread after every event.
    #[must_use]
    pub fn start(request: Request, cancel: &Cancel, notify: impl Fn() + Send + 'static) -> Self {
        let (sender, events) = mpsc::channel();
        let for_worker = cancel.clone();
        thread::spawn(move || {
            let tell = move |event| {
                // Nobody listens any more only when the job was dropped, which aborts it as well.
                let _ = sender.send(event);
                notify();
            };
            let outcome = run(request, for_worker, &tell);
            tell(Event::Done(outcome));
        });
        Self { events, cancel: cancel.clone(), done: false }
    }

    /// Asks the transfer to stop; [`Outcome::Aborted`] follows at once, whatever the port does.
    pub fn abort(&self) {
        self.cancel.cancel();
    }

    /// True once [`Event::Done`] was handed out.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.done
    }

    /// The next event; none if there is none within `timeout` or the transfer is done.
    pub fn next(&mut self, timeout: Duration) -> Option<Event> {
        if self.done {
            return None;
        }
        let event = match self.events.recv_timeout(timeout) {
            Ok(event) => event,
            Err(RecvTimeoutError::Timeout) => return None,
            Err(RecvTimeoutError::Disconnected) => {
                Event::Done(Outcome::Failed("The transfer stopped unexpectedly. Try again.".to_owned()))
            }
        };
        self.done = matches!(event, Event::Done(_));
        Some(event)
    }

    /// Hands every event to `on_event` until the transfer ends.
    pub fn run_to_end(mut self, on_event: &mut dyn FnMut(&Event)) -> Outcome {
        /// Only how often the loop looks; events are handed out at once.
        const LOOK: Duration = Duration::from_secs(1);
        loop {
            let Some(event) = self.next(LOOK) else { continue };
            on_event(&event);
            if let Event::Done(outcome) = event {
                return outcome;
            }
        }
    }
}

fn run(request: Request, cancel: Cancel, tell: &dyn Fn(Event)) -> Outcome {
    let Request { task, target, unpaced, press_keys, blanks, timing } = request;
    match target {
        Target::Folder(profile) => folder::run(task, &profile, timing.stuck, &cancel, tell),
        Target::Line { port, profile } => {
            let options = worker::Options { unpaced, press_keys, blanks, timing };
            worker::run(task, port, profile, options, cancel, tell)
        }
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        if !self.done {
            self.cancel.cancel();
        }
    }
}
