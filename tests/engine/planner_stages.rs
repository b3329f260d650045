//! The planner's stages beside turning outside: facing, bores, threads, parting off. Judged by the proof of the programs' text.

use crate::support::planned::{bent, drawn, hundredths, is_named};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, Generator, Infeed, ProgramChoices, ThreadChoices, TurnedPart};
use turnwright::machine::Catalog;
use turnwright::part::{Section, SectionKind};
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::storage::document_from_text;
use turnwright::turning::{CutMove, OperationKind};
use turnwright::units::Unit;

/// Machines with tools for bores.
const MACHINES: [&str; 2] = ["fanuc-0i", "linuxcnc"];

/// What may stay without being named, mm.
const NAMED_FROM_MM: f64 = 0.03;

fn document(part: TurnedPart) -> Document {
    Document { turnwright: 1, name: "STAGES".to_owned(), unit: Unit::Mm, content: Content::TurnedPart(part) }
}

fn derived(part: TurnedPart) -> Derived {
    let document = Arc::new(document(part));
    regenerate(&document, &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap()
}

fn housing() -> TurnedPart {
    let text = include_str!("../cases/parts/bearing-housing.turn");
    let Content::TurnedPart(part) = document_from_text("bearing-housing.turn", text).unwrap().content else {
        unreachable!("a turned part")
    };
    part
}

/// A planned part of C45 between 0 and 40 mm: a bar of 60 mm turned to 56 mm.
fn sleeve(machine: &str, bore: Vec<Section>) -> TurnedPart {
    TurnedPart {
        machine: machine.to_owned(),
        material: "C45".to_owned(),
        bar_diameter: 60.0,
        length: 40.0,
        generator: Generator::Planned { separate_programs: false },
        form_tolerance: 0.02,
        sections: vec![Section::line(1, 0.0, 56.0, 40.0, 56.0)],
        bore,
        ..TurnedPart::default()
    }
}

fn kinds(derived: &Derived) -> Vec<OperationKind> {
    derived.setups[0].path.operations.iter().map(|o| o.kind).collect()
}

/// The proof finds nothing wrong, and nothing is left that the planner did not name.
fn assert_proved(derived: &Derived, what: &str) {
    for setup in &derived.setups {
        let text = || setup.programs.iter().map(|p| p.text.as_str()).collect::<String>();
        assert!(setup.proof.passed, "{what}: {:#?}\n{}", setup.proof.errors().next(), text());
        assert!(setup.proof.deepest_gouge_mm < 0.003, "{what}: gouge {} mm", setup.proof.deepest_gouge_mm);
        for left in setup.proof.leftover.iter().filter(|l| l.largest_mm > NAMED_FROM_MM) {
            assert!(is_named(derived, left.section), "{what}: {left:?}\n{:#?}\n{}", derived.diagnostics, text());
        }
    }
}

/// Largest leftover of a row, mm.
fn left_on(derived: &Derived, section: u32) -> f64 {
    let rows = derived.setups.iter().flat_map(|s| &s.proof.leftover).filter(|l| l.section == section);
    rows.map(|l| l.largest_mm).fold(0.0, f64::max)
}

/// The housing without its groove outside.
fn plain_housing() -> TurnedPart {
    let mut part = housing();
    part.sections.retain(|row| row.id != 2);
    part.sections[0].z2 = 18.0;
    part
}

#[test]
fn the_bearing_housing_builds_and_is_proved_on_both_machines() {
    housing_is_proved(&housing());
}

#[test]
fn the_bearing_housing_without_its_groove_builds_and_is_proved_on_both_machines() {
    housing_is_proved(&plain_housing());
}

fn housing_is_proved(part: &TurnedPart) {
    for machine in MACHINES {
        let derived = derived(TurnedPart { machine: machine.to_owned(), ..part.clone() });
        assert_proved(&derived, machine);
        let kinds = kinds(&derived);
        let expected = [
            OperationKind::Face,
            OperationKind::Drill,
            OperationKind::RoughBore,
            OperationKind::FinishBore,
            OperationKind::PartOff,
        ];
        assert!(expected.iter().all(|k| kinds.contains(k)), "{machine}: {kinds:?}");
        for row in [5, 6, 7] {
            // The nose of the finishing bar leaves 0.4·(1 − 1/√2) = 0.117 mm in the corner.
            let most = if row == 7 { NAMED_FROM_MM } else { 0.12 };
            assert!(left_on(&derived, row) < most, "{machine}: row {row} keeps {} mm", left_on(&derived, row));
        }
    }
}

#[test]
fn the_free_end_is_faced_with_the_depth_of_the_material() {
    for (facing_allowance, cuts) in [(0.0, 0), (1.5, 1), (1.6, 2), (4.4, 3)] {
        let derived = derived(TurnedPart { facing_allowance, ..sleeve("fanuc-0i", vec![]) });
        assert_proved(&derived, &format!("{facing_allowance} mm"));
        let faced = derived.setups[0].path.operations.iter().find(|o| o.kind == OperationKind::Face);
        let lines = faced.map_or(0, |o| o.moves.iter().filter(|m| matches!(m, CutMove::Line { .. })).count());
        assert_eq!(lines, cuts, "{facing_allowance} mm");
    }
}

#[test]
fn a_blind_bore_is_drilled_and_bored_as_far_as_the_bars_go() {
    for machine in MACHINES {
        let derived = derived(sleeve(machine, vec![Section::line(2, 12.0, 30.0, 40.0, 30.0)]));
        assert_proved(&derived, machine);
        assert!(kinds(&derived).contains(&OperationKind::Drill));
        // What the drill's point leaves of the flat bottom is named.
        assert!(is_named(&derived, 2) && left_on(&derived, 2) < 4.0, "{machine}: {} mm", left_on(&derived, 2));
    }
}

#[test]
fn a_hole_of_the_drills_diameter_is_drilled_and_nothing_else() {
    let derived = derived(sleeve("fanuc-0i", vec![Section::line(2, 0.0, 20.0, 40.0, 20.0)]));
    assert_proved(&derived, "20 mm through");
    assert!(kinds(&derived).contains(&OperationKind::Drill) && !kinds(&derived).contains(&OperationKind::RoughBore));
    assert!(left_on(&derived, 2) < NAMED_FROM_MM);
}

#[test]
fn a_hole_too_narrow_for_every_tool_is_named_and_the_rest_is_cut() {
    let derived = derived(sleeve("fanuc-0i", vec![Section::line(2, 0.0, 16.0, 40.0, 16.0)]));
    assert_proved(&derived, "16 mm through");
    assert!(is_named(&derived, 2));
    assert!(!kinds(&derived).contains(&OperationKind::Drill));
    assert!(left_on(&derived, 1) < NAMED_FROM_MM);
}

#[test]
fn a_tube_is_bored_without_a_drill() {
    let bore = vec![Section::line(2, 20.0, 40.0, 40.0, 40.0)];
    let derived = derived(TurnedPart { stock_bore_diameter: 30.0, facing_allowance: 1.0, ..sleeve("linuxcnc", bore) });
    assert_proved(&derived, "tube");
    assert!(!kinds(&derived).contains(&OperationKind::Drill) && kinds(&derived).contains(&OperationKind::FinishBore));
}

/// A thread of 1.5 mm pitch on 30 mm, from 23 mm to the free end, behind a collar and, if asked for, a groove.
fn screw(machine: &str, starts: u32, groove: bool) -> TurnedPart {
    let thread = |id, z1| Section {
        kind: SectionKind::Thread { pitch: 1.5, starts },
        ..Section::line(id, z1, 30.0, 40.0, 28.16)
    };
    let sections = if groove {
        vec![Section::line(1, 0.0, 50.0, 18.0, 50.0), Section::line(2, 18.0, 27.0, 23.0, 27.0), thread(3, 23.0)]
    } else {
        vec![Section::line(1, 0.0, 50.0, 18.0, 50.0), Section::line(2, 18.0, 30.0, 23.0, 30.0), thread(3, 23.0)]
    };
    TurnedPart { bar_diameter: 52.0, sections, ..sleeve(machine, vec![]) }
}

/// A bore of 28.376 mm with a thread M30 × 1.5 over its outer half.
fn nut(machine: &str, starts: u32) -> TurnedPart {
    let thread =
        Section { kind: SectionKind::Thread { pitch: 1.5, starts }, ..Section::line(3, 20.0, 28.376, 40.0, 30.0) };
    sleeve(machine, vec![Section::line(2, 0.0, 28.376, 20.0, 28.376), thread])
}

/// Start angle, start and end of every pass.
fn passes(derived: &Derived) -> Vec<(f64, turnwright::geometry::Point, turnwright::geometry::Point)> {
    let kinds = [OperationKind::Thread, OperationKind::ThreadBore];
    let operation = derived.setups[0].path.operations.iter().find(|o| kinds.contains(&o.kind)).unwrap();
    let mut at = turnwright::geometry::Point::default();
    let mut passes = Vec::new();
    for m in &operation.moves {
        match *m {
            CutMove::ThreadPass { to, start_deg, .. } => {
                passes.push((start_deg, at, to));
                at = to;
            }
            CutMove::Rapid { to } | CutMove::Line { to, .. } => at = to,
            _ => {}
        }
    }
    passes
}

#[test]
fn threads_outside_and_in_a_bore_are_cut_pass_by_pass_and_proved() {
    for machine in MACHINES {
        for starts in [1, 2, 3] {
            for (part, crest, root) in
                [(screw(machine, starts, true), 15.0, 14.08), (nut(machine, starts), 14.188, 15.0)]
            {
                let derived = derived(part);
                assert_proved(&derived, &format!("{machine}, {starts} starts, to {root} mm"));
                let passes = passes(&derived);
                let angles: std::collections::BTreeSet<String> = passes.iter().map(|p| format!("{:.0}", p.0)).collect();
                assert_eq!(angles.len(), starts as usize, "{angles:?}");
                let level = passes.iter().filter(|p| p.0 == 0.0 && (p.1.r - p.2.r).abs() < 1e-9);
                let depths: Vec<f64> = level.map(|p| (p.2.r - crest).abs()).collect();
                assert!(depths.windows(2).all(|w| w[1] >= w[0]), "{depths:?}");
                assert!((depths.last().unwrap() - (crest - root).abs()).abs() < 1e-9, "{depths:?}");
            }
        }
    }
}

#[test]
fn the_infeed_goes_along_the_chosen_flank() {
    let starts = |infeed| {
        let threading = ThreadChoices { infeed, spring_passes: 0, ..ThreadChoices::default() };
        let derived = derived(TurnedPart { threading, ..screw("fanuc-0i", 1, true) });
        assert_proved(&derived, &format!("{infeed:?}"));
        let last = passes(&derived).last().unwrap().1;
        passes(&derived).into_iter().map(|p| (p.1.z - last.z, p.1.r - last.r)).collect::<Vec<_>>()
    };
    assert!(starts(Infeed::Radial).iter().all(|(z, _)| z.abs() < 1e-9));
    let slope = 29_f64.to_radians().tan();
    assert!(starts(Infeed::Flank).iter().all(|(z, r)| (z - r * slope).abs() < 1e-9));
    for (k, (z, r)) in starts(Infeed::Alternating).iter().enumerate() {
        let side = if k % 2 == 0 { 1.0 } else { -1.0 };
        assert!((z - side * r * slope).abs() < 1e-9, "pass {k}");
    }
}

#[test]
fn a_thread_without_a_groove_runs_out_over_the_chosen_length() {
    for (run_out, taper) in [(0.0, 0.0), (1.0, 1.5), (2.0, 3.0)] {
        let threading = ThreadChoices { run_out, ..ThreadChoices::default() };
        let derived = derived(TurnedPart { threading, ..screw("linuxcnc", 1, false) });
        assert_proved(&derived, &format!("run-out over {run_out} pitches"));
        let tapers: Vec<f64> =
            passes(&derived).iter().filter(|p| p.2.r > p.1.r + 1e-9).map(|p| p.1.z - p.2.z).collect();
        assert_eq!(tapers.is_empty(), taper == 0.0, "{tapers:?}");
        assert!(tapers.iter().all(|t| (t - taper).abs() < 1e-9), "{tapers:?}");
    }
}

/// Programs by the control's own means are proved like those of moves, and say so.
#[test]
fn programs_with_compensation_and_cycles_by_the_control_are_proved_too() {
    for machine in MACHINES {
        for (part, words) in [
            (TurnedPart { machine: machine.to_owned(), ..housing() }, &["G41", "G42", "G40"][..]),
            (screw(machine, 1, true), &["G42", "G76"]),
            (nut(machine, 1), &["G41", "G76"]),
        ] {
            let program = ProgramChoices { canned_cycles: true, compensated_by_control: true, ..part.program };
            let derived = derived(TurnedPart { program, ..part });
            assert_proved(&derived, machine);
            let text = &derived.setups[0].programs[0].text;
            assert!(words.iter().all(|word| text.contains(word)), "{machine}: {words:?}\n{text}");
        }
    }
}

/// Steps, a cone and a rounding that only rise towards the chuck.
fn steps(machine: &str) -> TurnedPart {
    let rounding = Section { kind: SectionKind::Convex { radius: 6.0 }, ..Section::line(3, 22.0, 46.0, 28.0, 34.0) };
    let sections = vec![
        Section::line(1, 0.0, 56.0, 12.0, 56.0),
        Section::line(2, 12.0, 46.0, 22.0, 46.0),
        rounding,
        Section::line(4, 28.0, 24.0, 37.0, 20.0),
        Section::line(5, 37.0, 20.0, 40.0, 14.0),
    ];
    TurnedPart { sections, facing_allowance: 1.0, ..sleeve(machine, vec![]) }
}

#[test]
fn a_part_that_only_rises_is_roughed_and_finished_by_the_cycles_of_the_control() {
    for (canned_cycles, compensated_by_control) in [(false, false), (true, false), (true, true)] {
        let part = steps("fanuc-0i");
        let program = ProgramChoices { canned_cycles, compensated_by_control, ..part.program };
        let derived = derived(TurnedPart { program, ..part });
        assert_proved(&derived, &format!("cycles {canned_cycles}, compensated {compensated_by_control}"));
        let text = &derived.setups[0].programs[0].text;
        assert_eq!(text.contains("G71"), canned_cycles, "{text}");
        assert_eq!(text.contains("G70"), canned_cycles && !compensated_by_control, "{text}");
        assert_eq!(text.contains("G42"), compensated_by_control, "{text}");
        assert!((1..=5).all(|row| left_on(&derived, row) < 0.2), "{:?}", derived.setups[0].proof.leftover);
    }
}

/// One row of a random bore: width, both diameters, bend (0 and 3 none, 1 hollow, 2 bulge), radius over chord.
type Row = (f64, f64, f64, u8, f64);

fn row() -> impl Strategy<Value = Row> {
    (1.0..12.0_f64, 16.0..50.0_f64, 16.0..50.0_f64, 0..4_u8, 0.6..3.0_f64)
}

/// A part with a random bore, blind or through, in a bar or a tube.
fn bored(rows: &[Row], machine: &str, blind: bool, hole: f64) -> TurnedPart {
    let mut z = if blind { 6.0 } else { 0.0 };
    let mut bore = Vec::new();
    for (id, &(width, d1, d2, bend, share)) in (2..).zip(rows) {
        let (width, d1, d2) = (hundredths(width), hundredths(d1), hundredths(d2));
        // Every second row is a cylinder.
        let d2 = if bend == 3 { d1 } else { d2 };
        let kind = bent(bend, width, (d1, d2), share);
        bore.push(Section { kind, ..Section::line(id, z, d1, z + width, d2) });
        z = hundredths(z + width);
    }
    TurnedPart {
        bar_diameter: 72.0,
        length: z,
        stock_bore_diameter: hole,
        facing_allowance: 0.7,
        sections: vec![Section::line(1, 0.0, 70.0, z, 70.0)],
        ..sleeve(machine, bore)
    }
}

fn promises_hold(rows: &[Row], machine: &str, blind: bool, hole: f64) -> Result<(), TestCaseError> {
    let derived = derived(bored(rows, machine, blind, hole));
    if derived.diagnostics.iter().any(|d| d.code.starts_with("arc-") || d.code.starts_with("bore-")) {
        return Ok(());
    }
    let setup = &derived.setups[0];
    prop_assert!(setup.proof.passed, "{:?}", setup.proof.errors().next());
    prop_assert!(setup.proof.deepest_gouge_mm < 0.001, "gouge {} mm", setup.proof.deepest_gouge_mm);
    for left in setup.proof.leftover.iter().filter(|l| l.largest_mm > NAMED_FROM_MM) {
        prop_assert!(is_named(&derived, left.section), "{left:?}");
    }
    Ok(())
}

fn run(cases: u32, seed: u64) {
    let hole = prop_oneof![2 => Just(0.0), 1 => (12.0..16.0_f64).prop_map(f64::round)];
    let parts = (proptest::collection::vec(row(), 1..6), 0..MACHINES.len(), any::<bool>(), hole);
    TestRunner::new(drawn(cases, seed))
        .run(&parts, |(rows, m, blind, hole)| promises_hold(&rows, MACHINES[m], blind, hole))
        .unwrap();
}

#[test]
fn random_bores_are_cut_without_gouge_or_contact() {
    run(30, 1);
}

/// `cargo test --release --test engine planner_stages:: -- --ignored`
#[test]
#[ignore = "takes minutes; seeds 1 to 10 with 200 bores each"]
fn two_thousand_random_bores_are_cut_without_gouge_or_contact() {
    (1..=10).for_each(|seed| run(200, seed));
}

#[test]
fn examples_are_proved_when_the_control_compensates_the_nose_and_repeats_the_cuts() {
    for example in turnwright::storage::examples_of(turnwright::document::Kind::TurnedPart) {
        let mut document = document_from_text(example.name, example.text).unwrap();
        let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
        if matches!(part.generator, Generator::Cycles { .. }) {
            continue;
        }
        part.generator = Generator::Planned { separate_programs: false };
        part.program =
            ProgramChoices { canned_cycles: true, compensated_by_control: true, ..ProgramChoices::default() };
        for machine in MACHINES {
            let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
            machine.clone_into(&mut part.machine);
            let document = Arc::new(document.clone());
            let derived =
                regenerate(&document, &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap();
            for setup in &derived.setups {
                assert!(setup.proof.passed, "{} on {machine}: {:?}", setup.name, setup.proof.findings);
            }
        }
    }
}
