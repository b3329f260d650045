//! Positions and straight moves.

use super::block::Taken;
use super::codes::G;
use super::compensation::with_start;
use super::state::Motion;
use super::{Run, SAME_MM};
use crate::cancel::Cancelled;
use crate::geometry::{Point, Segment, Vector};
use crate::machine::{Dialect, Preset};
use crate::proof::findings::Breach;
use crate::proof::reader::words::Number;
use crate::proof::report::FindingKind;
use crate::proof::step::{Drive, Step};
use crate::units::Unit;

impl Run<'_, '_> {
    /// A length in mm.
    pub(super) fn mm(&mut self, number: Number) -> f64 {
        if self.state.unit.is_none() {
            self.state.unit = Some(Unit::Mm);
            self.structure_warning(
                "units",
                "The program does not say G20 or G21 before its first length; mm is assumed.",
            );
        }
        let words = self.control.words;
        let value = if self.control.machine.dialect == Dialect::Linuxcnc {
            number.plain()
        } else {
            let inch = self.state.unit == Some(Unit::Inch);
            number.in_increments(if inch { words.decimals_inch } else { words.decimals_mm }, words)
        };
        value * self.state.mm_per_unit()
    }

    /// A length across the spindle that is always a radius, positive away from the axis.
    pub(super) fn radial(&mut self, number: Number) -> f64 {
        self.mm(number) * f64::from(self.control.words.x_sign)
    }

    /// The length of an X or U word as a radius, positive away from the axis.
    pub(super) fn radius(&mut self, number: Number) -> f64 {
        if self.control.machine.dialect == Dialect::Linuxcnc && !self.state.diameter_said {
            self.state.diameter_said = true;
            let taken = if self.state.diameter { "a diameter (G7)" } else { "a radius (G8)" };
            let message = format!("The program does not say G7 or G8 before its first X; {taken} is assumed.");
            self.structure_warning("diameter", &message);
        }
        self.radial(number) / if self.state.diameter { 2.0 } else { 1.0 }
    }

    /// Where the programmed point is, as the program counts.
    pub(super) fn here(&mut self) -> Point {
        if let Some(at) = self.state.at {
            return at;
        }
        if self.control.words.preset == Preset::G50 {
            let message = "The program moves before G50 says where the tool is.".to_owned();
            self.find(Breach::error("no preset", FindingKind::Structure, 0.0, 1.0, message));
        }
        let place = self.true_place();
        self.state.at = Some(place);
        place
    }

    /// The end point that the axis words say; without any, the present point.
    pub(super) fn target(&mut self, words: &mut Taken<'_>) -> Point {
        let here = self.here();
        let (x, z) = (words.take('X'), words.take('Z'));
        // LinuxCNC has no U and W on a lathe without those axes: they stay and are reported.
        let fanuc = self.control.machine.dialect != Dialect::Linuxcnc;
        let (u, w) = if fanuc { (words.take('U'), words.take('W')) } else { (None, None) };
        for (position, step, names) in [(x, u, "X and U"), (z, w, "Z and W")] {
            if position.is_some() && step.is_some() {
                self.unreadable(format!("{names} stand in one block; only one of them can be meant."));
            }
        }
        let from = if self.state.absolute { Vector::zeros() } else { here - Point::default() };
        let along = |value: Option<f64>, step: Option<f64>, from: f64, here: f64| match (value, step) {
            (Some(value), _) => from + value,
            (None, Some(step)) => here + step,
            (None, None) => here,
        };
        let (x, u) = (x.map(|x| self.radius(x)), u.map(|u| self.radius(u)));
        let (z, w) = (z.map(|z| self.mm(z)), w.map(|w| self.mm(w)));
        Point::new(along(z, w, from.x, here.z), along(x, u, from.y, here.r))
    }

    /// Obeys the axis words by the G word of group 1.
    pub(super) fn motion(&mut self, codes: &[G], words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let said = codes.iter().any(|c| matches!(c, G::Motion(_)));
        if !words.moves()
            && !(said && matches!(self.state.motion, Motion::Arc { .. }) && (words.has('I') || words.has('K')))
        {
            return Ok(());
        }
        match self.state.motion {
            Motion::Rapid | Motion::Line => {
                let rapid = self.state.motion == Motion::Rapid;
                let to = self.target(words);
                let from = self.here();
                self.go(Segment::line(from, to), rapid)
            }
            Motion::Arc { ccw } => self.arc(ccw, words),
            Motion::Thread => self.thread_pass_words(words),
            Motion::TurnCycle => self.turn_cycle(words),
            Motion::FaceCycle => self.face_cycle(words),
            Motion::ThreadCycle => self.simple_thread_cycle(words),
            Motion::None => {
                self.control_error(
                    "no motion",
                    0.0,
                    1.0,
                    "Positions stand in a block after G80, which no G word moves to.".into(),
                );
                let to = self.target(words);
                self.state.at = Some(to);
                Ok(())
            }
        }
    }

    /// Drives along a path given as the program counts.
    pub(super) fn go(&mut self, path: Segment, rapid: bool) -> Result<(), Cancelled> {
        let drive = Drive { rapid, ..self.cutting_drive() };
        self.drive(path, drive)
    }

    /// Rapid and straight.
    pub(super) fn rapid_to(&mut self, to: Point) -> Result<(), Cancelled> {
        let from = self.here();
        self.go(Segment::line(from, to), true)
    }

    /// Straight at cutting feed.
    pub(super) fn feed_to(&mut self, to: Point) -> Result<(), Cancelled> {
        let from = self.here();
        self.go(Segment::line(from, to), false)
    }

    /// Feed and speed in force.
    pub(super) fn cutting_drive(&self) -> Drive {
        Drive { rapid: false, feed: self.state.drive_feed(), speed: self.state.drive_speed(self.control.machine) }
    }

    /// Drives along a path given as the program counts.
    pub(super) fn drive(&mut self, path: Segment, drive: Drive) -> Result<(), Cancelled> {
        if !self.count_step() {
            return Ok(());
        }
        self.check_before_move(drive);
        let path = self.moved(path);
        let path = self.compensation.stands.take().map_or(path, |stands| with_start(path, stands));
        if self.compensation.is_on() {
            return self.compensated(path, drive);
        }
        if path.length() == 0.0 {
            return Ok(());
        }
        let tool = self.control.tool.unwrap_or(0);
        self.step(Step::Move { path, drive, tool })
    }

    /// Takes the programmed point along a path and returns the true path in part space.
    pub(super) fn moved(&mut self, path: Segment) -> Segment {
        let shift = self.shift();
        self.state.at = Some(path.end());
        let place = path.end() + shift;
        self.control.place = Some(place);
        path.translated(shift + Vector::new(self.control.zero_z, 0.0))
    }

    /// True place less what the program says; zero, not nearly zero, if they agree.
    pub(super) fn shift(&mut self) -> Vector {
        let at = self.here();
        let shift = self.true_place() - at;
        if shift.norm() <= SAME_MM { Vector::zeros() } else { shift }
    }

    /// G28: over the place that is said to the reference point, on the axes that are said.
    pub(super) fn home(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        self.end_compensation()?;
        let (x, z) = (words.has('X') || words.has('U'), words.has('Z') || words.has('W'));
        let both = !x && !z && self.control.machine.dialect == Dialect::Linuxcnc;
        let over = self.target(words);
        self.rapid_to(over)?;
        let reference = self.reference();
        let shift = self.shift();
        let to = reference - shift;
        self.rapid_to(Point::new(if z || both { to.z } else { over.z }, if x || both { to.r } else { over.r }))
    }

    /// G53: of the machine's coordinates only those of the reference point, 0, are known here.
    pub(super) fn machine_coordinates(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let (x, z) = (words.take('X'), words.take('Z'));
        let known = |n: Option<Number>| n.is_none_or(|n| n.plain() == 0.0);
        if !known(x) || !known(z) {
            let message =
                "G53 goes to a place in machine coordinates that is not known here; only 0, the reference point, is.";
            self.control_error("machine coordinates", 1.0, 0.0, message.to_owned());
            return Ok(());
        }
        let (here, shift) = (self.here(), self.shift());
        let to = self.reference() - shift;
        let rapid = self.state.motion != Motion::Line;
        self.go(Segment::line(here, Point::new(z.map_or(here.z, |_| to.z), x.map_or(here.r, |_| to.r))), rapid)
    }
}
