//! The parts whose programs are changed.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::geometry::{Contour, Point, Segment};
use turnwright::machine::{Catalog, outlines};
use turnwright::proof::{ProgramText, ProofInput, Target, Work};
use turnwright::regen::{Cache, proof_input, regenerate};
use turnwright::storage::{document_from_text, examples_of};

/// Deviation that the proofs of this test allow, mm: what the mutants are measured by.
const FORM_TOLERANCE_MM: f64 = 0.01;

/// A part with its programs, ready to be proved.
pub(crate) struct Subject {
    pub(crate) name: String,
    pub(crate) input: ProofInput,
}

/// The published listing of roll 1470b-2T on its blank, between centres.
pub(crate) fn roll() -> Subject {
    let catalog = Catalog::shipped();
    let machine = catalog.machine("mori-fanuc-6t").unwrap().clone();
    let tools = outlines(&machine, &catalog);
    let text = include_str!("../../cases/1470b/NC1470b-2T.nc").to_owned();
    let (contour, sections) = profile(include_str!("../../cases/1470b/E1470b-2T.txt"));
    let corners = [(0.0, 0.0), (159.303, 0.0), (159.303, 80.0), (0.0, 80.0)];
    let work = Work {
        stock: Contour::polygon(&corners.map(|(z, r)| Point::new(z, r))),
        target: Target {
            contour,
            sections,
            names: std::collections::BTreeMap::default(),
            machined_from_z: 0.0,
            bore: None,
        },
        program_zero_z: 0.0,
        chuck_face_z: -200.0,
        mandrel: None,
        tailstock: None,
        material: None,
        form_tolerance_mm: FORM_TOLERANCE_MM,
        may_cut: Vec::new(),
    };
    let program = ProgramText { name: "NC1470b-2T".into(), text, edited: false };
    let input = ProofInput {
        machine: Arc::new(machine),
        tools: Arc::new(tools),
        programs: Arc::new(vec![program]),
        work: Some(work),
    };
    Subject { name: "1470b-2T".into(), input }
}

/// The elements of a profile in the published layout but the two end faces: number, type, ends, then line or circle.
fn profile(text: &str) -> (Contour, Vec<u32>) {
    let rows = text.lines().map(|l| l.split_whitespace().map(|f| f.parse::<f64>().unwrap()).collect::<Vec<_>>());
    let rows: Vec<Vec<f64>> = rows.filter(|row| row[0] != 0.0).collect();
    let element = |row: &Vec<f64>| {
        let (start, end) = (Point::new(row[2], row[3]), Point::new(row[4], row[5]));
        if row[1] == 2.0 {
            Segment::Arc { start, end, center: Point::new(row[6], row[7]), ccw: row[9] > 0.0 }
        } else {
            Segment::line(start, end)
        }
    };
    let inner = &rows[1..rows.len() - 1];
    (Contour::new(inner.iter().map(element).collect()), (2..).zip(inner).map(|(id, _)| id).collect())
}

/// Every clamping of every shipped example for the ORAC.
pub(crate) fn on_the_orac() -> Vec<Subject> {
    let catalog = Catalog::shipped();
    let mut subjects = Vec::new();
    for example in examples_of(turnwright::document::Kind::TurnedPart) {
        let document = Arc::new(document_from_text(example.name, example.text).unwrap());
        let derived = regenerate(&document, &catalog, &mut Cache::default(), &Cancel::default()).unwrap();
        for item in &derived.setups {
            let Some(mut input) = proof_input(&derived, item) else { continue };
            // The form-roll's program is the published listing.
            if input.machine.words.is_some() {
                continue;
            }
            if let Some(work) = &mut input.work {
                work.form_tolerance_mm = FORM_TOLERANCE_MM;
            }
            subjects.push(Subject { name: item.name.clone(), input });
        }
    }
    subjects
}
