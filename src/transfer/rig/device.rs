//! The microcontroller's side: takes lines, runs the controller on its rig. Time comes from outside, so that it runs as fast
//! as its caller wants.

use super::frame::{Frame, LONGEST};
use super::why::Why;
use crate::spinning::control::{Controller, Phase, Plan, Target, Watch};
use crate::spinning::rig::{Rig, SimulatedRig, valve};

/// Most set points that the device has room for.
const MOST_POINTS: usize = 4096;

/// A device that hears nothing for so long while it runs stops, s of the line's time.
const SILENCE_S: f64 = 2.0;

/// A table that is being sent.
#[derive(Debug, Clone)]
struct Table {
    expected: usize,
    plan: Plan,
}

/// The simulated device.
#[derive(Debug)]
pub struct Device {
    rig: SimulatedRig,
    table: Option<Table>,
    run: Option<Controller>,
    /// The roller is on its way to the datum, without a run.
    seeks_datum: bool,
    /// The run was stopped because nothing was heard.
    was_deaf: bool,
    /// Longest silence in a run, s of the rig's time.
    silence_s: f64,
    began_s: f64,
    heard_s: f64,
    line: Vec<u8>,
}

impl Device {
    /// A device that has just been switched on.
    #[must_use]
    pub const fn new(rig: SimulatedRig) -> Self {
        Self {
            rig,
            table: None,
            run: None,
            seeks_datum: false,
            was_deaf: false,
            silence_s: SILENCE_S,
            began_s: 0.0,
            heard_s: 0.0,
            line: Vec::new(),
        }
    }

    /// The same with a rig whose time passes `pace` times as fast as that of its line.
    #[must_use]
    pub fn at_pace(self, pace: f64) -> Self {
        Self { silence_s: SILENCE_S * pace.max(1.0), ..self }
    }

    /// The rig, to look at or to break.
    pub const fn rig_mut(&mut self) -> &mut SimulatedRig {
        &mut self.rig
    }

    /// Lets time pass.
    pub fn advance(&mut self, seconds: f64) {
        let until = self.rig.time_s() + seconds;
        while self.rig.time_s() < until && self.turn() {}
    }

    /// One turn of the loop; false if nothing moves.
    fn turn(&mut self) -> bool {
        let deaf = self.rig.time_s() - self.heard_s > self.silence_s;
        if self.seeks_datum {
            self.draw_back(deaf);
            return true;
        }
        let Some(run) = self.run.as_mut().filter(|run| !run.phase().is_over()) else { return false };
        if deaf && !matches!(run.phase(), Phase::Stopping(_)) {
            self.was_deaf = true;
            run.emergency_stop(&mut self.rig);
        }
        run.step(&mut self.rig);
        true
    }

    /// Towards the datum, until the switch closes or nobody listens any more.
    fn draw_back(&mut self, deaf: bool) {
        let there = self.rig.read().at_datum || deaf;
        self.rig.set_pump(true);
        self.rig.set_valve(if there { valve::STOP } else { valve::RETRACT });
        self.seeks_datum = !there;
    }

    /// Takes bytes from the line; returns what is answered.
    pub fn take(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut answers = String::new();
        for &byte in bytes {
            if byte == b'\n' {
                let line = String::from_utf8_lossy(&std::mem::take(&mut self.line)).into_owned();
                answers.push_str(&self.answer(&line).to_string());
            } else if self.line.len() < LONGEST {
                self.line.push(byte);
            }
        }
        answers.into_bytes()
    }

    fn answer(&mut self, line: &str) -> Frame {
        let frame = match Frame::read(line) {
            Ok(frame) => frame,
            Err(error) => return Frame::word('E', error.code()),
        };
        self.heard_s = self.rig.time_s();
        match frame.letter {
            'H' => Frame { letter: 'H', words: vec!["turnwright-rig".to_owned(), "1".to_owned()] },
            'B' => self.begin(&frame),
            'S' => self.set_point(&frame),
            'G' => self.go(),
            'Z' if self.is_running() => Frame::word('E', "order"),
            'Z' => {
                self.seeks_datum = true;
                Frame::of('K', &[0])
            }
            'Q' => self.position(),
            'Y' => self.why().frame(),
            'X' => self.emergency(),
            _ => Frame::word('E', "line"),
        }
    }

    fn emergency(&mut self) -> Frame {
        if self.is_running() {
            self.run.iter_mut().for_each(|run| run.emergency_stop(&mut self.rig));
        } else {
            self.seeks_datum = false;
            self.rig.set_valve(valve::STOP);
            self.rig.set_pump(false);
        }
        Frame::of('K', &[0])
    }

    fn why(&self) -> Why {
        match self.run.as_ref().map(Controller::phase) {
            Some(Phase::Stopping(_) | Phase::Stopped { .. }) if self.was_deaf => Why::word("silence"),
            Some(Phase::Stopping(reason) | Phase::Stopped { reason, .. }) => Why::of(reason),
            _ => Why::word("none"),
        }
    }

    fn is_running(&self) -> bool {
        self.run.as_ref().is_some_and(|run| !run.phase().is_over())
    }

    fn begin(&mut self, frame: &Frame) -> Frame {
        let Some([count, roller, advance, retract, limit_um, um_per_s]) = frame.figures() else {
            return Frame::word('E', "line");
        };
        if self.is_running() {
            return Frame::word('E', "order");
        }
        let codes = u8::try_from(advance).ok().zip(u8::try_from(retract).ok());
        let count_fits = usize::try_from(count).ok().filter(|n| (1..=MOST_POINTS).contains(n));
        let roller = i32::try_from(roller).ok();
        let (Some((advance, retract)), Some(expected), Some(roller)) = (codes, count_fits, roller) else {
            return Frame::word('E', "range");
        };
        let watch = Watch { limit_mm: limit_um as f64 / 1000.0, carriage_mm_per_s: um_per_s as f64 / 1000.0 };
        let plan = Plan { advance, retract, watch: (limit_um > 0).then_some(watch), ..Plan::along(&[], roller) };
        self.table = Some(Table { expected, plan });
        Frame::of('K', &[count])
    }

    fn set_point(&mut self, frame: &Frame) -> Frame {
        let Some([index, pulses, steps]) = frame.figures() else { return Frame::word('E', "line") };
        let running = self.is_running();
        let Some(table) = self.table.as_mut().filter(|_| !running) else { return Frame::word('E', "order") };
        let targets = &mut table.plan.targets;
        let point = u32::try_from(pulses).ok().zip(i32::try_from(steps).ok());
        let (Ok(index), Some((pulses, steps))) = (usize::try_from(index), point) else {
            return Frame::word('E', "range");
        };
        let target = Target { pulses, steps };
        let told_again = targets.get(index) == Some(&target);
        let rises = targets.last().is_none_or(|last| last.pulses < pulses);
        if !told_again {
            if index != targets.len() || index >= table.expected {
                return Frame::word('E', "order");
            }
            if !rises {
                return Frame::word('E', "range");
            }
            targets.push(target);
        }
        Frame::of('K', &[i64::try_from(index).unwrap_or_default()])
    }

    fn go(&mut self) -> Frame {
        let complete = self.table.as_ref().filter(|t| t.plan.targets.len() == t.expected);
        let (Some(table), false) = (complete, self.is_running()) else { return Frame::word('E', "table") };
        self.began_s = self.rig.time_s();
        self.rig.bring_back();
        (self.seeks_datum, self.was_deaf) = (false, false);
        self.run = Some(Controller::new(table.plan.clone()));
        Frame::of('K', &[i64::try_from(table.expected).unwrap_or_default()])
    }

    fn position(&mut self) -> Frame {
        let reading = self.rig.read();
        #[allow(clippy::cast_possible_truncation, reason = "milliseconds of a run")]
        let ms = ((reading.time_s - self.began_s) * 1000.0) as i64;
        let mut frame = Frame::of('P', &[ms, i64::from(reading.pulses), i64::from(reading.steps)]);
        frame.words.push(self.state().to_owned());
        frame
    }

    fn state(&self) -> &'static str {
        if self.seeks_datum {
            return "T";
        }
        match self.run.as_ref().map(Controller::phase) {
            None => "I",
            Some(Phase::ToDatum) => "T",
            Some(Phase::Advance) => "A",
            Some(Phase::RunUp) => "U",
            Some(Phase::Follow) => "F",
            Some(Phase::Retract) => "R",
            Some(Phase::Settle) => "W",
            Some(Phase::Completed) => "C",
            Some(Phase::Stopping(_)) => "X",
            Some(Phase::Stopped { drawn_back: true, .. }) => "D",
            Some(Phase::Stopped { drawn_back: false, .. }) => "N",
        }
    }
}
