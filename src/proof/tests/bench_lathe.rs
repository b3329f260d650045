//! A small lathe and a bar for the tests, with figures of their own.

use super::*;
use crate::cancel::Cancel;

use crate::machine::{
    Chuck, DatumRule, Delivery, Dialect, Directions, FolderProfile, Limits, Machine, SpeedRule, Spindle, ToolOutline,
    TurretSide, ZeroEnd,
};
use std::collections::BTreeMap;
use std::sync::Arc;

pub(in crate::proof) fn machine() -> Machine {
    Machine {
        id: "test".into(),
        name: "Test lathe".into(),
        dialect: Dialect::Orac,
        limits: Limits {
            bar_diameter_mm: 40.0,
            travel_x_mm: 95.0,
            travel_z_mm: 350.0,
            taper_ratio: 20.0,
            arc_radius_min_mm: 2.0,
            arc_radius_max_mm: 3000.0,
            arc_one_quadrant: true,
            pitch_min_mm: 0.35,
            pitch_max_mm: 3.5,
            feed_min_mm_per_min: 30.0,
            feed_max_mm_per_min: 1200.0,
            spindle_max_rpm: 2000.0,
            blocks_per_program: 99,
        },
        spindle: Spindle {
            speed: SpeedRule::Radius { at_center_rpm: 2000.0, per_mm_radius_rpm: 60.0 },
            min_rpm: 1.0,
            thread_feed_mm_per_min: 700.0,
            power_kw: None,
            full_power_rpm: None,
            efficiency: 0.8,
            ranges: Vec::new(),
        },
        datum: DatumRule { radial_clearance_mm: 2.0, axial_clearance_mm: 20.0, zero: ZeroEnd::FreeEnd },
        chuck: Chuck {
            radius_mm: 30.0,
            depth_mm: 30.0,
            gap_mm: 10.0,
            grip_mm: 30.0,
            automatic_grip_mm: 50.0,
            cuts: Directions::Both,
        },
        rapid_feed_mm_per_min: Some(1000.0),
        turret_side: TurretSide::Rear,
        words: None,
        motion: None,
        rest: None,
        mandrel: None,
        tailstock: None,
        cost: None,
        tool_change_s: 4.0,
        tools: Vec::new(),
        serial: Delivery::Folder(FolderProfile { folder: "~/nc".into(), extension: "nc".into() }),
    }
}

pub(in crate::proof) fn polygon(points: &[(f64, f64)]) -> Contour {
    Contour::polygon(&points.iter().map(|&(z, r)| Point::new(z, r)).collect::<Vec<_>>())
}

/// Sharp tools: 1 right-hand, 2 left-hand, 3 threading, 4 parting 3 mm wide; holders well above.
pub(in crate::proof) fn tools() -> BTreeMap<u32, ToolOutline> {
    let right = ToolOutline {
        insert: polygon(&[(0.0, 0.0), (5.0, 4.0), (5.0, 10.0), (0.0, 6.0)]),
        holder: polygon(&[(0.5, 8.0), (12.0, 8.0), (12.0, 60.0), (0.5, 60.0)]),
        ..ToolOutline::default()
    };
    let left = ToolOutline {
        insert: polygon(&[(0.0, 0.0), (0.0, 6.0), (-5.0, 10.0), (-5.0, 4.0)]),
        holder: polygon(&[(-12.0, 8.0), (-0.5, 8.0), (-0.5, 60.0), (-12.0, 60.0)]),
        ..ToolOutline::default()
    };
    let thread = ToolOutline {
        insert: polygon(&[(0.0, 0.0), (2.886_75, 5.0), (-2.886_75, 5.0)]),
        holder: polygon(&[(-6.0, 5.0), (6.0, 5.0), (6.0, 60.0), (-6.0, 60.0)]),
        ..ToolOutline::default()
    };
    let parting = ToolOutline {
        insert: polygon(&[(0.0, 0.0), (3.0, 0.0), (3.0, 20.0), (0.0, 20.0)]),
        holder: polygon(&[(-1.0, 20.0), (8.0, 20.0), (8.0, 60.0), (-1.0, 60.0)]),
        ..ToolOutline::default()
    };
    BTreeMap::from([(1, right), (2, left), (3, thread), (4, parting)])
}

pub(in crate::proof) fn input_of(texts: &[&str]) -> ProofInput {
    let program = |(i, text): (usize, &&str)| ProgramText {
        name: format!("TEST{}", i + 1),
        text: (*text).to_owned(),
        edited: false,
    };
    ProofInput {
        machine: Arc::new(machine()),
        tools: Arc::new(tools()),
        programs: Arc::new(texts.iter().enumerate().map(program).collect()),
        work: None,
    }
}

pub(in crate::proof) fn prove_input(input: &ProofInput) -> ProofReport {
    prove(input, &Cancel::default()).unwrap()
}

/// Proves lists of instructions without work.
pub(in crate::proof) fn prove_texts(texts: &[&str]) -> ProofReport {
    prove_input(&input_of(texts))
}

pub(in crate::proof) fn kinds(report: &ProofReport) -> Vec<(FindingKind, usize)> {
    report.findings.iter().map(|f| (f.kind, f.block)).collect()
}

/// Length of the test part; its end face is the program zero.
pub(in crate::proof) const LENGTH: f64 = 30.0;

/// A bar of radius 10 from z −40 to 30, chuck face at −10, to become a cylinder of radius 8 up to z 20 and 6 from there.
pub(in crate::proof) fn work() -> Work {
    let p = Point::new;
    let contour = Contour::new(vec![
        Segment::line(p(0.0, 8.0), p(20.0, 8.0)),
        Segment::line(p(20.0, 8.0), p(20.0, 6.0)),
        Segment::line(p(20.0, 6.0), p(LENGTH, 6.0)),
    ]);
    Work {
        stock: polygon(&[(-40.0, 0.0), (LENGTH, 0.0), (LENGTH, 10.0), (-40.0, 10.0)]),
        target: Target { contour, sections: vec![1, 2, 2], names: BTreeMap::new(), machined_from_z: 0.0, bore: None },
        program_zero_z: LENGTH,
        chuck_face_z: -10.0,
        mandrel: None,
        tailstock: None,
        material: None,
        form_tolerance_mm: 0.05,
        may_cut: Vec::new(),
    }
}

/// A program in absolute format: numbers are added, and the head and the end around `body`.
pub(in crate::proof) fn absolute(body: &str) -> String {
    lines(&format!("ABS\nMM\nPDAT 12 20\n{body}\nPTP 12 20 1000 1 1000\nEND"))
}

/// Blocks before the body of [`absolute`].
pub(in crate::proof) const HEAD: usize = 3;

pub(in crate::proof) fn lines(text: &str) -> String {
    let numbered: Vec<String> = text.lines().enumerate().map(|(i, l)| format!("{:>3}  {l}\n", i + 1)).collect();
    numbered.concat()
}

pub(in crate::proof) fn with_work(texts: &[&str], work: Work) -> ProofInput {
    ProofInput { work: Some(work), ..input_of(texts) }
}

pub(in crate::proof) fn prove_work(body: &str) -> ProofReport {
    prove_input(&with_work(&[&absolute(body)], work()))
}

/// Findings but those of leftover, which most short programs have.
pub(in crate::proof) fn faults(report: &ProofReport) -> Vec<(FindingKind, usize)> {
    kinds(report).into_iter().filter(|(kind, _)| *kind != FindingKind::Leftover).collect()
}

/// Area of a stock state, mm².
pub(in crate::proof) fn area(state: &StockState) -> f64 {
    let doubled = |ring: &Vec<Point>| {
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.z * b.r - b.z * a.r).sum::<f64>()
    };
    state.rings.iter().map(doubled).sum::<f64>() / 2.0
}

/// The shipped lathe with today's control of words.
pub(in crate::proof) fn word_lathe() -> Machine {
    crate::machine::Catalog::shipped().machine("fanuc-0i").unwrap().clone()
}
