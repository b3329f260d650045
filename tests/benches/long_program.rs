//! A long program: a wavy shaft turned in ever finer passes of ever shorter blocks.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::Arc;
use turnwright::geometry::{Contour, Point, Segment};
use turnwright::machine::{self, Catalog};
use turnwright::proof::{ProgramText, ProofInput, Target, Work};

/// Length that is turned, mm.
const LENGTH: f64 = 90.0;
/// Radius of the bar, mm.
const BAR: f64 = 20.0;
/// Most that the passes take off the radius, mm.
const DEPTH: f64 = 7.0;
/// Lines of the finished contour.
const LINES: u32 = 90;

/// Radius of the finished shaft, mm.
fn radius(z: f64) -> f64 {
    12.0 + (z / 7.0).sin()
}

/// The proof of a program of about `blocks` blocks, with the real right-hand tool: as many passes as each has blocks, four
/// times over.
pub(crate) fn input(blocks: u32) -> ProofInput {
    let catalog = Catalog::shipped();
    let mut machine = catalog.machine("orac").expect("the machine is shipped").clone();
    // Short blocks are often nearly level; a finding for each would be all that is measured.
    machine.limits.taper_ratio = f64::INFINITY;
    let tools = machine::outlines(&machine, &catalog);
    let program = ProgramText { name: "LONG".into(), text: text(blocks), edited: false };
    let at = |k: u32| {
        let z = LENGTH * f64::from(k) / f64::from(LINES);
        Point::new(z, radius(z))
    };
    let lines = (0..LINES).map(|k| Segment::line(at(k), at(k + 1))).collect();
    let corners = [(-40.0, 0.0), (LENGTH, 0.0), (LENGTH, BAR), (-40.0, BAR)].map(|(z, r)| Point::new(z, r));
    let target = Target {
        contour: Contour::new(lines),
        sections: (1..=LINES).collect(),
        names: BTreeMap::new(),
        machined_from_z: 0.0,
        bore: None,
    };
    let work = Work {
        stock: Contour::polygon(&corners),
        target,
        program_zero_z: LENGTH,
        chuck_face_z: -10.0,
        mandrel: None,
        tailstock: None,
        material: None,
        form_tolerance_mm: 0.05,
        may_cut: Vec::new(),
    };
    ProofInput {
        machine: Arc::new(machine),
        tools: Arc::new(tools),
        programs: Arc::new(vec![program]),
        work: Some(work),
    }
}

fn text(blocks: u32) -> String {
    let passes = (f64::from(blocks).sqrt() / 2.0).ceil();
    let chords = (f64::from(blocks) / passes - 3.0).floor();
    let (mut text, mut number) = (String::new(), 0);
    let mut block = |op: &str| {
        number += 1;
        writeln!(text, "{number:>3}  {op}").expect("text takes all");
    };
    block("ABS");
    block("MM");
    block("PDAT 22 20");
    let (mut pass, mut at) = (1.0, 0.0);
    while pass <= passes {
        let allowance = DEPTH * (1.0 - pass / passes);
        let x = |z: f64| (radius(LENGTH + z) + allowance).min(BAR - pass / passes);
        block(&format!("PTP {:.3} 1 1000 1 1000", x(1.0)));
        while at <= chords {
            let z = -(LENGTH - 2.0) * at / chords;
            block(&format!("PTP {:.3} {z:.3} 80 1 1000", x(z)));
            at += 1.0;
        }
        block(&format!("PTP 22 {:.3} 1000 1 1000", -LENGTH + 2.0));
        block("PTP 22 1 1000 1 1000");
        (pass, at) = (pass + 1.0, 0.0);
    }
    block("PTP 22 20 1000 1 1000");
    block("END");
    text
}
