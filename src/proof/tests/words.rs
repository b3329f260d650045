//! Programs of words on stock: each finding with a program that has it, beside a good one that has none.

use super::*;
use crate::machine::{Catalog, outlines};
use FindingKind::{ChuckCollision, Gouge, OutsideLimits, OverTravel, Power, RapidContact};
use std::sync::Arc;

/// A bar of diameter 60 on the lathe of today, to become 50 over the last 40 of 80 mm; the free end is the program zero.
fn bar() -> Work {
    let p = Point::new;
    let contour =
        Contour::new(vec![Segment::line(p(40.0, 30.0), p(40.0, 25.0)), Segment::line(p(40.0, 25.0), p(80.0, 25.0))]);
    let material = Catalog::shipped().materials.into_iter().find(|m| m.name == "STEEL");
    Work {
        stock: polygon(&[(-20.0, 0.0), (80.0, 0.0), (80.0, 30.0), (-20.0, 30.0)]),
        target: Target { contour, sections: vec![1, 2], machined_from_z: 39.0, ..work().target },
        program_zero_z: 80.0,
        chuck_face_z: -5.0,
        material: material.map(|m| m.in_mm()),
        ..work()
    }
}

fn prove_words(body: &str, work: Work) -> ProofReport {
    let machine = word_lathe();
    let tools = outlines(&machine, &Catalog::shipped());
    let text = format!("%\nO1\nG21 G40 G99 T0101\nG97 S800 M03\nG0 X66. Z2.\n{body}\nG28 U0.\nG28 W0.\nM05\nM30\n%");
    let program = ProgramText { name: "WORDS".into(), text, edited: false };
    prove_input(&ProofInput {
        machine: Arc::new(machine),
        tools: Arc::new(tools),
        programs: Arc::new(vec![program]),
        work: Some(work),
    })
}

/// Blocks before the body: `%`, number, units and tool, speed, approach.
const HEAD: usize = 5;

/// Two cuts of 2.5 mm.
const GOOD: &str = "G0 X55.\nG1 Z-39.9 F.2\nG0 X66. Z2.\nX50.\nG1 Z-39.9\nX66. F.5";

#[test]
fn a_good_program_has_nothing_to_say() {
    let report = prove_words(GOOD, bar());
    assert_eq!(faults(&report), [], "{:?}", report.findings);
    assert!(report.passed && report.deepest_gouge_mm < 1e-3);
}

#[test]
fn each_fault_is_found_in_its_block() {
    let cases = [
        // A lost digit of Z drives through the chuck; twenty times the way leaves the machine.
        ("G1 Z-39.9 F.2", "G1 Z-399. F.2", ChuckCollision, "chuck"),
        ("G1 Z-39.9 F.2", "G1 Z-399. F.2", OverTravel, "550 mm"),
        ("G0 X55.", "M05\nG0 X55.", OutsideLimits, "spindle at rest"),
        ("G1 Z-39.9 F.2", "G1 Z-39.9 F0.", OutsideLimits, "would not move"),
        ("G1 Z-39.9 F.2", "G1 Z-39.9 F20.", OutsideLimits, "highest is 10000"),
        ("G1 Z-39.9 F.2", "G0 Z-39.9", RapidContact, "rapid"),
        ("X50.", "X49.", Gouge, "below the contour"),
        ("G97 S800", "G97 S8000", OutsideLimits, "4500"),
        ("G0 X55.\nG1 Z-39.9 F.2", "G0 X34.\nG1 Z-39.9 F.4", Power, "kW"),
        ("G0 X55.\nG1 Z-39.9 F.2", "G0 X55.\nG32 Z-39.9 F20.", OutsideLimits, "Pitch 20.000 mm at 800 rev/min"),
    ];
    for (from, to, kind, what) in cases {
        let head = "G97 S800";
        let body = if from == head { format!("{to}\n{GOOD}") } else { GOOD.replacen(from, to, 1) };
        assert_ne!(body, GOOD);
        let report = prove_words(&body, bar());
        let found = report.findings.iter().find(|f| f.kind == kind && f.message.contains(what));
        assert!(found.is_some_and(|f| f.block > HEAD), "{to}: {:?}", report.findings);
    }
}

#[test]
fn a_bore_is_proved_too() {
    let p = Point::new;
    // A tube with a hole of radius 12 that is to become 14 over 30 mm; the boring bar of station 7 reaches in.
    let bore =
        Contour::new(vec![Segment::line(p(50.0, 12.0), p(50.0, 14.0)), Segment::line(p(50.0, 14.0), p(80.0, 14.0))]);
    let bored = |body: &str| {
        let target = Target {
            contour: Contour::new(vec![Segment::line(p(40.0, 30.0), p(80.0, 30.0))]),
            sections: vec![1],
            bore: Some(BoreTarget {
                contour: bore.clone(),
                sections: vec![8, 9],
                machined_from_z: 49.0,
                may_cut: Vec::new(),
            }),
            ..bar().target
        };
        let stock = polygon(&[(-20.0, 12.0), (80.0, 12.0), (80.0, 30.0), (-20.0, 30.0)]);
        prove_words(&format!("G28 U0.\nG28 W0.\nT0707\nG0 X22. Z5.\n{body}"), Work { stock, target, ..bar() })
    };
    let good = "X28.\nG1 Z-29.9 F.15\nX23.\nG0 Z5.";
    assert_eq!(faults(&bored(good)), [], "{:?}", bored(good).findings);
    for (from, to, kind) in [
        ("X28.", "X29.", Gouge),
        ("G1 Z-29.9 F.15", "G0 Z-29.9", RapidContact),
        ("Z-29.9 F.15", "Z-29.9 F0.", OutsideLimits),
    ] {
        let report = bored(&good.replacen(from, to, 1));
        assert!(faults(&report).iter().any(|(k, _)| *k == kind), "{to}: {:?}", report.findings);
    }
}
