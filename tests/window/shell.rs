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
    window.type_text("45");
    window.harness.key_press(Key::Enter);
    window.until_current();
    assert_eq!(half_angle(&mut window), 45.0);
    let made = window.session().derived().and_then(|d| d.shell.clone()).expect("a shell");
    assert!((made.shape.stations[0].wall - 1.6 * 0.5_f64.sqrt()).abs() < 1e-9);
    assert_eq!(window.session().history().undo_label(), Some("half angle"));
}

/// Types a text into a field and leaves it.
fn type_into(window: &mut Window, name: &str, text: &str) {
    let field = window.harness.get_by_label(name);
    field.scroll_to_me();
    window.harness.run_steps(4);
    window.harness.get_by_label(name).focus();
    window.harness.run_steps(2);
    window.type_text(text);
    window.harness.key_press(Key::Enter);
    window.until_current();
}

#[test]
fn lubricant_follower_flank_and_station_are_typed() {
    let mut window = open("CONE");
    type_into(&mut window, "Follower length", "55");
    type_into(&mut window, "Lubricant", "tallow and graphite");
    type_into(&mut window, "Flank angle", "25");
    type_into(&mut window, "Turret station", "3");
    window.keep_picture("shell-fields");
    let made = shell(&mut window);
    assert_eq!((made.blank.follower_length, made.roller.flank_deg, made.roller.station), (55.0, 25.0, 3));
    assert_eq!(made.lubricant, "tallow and graphite");
    let program = window.session().derived().and_then(|d| d.shell.clone()).expect("a shell").programs[0].text.clone();
    assert!(program.contains("T3"), "{program}");
}

#[test]
fn rows_of_a_former_get_their_type_and_its_figures() {
    let mut window = open("CONE");
    choose(&mut window, "Contour", "section table");
    window.until_current();
    window.harness.get_by_label("Type of row 1").scroll_to_me();
    window.harness.run_steps(4);
    choose(&mut window, "Type of row 1", "convex");
    window.until_current();
    type_into(&mut window, "Radius of row 1", "20");
    window.keep_picture("shell-rows");
    let FormerShape::Sections { sections } = shell(&mut window).former.shape else { panic!("a table") };
    assert_eq!(sections[0].kind, turnwright::part::SectionKind::Convex { radius: 20.0 });
    let told =
        |window: &mut Window| window.session().problems().iter().any(|d| d.message.contains("at least 28.868 mm"));
    assert!(told(&mut window), "{:?}", window.session().problems());
    assert!(
        window.harness.query_all_by_label_contains("at least 28.868 mm").next().is_some(),
        "said where the drawing would be"
    );
    type_into(&mut window, "Radius of row 1", "120");
    assert!(!told(&mut window) && window.session().derived().is_some_and(|d| d.shell.is_some()));
    type_into(&mut window, "z end of row 1", "1000000");
    let said = window.session().problems().iter().any(|d| d.code == "shell-figure");
    assert!(said, "{:?}", window.session().problems());
}

#[test]
fn the_emergency_stop_is_in_reach_whatever_is_shown() {
    let mut window = open("CONE");
    set_up(&mut window);
    lead(&mut window, &["C  this shell", "Run"]);
    window.harness.run_steps(30);
    // Another document: the rig goes on, and the head of the window holds its stop.
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, turnwright::app::Action::New(Kind::TurnedPart));
    window.until_current();
    assert_eq!(window.session().document().content.kind(), Kind::TurnedPart);
    window.keep_picture("stop-in-the-head");
    window.click("Emergency stop");
    assert!(window.harness.query_by_label("Emergency stop").is_none());
    // By the key, with a question open.
    let mut window = open("CONE");
    set_up(&mut window);
    lead(&mut window, &["C  this shell", "Run"]);
    window.harness.run_steps(30);
    window.harness.key_press(Key::F1);
    window.harness.run_steps(3);
    window.harness.key_press(Key::Escape);
    window.harness.run_steps(4);
    window.harness.key_press(Key::Escape);
    window.harness.run_steps(4);
    assert!(window.harness.query_by_label("Emergency stop by the operator.").is_some());
}

#[test]
fn a_shell_that_breaks_a_rule_is_not_run() {
    let mut window = open("CONE");
    type_into(&mut window, "Half angle", "10");
    set_up(&mut window);
    lead(&mut window, &["C  this shell", "Run"]);
    assert!(window.harness.query_by_label_contains("Not started: The wall stands at 10.0°").is_some());
    window.keep_picture("not-started");
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
fn the_workspace_works_in_the_dark() {
    let mut window = Window::with_theme(egui::Theme::Dark);
    window.open_example("CONE");
    window.keep_picture("dark-shell");
    window.click("Rig");
    choose(&mut window, "Pace", "at once");
    set_up(&mut window);
    lead(&mut window, &["A  cone", "2", "9", "Enter"]);
    window.keep_picture("dark-wrong-entry");
    lead(&mut window, &["5", "0", "Enter", "1", "6", "Enter", "3", "0", "Enter", "No", "No", "Run"]);
    window.harness.run_steps(4);
    window.keep_picture("dark-completed");
    lead(&mut window, &["No"]);
    choose(&mut window, "Fault", "valve stuck shut");
    lead(&mut window, &["C  this shell", "Run"]);
    window.harness.run_steps(4);
    assert!(window.harness.query_by_label_contains("could not be drawn back").is_some());
    window.keep_picture("dark-stopped");
    window.click("Runs");
    window.click("published measurements");
    window.harness.run_steps(2);
    window.keep_picture("dark-measurements");
    window.harness.get_by_label("Lubricant").scroll_to_me();
    window.harness.run_steps(6);
    window.click("Wall");
    window.harness.run_steps(2);
    window.keep_picture("dark-wall");
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

#[cfg(unix)]
mod at_a_port {
    use super::*;
    use std::sync::mpsc;
    use std::time::{Duration, Instant};
    use turnwright::cancel::Cancel;
    use turnwright::spinning::rig::{RigModel, SimulatedRig};
    use turnwright::transfer::rig::{Device, run_on_pty};

    /// A rig on a pseudo-terminal whose time passes thirty times as fast.
    struct PortRig {
        cancel: Cancel,
        port: String,
        thread: Option<std::thread::JoinHandle<Result<(), String>>>,
    }

    impl PortRig {
        fn new() -> Self {
            let cancel = Cancel::default();
            let (tell, ready) = mpsc::channel();
            let unplugged = cancel.clone();
            let thread = std::thread::spawn(move || {
                let device = Device::new(SimulatedRig::new(RigModel::new(95.0, 1.27), Vec::new()));
                run_on_pty(device, 30.0, |port| tell.send(port).expect("waited for"), &unplugged)
            });
            let port = ready.recv_timeout(Duration::from_secs(30)).expect("a pseudo-terminal");
            Self { cancel, port, thread: Some(thread) }
        }

        fn unplug(&mut self) {
            self.cancel.cancel();
            if let Some(thread) = self.thread.take() {
                assert_eq!(thread.join().expect("the rig's thread"), Ok(()));
            }
        }
    }

    impl Drop for PortRig {
        fn drop(&mut self) {
            self.cancel.cancel();
        }
    }

    /// Frames until a text is shown.
    fn until(window: &mut Window, text: &str) {
        let until = Instant::now() + Duration::from_mins(1);
        while window.harness.query_by_label_contains(text).is_none() {
            window.harness.run_steps(1);
            assert!(Instant::now() < until, "{text} never came");
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    fn choose_port(window: &mut Window, port: &str) {
        window.click("Rig");
        choose(window, "Which rig", "rig at a port…");
        let field = window.harness.get_by_label("Path of the rig's port");
        field.focus();
        window.harness.run_steps(2);
        window.type_text(port);
        window.harness.key_press(Key::Enter);
        window.harness.run_steps(4);
    }

    #[test]
    fn a_rig_at_a_port_is_run_stopped_and_lost() {
        let mut rig = PortRig::new();
        let mut window = open("CONE");
        choose_port(&mut window, &rig.port);
        window.keep_picture("rig-chosen");
        lead(&mut window, &["Begin", "Done", "Done", "Done", "Done", "Done"]);
        until(&mut window, "Which contour is formed?");
        lead(&mut window, &["C  this shell", "Run"]);
        until(&mut window, "follows the contour ·");
        window.harness.run_steps(20);
        window.keep_picture("rig-at-a-port");
        until(&mut window, "Another identical piece?");
        window.keep_picture("rig-at-a-port-done");
        // Another piece, and the key of the emergency stop in the middle of it.
        lead(&mut window, &["Yes"]);
        until(&mut window, "follows the contour ·");
        window.harness.key_press(Key::Escape);
        until(&mut window, "stopped ·");
        assert!(window.harness.query_by_label("Emergency stop by the operator.").is_some());
        window.keep_picture("rig-at-a-port-stopped");
        // A third, and the plug is pulled.
        lead(&mut window, &["Set up again", "Done", "Done", "Done", "Done", "Done"]);
        until(&mut window, "Which contour is formed?");
        lead(&mut window, &["C  this shell", "Run"]);
        until(&mut window, "follows the contour ·");
        rig.unplug();
        until(&mut window, "The rig stops by itself after 2 s without a word");
        window.keep_picture("rig-at-a-port-lost");
    }

    #[test]
    fn a_port_without_a_rig_is_told() {
        let mut window = open("CONE");
        choose_port(&mut window, "/dev/no-such-port");
        lead(&mut window, &["Begin", "Done", "Done", "Done", "Done", "Done"]);
        until(&mut window, "/dev/no-such-port could not be opened");
        window.keep_picture("rig-refused");
        choose(&mut window, "Which rig", "simulated rig");
        set_up(&mut window);
    }
}

#[test]
fn a_sharp_hollow_corner_is_shown_as_it_will_be() {
    let mut window = open("CONE");
    window.session().edit("hollow", None, |document| {
        let Content::Shell(shell) = &mut document.content else { panic!("a shell") };
        let row = |id, z1, d1, z2, d2| turnwright::part::Section::line(id, z1, d1, z2, d2);
        let sections = vec![row(1, 0.0, 140.0, 10.0, 86.0), row(2, 10.0, 86.0, 40.0, 60.0)];
        shell.former.shape = FormerShape::Sections { sections };
        (shell.blank.follower_diameter, shell.roller.swivel_deg) = (30.0, 0.0);
    });
    window.until_current();
    window.harness.run_steps(4);
    window.keep_picture("hollow-corner");
    window.click("Problems");
    window.harness.run_steps(2);
    assert!(window.harness.query_by_label_contains("is a sharp corner").is_some());
    window.keep_picture("hollow-corner-problems");
}

#[test]
fn the_program_of_a_shell_is_edited_by_hand_and_reverted() {
    let mut window = open("CONE");
    window.click("Program");
    window.click("edit");
    let field = window.harness.get_by_label("Text of CONE");
    field.focus();
    window.harness.run_steps(2);
    window.type_text("G1 X10 Z-20 F0.1\n");
    window.until_current();
    let made = window.session().derived().and_then(|d| d.shell.clone()).expect("a shell");
    assert!(made.programs[0].edited && !made.proof.passed);
    assert!(window.harness.query_by_label("edited by hand").is_some());
    window.keep_picture("shell-program-by-hand");
    window.click("revert");
    window.until_current();
    let made = window.session().derived().and_then(|d| d.shell.clone()).expect("a shell");
    assert!(!made.programs[0].edited && made.proof.passed);
}
