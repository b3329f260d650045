//! The window with a flow-turned shell: parameters, drawing, the operator led step by step, runs and their comparison.
//!
//! `WINDOW_PICTURES=FOLDER cargo test --test window shell::` writes the pictures to a folder.

use crate::common::Window;
use egui::Key;
use egui_kittest::kittest::Queryable;
use turnwright::document::{Content, FormerShape, Kind, Shell};

fn open(name: &str) -> Window {
    let mut window = Window::open();
    window.open_example(name);
    window
}

fn shell(window: &mut Window) -> Shell {
    match &window.session().document().content {
        Content::Shell(shell) => shell.clone(),
        other => panic!("a shell, not {:?}", other.kind()),
    }
}

fn half_angle(window: &mut Window) -> f64 {
    let FormerShape::Cone { half_angle_deg, .. } = shell(window).former.shape else { panic!("a cone") };
    half_angle_deg
}

/// Presses buttons of the operator's panel by their names.
fn lead(window: &mut Window, buttons: &[&str]) {
    for name in buttons {
        window.click(name);
    }
}

/// To the question for the shape.
fn set_up(window: &mut Window) {
    lead(window, &["Begin", "Done", "Done", "Done", "Done", "Done"]);
    assert!(window.harness.query_by_label("Which contour is formed?").is_some());
}

fn choose(window: &mut Window, list: &str, entry: &str) {
    window.click(list);
    window.click(entry);
}

#[test]
fn a_figure_is_typed_and_everything_follows() {
    let mut window = open("CONE");
    window.keep_picture("shell");
    window.screenshot("shell");
    let field = window.harness.get_by_label("Half angle");
    field.focus();
    window.harness.run_steps(2);
    window.harness.event(egui::Event::Text("45".to_owned()));
    window.harness.run_steps(2);
    window.harness.key_press(Key::Enter);
    window.until_current();
    assert_eq!(half_angle(&mut window), 45.0);
    let made = window.session().derived().and_then(|d| d.shell.clone()).expect("a shell");
    assert!((made.shape.stations[0].wall - 1.6 * 0.5_f64.sqrt()).abs() < 1e-9);
    assert_eq!(window.session().history().undo_label(), Some("half angle"));
}

#[test]
fn the_base_is_dragged_and_undone_in_one_step() {
    let mut window = open("CONE");
    let grip = window.harness.get_by_label("Base of the former").rect().center();
    window.harness.hover_at(grip);
    window.harness.drag_at(grip);
    for step in 1..=6u8 {
        window.harness.hover_at(grip + egui::vec2(0.0, -4.0) * f32::from(step));
        window.harness.run_steps(1);
    }
    window.harness.drop_at(grip + egui::vec2(0.0, -24.0));
    window.harness.run_steps(3);
    window.until_current();
    assert!(half_angle(&mut window) > 32.0, "{}", half_angle(&mut window));
    window.keep_picture("shell-dragged");
    window.session().undo();
    assert_eq!(half_angle(&mut window), 30.0);
}

#[test]
fn the_operator_is_led_to_a_run_and_repeats_it() {
    let mut window = open("CONE");
    window.keep_picture("operator-begin");
    set_up(&mut window);
    lead(&mut window, &["C  this shell", "Run"]);
    window.harness.run_steps(30);
    assert!(window.harness.query_by_label("The roller follows the contour.").is_some());
    window.click("Rig");
    window.harness.run_steps(20);
    window.keep_picture("guided-run");
    window.screenshot("shell-run");
    let again = "Completed. Remove the component, disengage the carriage and bring it back by handwheel. Another identical piece?";
    // Ten times as fast: 35 s of the rig's time.
    for _ in 0..40 {
        window.harness.run_steps(10);
        if window.harness.query_by_label(again).is_some() {
            break;
        }
    }
    window.keep_picture("run-completed");
    lead(&mut window, &["Yes"]);
    window.harness.run_steps(4);
    window.harness.key_press(Key::Escape);
    window.harness.run_steps(4);
    assert!(window.harness.query_by_label("Emergency stop by the operator.").is_some());
    window.keep_picture("emergency-stop");
}

#[test]
fn published_entries_are_typed_and_wrong_ones_told() {
    let mut window = open("CONE");
    set_up(&mut window);
    lead(&mut window, &["A  cone", "2", "9", "Enter"]);
    assert!(window.harness.query_by_label_contains("enter 30 to 74").is_some());
    window.keep_picture("wrong-entry");
    lead(&mut window, &["5", "0", "Enter", "1", "6", "Enter", "3", "0", "Enter", "No", "No"]);
    assert!(window.harness.query_by_label("cone 30°, 50 mm, 16 pulses").is_some());
}

#[test]
fn faults_stop_the_run_and_runs_are_compared() {
    let mut window = open("CONE");
    window.click("Rig");
    choose(&mut window, "Pace", "at once");
    set_up(&mut window);
    lead(&mut window, &["A  cone", "5", "0", "Enter", "1", "6", "Enter", "3", "0", "Enter", "No", "No", "Run"]);
    window.harness.run_steps(4);
    lead(&mut window, &["No"]);
    choose(&mut window, "Moves", "relative moves");
    choose(&mut window, "Watch", "not watched");
    lead(&mut window, &["A  cone", "5", "0", "Enter", "1", "6", "Enter", "3", "0", "Enter", "No", "No", "Run"]);
    window.harness.run_steps(4);
    window.harness.run_steps(4);
    window.keep_picture("error-plot");
    window.screenshot("shell-error");
    lead(&mut window, &["No"]);
    choose(&mut window, "Moves", "absolute moves");
    choose(&mut window, "Watch", "path watched");
    choose(&mut window, "Fault", "carriage stalled");
    lead(&mut window, &["C  this shell", "Run"]);
    window.harness.run_steps(4);
    assert!(window.harness.query_by_label_contains("The encoder counted").is_some());
    window.keep_picture("stopped-run");
    window.screenshot("shell-stopped");
    window.click("Runs");
    window.keep_picture("runs");
    window.click("published measurements");
    window.harness.run_steps(2);
    window.keep_picture("measurements");
}

#[test]
fn other_shells_and_the_former_as_a_part() {
    for name in ["PARABOLA", "DISH"] {
        let mut window = open(name);
        window.keep_picture(&format!("shell-{}", name.to_lowercase()));
        window.click("Program");
        window.keep_picture(&format!("program-{}", name.to_lowercase()));
        window.click("former as part");
        window.until_current();
        assert_eq!(window.session().document().content.kind(), Kind::TurnedPart);
        window.keep_picture(&format!("former-{}", name.to_lowercase()));
    }
}
