//! What a user changes of the planner's operations: the rest is planned around it, and the proof finds nothing wrong.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, OperationEdit, OperationKind, OperationRef, TurnedPart};
use turnwright::machine::Catalog;
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::storage::document_from_text;
use turnwright::turning::{CutMove, Feed, Operation, Speed};
use turnwright::units::Unit;

fn housing() -> Document {
    document_from_text("bearing-housing.turn", include_str!("../cases/parts/bearing-housing.turn")).unwrap()
}

fn derived(document: Document) -> Derived {
    regenerate(&Arc::new(document), &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap()
}

fn part(document: &mut Document) -> &mut TurnedPart {
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    part
}

fn operation(kind: OperationKind, tool: u32) -> OperationRef {
    OperationRef { clamping: String::new(), kind, tool }
}

/// The housing with one changed operation.
fn changed(kind: OperationKind, tool: u32, change: impl FnOnce(&mut OperationEdit)) -> Derived {
    let mut document = housing();
    part(&mut document).plan.change(&operation(kind, tool), change);
    let derived = derived(document);
    assert_proved(&derived);
    derived
}

fn assert_proved(derived: &Derived) {
    let setup = &derived.setups[0];
    let text = || setup.programs.iter().map(|p| p.text.as_str()).collect::<String>();
    assert!(setup.proof.passed, "{:#?}\n{}", setup.proof.errors().next(), text());
    assert!(setup.proof.deepest_gouge_mm < 0.003);
}

fn operations(derived: &Derived) -> Vec<(OperationKind, u32)> {
    derived.setups[0].path.operations.iter().map(|o| (o.kind, o.tool)).collect()
}

fn found(derived: &Derived, kind: OperationKind) -> &Operation {
    derived.setups[0].path.operations.iter().find(|o| o.kind == kind).unwrap()
}

/// Feeds and speeds of an operation's cuts.
fn cuts(operation: &Operation) -> Vec<(f64, f64)> {
    let figures = operation.moves.iter().filter_map(|m| match m {
        CutMove::Line { cut, .. } | CutMove::Arc { cut, .. } => Some(cut),
        _ => None,
    });
    let feed = |feed| match feed {
        Feed::PerMinute(feed) | Feed::PerRev(feed) => feed,
    };
    let speed = |speed| match speed {
        Speed::Rpm(speed) | Speed::Surface { m_per_min: speed, .. } => speed,
    };
    figures.map(|cut| (feed(cut.feed), speed(cut.speed))).collect()
}

#[test]
fn what_is_left_out_is_cut_by_the_others() {
    let planned = operations(&derived(housing()));
    assert!(planned.contains(&(OperationKind::RoughBore, 7)), "{planned:?}");
    let derived = changed(OperationKind::RoughBore, 7, |edit| edit.skip = true);
    let after = operations(&derived);
    assert!(
        !after.contains(&(OperationKind::RoughBore, 7)) && after.contains(&(OperationKind::RoughBore, 8)),
        "{after:?}"
    );
    let left = derived.setups[0].proof.leftover.iter().filter(|l| [5, 6, 7].contains(&l.section));
    assert!(left.clone().count() > 0 && left.clone().all(|l| l.largest_mm < 0.2), "{:?}", left.collect::<Vec<_>>());
}

#[test]
fn an_operation_takes_the_tool_it_is_given() {
    let derived = changed(OperationKind::FinishBore, 8, |edit| edit.tool = Some(7));
    assert!(operations(&derived).contains(&(OperationKind::FinishBore, 7)));
    let unsuitable = {
        let mut document = housing();
        part(&mut document).plan.change(&operation(OperationKind::FinishBore, 8), |edit| edit.tool = Some(6));
        derived_codes(document)
    };
    assert!(unsuitable.iter().any(|code| code == "tool-unsuitable"), "{unsuitable:?}");
}

fn derived_codes(document: Document) -> Vec<String> {
    derived(document).diagnostics.into_iter().map(|d| d.code).collect()
}

#[test]
fn speed_feed_and_depth_are_those_that_were_asked_for() {
    let strokes = |derived: &Derived| found(derived, OperationKind::RoughBore).moves.len();
    let before = strokes(&derived(housing()));
    let derived = changed(OperationKind::RoughBore, 7, |edit| {
        (edit.speed_m_per_min, edit.feed, edit.depth) = (Some(140.0), Some(0.08), Some(0.5));
    });
    assert!(
        cuts(found(&derived, OperationKind::RoughBore)).iter().all(|&(feed, speed)| feed == 0.08 && speed == 140.0)
    );
    assert!(strokes(&derived) > 2 * before, "{} moves, {before} before", strokes(&derived));
}

#[test]
fn a_feed_beyond_the_spindle_s_power_is_reduced_all_the_same() {
    let derived = changed(OperationKind::RoughRight, 1, |edit| edit.feed = Some(1.2));
    assert!(cuts(found(&derived, OperationKind::RoughRight)).iter().all(|&(feed, _)| feed < 1.2));
}

#[test]
fn operations_come_in_the_order_that_was_asked_for() {
    let planned = operations(&derived(housing()));
    let is_bored = |&&(kind, _): &&(OperationKind, u32)| {
        matches!(kind, OperationKind::Drill | OperationKind::RoughBore | OperationKind::FinishBore)
    };
    // The bore right behind the face, before everything outside.
    let (face, rest) = planned.split_first().unwrap();
    let bore = rest.iter().filter(is_bored);
    let outside = rest.iter().filter(|o| !is_bored(o));
    let wanted: Vec<(OperationKind, u32)> = std::iter::once(face).chain(bore).chain(outside).copied().collect();
    assert_ne!(wanted, planned);
    let mut document = housing();
    part(&mut document).plan.order = wanted.iter().map(|&(kind, tool)| operation(kind, tool)).collect();
    let derived = derived(document);
    assert_proved(&derived);
    assert_eq!(operations(&derived), wanted);
}

#[test]
fn a_locked_operation_is_kept_where_the_planner_would_not_take_it() {
    let mut document = housing();
    let part = part(&mut document);
    part.part_off = false;
    part.plan.change(&operation(OperationKind::PartOff, 10), |edit| edit.locked = true);
    assert!(!operations(&derived(housing())).is_empty());
    let made = operations(&derived(document));
    assert!(made.contains(&(OperationKind::PartOff, 10)), "{made:?}");
}

#[test]
fn edits_are_saved_with_the_document_and_follow_its_unit() {
    let mut document = housing();
    part(&mut document).plan.change(&operation(OperationKind::Face, 1), |edit| edit.depth = Some(0.5));
    part(&mut document).plan.order = vec![operation(OperationKind::Face, 1)];
    let text = turnwright::storage::document_to_text(&document).unwrap();
    assert_eq!(document_from_text("again.turn", &text).unwrap(), document);
    let inches = part(&mut document).scaled(1.0 / Unit::Inch.in_mm());
    assert_eq!(inches.plan.operations[0].depth, Some(0.5 / 25.4));
}
