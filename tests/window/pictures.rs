//! Pictures of the running window. `UPDATE_SCREENSHOTS=1 cargo test --test window pictures::` writes them to `screenshots/`.

use crate::common::Window;
use egui_kittest::kittest::Queryable;
use turnwright::app::data::Kind;
use turnwright::app::{Action, Surroundings};

#[test]
fn start_page() {
    Window::open().screenshot("start-page");
}

#[test]
fn queen_dragging() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let node = window.harness.get_by_label_contains("Node z 36.000  ⌀ 17.500").rect().center();
    window.harness.hover_at(node);
    window.harness.drag_at(node);
    for step in 1..=6u8 {
        window.harness.hover_at(node + egui::vec2(0.0, 1.4) * f32::from(step));
        window.harness.step();
    }
    window.until_current();
    window.screenshot("queen-dragging");
    assert!(window.session().part().sections[5].d1 < 17.0);
    window.harness.drop_at(node + egui::vec2(0.0, 8.4));
    window.harness.run_steps(2);
    window.session().undo();
    assert_eq!(window.session().part().sections[5].d1, 17.5, "a drag is one step of undo");
}

#[test]
fn playback_half_way() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let half = window.session().setup().unwrap().proof.times.total_s / 2.0;
    window.desk().play_from(half);
    window.harness.run_steps(4);
    window.screenshot("playback-half-way");
}

#[test]
fn playback_of_a_form_roll() {
    let mut window = Window::open();
    window.open_example("1470b-2T");
    let end = window.session().setup().unwrap().proof.times.total_s;
    window.desk().play_from(end * 0.6);
    window.harness.run_steps(4);
    window.screenshot("playback-form-roll");
    assert!(window.session().selection.block.is_some(), "the block that is cut is shown");
}

#[test]
fn failing_proof() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    crate::common::change_one_z(&mut window);
    window.click("Problems");
    let problem = window.session().problems().first().cloned().unwrap();
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::GoTo(problem.at));
    window.harness.run_steps(2);
    window.click("Problems");
    window.click("Send to ORAC");
    window.screenshot("failing-proof");
}

#[test]
fn transfer_under_way() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("Send to ORAC");
    window.until("a few pages are out", |desk| desk.transfer_progress().is_some_and(|p| p.block >= 9));
    window.screenshot("transfer-under-way");
    assert!(window.harness.query_by_label("Abort").is_some());
    window.click("Abort");
    window.until("aborted", |desk| desk.transfer_outcome().is_some());
}

#[test]
fn operations_panel() {
    let mut window = Window::open();
    window.open_example("1470b-2T");
    window.harness.get_by_label_contains("Operation 3: ").click();
    window.harness.run_steps(4);
    window.harness.remove_cursor();
    window.harness.run_steps(3);
    window.screenshot("operations-panel");
    assert!(!window.session().lit().blocks.is_empty());
}

#[test]
fn tool_editor() {
    let folder = tempfile::tempdir().unwrap();
    let surroundings = Surroundings { config_folder: Some(folder.path().to_owned()), ..Surroundings::default() };
    let mut window = Window::with(egui::Theme::Light, surroundings);
    window.open_example("QUEEN");
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::EditData(Kind::Tools, Some("svjbr-vbmt-04".to_owned())));
    window.harness.run_steps(30);
    window.screenshot("tool-editor");
    assert!(window.harness.query_by_label("Picture of the tool").is_some());
}
