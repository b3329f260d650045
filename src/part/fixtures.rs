//! The published parts and the machine they were made for, for tests.

use super::Section;
use crate::document::{Content, Document, Ends, TurnedPart};
use crate::machine::{Catalog, Machine};

pub(crate) fn orac() -> Machine {
    Catalog::shipped().machine("orac").unwrap().clone()
}

/// A part of the given rows on a 26.2 mm bar, in mm.
pub(crate) fn part(length: f64, sections: Vec<Section>) -> TurnedPart {
    TurnedPart {
        machine: "orac".to_owned(),
        material: "ALUMINUM".to_owned(),
        bar_diameter: 26.2,
        length,
        ends: Ends::One,
        part_off: false,
        automatic: false,
        form_tolerance: 0.05,
        sections,
        ..TurnedPart::default()
    }
}

pub(crate) fn queen() -> TurnedPart {
    turned_part(include_str!("../../assets/examples/queen.turn"))
}

pub(crate) fn master() -> TurnedPart {
    turned_part(include_str!("../../assets/examples/master.turn"))
}

/// All shipped examples.
pub(crate) fn examples() -> [Document; 5] {
    [
        include_str!("../../assets/examples/queen.turn"),
        include_str!("../../assets/examples/master.turn"),
        include_str!("../../assets/examples/knob.turn"),
        include_str!("../../assets/examples/spigot.turn"),
        include_str!("../../assets/examples/stud.turn"),
    ]
    .map(|text| serde_json::from_str(text).unwrap())
}

fn turned_part(text: &str) -> TurnedPart {
    let document: Document = serde_json::from_str(text).unwrap();
    let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
    part
}
