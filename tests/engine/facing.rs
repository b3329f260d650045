//! Facing between centres, up to the tailstock's centre: judged by the proof of the program's text.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, Generator, Holding, OperationKind, TurnedPart};
use turnwright::machine::Catalog;
use turnwright::part::Section;
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::units::Unit;

const LENGTH: f64 = 80.0;

fn shaft(facing_allowance: f64) -> Derived {
    let part = TurnedPart {
        machine: "fanuc-0i".to_owned(),
        material: "C45".to_owned(),
        bar_diameter: 60.0,
        length: LENGTH,
        facing_allowance,
        holding: Holding::BetweenCentres,
        sections: vec![Section::line(1, 0.0, 58.0, 40.0, 58.0), Section::line(2, 40.0, 50.0, LENGTH, 50.0)],
        generator: Generator::Planned { separate_programs: false },
        form_tolerance: 0.02,
        ..TurnedPart::default()
    };
    let content = Content::TurnedPart(part);
    let document = Document { turnwright: 1, name: "SHAFT".to_owned(), unit: Unit::Mm, content };
    regenerate(&Arc::new(document), &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap()
}

#[test]
fn a_shaft_is_faced_up_to_the_tailstock_and_its_stub_is_told() {
    let derived = shaft(1.0);
    let setup = &derived.setups[0];
    assert!(setup.proof.passed, "{:?}", setup.proof.errors().next());
    let face = setup.path.operations.iter().find(|o| o.kind == OperationKind::Face);
    assert!(face.is_some());
    let said = derived.diagnostics.iter().find(|d| d.code == "not-faced").unwrap();
    let diameter: f64 = said.message.split("diameter of ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    let centre = 2.0 * setup.setup.tailstock.as_ref().unwrap().segments.iter().map(|s| s.start().r).fold(0.0, f64::min);
    assert!(diameter > centre && diameter < 50.0, "{}", said.message);
    // What the proof finds on the face is the stub and nothing else.
    let left = |r: f64| {
        let rings = setup.proof.stock.last().unwrap().rings;
        rings.iter().flatten().any(|p| p.z > LENGTH + 0.01 && p.r > r)
    };
    assert!(left(0.5 * diameter - 1.0) && !left(0.5 * diameter + 0.01), "{}", said.message);
}

#[test]
fn a_shaft_of_its_length_needs_no_facing() {
    assert!(shaft(0.0).diagnostics.iter().all(|d| d.code != "not-faced"));
}
