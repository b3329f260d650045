//! Runs the programs of one set-up one after another and puts the report together.

use super::control::Control;
use super::findings::{Breach, Findings, Place};
use super::input::ProofInput;
use super::interpreter::Interpreter;
use super::reader::words::Tape;
use super::reader::{self, Listing, Trouble};
use super::report::{FindingKind, ProofReport};
use super::run::Run;
use super::{cost, limits, lint, structure};
use crate::cancel::{Cancel, Cancelled};
use crate::diagnostic::Severity;
use crate::geometry::{Point, Vector};
use crate::machine::Dialect;

/// A program's increments may miss its datum by this much, mm, before it counts as not closed: each is rounded to 0.001, and
/// the published programs add up to 0.001.
const CLOSING_TOLERANCE_MM: f64 = 0.0015;

/// Proves programs: reads them, runs them, checks every move against the machine, cuts the stock and measures what is left.
///
/// # Errors
/// [`Cancelled`] if `cancel` was asked to stop.
pub fn prove(input: &ProofInput, cancel: &Cancel) -> Result<ProofReport, Cancelled> {
    let names: Vec<String> = input.programs.iter().map(|p| p.name.clone()).collect();
    let mut findings = Findings::default();
    let mut run = Run::new(input, cancel);
    let last = match input.machine.dialect {
        Dialect::Orac => run_pages(input, cancel, &mut run, &mut findings)?,
        Dialect::Fanuc | Dialect::Linuxcnc => run_words(input, cancel, &mut run, &mut findings)?,
    };
    Ok(report(run, findings, last, &names))
}

/// Runs the ORAC's pages and returns the last block.
fn run_pages(
    input: &ProofInput,
    cancel: &Cancel,
    run: &mut Run<'_>,
    findings: &mut Findings,
) -> Result<Place, Cancelled> {
    let listings: Vec<Listing> = input.programs.iter().map(|p| reader::read(&p.text)).collect();
    let mut control = Control::new(zero_z(input), start(input));
    for (program, listing) in listings.iter().enumerate() {
        cancel.check()?;
        report_troubles(&listing.troubles, program, findings);
        limits::check_pages(listing, program, input.machine.limits.blocks_per_program, findings);
        let structure = structure::check(listing, program, findings);
        let printed: Vec<Option<u32>> = listing.blocks.iter().map(|block| block.printed).collect();
        run.begin_program(program, &printed);
        control.datum = None;
        control.run(listing, &structure, program, findings, run)?;
        let next_sets_datum = listings.get(program + 1).is_none_or(sets_datum_first);
        run.end_program(findings);
        check_closed(&control, Place { program, block: listing.blocks.len().max(1) }, next_sets_datum, findings);
    }
    Ok(last_block(listings.iter().map(|l| l.blocks.len())))
}

/// Runs programs of words and returns the last block.
fn run_words(
    input: &ProofInput,
    cancel: &Cancel,
    run: &mut Run<'_>,
    findings: &mut Findings,
) -> Result<Place, Cancelled> {
    let machine = &input.machine;
    let tapes: Vec<Tape> = input.programs.iter().map(|p| reader::words::read(&p.text, machine.dialect)).collect();
    let assumed = start(input) - Vector::new(zero_z(input), 0.0);
    // A machine file without [words] is refused when it is read.
    let mut control = Interpreter::new(machine, &input.tools, zero_z(input), assumed);
    for (program, (tape, text)) in tapes.iter().zip(input.programs.iter()).enumerate() {
        cancel.check()?;
        report_troubles(&tape.troubles, program, findings);
        lint::check(tape, &text.text, program, machine, findings);
        let printed: Vec<Option<u32>> = tape.blocks.iter().map(|block| block.printed).collect();
        run.begin_program(program, &printed);
        if let Some(control) = &mut control {
            control.run(tape, program, findings, run)?;
        }
        run.end_program(findings);
    }
    Ok(last_block(tapes.iter().map(|t| t.blocks.len())))
}

/// The last block of the last program, for what is found at the end.
fn last_block(counts: impl ExactSizeIterator<Item = usize>) -> Place {
    let program = counts.len().saturating_sub(1);
    Place { program, block: counts.last().unwrap_or(1).max(1) }
}

pub(super) fn zero_z(input: &ProofInput) -> f64 {
    input.work.as_ref().map_or(0.0, |work| work.program_zero_z)
}

/// Where the tool is taken to be if a program does not say so: the machine's usual datum.
pub(super) fn start(input: &ProofInput) -> Point {
    let bar = input.work.as_ref().and_then(|work| work.stock.bounds()).map_or(0.0, |b| b.max.r);
    let datum = &input.machine.datum;
    Point::new(zero_z(input) + datum.axial_clearance_mm, bar + datum.radial_clearance_mm)
}

fn report_troubles(troubles: &[Trouble], program: usize, findings: &mut Findings) {
    for trouble in troubles {
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
    let record = run.record;
    let mut report = ProofReport::default();
    if let Some(judge) = run.judge {
        report.leftover = judge.leftover(last, &mut findings);
        report.deepest_gouge_mm = judge.deepest_gouge_mm();
        report.stock = judge.into_history();
    }
    let cost = cost::of(run.input, record.times.total_s);
    let findings = findings.in_order(names);
    ProofReport {
        passed: findings.iter().all(|f| f.severity != Severity::Error),
        findings,
        times: record.times,
        cost,
        largest_chip_mm2: record.blocks.iter().map(|b| b.chip_mm2).fold(0.0, f64::max),
        blocks: record.blocks,
        moves: record.moves,
        ..report
    }
}
