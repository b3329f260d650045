//! What the operator is asked and told at every step of the sequence.

use super::events::Key;
use super::screen::{Choice, Screen};
use super::sequence::{Entered, Sequence, State};

/// Prompts of the machine's set-up, each confirmed with the space bar.
pub(super) const SET_UP: [&str; 5] = [
    "Place the workpiece.",
    "Start the oil pump.",
    "Switch on the valve controller.",
    "Switch on encoder and transducer.",
    "Check that the roller is at its datum.",
];

impl Sequence {
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
        if let State::Stopped { job, is_off, .. } = &self.state {
            let known =
                if *is_off { "Lathe and pump are off." } else { "Whether lathe and pump are off is not known." };
            notes.push(known.to_owned());
            notes.extend(job.map(|job| job.name()));
        }
        notes
    }
}
