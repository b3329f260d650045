//! Mutants: single words of good programs are changed, and the proof must notice each change that matters.
//!
//! A mutant is caught if the proof finds something that it did not find in the original. One that is not caught must be
//! harmless: an independent comparison (`shape`) finds the finished shape the same within 0.01 mm and nothing touched at rapid.
//!
//! All of them: `cargo test --no-default-features --test engine mutants:: -- --ignored --nocapture`.

mod mutate;
mod parts;
mod shape;

use mutate::{Kind, Mutant, mutants};
use parts::Subject;
use shape::Shape;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::proof::{FindingKind, ProgramText, ProofInput, ProofReport, prove};

/// A change of the finished shape up to this, mm, is none.
const SHAPE_MM: f64 = 0.01;
/// Depth of a rapid contact, mm, that counts: the columns of the comparison are no finer.
const CONTACT_MM: f64 = 0.01;

/// What came of the mutants of one kind.
#[derive(Default)]
struct Row {
    made: usize,
    caught: usize,
    harmless: BTreeMap<String, usize>,
    missed: Vec<String>,
}

/// What the proof says about the published listing on its blank: nothing is wrong with it, and its figures.
#[test]
fn the_published_listing_proves() {
    let subject = parts::roll();
    let report = report(&subject.input);
    for finding in &report.findings {
        println!("block {} {}: {}", finding.block, finding.severity, finding.message);
    }
    for left in report.leftover.iter().filter(|l| l.largest_mm > 0.001) {
        println!("element {}: {:.3} mm at most, {:.3} mm in the mean", left.section, left.largest_mm, left.mean_mm);
    }
    println!("deepest gouge {:.4} mm, times {:?}", report.deepest_gouge_mm, report.times);
    let of = |kind| report.findings.iter().filter(move |f| f.kind == kind).count();
    assert_eq!((of(FindingKind::Unreadable), of(FindingKind::Control), of(FindingKind::RapidContact)), (0, 0, 0));
}

#[test]
fn a_sample_of_mutants_is_caught_or_harmless() {
    let mut rows = BTreeMap::new();
    judge(&parts::roll(), 1, &mut rows);
    check(&rows, 8);
}

#[test]
#[ignore = "several minutes: the whole table"]
fn all_mutants_are_caught_or_harmless() {
    let mut rows = BTreeMap::new();
    judge(&parts::roll(), 24, &mut rows);
    for subject in parts::on_the_orac() {
        judge(&subject, 6, &mut rows);
    }
    check(&rows, 300);
}

/// Tries up to `most` mutants of every kind, spread evenly over the programs.
fn judge(subject: &Subject, most: usize, rows: &mut BTreeMap<Kind, Row>) {
    let original = report(&subject.input);
    let known = said(&original);
    let shape = std::cell::LazyCell::new(|| Shape::of(&subject.input, &original.moves));
    for kind in Kind::ALL {
        let row = rows.entry(kind).or_default();
        for (program, mutant) in spread(subject, kind, most) {
            let input = with_text(&subject.input, program, &mutant.text);
            let report = report(&input);
            row.made += 1;
            if said(&report).difference(&known).next().is_some() {
                row.caught += 1;
                continue;
            }
            match harmless(&input, &report, &original, &shape) {
                Ok((reason, figures)) => {
                    println!("{}: {}: {}: {reason}{figures}", subject.name, kind.name(), mutant.what);
                    *row.harmless.entry(reason.to_owned()).or_default() += 1;
                }
                Err(why) => row.missed.push(format!("{}: {}: {}: {why}", subject.name, kind.name(), mutant.what)),
            }
        }
    }
}

fn spread(subject: &Subject, kind: Kind, most: usize) -> Vec<(usize, Mutant)> {
    let programs = subject.input.programs.iter().enumerate();
    let all: Vec<_> = programs.flat_map(|(i, p)| mutants(&p.text, kind).into_iter().map(move |m| (i, m))).collect();
    let (count, step) = (all.len(), all.len().div_ceil(most).max(1));
    let middle = if count > step { step / 2 } else { 0 };
    all.into_iter().skip(middle).step_by(step).collect()
}

fn with_text(input: &ProofInput, program: usize, text: &str) -> ProofInput {
    let mut programs: Vec<ProgramText> = input.programs.to_vec();
    text.clone_into(&mut programs[program].text);
    ProofInput { programs: Arc::new(programs), ..input.clone() }
}

fn report(input: &ProofInput) -> ProofReport {
    prove(input, &Cancel::default()).unwrap()
}

/// Everything that a report says, without the blocks, whose numbers move when one is dropped.
fn said(report: &ProofReport) -> BTreeSet<(FindingKind, String)> {
    report.findings.iter().map(|f| (f.kind, f.message.clone())).collect()
}

/// Why a mutant that was not caught does no harm, with the figures that say so, or what harm it does.
fn harmless(
    input: &ProofInput,
    report: &ProofReport,
    original: &ProofReport,
    shape: &Shape,
) -> Result<(&'static str, String), String> {
    let path = |r: &ProofReport| r.moves.iter().map(|m| (m.path, m.motion, m.tool)).collect::<Vec<_>>();
    if path(report) == path(original) {
        let speed = |r: &ProofReport| r.moves.iter().map(|m| (m.feed_mm_per_min, m.rpm)).collect::<Vec<_>>();
        let same = speed(report) == speed(original);
        let reason = if same { "the same moves" } else { "the same path, other feeds or speeds within the limits" };
        return Ok((reason, String::new()));
    }
    let now = Shape::of(input, &report.moves);
    let difference = now.difference(shape);
    if difference > SHAPE_MM {
        return Err(format!("the finished shape changes by {difference:.3} mm"));
    }
    if now.rapid_contact_mm > CONTACT_MM.max(shape.rapid_contact_mm + 1e-6) {
        return Err(format!("a rapid move goes {:.3} mm into the stock", now.rapid_contact_mm));
    }
    let figures = format!(": it changes by {difference:.4} mm, rapid moves touch {:.4} mm", now.rapid_contact_mm);
    Ok(("another path, the same finished shape, nothing touched at rapid", figures))
}

/// Prints the table and checks how many there were.
fn check(rows: &BTreeMap<Kind, Row>, least: usize) {
    println!("| change | made | caught | harmless |\n|---|---|---|---|");
    let (mut made, mut caught) = (0, 0);
    for (kind, row) in rows {
        let reasons: Vec<String> = row.harmless.iter().map(|(why, n)| format!("{n} {why}")).collect();
        let count: usize = row.harmless.values().sum();
        assert_eq!(row.made, row.caught + count + row.missed.len());
        println!("| {} | {} | {} | {count}: {} |", kind.name(), row.made, row.caught, reasons.join("; "));
        made += row.made;
        caught += row.caught;
    }
    println!("| all | {made} | {caught} | {} |", made - caught);
    let missed: Vec<&String> = rows.values().flat_map(|row| &row.missed).collect();
    assert!(missed.is_empty(), "not caught: {missed:#?}");
    assert!(made >= least, "{made} mutants, {least} wanted");
}
