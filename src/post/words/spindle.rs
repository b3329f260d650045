//! Spindle speed, its clamp and the gear range.

use super::control::{Spindle, rounded};
use super::writer::Writer;
use crate::geometry::{Point, Vector};
use crate::machine::ClampWord;
use crate::turning::{Cut, CutMove, Operation, Speed};

impl Writer<'_> {
    /// Changes the speed of the turning spindle where a cut wants another.
    pub(super) fn spindle_for(&mut self, cut: &Cut, radius: f64) {
        self.spindle(self.control.spindle(cut, radius));
    }

    pub(super) fn spindle(&mut self, spindle: Spindle) {
        if self.state.spindle != Some(spindle) {
            self.clamp(spindle, true);
            self.speed(spindle, "");
        }
    }

    /// The block that sets the speed, with `code` at its end.
    pub(super) fn speed(&mut self, spindle: Spindle, code: &str) {
        let control = self.control;
        let mut line = self.line();
        match spindle {
            Spindle::Surface { speed, most_rpm } => {
                line.word("G96");
                if control.words.clamp_word == Some(ClampWord::OnG96) {
                    line.whole('D', most_rpm);
                }
                line.whole('S', speed);
            }
            Spindle::Rpm(rpm) => {
                if control.words.surface_speed {
                    line.word("G97");
                }
                line.whole('S', rpm);
            }
            Spindle::Code(number) => {
                line.whole('S', number);
            }
        }
        line.code(code);
        self.push(line);
        self.state.spindle = Some(spindle);
    }

    /// The block that sets the clamp of a constant cutting speed, if the control has one of its own and `needed`.
    pub(super) fn clamp(&mut self, spindle: Spindle, needed: bool) {
        let Spindle::Surface { most_rpm, .. } = spindle else { return };
        let code = match self.control.words.clamp_word {
            Some(ClampWord::G50) => "G50",
            Some(ClampWord::G92) => "G92",
            Some(ClampWord::OnG96) | None => return,
        };
        if !needed || self.state.clamp == Some(most_rpm) {
            return;
        }
        let mut line = self.line();
        line.word(code).whole('S', most_rpm);
        self.push(line);
        self.state.clamp = Some(most_rpm);
    }
}

/// The spindle at the first cut of an operation, and the highest speed that its cuts ask for, rev/min, clamps left out.
pub(super) struct Speeds {
    pub(super) first: Option<Spindle>,
    pub(super) highest_rpm: f64,
}

impl Speeds {
    pub(super) fn of(operation: &Operation, writer: &Writer<'_>, start: Point) -> Self {
        let mut speeds = Self { first: None, highest_rpm: 0.0 };
        speeds.moves(&operation.moves, writer, &mut start.clone(), Vector::zeros());
        speeds
    }

    fn moves(&mut self, moves: &[CutMove], writer: &Writer<'_>, at: &mut Point, by: Vector) {
        for m in moves {
            match *m {
                CutMove::Rapid { to } => *at = to + by,
                CutMove::Line { to, cut } | CutMove::Arc { to, cut, .. } => {
                    self.cut(&cut, [at.r, to.r + by.y], writer);
                    *at = to + by;
                }
                CutMove::ThreadPass { to, rpm, .. } => {
                    self.fixed(rpm, writer);
                    *at = to + by;
                }
                CutMove::Thread { rpm, .. } => self.fixed(rpm, writer),
                CutMove::Dwell { .. } => {}
                CutMove::Repeat { count, step, ref body } => {
                    self.moves(body, writer, at, by);
                    if count > 1 {
                        self.moves(body, writer, at, by + step * f64::from(count - 1));
                    }
                }
            }
        }
    }

    fn cut(&mut self, cut: &Cut, radii: [f64; 2], writer: &Writer<'_>) {
        let [a, b] = radii.map(f64::abs);
        self.first.get_or_insert_with(|| writer.control.spindle(cut, a.max(b)));
        let rpm = match cut.speed {
            Speed::Rpm(rpm) => rpm,
            Speed::Surface { m_per_min, .. } => m_per_min * 1000.0 / (std::f64::consts::TAU * a.min(b)),
        };
        self.highest_rpm = self.highest_rpm.max(rpm);
    }

    fn fixed(&mut self, rpm: f64, writer: &Writer<'_>) {
        self.first.get_or_insert_with(|| writer.control.fixed(rpm));
        self.highest_rpm = self.highest_rpm.max(rpm);
    }

    /// True if a cut would turn faster than the clamp lets it.
    pub(super) fn reach_clamp(&self) -> bool {
        matches!(self.first, Some(Spindle::Surface { most_rpm, .. }) if rounded(self.highest_rpm) > most_rpm)
    }
}
