//! Runs the programs of one set-up one after another and puts the report together.

use super::control::{Control, Sink};
use super::findings::{Breach, Findings, Place};
use super::input::ProofInput;
use super::judge::Judge;
use super::reader::{self, Listing};
use super::record::{Played, Record};
use super::report::{FindingKind, Motion, ProofReport, StockState};
use super::step::{Step, Thread};
use super::{limits, structure};
use crate::cancel::{Cancel, Cancelled};
use crate::diagnostic::Severity;
use crate::geometry::{Point, Segment};
use crate::machine::Axis;

/// A program's increments may miss its datum by this much, mm, before it counts as not closed: each is rounded to 0.001, and
/// the published programs add up to 0.001.
const CLOSING_TOLERANCE_MM: f64 = 0.0015;

/// Proves programs: reads them, runs them, checks every move against the machine, cuts the stock and measures what is left.
///
/// # Errors
/// [`Cancelled`] if `cancel` was asked to stop.
pub fn prove(input: &ProofInput, cancel: &Cancel) -> Result<ProofReport, Cancelled> {
    let names: Vec<String> = input.programs.iter().map(|p| p.name.clone()).collect();
    let listings: Vec<Listing> = input.programs.iter().map(|p| reader::read(&p.text)).collect();
    let mut findings = Findings::default();
    let mut control = Control::new(zero_z(input), start(input));
    let mut run = Run::new(input, cancel);
    for (program, listing) in listings.iter().enumerate() {
        cancel.check()?;
        report_troubles(listing, program, &mut findings);
        let structure = structure::check(listing, program, input.machine.limits.blocks_per_program, &mut findings);
        run.program = program;
        run.record.begin_program(&names[program], listing.blocks.len());
        control.datum = None;
        control.run(listing, &structure, program, &mut findings, &mut run)?;
        let next_sets_datum = listings.get(program + 1).is_none_or(sets_datum_first);
        if let Some(judge) = &mut run.judge {
            judge.end_program(&mut findings);
        }
        check_closed(&control, Place { program, block: listing.blocks.len().max(1) }, next_sets_datum, &mut findings);
    }
    let last = Place {
        program: listings.len().saturating_sub(1),
        block: listings.last().map_or(1, |l| l.blocks.len().max(1)),
    };
    Ok(report(run, findings, last, &names))
}

fn zero_z(input: &ProofInput) -> f64 {
    input.work.as_ref().map_or(0.0, |work| work.program_zero_z)
}

/// Where the tool is taken to be if a program does not say so: the machine's usual datum.
fn start(input: &ProofInput) -> Point {
    let bar = input.work.as_ref().and_then(|work| work.stock.bounds()).map_or(0.0, |b| b.max.r);
    let datum = &input.machine.datum;
    Point::new(zero_z(input) + datum.axial_clearance_mm, bar + datum.radial_clearance_mm)
}

fn report_troubles(listing: &Listing, program: usize, findings: &mut Findings) {
    for trouble in &listing.troubles {
        let message = format!("Line {}: {}", trouble.line, trouble.message);
        let breach = Breach::error("unreadable", FindingKind::Unreadable, 1.0, 0.0, message);
        findings.add_each(Place { program, block: trouble.block }, breach);
    }
}

/// True if the program says where the tool is before it moves.
fn sets_datum_first(listing: &Listing) -> bool {
    use reader::Op;
    let first = listing
        .blocks
        .iter()
        .filter_map(|b| b.op)
        .find(|op| matches!(op, Op::Datum | Op::Straight | Op::Arc | Op::Thread | Op::Call));
    first.is_none_or(|op| op == Op::Datum)
}

/// A length as it is printed with three decimals, mm; never −0.
fn shown(mm: f64) -> f64 {
    (mm * 1000.0).round() / 1000.0 + 0.0
}

fn check_closed(control: &Control, place: Place, next_sets_datum: bool, findings: &mut Findings) {
    let (Some(datum), Some(position)) = (control.datum, control.position) else { return };
    let miss = position - datum;
    let largest = miss.x.abs().max(miss.y.abs());
    if largest <= CLOSING_TOLERANCE_MM {
        return;
    }
    let follows = if next_sets_datum { "" } else { " The next program starts there without a datum of its own." };
    let message = format!(
        "The program does not end at its datum: it misses it by {:.3} mm in x and {:.3} mm in z; {CLOSING_TOLERANCE_MM} mm is allowed.{follows}",
        shown(miss.y),
        shown(miss.x)
    );
    let breach =
        Breach::error("not closed", FindingKind::NotClosed, largest, CLOSING_TOLERANCE_MM, message).at(position);
    findings.add(place, if next_sets_datum { breach.into_warning() } else { breach });
}

fn report(run: Run<'_>, mut findings: Findings, last: Place, names: &[String]) -> ProofReport {
    let mut record = run.record;
    let mut report = ProofReport::default();
    if let Some(judge) = run.judge {
        record.finish(judge.stock().state());
        report.leftover = judge.leftover(last, &mut findings);
        report.deepest_gouge_mm = judge.deepest_gouge_mm();
    }
    let findings = findings.in_order(names);
    ProofReport {
        passed: findings.iter().all(|f| f.severity != Severity::Error),
        findings,
        times: record.times,
        largest_chip_mm2: record.blocks.iter().map(|b| b.chip_mm2).fold(0.0, f64::max),
        blocks: record.blocks,
        moves: record.moves,
        stock: record.stock,
        ..report
    }
}

/// Takes the steps of the programs as they run.
struct Run<'a> {
    input: &'a ProofInput,
    cancel: &'a Cancel,
    program: usize,
    record: Record,
    judge: Option<Judge<'a>>,
    travel: limits::Travel,
    tool: Option<u32>,
    at: Point,
}

impl<'a> Run<'a> {
    fn new(input: &'a ProofInput, cancel: &'a Cancel) -> Self {
        let judge = Judge::new(input);
        let stock = judge.as_ref().map_or_else(StockState::default, |judge| judge.stock().state());
        Self {
            input,
            cancel,
            program: 0,
            record: Record::new(stock),
            judge,
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
            Step::Move { path, feed, tool, rpm } => self.moved(place, path, feed, tool, rpm, findings),
            Step::Thread(thread) => self.thread(place, &thread, findings)?,
            Step::Pause(seconds) => self.pause(place, seconds),
        }
        Ok(())
    }
}

impl Run<'_> {
    /// The first datum is reached from the program zero, as published; its path is not known, so it only takes time.
    fn datum(&mut self, place: Place, from: Option<Point>, to: Point, findings: &mut Findings) {
        let feed = self.input.machine.rapid_mm_per_min(Axis::Z);
        let zero = Point::new(zero_z(self.input), 0.0);
        let lasts_s = seconds(from.unwrap_or(zero).distance(to), feed);
        let path = Segment::line(from.unwrap_or(to), to);
        self.travel.cover(&path, &self.input.machine, place, findings);
        let tool = self.tool.unwrap_or(0);
        self.cut_and_play(place, Played { path, motion: Motion::Rapid, tool, feed, rpm: 0.0, lasts_s }, findings);
    }

    fn moved(&mut self, place: Place, path: Segment, feed: f64, tool: u32, rpm: f64, findings: &mut Findings) {
        let machine = &self.input.machine;
        limits::check_move(&path, feed, rpm, machine, place, findings);
        self.travel.cover(&path, machine, place, findings);
        self.change_tool(place, path.start(), tool, rpm, findings);
        let motion = if machine.counts_as_rapid(feed) { Motion::Rapid } else { Motion::Feed };
        self.cut_and_play(
            place,
            Played { path, motion, tool, feed, rpm, lasts_s: seconds(path.length(), feed) },
            findings,
        );
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
            self.play(
                place,
                Played { path: Segment::line(at, at), motion: Motion::Pause, tool, feed: 0.0, rpm, lasts_s },
            );
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
            let played = Played { path, motion, tool: thread.tool, feed, rpm, lasts_s: seconds(path.length(), feed) };
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

/// Time of a move, s; a move without feed takes none, it is an error of its own.
fn seconds(length_mm: f64, feed_mm_per_min: f64) -> f64 {
    if feed_mm_per_min > 0.0 { length_mm / feed_mm_per_min * 60.0 } else { 0.0 }
}
