//! The planner against the published generator, and what it promises for the shipped examples: judged by the proof of the
//! programs' text.

use crate::support::planned::{bent, drawn, hundredths, is_named};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::Diagnostic;
use turnwright::document::{Content, Document, Generator, TurnedPart};
use turnwright::machine::Catalog;
use turnwright::part::Section;
use turnwright::proof::ProofReport;
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::storage::{document_from_text, examples, examples_of};
use turnwright::units::Unit;

/// Deviation that the planned programs keep, mm: the published ones need 0.25.
const TOLERANCE_MM: f64 = 0.01;

fn example(name: &str) -> Document {
    let example = examples().iter().find(|e| e.name == name).unwrap();
    document_from_text(name, example.text).unwrap()
}

fn planned(mut document: Document) -> Document {
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    part.generator = Generator::Planned { separate_programs: false };
    part.form_tolerance = TOLERANCE_MM;
    document
}

fn derived(document: Document) -> Derived {
    regenerate(&Arc::new(document), &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap()
}

fn proof(derived: &Derived) -> &ProofReport {
    &derived.setups[0].proof
}

fn blocks(derived: &Derived) -> usize {
    derived.setups[0].post.programs.iter().map(|p| p.blocks.len()).sum()
}

/// Mean leftover over the rows of the part, mm.
fn mean_leftover(report: &ProofReport) -> f64 {
    report.leftover.iter().map(|l| l.mean_mm).sum::<f64>() / report.leftover.len() as f64
}

#[test]
fn the_planned_queen_and_master_beat_the_published_programs() {
    for (name, seconds, pages) in [("QUEEN", 480.0, 155), ("MASTER", 560.0, 117)] {
        let (before, after) = (derived(example(name)), derived(planned(example(name))));
        assert!(proof(&after).passed, "{name}: {:?}", proof(&after).errors().next());
        assert!(proof(&after).deepest_gouge_mm < 0.003, "{name}: {} mm", proof(&after).deepest_gouge_mm);
        assert!(proof(&after).times.total_s < proof(&before).times.total_s.min(seconds), "{name}");
        assert!(blocks(&after) < blocks(&before).min(pages), "{name}: {} blocks", blocks(&after));
        assert!(mean_leftover(proof(&after)) < mean_leftover(proof(&before)) / 4.0, "{name}");
    }
}

#[test]
fn what_is_left_is_named_beforehand() {
    for example in examples_of(turnwright::document::Kind::TurnedPart) {
        let derived = derived(planned(document_from_text(example.name, example.text).unwrap()));
        for setup in &derived.setups {
            for left in setup.proof.leftover.iter().filter(|l| l.largest_mm > 0.03) {
                let named = is_named(&derived, left.section);
                assert!(named, "{}: row {} keeps {} mm at {:?}", example.name, left.section, left.largest_mm, left.at);
            }
        }
    }
}

fn planned_is_proved(name: &str) {
    let derived = derived(planned(example(name)));
    for setup in &derived.setups {
        assert!(setup.proof.passed, "{}: {:?}", setup.name, setup.proof.errors().next());
    }
}

#[test]
fn every_planned_example_passes_its_proof() {
    for example in examples_of(turnwright::document::Kind::TurnedPart) {
        planned_is_proved(example.name);
    }
}

/// A random part of lines and arcs with faces, grooves and undercut hollows: width, both diameters, bend (0 none, 1 hollow,
/// 2 bulge) and radius over chord of every row. Hollows are no deeper than the tools' edges are long.
type Row = (f64, f64, f64, u8, f64);

fn row() -> impl Strategy<Value = Row> {
    (0.5..9.0_f64, 6.0..24.0_f64, 6.0..24.0_f64, 0..4_u8, 0.55..3.0_f64)
}

/// Machines with different tools: one of each kind, and several of one hand.
const MACHINES: [&str; 2] = ["orac", "linuxcnc"];

fn part(machine: &str, rows: &[Row]) -> Document {
    let mut z = 0.0;
    let mut sections = Vec::new();
    for (id, &(width, d1, d2, bend, share)) in (1..).zip(rows) {
        let (width, d1, d2) = (hundredths(width), hundredths(d1), hundredths(d2));
        let kind = bent(bend, width, (d1, d2), share);
        sections.push(Section { kind, ..Section::line(id, z, d1, z + width, d2) });
        z = hundredths(z + width);
    }
    let part = TurnedPart { machine: machine.into(), bar_diameter: 26.0, length: z, sections, ..TurnedPart::default() };
    let content = Content::TurnedPart(part);
    planned(Document { turnwright: 1, name: "RANDOM".to_owned(), unit: Unit::Mm, content })
}

/// No gouge beyond rounding, nothing touched at rapid, no holder or chuck met, and nothing left that was not named.
fn promises_hold(machine: &str, rows: &[Row]) -> Result<(), TestCaseError> {
    let derived = derived(part(machine, rows));
    let impossible = |d: &Diagnostic| d.code.starts_with("arc-");
    if derived.diagnostics.iter().any(impossible) {
        return Ok(());
    }
    for setup in &derived.setups {
        prop_assert!(setup.proof.passed, "{:?}", setup.proof.errors().next());
        prop_assert!(setup.proof.deepest_gouge_mm < 0.001, "gouge {} mm", setup.proof.deepest_gouge_mm);
        for left in setup.proof.leftover.iter().filter(|l| l.largest_mm > 0.03) {
            prop_assert!(is_named(&derived, left.section), "row {} keeps {} mm", left.section, left.largest_mm);
        }
    }
    Ok(())
}

fn run(cases: u32, seed: u64) {
    let parts = (proptest::sample::select(&MACHINES[..]), proptest::collection::vec(row(), 1..9));
    TestRunner::new(drawn(cases, seed)).run(&parts, |(machine, rows)| promises_hold(machine, &rows)).unwrap();
}

#[test]
fn random_parts_are_cut_without_gouge_or_contact() {
    run(60, 1);
}

/// `cargo test --release --test engine planner:: -- --ignored`
#[test]
#[ignore = "takes minutes; seeds 1 to 10 with 500 parts each"]
fn five_thousand_random_parts_are_cut_without_gouge_or_contact() {
    (1..=10).for_each(|seed| run(500, seed));
}
