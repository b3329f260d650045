//! Runs a program as the control would: formats, units, positions, loops and subroutines. Emits moves in part space.

use super::findings::{Breach, Findings, Place};
use super::reader::{Block, CLOCKWISE, Listing, Op, Word};
use super::report::FindingKind;
use super::step::{Drive, Feed, STEP_BUDGET, Speed, Step, Thread};
use super::structure::{Structure, whole};
use crate::cancel::Cancelled;
use crate::geometry::{Point, Segment};
use crate::units::{MM_PER_INCH, Unit};

/// Subroutines that may be open at once. The control's own limit is not published; honest programs need two or three.
const CALL_DEPTH: usize = 16;
/// Ends of an arc may be this much further apart than its diameter, mm: both are rounded to 0.001.
const ARC_END_TOLERANCE_MM: f64 = 0.002;

/// What the control remembers from one program to the next.
#[derive(Debug, Clone, Default)]
pub(super) struct Control {
    /// Known position of the programmed point.
    pub position: Option<Point>,
    /// Datum of the program that ran last.
    pub datum: Option<Point>,
    /// Part-space position of the control's zero.
    pub zero_z: f64,
    /// Where the tool is assumed to be if a program moves before it sets its datum.
    pub assumed: Point,
    tool: u32,
    feed: f64,
    rpm: f64,
}

/// A loop or a call that is being run.
enum Frame {
    Loop { first: usize, left: u64 },
    Call { from: usize, number: u64 },
}

/// Takes the steps of a program as they are run, with the block from 1 that each one comes from.
pub(super) trait Sink {
    /// Takes one block that runs, before its step.
    fn block(&mut self, block: usize);
    /// Takes one step.
    fn step(&mut self, block: usize, step: Step, findings: &mut Findings) -> Result<(), Cancelled>;
}

impl Control {
    /// A control that knows nothing yet.
    pub(super) fn new(zero_z: f64, assumed: Point) -> Self {
        Self { zero_z, assumed, ..Self::default() }
    }

    /// Runs a program to its end.
    pub(super) fn run(
        &mut self,
        listing: &Listing,
        structure: &Structure,
        program: usize,
        findings: &mut Findings,
        sink: &mut impl Sink,
    ) -> Result<(), Cancelled> {
        Run {
            control: self,
            listing,
            structure,
            program,
            findings,
            frames: Vec::new(),
            absolute: None,
            unit: None,
            thread_steps: 0,
        }
        .run(sink)
    }
}

struct Run<'a> {
    control: &'a mut Control,
    listing: &'a Listing,
    structure: &'a Structure,
    program: usize,
    findings: &'a mut Findings,
    frames: Vec<Frame>,
    absolute: Option<bool>,
    unit: Option<Unit>,
    thread_steps: u32,
}

impl Run<'_> {
    fn run(mut self, sink: &mut impl Sink) -> Result<(), Cancelled> {
        let listing = self.listing;
        let (mut next, mut steps) = (0, 0);
        while let Some(block) = listing.blocks.get(next) {
            steps += 1;
            if steps + self.thread_steps > STEP_BUDGET {
                let message =
                    format!("The program runs more than {STEP_BUDGET} blocks and was stopped: a loop without end.");
                self.control_error(next, "endless", f64::from(steps), f64::from(STEP_BUDGET), message);
                break;
            }
            sink.block(next + 1);
            match block.op {
                Some(Op::End) => break,
                Some(op @ (Op::Do | Op::EndDo | Op::Call | Op::Sub | Op::EndSub)) => next = self.jump(op, block, next),
                Some(op) => {
                    if let Some(step) = self.act(op, block, next) {
                        sink.step(next + 1, step, self.findings)?;
                    }
                    next += 1;
                }
                None => next += 1,
            }
        }
        Ok(())
    }

    fn control_error(&mut self, index: usize, rule: &'static str, value: f64, limit: f64, message: String) {
        let place = Place { program: self.program, block: index + 1 };
        self.findings.add(place, Breach::error(rule, FindingKind::Control, value, limit, message));
    }

    /// Index of the block that follows a loop or subroutine instruction.
    fn jump(&mut self, op: Op, block: &Block, index: usize) -> usize {
        match op {
            Op::Do => self.enter_loop(block, index),
            Op::EndDo => self.repeat(index),
            Op::Call => self.call(block, index),
            // A subroutine reached in sequence is passed over.
            Op::Sub => self.structure.end_of_sub.get(&index).map_or(index, |&end| end) + 1,
            _ => self.return_from(index),
        }
    }

    fn enter_loop(&mut self, block: &Block, index: usize) -> usize {
        let count = block.value(Word::Count).map_or(1, whole);
        if count == 0 {
            self.control_error(
                index,
                "no count",
                0.0,
                1.0,
                "A loop must run at least once; its count is 0.".to_owned(),
            );
        }
        self.frames.push(Frame::Loop { first: index + 1, left: count.max(1) - 1 });
        index + 1
    }

    fn repeat(&mut self, index: usize) -> usize {
        match self.frames.last_mut() {
            Some(Frame::Loop { first, left }) if *left > 0 => {
                *left -= 1;
                return *first;
            }
            Some(Frame::Loop { .. }) => {
                self.frames.pop();
            }
            _ => {}
        }
        index + 1
    }

    fn call(&mut self, block: &Block, index: usize) -> usize {
        let Some(number) = block.value(Word::Number).map(whole) else { return index + 1 };
        let calls = self.frames.iter().filter(|f| matches!(f, Frame::Call { .. })).count();
        let running = self.frames.iter().any(|f| matches!(f, Frame::Call { number: n, .. } if *n == number));
        let target = self.structure.subs.get(&number).copied();
        let problem = match target {
            None => Some(format!("Subroutine {number} is called, but the program does not contain it.")),
            Some(_) if running => Some(format!("Subroutine {number} calls itself; the call is not followed.")),
            Some(_) if calls >= CALL_DEPTH => {
                Some(format!("Subroutine {number} is nested {} deep; {CALL_DEPTH} is the limit.", calls + 1))
            }
            Some(_) => None,
        };
        if let Some(message) = problem {
            self.control_error(index, "call", (calls + 1) as f64, CALL_DEPTH as f64, message);
            return index + 1;
        }
        self.frames.push(Frame::Call { from: index, number });
        target.map_or(index, |t| t) + 1
    }

    fn return_from(&mut self, index: usize) -> usize {
        while let Some(frame) = self.frames.pop() {
            if let Frame::Call { from, .. } = frame {
                return from + 1;
            }
        }
        index + 1
    }

    /// Does what a block says and returns what it moves.
    fn act(&mut self, op: Op, block: &Block, index: usize) -> Option<Step> {
        match op {
            Op::Incremental | Op::Absolute => self.absolute = Some(op == Op::Absolute),
            Op::Millimetre => self.unit = Some(Unit::Mm),
            Op::Inch => self.unit = Some(Unit::Inch),
            Op::Datum => return Some(self.datum(block, index)),
            Op::Straight => return Some(self.straight(block, index)),
            Op::Arc => return Some(self.arc(block, index)),
            Op::Thread => return self.thread(block, index).map(Step::Thread),
            Op::Dwell => return Some(self.dwell(block, index)),
            Op::Input | Op::Output => return Some(Step::Pause(0.0)),
            _ => {}
        }
        None
    }

    fn dwell(&mut self, block: &Block, index: usize) -> Step {
        let seconds = block.value(Word::Seconds).unwrap_or(0.0);
        if seconds < 0.0 {
            let message = format!("A dwell of {seconds} s is less than no time.");
            self.control_error(index, "dwell", seconds, 0.0, message);
        }
        Step::Pause(seconds.max(0.0))
    }

    fn mm(&mut self, value: f64, index: usize) -> f64 {
        if self.unit.is_none() {
            self.unit = Some(Unit::Mm);
            self.assumed(index, "units", "The program does not say MM or IN before it moves; mm is assumed.");
        }
        value * if self.unit == Some(Unit::Inch) { MM_PER_INCH } else { 1.0 }
    }

    fn is_absolute(&mut self, index: usize) -> bool {
        if self.absolute.is_none() {
            self.absolute = Some(true);
            self.assumed(index, "format", "The program does not say INC or ABS before it moves; ABS is assumed.");
        }
        self.absolute == Some(true)
    }

    fn assumed(&mut self, index: usize, rule: &'static str, message: &str) {
        let place = Place { program: self.program, block: index + 1 };
        let breach = Breach::error(rule, FindingKind::Structure, 0.0, 1.0, message.to_owned());
        self.findings.add(place, breach.into_warning());
    }

    fn datum(&mut self, block: &Block, index: usize) -> Step {
        let from = self.control.position;
        let x = block.value(Word::X).map(|v| self.mm(v, index));
        let z = block.value(Word::Z).map(|v| self.mm(v, index) + self.control.zero_z);
        let old = from.unwrap_or(self.control.assumed);
        let to = Point::new(z.unwrap_or(old.z), x.unwrap_or(old.r));
        self.control.position = Some(to);
        self.control.datum = Some(to);
        Step::Datum { from, to }
    }

    /// Where the tool is; if nobody knows, that is said once and a place is assumed.
    fn position(&mut self, index: usize) -> Point {
        if let Some(position) = self.control.position {
            self.control.datum.get_or_insert(position);
            return position;
        }
        let place = Place { program: self.program, block: index + 1 };
        let message = "The program moves before PDAT sets its datum, so nobody knows where the tool is.".to_owned();
        self.findings.add(place, Breach::error("no datum", FindingKind::Structure, 0.0, 1.0, message));
        let assumed = self.control.assumed;
        self.control.position = Some(assumed);
        self.control.datum = Some(assumed);
        assumed
    }

    fn target(&mut self, block: &Block, from: Point, index: usize) -> Point {
        let absolute = self.is_absolute(index);
        let zero_z = self.control.zero_z;
        let x = block.value(Word::X).map(|v| self.mm(v, index));
        let z = block.value(Word::Z).map(|v| self.mm(v, index));
        if absolute {
            Point::new(z.map_or(from.z, |z| z + zero_z), x.unwrap_or(from.r))
        } else {
            Point::new(from.z + z.unwrap_or(0.0), from.r + x.unwrap_or(0.0))
        }
    }

    /// Feed, tool and speed of the block; a value that cannot be read stays as it was.
    fn modal(&mut self, block: &Block, index: usize) {
        if let Some(feed) = block.value(Word::Feed) {
            self.control.feed = self.mm(feed, index);
        }
        if let Some(tool) = block.value(Word::Tool) {
            self.control.tool = u32::try_from(whole(tool)).unwrap_or(u32::MAX);
        }
        self.control.rpm = block.value(Word::Speed).unwrap_or(self.control.rpm);
    }

    fn moved(&mut self, path: Segment) -> Step {
        self.control.position = Some(path.end());
        let (feed, speed) = (Feed::PerMinute(self.control.feed), Speed::Rpm(self.control.rpm));
        Step::Move { path, drive: Drive { rapid: false, feed, speed }, tool: self.control.tool }
    }

    fn straight(&mut self, block: &Block, index: usize) -> Step {
        let from = self.position(index);
        let to = self.target(block, from, index);
        self.modal(block, index);
        self.moved(Segment::line(from, to))
    }

    fn arc(&mut self, block: &Block, index: usize) -> Step {
        let from = self.position(index);
        let to = self.target(block, from, index);
        self.modal(block, index);
        let radius = block.value(Word::Radius).map(|v| self.mm(v, index));
        let ccw = block.value(Word::Sense).map(|sense| sense != CLOCKWISE);
        let (Some(radius), Some(ccw)) = (radius, ccw) else { return self.moved(Segment::line(from, to)) };
        let chord = from.distance(to);
        if radius <= 0.0 || chord <= 0.0 || chord > 2.0 * radius + ARC_END_TOLERANCE_MM {
            let message = format!(
                "No arc of radius {radius:.3} mm joins two points {chord:.3} mm apart; the distance must be above 0 and at most {:.3} mm.",
                2.0 * radius
            );
            let place = Place { program: self.program, block: index + 1 };
            let breach = Breach::error("arc impossible", FindingKind::OutsideLimits, chord, 2.0 * radius, message);
            self.findings.add(place, breach.at(from));
            return self.moved(Segment::line(from, to));
        }
        self.moved(arc_between(from, to, radius, ccw))
    }

    fn thread(&mut self, block: &Block, index: usize) -> Option<Thread> {
        let from = self.position(index);
        let to_z = self.target(block, from, index).z;
        self.modal(block, index);
        let mut length = |word| block.value(word).map(|v| self.mm(v, index));
        let outside_radius = length(Word::Outside)? / 2.0;
        let base_radius = length(Word::Base)? / 2.0;
        let pitch = length(Word::Pitch)?;
        let depth = length(Word::Depth)?;
        let thread = Thread {
            from,
            to_z,
            outside_radius,
            base_radius,
            pitch,
            depth,
            tool: self.control.tool,
            rpm: self.control.rpm,
        };
        self.thread_steps = self.thread_steps.saturating_add(thread.passes());
        Some(thread)
    }
}

/// The arc of at most half a turn with the given sense.
fn arc_between(start: Point, end: Point, radius: f64, ccw: bool) -> Segment {
    let chord = end - start;
    let half = chord.norm() / 2.0;
    let height = (radius * radius - half * half).max(0.0).sqrt();
    let left = nalgebra::Vector2::new(-chord.y, chord.x) / (2.0 * half);
    let middle = start + chord / 2.0;
    let center = if ccw { middle + left * height } else { middle - left * height };
    Segment::Arc { start, end, center, ccw }
}
