//! Takes the steps of running programs: checks them against the machine, cuts the stock, counts the time.

use super::control::Sink;
use super::findings::{Breach, Findings, Place};
use super::input::ProofInput;
use super::judge::Judge;
use super::prove::{start, zero_z};
use super::record::{Played, Record};
use super::report::{FindingKind, Motion};
use super::step::{Drive, Step, Thread};
use super::{limits, times};
use crate::cancel::{Cancel, Cancelled};
use crate::geometry::{Point, Segment};
use crate::machine::Axis;

/// Takes the steps of the programs as they run.
pub(super) struct Run<'a> {
    pub input: &'a ProofInput,
    cancel: &'a Cancel,
    program: usize,
    pub record: Record,
    pub judge: Option<Judge<'a>>,
    travel: limits::Travel,
    tool: Option<u32>,
    at: Point,
}

impl<'a> Run<'a> {
    /// Before the first program.
    pub(super) fn new(input: &'a ProofInput, cancel: &'a Cancel) -> Self {
        Self {
            input,
            cancel,
            program: 0,
            record: Record::default(),
            judge: Judge::new(input),
            travel: limits::Travel::default(),
            tool: None,
            at: start(input),
        }
    }
}

impl Sink for Run<'_> {
    fn block(&mut self, block: usize) {
        if let Some(report) = self.record.block(block) {
            report.runs += 1;
        }
    }

    fn step(&mut self, block: usize, step: Step, findings: &mut Findings) -> Result<(), Cancelled> {
        self.cancel.check()?;
        let place = Place { program: self.program, block };
        match step {
            Step::Datum { from, to } => self.datum(place, from, to, findings),
            Step::Move { path, drive, tool } => self.moved(place, path, drive, tool, findings),
            Step::ThreadPass { path, lead, rpm, tool } => self.single_pass(place, path, lead, rpm, tool, findings),
            Step::Thread(thread) => self.thread(place, &thread, findings)?,
            Step::Pause(seconds) => self.pause(place, seconds),
        }
        Ok(())
    }
}

impl Run<'_> {
    /// Starts a program with its blocks' own numbers.
    pub(super) fn begin_program(&mut self, program: usize, printed: &[Option<u32>]) {
        self.program = program;
        let name = self.input.programs.get(program).map_or("", |p| p.name.as_str());
        self.record.begin_program(name, printed);
    }

    /// Ends a program.
    pub(super) fn end_program(&mut self, findings: &mut Findings) {
        if let Some(judge) = &mut self.judge {
            judge.end_program(findings);
        }
    }

    /// The first datum is reached from the program zero, as published; its path is not known, so it only takes time.
    fn datum(&mut self, place: Place, from: Option<Point>, to: Point, findings: &mut Findings) {
        let zero = Point::new(zero_z(self.input), 0.0);
        let lasts_s = times::rapid_seconds(&self.input.machine, from.unwrap_or(zero), to);
        let path = Segment::line(from.unwrap_or(to), to);
        self.travel.cover(&path, &self.input.machine, place, findings);
        let tool = self.tool.unwrap_or(0);
        let feed = self.input.machine.rapid_mm_per_min(Axis::Z);
        self.cut_and_play(place, Played { path, motion: Motion::Rapid, tool, feed, rpm: 0.0, lasts_s }, findings);
    }

    fn moved(&mut self, place: Place, path: Segment, drive: Drive, tool: u32, findings: &mut Findings) {
        let machine = &self.input.machine;
        limits::check_move(&path, &drive, machine, place, findings);
        self.travel.cover(&path, machine, place, findings);
        let played = times::played(&path, &drive, tool, machine);
        self.change_tool(place, path.start(), tool, played.rpm, findings);
        self.cut_and_play(place, played, findings);
    }

    /// One threading pass of a control that has a word for it.
    fn single_pass(&mut self, place: Place, path: Segment, lead: f64, rpm: f64, tool: u32, findings: &mut Findings) {
        let machine = &self.input.machine;
        limits::check_pass(&path, lead, rpm, machine, place, findings);
        self.travel.cover(&path, machine, place, findings);
        self.change_tool(place, path.start(), tool, rpm, findings);
        let feed = lead * rpm;
        let lasts_s = if feed > 0.0 { path.length() / feed * 60.0 } else { 0.0 };
        let played = Played { path, motion: Motion::Thread, tool, feed, rpm, lasts_s };
        if let Some(judge) = &mut self.judge {
            judge.threaded(place, &played, lead, 1, &mut self.record, findings);
        }
        self.play(place, played);
    }

    /// The tool that is in place at the first move costs no time.
    fn change_tool(&mut self, place: Place, at: Point, tool: u32, rpm: f64, findings: &mut Findings) {
        if self.tool == Some(tool) {
            return;
        }
        if !self.input.tools.contains_key(&tool) {
            let stations = self.input.tools.keys().map(u32::to_string).collect::<Vec<_>>().join(", ");
            let message = format!("Tool {tool} is not in the turret; stations {stations} are.");
            findings.add(place, Breach::error("tool", FindingKind::OutsideLimits, f64::from(tool), 0.0, message));
        }
        let changes = self.tool.replace(tool).is_some();
        let lasts_s = if changes { self.input.machine.tool_change_s } else { 0.0 };
        if changes {
            let path = Segment::line(at, at);
            let played = Played { path, motion: Motion::Pause, tool, feed: 0.0, rpm, lasts_s };
            self.cut_and_play(place, played, findings);
        }
        self.record.times.tool_change_s += lasts_s;
    }

    fn pause(&mut self, place: Place, lasts_s: f64) {
        let path = Segment::line(self.at, self.at);
        self.play(
            place,
            Played { path, motion: Motion::Pause, tool: self.tool.unwrap_or(0), feed: 0.0, rpm: 0.0, lasts_s },
        );
        self.record.times.dwell_s += lasts_s;
    }

    fn cut_and_play(&mut self, place: Place, played: Played, findings: &mut Findings) {
        if let Some(judge) = &mut self.judge {
            judge.moved(place, &played, &mut self.record, findings);
        }
        self.play(place, played);
    }

    fn play(&mut self, place: Place, played: Played) {
        self.at = played.path.end();
        self.record.play(place, played);
    }

    /// Every pass: in at the present position, along the thread, out, and back.
    fn thread(&mut self, place: Place, thread: &Thread, findings: &mut Findings) -> Result<(), Cancelled> {
        let machine = &self.input.machine;
        let can_run = limits::check_thread(thread, machine, place, findings);
        let from = thread.from;
        let reach = Segment::line(from, Point::new(thread.to_z, thread.base_radius));
        self.travel.cover(&reach, machine, place, findings);
        self.change_tool(place, from, thread.tool, thread.rpm, findings);
        if !can_run {
            return Ok(());
        }
        let passes = thread.passes();
        for pass in 1..=passes {
            self.cancel.check()?;
            let depth = (f64::from(pass) * thread.depth).min(thread.outside_radius - thread.base_radius);
            self.thread_pass(
                place,
                thread,
                thread.outside_radius - depth,
                (pass == passes).then_some(passes),
                findings,
            );
        }
        Ok(())
    }

    /// One pass; the stock is cut by the last one, in whose grooves all others lie.
    fn thread_pass(
        &mut self,
        place: Place,
        thread: &Thread,
        radius: f64,
        last_of: Option<u32>,
        findings: &mut Findings,
    ) {
        let (rapid, rpm, from) = (self.input.machine.rapid_mm_per_min(Axis::Z), thread.rpm, thread.from);
        let near = Point::new(from.z, radius);
        let far = Point::new(thread.to_z, radius);
        let out = Point::new(thread.to_z, from.r);
        for (start, end, motion) in [
            (from, near, Motion::Rapid),
            (near, far, Motion::Thread),
            (far, out, Motion::Rapid),
            (out, from, Motion::Rapid),
        ] {
            let feed = if motion == Motion::Thread { thread.pitch * rpm } else { rapid };
            let path = Segment::line(start, end);
            let played = Played { path, motion, tool: thread.tool, feed, rpm, lasts_s: path.length() / feed * 60.0 };
            if let (Some(judge), Some(passes)) = (&mut self.judge, last_of) {
                if motion == Motion::Thread {
                    judge.threaded(place, &played, thread.pitch, passes, &mut self.record, findings);
                } else {
                    judge.moved(place, &played, &mut self.record, findings);
                }
            }
            self.play(place, played);
        }
    }
}
