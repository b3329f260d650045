//! The operations panel with a planned part: what a person changes of the plan, and what becomes of document and plan.
//!
//! `WINDOW_PICTURES=FOLDER cargo test --test window plan::` writes pictures to a folder.

use crate::common::Window;
use egui::{Key, Modifiers};
use turnwright::document::{OperationKind, PlanEdits};

/// The bearing housing, planned.
fn open() -> Window {
    Window::with_file("tests/cases/parts/bearing-housing.turn")
}

fn select(window: &mut Window, kind: OperationKind) {
    let operations = window.session().setup().unwrap().path.operations.clone();
    let index = operations.iter().position(|o| o.kind == kind).unwrap();
    window.session().select_operation(index);
    window.harness.run_steps(3);
}

fn kinds(window: &mut Window) -> Vec<OperationKind> {
    window.until_current();
    let setup = window.session().setup().unwrap().clone();
    assert!(setup.proof.passed, "{:?}", setup.proof.errors().next());
    setup.path.operations.iter().map(|o| o.kind).collect()
}

fn plan(window: &mut Window) -> PlanEdits {
    window.session().part().plan.clone()
}

#[test]
fn an_operation_is_left_out_and_taken_again() {
    let mut window = open();
    assert!(kinds(&mut window).contains(&OperationKind::Face));
    select(&mut window, OperationKind::Face);
    window.click("leave out");
    assert!(plan(&mut window).operations[0].skip);
    assert!(!kinds(&mut window).contains(&OperationKind::Face));
    window.harness.run_steps(3);
    window.keep_picture("plan-left-out");
    window.click("take it again");
    assert_eq!(plan(&mut window), PlanEdits::default());
    window.session().undo();
    assert!(!kinds(&mut window).contains(&OperationKind::Face), "undone");
    window.session().undo();
    assert!(kinds(&mut window).contains(&OperationKind::Face));
}

#[test]
fn an_operation_is_moved_with_links_and_keys() {
    let mut window = open();
    let before = kinds(&mut window);
    let drill = before.iter().position(|k| *k == OperationKind::Drill).unwrap();
    select(&mut window, OperationKind::Drill);
    window.click("↑");
    let after = kinds(&mut window);
    assert_eq!(after.iter().position(|k| *k == OperationKind::Drill), Some(drill - 1), "{after:?}");
    window.harness.run_steps(3);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::ArrowDown);
    window.harness.run_steps(3);
    assert_eq!(kinds(&mut window), before);
    window.harness.run_steps(3);
    window.click("planner's order");
    assert_eq!(plan(&mut window), PlanEdits::default());
}

#[test]
fn figures_are_typed_and_given_back_to_the_planner() {
    let mut window = open();
    select(&mut window, OperationKind::RoughBore);
    window.click("Depth");
    window.type_text("0.6");
    window.harness.key_press(Key::Enter);
    window.harness.run_steps(3);
    assert_eq!(plan(&mut window).operations[0].depth, Some(0.6));
    window.until_current();
    window.harness.run_steps(3);
    window.click("lock");
    let edit = plan(&mut window).operations[0].clone();
    assert!(
        edit.locked && edit.feed.is_some_and(|f| f > 0.0) && edit.speed_m_per_min.is_some_and(|v| v > 0.0),
        "{edit:?}"
    );
    window.until_current();
    window.harness.run_steps(3);
    window.keep_picture("plan-figures");
    window.click("planner's choices");
    assert_eq!(plan(&mut window), PlanEdits::default());
    assert!(kinds(&mut window).contains(&OperationKind::RoughBore));
}
