//! Instructions that cannot be carried out, and small paths.

use super::*;
use crate::document::{CutIn, Generator, TurnedPart};
use crate::machine::{Catalog, Machine, ToolOutline, outlines};
use crate::part::{Section, Setup, setups};
use crate::units::Unit;
use std::collections::BTreeMap;

/// A roll of two shoulders with a hollow between them, on the published lathe.
fn part(instructions: Vec<Instruction>) -> TurnedPart {
    TurnedPart {
        machine: "mori-fanuc-6t".to_owned(),
        bar_diameter: 115.0,
        length: 60.0,
        form_tolerance: 0.05,
        generator: Generator::Cycles { instructions },
        sections: vec![
            Section::line(1, 0.0, 100.0, 20.0, 100.0),
            Section::line(2, 20.0, 100.0, 25.0, 80.0),
            Section::line(3, 25.0, 80.0, 40.0, 80.0),
            Section::line(4, 40.0, 80.0, 40.0, 100.0),
            Section::line(5, 40.0, 100.0, 60.0, 100.0),
        ],
        ..TurnedPart::default()
    }
}

fn machine() -> Machine {
    Catalog::shipped().machine("mori-fanuc-6t").unwrap().clone()
}

fn made(part: &TurnedPart, machine: &Machine, tools: &BTreeMap<u32, ToolOutline>) -> (CutterPath, Vec<Diagnostic>) {
    let setup: Setup = setups(part, machine).0.remove(0);
    let material = Catalog::shipped().material("STEEL", Unit::Mm).unwrap().in_mm();
    let Generator::Cycles { instructions } = &part.generator else { panic!("cycles") };
    generate(&Task { setup: &setup, part_mm: part, machine, tools, material_mm: &material }, instructions)
}

fn of(instructions: Vec<Instruction>) -> (CutterPath, Vec<Diagnostic>) {
    let machine = machine();
    let tools = outlines(&machine, &Catalog::shipped());
    made(&part(instructions), &machine, &tools)
}

fn instruction(cycle: Cycle, from: u32, to: u32, tool: u32) -> Instruction {
    Instruction {
        cycle,
        from,
        to,
        stock_left: 0.1,
        tool,
        depth: if matches!(cycle, Cycle::Rough | Cycle::Pocket) { 2.0 } else { 0.0 },
        speed_m_per_min: 200.0,
        feed_per_rev: 0.2,
        cut_in: None,
    }
}

/// Where a move of these cycles ends.
fn end(made: &CutMove) -> Option<Point> {
    match *made {
        CutMove::Rapid { to } | CutMove::Line { to, .. } | CutMove::Arc { to, .. } => Some(to),
        _ => None,
    }
}

fn cut_in(z: f64, angle_deg: f64) -> CutIn {
    CutIn { z, diameter: 80.0, angle_deg }
}

/// The only message, of an operation that is left out.
fn refused(bad: Instruction) -> (String, String) {
    let good = instruction(Cycle::Rough, 5, 1, 2);
    let (path, diagnostics) = of(vec![bad, good]);
    let carried_out: Vec<bool> = path.operations.iter().map(|o| !o.moves.is_empty()).collect();
    assert_eq!(carried_out, [false, true], "the other operation is carried out, at its place");
    let errors: Vec<&Diagnostic> =
        diagnostics.iter().filter(|d| d.severity == crate::diagnostic::Severity::Error).collect();
    let [error] = errors[..] else { panic!("{diagnostics:?}") };
    assert!(error.message.starts_with("Operation 1, "), "{error}");
    (error.code.clone(), error.message.clone())
}

#[test]
fn roughing_goes_down_to_the_contour_and_crosses_the_hollow() {
    let (path, diagnostics) = of(vec![instruction(Cycle::Rough, 5, 1, 2)]);
    assert_eq!(diagnostics, []);
    let [rough] = &path.operations[..] else { panic!("one operation") };
    assert_eq!((rough.kind, rough.tool, rough.change), (OperationKind::RoughRight, 2, Some(Point::new(320.0, 227.5))));
    let lowest = rough.moves.iter().filter_map(end).map(|p| p.r).fold(f64::INFINITY, f64::min);
    // The lead-in begins 3 mm below the offset contour, in front of the roll.
    assert!((lowest - (50.0 + 0.1 - 3.0)).abs() < 1e-9, "{lowest}");
    assert_eq!(rough.moves.last().and_then(end), rough.change);
}

#[test]
fn the_blank_is_carried_from_roughing_to_the_next_operation() {
    let approach = |path: &CutterPath, index: usize| end(&path.operations[index].moves[0]).unwrap().r;
    let (path, _) = of(vec![instruction(Cycle::Rough, 5, 1, 2), instruction(Cycle::Finish, 5, 1, 11)]);
    assert!((approach(&path, 0) - 67.5).abs() < 1e-9);
    // Tips at 55.5, 53.5, 51.5: the last nose centre still passes above 50.9 + 0.8.
    assert!((approach(&path, 1) - 61.5).abs() < 1e-9, "{}", approach(&path, 1));
}

#[test]
fn a_pocket_ends_above_the_blank_and_stays_within_its_walls() {
    let cut_in = cut_in(38.0, 30.0);
    let pocket = Instruction { cut_in: Some(cut_in), ..instruction(Cycle::Pocket, 3, 1, 2) };
    let (path, diagnostics) = of(vec![pocket]);
    assert_eq!(diagnostics, []);
    assert_eq!(path.operations[0].kind, OperationKind::Pocket);
}

#[test]
fn a_groove_is_plunged_in_steps_of_half_the_blade_and_ends_on_the_wall() {
    let (path, diagnostics) = of(vec![instruction(Cycle::Groove, 3, 3, 8)]);
    assert_eq!(diagnostics, []);
    let mut plunges: Vec<f64> = path.operations[0].moves.iter().filter_map(end).map(|p| p.z).collect();
    plunges.dedup();
    // The approach, 25 mm and on in steps of 2.05 mm, then 40 mm less the blade, and the change position.
    let expected = [20.0, 25.0, 27.05, 29.1, 31.15, 33.2, 35.25, 35.9, 320.0];
    assert!(plunges.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{plunges:?}");
    assert_eq!(plunges.len(), expected.len());
}

#[test]
fn elements_that_do_not_exist_are_named() {
    let (code, message) = refused(instruction(Cycle::Finish, 77, 1, 11));
    assert_eq!(code, "unknown-element");
    assert!(message.contains("77"), "{message}");
}

#[test]
fn a_missing_tool_and_one_of_the_wrong_kind_are_named() {
    let code = |bad| refused(bad).0;
    assert_eq!(code(instruction(Cycle::Finish, 5, 1, 99)), "tool-missing");
    assert_eq!(code(instruction(Cycle::Finish, 5, 1, 8)), "tool-unfit");
    let (code, message) = refused(instruction(Cycle::Groove, 3, 3, 2));
    assert_eq!(code, "tool-unfit");
    assert!(message.contains("wider than 0 mm"), "{message}");
}

#[test]
fn depth_feed_speed_and_stock_have_limits() {
    let rough = || instruction(Cycle::Rough, 5, 1, 2);
    for depth in [0.0, -1.0, 1e-9, f64::NAN] {
        assert_eq!(refused(Instruction { depth, ..rough() }).0, "depth");
    }
    assert_eq!(refused(Instruction { feed_per_rev: 0.0, ..rough() }).0, "cutting-data");
    assert_eq!(refused(Instruction { speed_m_per_min: f64::INFINITY, ..rough() }).0, "cutting-data");
    assert_eq!(refused(Instruction { stock_left: -0.1, ..rough() }).0, "stock-left");
}

#[test]
fn cut_in_lines_must_cross_the_first_element() {
    let pocket = |cut_in| Instruction { cut_in, ..instruction(Cycle::Pocket, 3, 1, 2) };
    assert_eq!(refused(pocket(None)).0, "cut-in-missing");
    assert_eq!(refused(pocket(Some(cut_in(50.0, 60.0)))).0, "cut-in-misses");
    assert_eq!(refused(pocket(Some(cut_in(38.0, 0.0)))).0, "cut-in-flat");
    assert_eq!(refused(pocket(Some(cut_in(f64::NAN, 30.0)))).0, "cut-in-flat");
}

#[test]
fn a_blade_wider_than_the_groove_is_refused() {
    let (code, message) = refused(instruction(Cycle::Groove, 4, 4, 8));
    assert_eq!(code, "groove-narrow");
    assert!(message.contains("4.100 mm"), "{message}");
}

#[test]
fn the_other_hand_and_useless_figures_are_warned_of() {
    let left = Instruction { depth: 1.0, cut_in: None, ..instruction(Cycle::Finish, 1, 5, 11) };
    let (path, diagnostics) = of(vec![left]);
    assert_eq!(path.operations.len(), 1);
    let codes: Vec<&str> = diagnostics.iter().map(|d| d.code.as_str()).collect();
    assert_eq!(codes, ["tool-hand", "depth-unused"]);
}

#[test]
fn two_ends_are_not_for_these_cycles() {
    let machine = machine();
    let tools = outlines(&machine, &Catalog::shipped());
    let part = TurnedPart { ends: Ends::Two { split: Some(30.0) }, ..part(vec![instruction(Cycle::Rough, 5, 1, 2)]) };
    let (path, diagnostics) = made(&part, &machine, &tools);
    assert_eq!((path.operations.len(), diagnostics[0].code.as_str()), (0, "cycles-two-ends"));
}
