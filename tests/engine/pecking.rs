//! Deep holes are drilled in pecks on every control: judged by what its reader finds in the program's text.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, Generator, TurnedPart};
use turnwright::machine::{Catalog, TurretTool};
use turnwright::part::Section;
use turnwright::proof::{Motion, Move};
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::units::Unit;

/// Station of the drill in every turret.
const STATION: u32 = 30;

/// Diameter of the drill `drill-10-hss`, mm.
const DIAMETER: f64 = 10.0;

const LENGTH: f64 = 60.0;

/// A bush with a hole as wide as the drill, through all of its length or to a depth.
fn derived(machine: &str, material: &str, from_z: f64) -> Derived {
    let mut catalog = Catalog::shipped();
    let turret = &mut catalog.machines.iter_mut().find(|m| m.id == machine).unwrap().tools;
    turret.retain(|t| !t.tool.starts_with("drill") && !t.tool.starts_with("bore"));
    let tool = "drill-10-hss".to_owned();
    // Changed where the first tool is.
    turret.push(TurretTool { station: STATION, tool, offset: None, ..turret[0].clone() });
    let part = TurnedPart {
        machine: machine.to_owned(),
        material: material.to_owned(),
        bar_diameter: 30.0,
        length: LENGTH,
        sections: vec![Section::line(1, 0.0, 28.0, LENGTH, 28.0)],
        bore: vec![Section::line(2, from_z, 12.0, LENGTH, 12.0)],
        generator: Generator::Planned { separate_programs: false },
        form_tolerance: 0.02,
        ..TurnedPart::default()
    };
    let content = Content::TurnedPart(part);
    let document = Document { turnwright: 1, name: "BUSH".to_owned(), unit: Unit::Mm, content };
    regenerate(&Arc::new(document), &catalog, &mut Cache::default(), &Cancel::default()).unwrap()
}

/// The drill's moves as the reader of the control's language found them.
fn drilled(derived: &Derived) -> Vec<&Move> {
    let moves = &derived.setups[0].proof.moves;
    moves.iter().filter(|m| m.tool == STATION && m.motion != Motion::Pause && m.path.length() > 0.0).collect()
}

#[test]
fn a_deep_hole_is_pecked_on_every_control() {
    let machines = [
        ("orac", "ALUMINUM"),
        ("mori-fanuc-6t", "ALUMINUM"),
        ("fanuc-0i", "C45"),
        ("linuxcnc", "C45"),
        ("swedish-1970s", "C45"),
    ];
    for (machine, material) in machines {
        let derived = derived(machine, material, 0.0);
        assert!(derived.setups[0].proof.passed, "{machine}: {:?}", derived.setups[0].proof.errors().next());
        let moves = drilled(&derived);
        let cuts: Vec<_> = moves.iter().filter(|m| m.motion == Motion::Feed && m.path.end().z < LENGTH).collect();
        assert!(cuts.len() >= 4, "{machine}: {} pecks", cuts.len());
        let mut bottom = LENGTH;
        for (k, cut) in cuts.iter().enumerate() {
            let most = if k == 0 { 3.0 } else { 1.0 } * DIAMETER;
            let to = cut.path.end().z;
            assert!(to < bottom && bottom - to <= most + 0.002, "{machine}: from {bottom} to {to}");
            let back = moves.iter().skip_while(|m| m.path != cut.path).nth(1).unwrap();
            assert!(back.motion == Motion::Rapid && back.path.end().z > LENGTH, "{machine}: {back:?}");
            bottom = to;
        }
        assert!(bottom < 0.0, "{machine}: through at {bottom}");
    }
}

#[test]
fn a_shallow_hole_is_drilled_in_one_go() {
    let derived = derived("fanuc-0i", "C45", LENGTH - 2.0 * DIAMETER);
    let cuts = drilled(&derived).iter().filter(|m| m.motion == Motion::Feed).count();
    assert_eq!(cuts, 1);
}
