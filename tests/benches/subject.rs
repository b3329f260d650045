//! Parts that are measured, ready to be planned, posted and proved.

use std::collections::BTreeMap;
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, Generator, TurnedPart};
use turnwright::machine::{Catalog, Machine, Material, ToolOutline};
use turnwright::part::{Section, Setup};
use turnwright::post::{self, PostOutput};
use turnwright::proof::{self, ProgramText, ProofInput, ProofReport};
use turnwright::regen::{self, Cache};
use turnwright::storage;
use turnwright::turning::{self, CutterPath, Task};
use turnwright::units::Unit;

/// The first clamping of a part.
pub(crate) struct Subject {
    part_mm: TurnedPart,
    setup: Arc<Setup>,
    machine: Arc<Machine>,
    tools: Arc<BTreeMap<u32, ToolOutline>>,
    material: Material,
    header: post::Header,
    unit: Unit,
    name: String,
    input: ProofInput,
}

impl Subject {
    pub(crate) fn of(document: &Document) -> Self {
        let catalog = Catalog::shipped();
        let document = Arc::new(document.clone());
        let derived =
            regen::regenerate(&document, &catalog, &mut Cache::default(), &Cancel::default()).expect("nobody cancels");
        let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
        let item = derived.setups.first().expect("the part has a clamping");
        let machine = derived.machine.clone().expect("the machine is shipped");
        Self {
            part_mm: part.scaled(document.unit.in_mm()),
            setup: Arc::clone(&item.setup),
            tools: Arc::clone(&item.tools),
            material: derived.material.clone().expect("the material is shipped"),
            header: post::Header::new(&document, part, &machine, &catalog),
            unit: document.unit,
            name: item.name.clone(),
            input: regen::proof_input(&derived, item).expect("the machine is shipped"),
            machine,
        }
    }

    pub(crate) fn plan(&self) -> CutterPath {
        let Self { setup, part_mm, machine, tools, material, .. } = self;
        turning::generate(&Task { setup, part_mm, machine, tools, material_mm: material }).0
    }

    pub(crate) fn post(&self, path: &CutterPath) -> PostOutput {
        let options = regen::post_options(&self.part_mm, self.unit);
        post::post(&self.name, path, &options, &self.header, &self.machine)
    }

    pub(crate) fn prove(&self, posted: &PostOutput) -> ProofReport {
        let text = |p: &post::Program| ProgramText { name: p.name.clone(), text: p.text.clone(), edited: false };
        let programs = Arc::new(posted.programs.iter().map(text).collect());
        let input = ProofInput { programs, ..self.input.clone() };
        proof::prove(&input, &Cancel::default()).expect("nobody cancels")
    }

    pub(crate) fn all(&self) -> ProofReport {
        self.prove(&self.post(&self.plan()))
    }
}

pub(crate) fn example(name: &str) -> Document {
    let example = storage::examples().iter().find(|e| e.name == name).expect("the example is shipped");
    storage::document_from_text(name, example.text).expect("shipped examples can be read")
}

pub(crate) fn planned(mut document: Document) -> Document {
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    part.generator = Generator::Planned { separate_programs: false };
    document
}

/// 51 steps of 1 mm on the diameter, 2 mm wide: two points each, and the one on the axis.
pub(crate) fn staircase() -> Document {
    let step = |k: u32| {
        let (z, d) = (2.0 * f64::from(k), 70.0 - f64::from(k));
        Section::line(k + 1, z, d, z + 2.0, d)
    };
    for_linuxcnc("STAIRCASE", 72.0, 102.0, (0..51).map(step).collect())
}

/// A wavy shaft of short lines.
pub(crate) fn wavy(sections: u32) -> Document {
    const LENGTH: f64 = 200.0;
    let z = |k: u32| LENGTH * f64::from(k) / f64::from(sections);
    let d = |k: u32| 40.0 + 6.0 * (z(k) / 8.0).sin();
    let row = |k: u32| Section::line(k + 1, z(k), d(k), z(k + 1), d(k + 1));
    for_linuxcnc("WAVES", 48.0, LENGTH, (0..sections).map(row).collect())
}

fn for_linuxcnc(name: &str, bar_diameter: f64, length: f64, sections: Vec<Section>) -> Document {
    let part = TurnedPart { machine: "linuxcnc".to_owned(), bar_diameter, length, sections, ..TurnedPart::default() };
    planned(Document { turnwright: 1, name: name.to_owned(), unit: Unit::Mm, content: Content::TurnedPart(part) })
}
