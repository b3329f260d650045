//! The sequence itself.

use super::job::Job;
use super::screen::{Choice, Screen};
use crate::spinning::published::{ConeParameters, Field, ParabolaParameters, RollerStart};

/// A key of the operator's keyboard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Key {
    /// The space bar.
    Space,
    /// Return.
    Return,
    /// Deletes one digit.
    Delete,
    /// A letter or digit.
    Char(char),
    /// Emergency stop.
    Emergency,
}

/// Something that happens to the sequence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Event {
    /// A key was pressed.
    Key(Key),
    /// The datum switch is closed.
    AtDatum,
    /// The run has ended as planned.
    Completed,
    /// The run was stopped by the controller, with its reason.
    Stopped(String),
}

/// What the sequence wants done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Command {
    /// Ring the bell: the key means nothing here.
    Bell,
    /// Start the oil pump.
    StartPump,
    /// Draw the roller back until the datum switch closes.
    SeekDatum,
    /// Run a job.
    Run(Job),
    /// Draw the roller back and switch everything off.
    EmergencyStop,
}

/// Prompts of the machine's set-up, each confirmed with the space bar.
const SET_UP: [&str; 5] = [
    "Place the workpiece.",
    "Start the oil pump.",
    "Switch on the valve controller.",
    "Switch on encoder and transducer.",
    "Check that the roller is at its datum.",
];

/// Where the sequence is.
#[derive(Debug, Clone, PartialEq, Eq)]
enum State {
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
    Stopped { job: Option<Job>, reason: String },
}

/// What has been entered for the contour being described.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Entered {
    parabola: bool,
    form_length: u32,
    increment: u32,
    angle: u32,
}

/// The sequence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sequence {
    state: State,
    entered: Entered,
    text: String,
    wrong: Option<String>,
    /// The shell of a document can be chosen.
    has_design: bool,
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
                if let State::Running(job) = self.state {
                    self.go(State::Stopped { job: Some(job), reason });
                }
                None
            }
        }
    }

    fn emergency(&mut self) -> Command {
        let job = match self.state {
            State::Running(job) | State::Ready(job) | State::Again(job) => Some(job),
            _ => None,
        };
        self.go(State::Stopped { job, reason: "Emergency stop by the operator.".to_owned() });
        Command::EmergencyStop
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

    /// What the operator sees now.
    #[must_use]
    pub fn screen(&self) -> Screen {
        let (title, prompt, choices) = self.shown();
        let typing = matches!(self.state, State::Number(_) | State::AdjustBy(_));
        Screen {
            title,
            prompt,
            notes: self.notes(),
            field: typing.then(|| self.text.clone()),
            wrong: self.wrong.clone(),
            choices: choices.into_iter().map(|(label, key)| Choice { label, key }).collect(),
        }
    }

    fn shown(&self) -> (&'static str, String, Vec<(&'static str, Key)>) {
        let yes_no = || vec![("No", Key::Char('N')), ("Yes", Key::Char('Y'))];
        match &self.state {
            State::Welcome => (
                "Flow-turning",
                "The machine is set up first, then a shape is chosen.".to_owned(),
                vec![("Begin", Key::Space)],
            ),
            State::SetUp(step) => (
                "Machine set-up",
                SET_UP.get(*step).copied().unwrap_or_default().to_owned(),
                vec![("Done", Key::Space)],
            ),
            State::WaitDatum => ("Machine set-up", "The roller goes to its datum.".to_owned(), Vec::new()),
            State::Shape => ("Shape", "Which contour is formed?".to_owned(), self.shapes()),
            State::Number(field) | State::AdjustBy(field) => {
                let range = field.range();
                let prompt = format!("{}, {} to {}", field.name(), range.start(), range.end());
                ("Parameters", prompt, vec![("Enter", Key::Return)])
            }
            State::Test => ("Parameters", "Roller in its test position?".to_owned(), yes_no()),
            State::Adjust => ("Parameters", "Adjust the roller?".to_owned(), yes_no()),
            State::AdjustWay(_) => (
                "Parameters",
                "Which way is the roller adjusted?".to_owned(),
                vec![("F  away from the former", Key::Char('F')), ("R  towards the former", Key::Char('R'))],
            ),
            State::Ready(_) => (
                "Ready",
                "Stand clear. The roller will advance.".to_owned(),
                vec![("Run", Key::Space), ("Another shape", Key::Char('N'))],
            ),
            State::Running(_) => ("Running", "The roller follows the contour.".to_owned(), Vec::new()),
            State::Again(_) => {
                let prompt = "Completed. Remove the component, disengage the carriage and bring it back by handwheel. \
                              Another identical piece?";
                ("Completed", prompt.to_owned(), vec![("Yes", Key::Char('Y')), ("No", Key::Char('N'))])
            }
            State::Stopped { reason, .. } => ("Stopped", reason.clone(), vec![("Set up again", Key::Space)]),
        }
    }

    fn shapes(&self) -> Vec<(&'static str, Key)> {
        let mut shapes = vec![("A  cone", Key::Char('A')), ("B  parabola", Key::Char('B'))];
        if self.has_design {
            shapes.insert(0, ("C  this shell", Key::Char('C')));
        }
        shapes
    }

    fn notes(&self) -> Vec<String> {
        let Entered { parabola, form_length, increment, angle } = self.entered;
        let describing = matches!(
            self.state,
            State::Number(_) | State::AdjustBy(_) | State::Test | State::Adjust | State::AdjustWay(_)
        );
        let mut notes = Vec::new();
        if describing {
            notes.push(if parabola { "Parabola y² = 4ax, a = 68.45".to_owned() } else { "Cone".to_owned() });
            let known = [("form length", form_length, "mm"), ("increment", increment, "pulses"), ("angle", angle, "°")];
            let known = known.iter().filter(|(_, value, _)| *value > 0);
            notes.extend(known.map(|(name, value, unit)| format!("{name} {value} {unit}")));
        }
        if let State::Ready(job) | State::Running(job) | State::Again(job) = &self.state {
            notes.push(job.name());
        }
        if let State::Stopped { job, .. } = &self.state {
            notes.push("Lathe and pump are off.".to_owned());
            notes.extend(job.map(|job| job.name()));
        }
        notes
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
