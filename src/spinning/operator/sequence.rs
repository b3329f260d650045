//! The sequence itself: what every key and event makes of it.

use super::events::{Command, Event, Key};
use super::job::Job;
use super::prompts::SET_UP;
use crate::spinning::published::{ConeParameters, Field, ParabolaParameters, RollerStart};

/// Where the sequence is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum State {
    Welcome,
    SetUp(usize),
    WaitDatum,
    Shape,
    Number(Field),
    Test,
    Adjust,
    AdjustBy(Field),
    AdjustWay(i32),
    Ready(Job),
    Running(Job),
    Again(Job),
    Stopped { job: Option<Job>, reason: String, is_off: bool },
}

/// What has been entered for the contour being described.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Entered {
    pub parabola: bool,
    pub form_length: u32,
    pub increment: u32,
    pub angle: u32,
}

/// The sequence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sequence {
    pub(super) state: State,
    pub(super) entered: Entered,
    pub(super) text: String,
    pub(super) wrong: Option<String>,
    /// The shell of a document can be chosen.
    pub(super) has_design: bool,
}

impl Sequence {
    /// The sequence at its beginning; with a design the shell of the document can be chosen as a shape.
    #[must_use]
    pub const fn new(has_design: bool) -> Self {
        let entered = Entered { parabola: false, form_length: 0, increment: 0, angle: 0 };
        Self { state: State::Welcome, entered, text: String::new(), wrong: None, has_design }
    }

    /// True while a run goes on.
    #[must_use]
    pub const fn is_running(&self) -> bool {
        matches!(self.state, State::Running(_))
    }

    /// Says whether the document's shell can be chosen from now on.
    pub const fn set_design(&mut self, has_design: bool) {
        self.has_design = has_design;
    }

    /// Takes an event; says what is to be done.
    pub fn take(&mut self, event: Event) -> Option<Command> {
        match event {
            Event::Key(Key::Emergency) => Some(self.emergency()),
            Event::Key(key) => self.key(key),
            Event::AtDatum => {
                if self.state == State::WaitDatum {
                    self.go(State::Shape);
                }
                None
            }
            Event::Completed => {
                if let State::Running(job) = self.state {
                    self.go(State::Again(job));
                }
                None
            }
            Event::Stopped(reason) => {
                self.stopped(reason, true);
                None
            }
            Event::Lost(reason) => {
                self.stopped(reason, false);
                None
            }
        }
    }

    fn emergency(&mut self) -> Command {
        let reason = "Emergency stop by the operator.".to_owned();
        self.go(State::Stopped { job: self.job(), reason, is_off: true });
        Command::EmergencyStop
    }

    /// The job that runs, or is about to.
    const fn job(&self) -> Option<Job> {
        match self.state {
            State::Running(job) | State::Ready(job) | State::Again(job) => Some(job),
            State::Stopped { job, .. } => job,
            _ => None,
        }
    }

    /// The rig has stopped, or cannot be reached; before it is set up that means nothing.
    fn stopped(&mut self, reason: String, is_off: bool) {
        if !matches!(self.state, State::Welcome | State::SetUp(_)) {
            self.go(State::Stopped { job: self.job(), reason, is_off });
        }
    }

    fn go(&mut self, state: State) {
        self.state = state;
        self.text.clear();
        self.wrong = None;
    }

    /// A key that means nothing here: bell, and what is expected.
    fn refuse(&mut self, expected: impl Into<String>) -> Command {
        self.wrong = Some(expected.into());
        self.text.clear();
        Command::Bell
    }

    fn key(&mut self, key: Key) -> Option<Command> {
        match self.state.clone() {
            State::Welcome | State::Stopped { .. } => self.on_space(key, State::SetUp(0)),
            State::SetUp(step) => self.set_up(key, step),
            State::WaitDatum | State::Running(_) => Some(Command::Bell),
            State::Shape => self.shape(key),
            State::Number(field) | State::AdjustBy(field) => self.number(key, field),
            State::Test => self.yes_no(key, |s| s.finish(RollerStart::Test), |s| s.go(State::Adjust)),
            State::Adjust => {
                self.yes_no(key, |s| s.go(State::AdjustBy(Field::Adjustment)), |s| s.finish(RollerStart::AtTip))
            }
            State::AdjustWay(steps) => self.adjust_way(key, steps),
            State::Ready(job) => match key {
                Key::Space => Some(self.run(job)),
                Key::Char('N' | 'n') => self.shape_again(),
                _ => Some(self.refuse("Press the space bar to begin, or N for another shape.")),
            },
            State::Again(job) => match key {
                Key::Char('Y' | 'y') => Some(self.run(job)),
                Key::Char('N' | 'n') => self.shape_again(),
                _ => Some(self.refuse("Answer Y for another identical piece, or N for another shape.")),
            },
        }
    }

    fn on_space(&mut self, key: Key, next: State) -> Option<Command> {
        if key == Key::Space {
            self.go(next);
            return None;
        }
        Some(self.refuse("Press the space bar."))
    }

    fn set_up(&mut self, key: Key, step: usize) -> Option<Command> {
        if key != Key::Space {
            return Some(self.refuse("Press the space bar when it is done."));
        }
        if step + 1 < SET_UP.len() {
            self.go(State::SetUp(step + 1));
            // The pump is started with its own prompt.
            return (step + 1 == 1).then_some(Command::StartPump);
        }
        self.go(State::WaitDatum);
        Some(Command::SeekDatum)
    }

    fn shape_again(&mut self) -> Option<Command> {
        self.go(State::Shape);
        None
    }

    fn shape(&mut self, key: Key) -> Option<Command> {
        match key {
            Key::Char('A' | 'a') => self.describe(false),
            Key::Char('B' | 'b') => self.describe(true),
            Key::Char('C' | 'c') if self.has_design => self.go(State::Ready(Job::Design)),
            _ if self.has_design => return Some(self.refuse("That is not in the menu: choose A, B or C.")),
            _ => return Some(self.refuse("That is not in the menu: choose A or B.")),
        }
        None
    }

    fn describe(&mut self, parabola: bool) {
        self.entered = Entered { parabola, ..Entered::default() };
        self.go(State::Number(Field::FormLength));
    }

    /// Two digits at most; RETURN ends. An empty field counts as 0.
    fn number(&mut self, key: Key, field: Field) -> Option<Command> {
        match key {
            Key::Char(digit) if digit.is_ascii_digit() && self.text.len() < 2 => {
                self.text.push(digit);
                self.wrong = None;
                None
            }
            Key::Delete if self.text.pop().is_some() => None,
            Key::Return => {
                let value = self.text.parse().unwrap_or(0);
                match field.checked(value) {
                    Ok(value) => {
                        self.entered_number(field, value);
                        None
                    }
                    Err(wrong) => Some(self.refuse(format!("Not within limits. {wrong}"))),
                }
            }
            Key::Char(digit) if digit.is_ascii_digit() => {
                self.wrong = Some("A figure has two digits at most; press RETURN, or DEL to correct it.".to_owned());
                Some(Command::Bell)
            }
            _ => {
                self.wrong = Some("Enter digits and press RETURN.".to_owned());
                Some(Command::Bell)
            }
        }
    }

    fn entered_number(&mut self, field: Field, value: u32) {
        match field {
            Field::FormLength => {
                self.entered.form_length = value;
                self.go(if self.entered.parabola { State::Test } else { State::Number(Field::Increment) });
            }
            Field::Increment => {
                self.entered.increment = value;
                self.go(State::Number(Field::ConeAngle));
            }
            Field::ConeAngle => {
                self.entered.angle = value;
                self.go(State::Test);
            }
            Field::Adjustment => self.go(State::AdjustWay(i32::try_from(value).unwrap_or(0))),
        }
    }

    fn yes_no(&mut self, key: Key, yes: impl Fn(&mut Self), no: impl Fn(&mut Self)) -> Option<Command> {
        match key {
            Key::Char('Y' | 'y') => yes(self),
            Key::Char('N' | 'n') => no(self),
            _ => return Some(self.refuse("Answer Y or N.")),
        }
        None
    }

    fn adjust_way(&mut self, key: Key, steps: i32) -> Option<Command> {
        match key {
            Key::Char('F' | 'f') => self.finish(RollerStart::Adjusted(-steps)),
            Key::Char('R' | 'r') => self.finish(RollerStart::Adjusted(steps)),
            _ => return Some(self.refuse("Answer F to subtract from the roller's position, or R to add to it.")),
        }
        None
    }

    /// All figures are known.
    fn finish(&mut self, start: RollerStart) {
        let Entered { parabola, form_length, increment, angle } = self.entered;
        let job = if parabola {
            ParabolaParameters::new(form_length).map(|p| Job::Parabola(p.starting(start)))
        } else {
            ConeParameters::new(form_length, increment, angle).map(|c| Job::Cone(c.starting(start)))
        };
        match job {
            Ok(job) => self.go(State::Ready(job)),
            Err(wrong) => {
                self.go(State::Shape);
                self.wrong = Some(wrong.to_string());
            }
        }
    }

    fn run(&mut self, job: Job) -> Command {
        self.go(State::Running(job));
        Command::Run(job)
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
