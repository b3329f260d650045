//! Cross-section, flower and charts of a set of form-rolls in the window.

use crate::common::Window;
use egui::{Event, Key, Modifiers, PointerButton, Pos2};
use egui_kittest::kittest::{NodeT, Queryable};
use std::path::Path;
use turnwright::app::Action;
use turnwright::document::{Document, ElementKind, RollSet};
use turnwright::rollform::bends::{Stage, angles_deg};
use turnwright::storage::{open_document, save_document};

/// The published section 1470b with its flower and its rolls, in a window.
fn published() -> Window {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples/1470b.turn");
    open(&open_document(&example).unwrap())
}

fn open(document: &Document) -> Window {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("1470b.turn");
    save_document(&path, document).unwrap();
    let mut window = Window::open();
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::Open(path));
    window.harness.run_steps(2);
    window.until("designed", |desk| desk.session().is_some_and(|s| s.derived().is_some_and(|d| d.rolls.is_some())));
    window.harness.run_steps(3);
    window
}

fn set(window: &mut Window) -> RollSet {
    window.session().document().content.roll_set().unwrap().clone()
}

fn angle(window: &mut Window, station: usize, element: u32) -> f64 {
    angles_deg(&set(window), Stage::Station(station))[&element]
}

#[test]
fn stages_are_picked_and_the_station_follows() {
    let mut window = published();
    window.click("Stage 2");
    assert_eq!(window.session().selection.station, Some(2));
    window.screenshot("rolls-flower");
    let canvas = window.harness.get_by_role_and_label(egui::accesskit::Role::Canvas, "Flower").rect();
    let in_common = window.picture().part(canvas);
    window.click("side by side");
    window.harness.run_steps(3);
    let apart = window.picture().part(canvas);
    assert!(apart != in_common, "every stage has an origin of its own");
    window.screenshot("rolls-flower-side-by-side");
    window.click("side by side");
    window.harness.run_steps(3);
    assert!(window.picture().part(canvas) != apart, "and one in common again");
}

#[test]
fn a_leg_is_dragged_and_the_angle_of_its_bend_follows() {
    let mut window = published();
    window.click("Stage 2");
    window.harness.run_steps(3);
    let canvas = window.harness.get_by_role_and_label(egui::accesskit::Role::Canvas, "Flower").rect();
    // The right end of the strip lies low at the right; it is found by looking for the piece under the pointer.
    let before = angle(&mut window, 1, 20);
    let grip = find_leg(&mut window, canvas);
    drag(&mut window, grip, grip + egui::vec2(0.0, -14.0));
    let after = angle(&mut window, 1, 20) - before;
    let others = [8, 10, 16, 18].map(|id| angle(&mut window, 1, id));
    assert!(after != 0.0 || others != [-25.0, -45.0, 25.0, 25.0], "nothing was bent");
    assert!(window.session().history().undo_label().unwrap().starts_with("angle of element"));
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.harness.run_steps(2);
    assert_eq!(angle(&mut window, 1, 20), before);
    assert_eq!(window.session().history().undo_label(), None);
}

/// A place at which the strip can be taken hold of, right of the middle.
fn find_leg(window: &mut Window, canvas: egui::Rect) -> Pos2 {
    for x in [0.92, 0.93, 0.94, 0.91, 0.90, 0.89] {
        for step in 0..60 {
            let y = canvas.top() + canvas.height() * (step as f32 + 0.5) / 60.0;
            let pos = egui::pos2(canvas.left() + canvas.width() * x, y);
            window.harness.hover_at(pos);
            window.harness.run_steps(1);
            if window.harness.output().platform_output.cursor_icon == egui::CursorIcon::Grab {
                return pos;
            }
        }
    }
    panic!("no leg was found in {canvas:?}");
}

fn drag(window: &mut Window, from: Pos2, to: Pos2) {
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    window.harness.event(Event::PointerMoved(from));
    window.harness.run_steps(1);
    window.harness.event(button(from, true));
    window.harness.run_steps(1);
    for step in 1..=6 {
        window.harness.event(Event::PointerMoved(from + (to - from) * (step as f32 / 6.0)));
        window.harness.run_steps(1);
    }
    window.harness.event(button(to, false));
    window.harness.run_steps(3);
}

#[test]
fn an_angle_is_typed_into_the_matrix() {
    let mut window = published();
    let label = window
        .harness
        .get_all_by_role(egui::accesskit::Role::Cell)
        .map(|n| n.accesskit_node().label().unwrap_or_default())
        .collect::<Vec<_>>();
    let name = label
        .iter()
        .find(|l| l.contains("stn 3") && l.ends_with(": -75"))
        .cloned()
        .unwrap_or_else(|| panic!("{label:?}"));
    window.click(&name);
    window.type_text("-90");
    window.press(Modifiers::NONE, Key::Enter);
    assert_eq!(angle(&mut window, 2, 20), -90.0);
}

#[test]
fn a_flower_is_suggested() {
    let mut window = published();
    window.click("suggest");
    window.harness.run_steps(3);
    window.screenshot("rolls-suggest");
    window.click("Make this flower");
    let set = set(&mut window);
    let last = set.stations.len() - 1;
    for element in set.section.all() {
        if let ElementKind::Bend { angle_deg, .. } = element.kind {
            assert!((angles_deg(&set, Stage::Station(last))[&element.id] - angle_deg).abs() < 1e-9);
        }
    }
    assert_eq!(window.session().history().undo_label(), Some("suggest a flower"));
}

#[test]
fn charts_show_strain_springback_and_properties() {
    let mut window = published();
    window.click("Stage 3");
    window.screenshot("rolls-strain");
    window.click("Springback");
    assert!(window.harness.query_by_label_contains("element 20, -75.00°").is_some());
    window.click("Section");
    window.screenshot("rolls-properties");
    assert!(window.harness.query_by_label_contains("Area, mm², 56.42, 56.42").is_some());
}

#[test]
fn an_impossible_element_is_marked_and_found_by_its_message() {
    let mut window = published();
    window.session().edit("break it", None, |document| {
        if let turnwright::document::Content::RollSet(set) = &mut document.content {
            set.section.elements[18].kind = ElementKind::Line { length: 0.0 };
        }
    });
    window.until("said", |desk| {
        desk.session().is_some_and(|s| s.is_designed() && s.problems().iter().any(|p| p.code == "element-length"))
    });
    window.harness.run_steps(3);
    let problem = window.session().problems().iter().find(|p| p.code == "element-length").cloned().unwrap();
    assert_eq!(problem.at.to_string(), "element 19");
}
