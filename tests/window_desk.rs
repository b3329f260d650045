//! The window: what a person does on it, and what becomes of the document.

#![cfg(feature = "gui")]

mod common;

use common::Window;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use turnwright::app::{Action, Pane, Surroundings};
use turnwright::diagnostic::Severity;
use turnwright::session::Verdict;
use turnwright::transfer::Outcome;

#[test]
fn an_example_opens_with_its_program_proved() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    assert_eq!(window.session().document().name, "QUEEN");
    assert_eq!(window.session().part().sections.len(), 12);
    assert!(matches!(window.session().verdict(), Verdict::Proved { .. }), "{:?}", window.session().problems());
}

#[test]
fn a_cell_is_edited_and_undone() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("⌀ end of row 1: 25.400");
    window.harness.key_press(Key::F2);
    window.harness.run_steps(3);
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text("1in-0.4".to_owned()));
    window.harness.run_steps(2);
    window.harness.key_press(Key::Enter);
    window.harness.run_steps(3);
    assert_eq!(window.session().part().sections[0].d2, 25.0);
    assert_eq!(window.session().history().undo_label(), Some("⌀ end of line 1"));
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.harness.run_steps(2);
    assert_eq!(window.session().part().sections[0].d2, 25.4);
    assert_eq!(window.session().history().undo_label(), None);
}

#[test]
fn a_bad_cell_is_marked_and_changes_nothing() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("z end of row 1: 2.000");
    window.harness.event(Event::Text("2..1".to_owned()));
    window.harness.run_steps(3);
    window.harness.key_press(Key::Tab);
    window.harness.run_steps(3);
    assert_eq!(window.session().part().sections[0].z2, 2.0);
    assert!(window.harness.query_by_label("z end of row 1: 2..1").is_some());
}

#[test]
fn figures_typed_within_one_frame_are_all_taken() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("⌀ end of row 1: 25.400");
    let key =
        Event::Key { key: Key::Enter, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE };
    let typed = ["2", "4", ".", "5"].map(|figure| Event::Text(figure.to_owned()));
    window.harness.input_mut().events.extend(typed.into_iter().chain([key]));
    window.harness.run_steps(3);
    assert_eq!(window.session().part().sections[0].d2, 24.5);
}

#[test]
fn rows_are_pasted_from_a_spreadsheet() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("Row 12");
    window.harness.event(Event::Paste("line\t53.5\t4\t54\t4\nconvex\t54\t4\t56\t1\t4\n".to_owned()));
    window.harness.run_steps(3);
    let sections = window.session().part().sections.clone();
    assert_eq!(sections.len(), 13);
    assert_eq!((sections[11].z2, sections[12].d2), (54.0, 1.0));
    window.desk().act(&egui::Context::default(), Action::Undo);
    assert_eq!(window.session().part().sections.len(), 12);
}

#[test]
fn keys_insert_duplicate_move_and_delete_rows() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("Row 3");
    let first = window.session().part().sections[2].id;
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::D);
    window.harness.run_steps(2);
    assert_eq!(window.session().part().sections.len(), 13);
    window.click("Row 3");
    window.harness.key_press_modifiers(Modifiers::ALT, Key::ArrowUp);
    window.harness.run_steps(2);
    assert_eq!(window.session().part().sections[1].id, first);
    window.harness.key_press(Key::Insert);
    window.harness.run_steps(2);
    assert_eq!(window.session().part().sections.len(), 14);
    window.click("Row 2");
    window.harness.key_press(Key::Delete);
    window.harness.run_steps(2);
    assert_eq!(window.session().part().sections.len(), 13);
}

#[test]
fn a_problem_leads_to_its_cell() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.session().edit_part("spoil", None, |part| part.sections[5].d1 = 30.0);
    window.until_current();
    window.click("Problems");
    let problem = window.session().problems().iter().find(|d| d.severity == Severity::Error).cloned().unwrap();
    window.click(&format!("{}: {}", problem.at, problem.message));
    let selected = window.session().selection.section;
    assert_eq!(selected, Some(window.session().part().sections[5].id));
}

#[test]
fn a_program_is_sent_to_the_virtual_lathe_and_compared() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.desk().set_paced(false);
    window.click("Send to ORAC");
    window.until("sent", |desk| desk.transfer_outcome().is_some());
    assert_eq!(window.desk().transfer_outcome(), Some(&Outcome::SentNotVerified));
    window.click("Compare");
    window.until("compared", |desk| desk.transfer_progress().is_none() && desk.transfer_outcome().is_some());
    assert_eq!(window.desk().transfer_outcome(), Some(&Outcome::Verified));
}

#[test]
fn a_program_whose_proof_fails_is_sent_in_a_second_step_only() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.desk().set_paced(false);
    common::change_one_z(&mut window);
    assert!(matches!(window.session().verdict(), Verdict::Failed { .. }));
    window.click("Send to ORAC");
    assert!(window.desk().asks_to_insist());
    assert!(window.desk().transfer_progress().is_none() && window.desk().transfer_outcome().is_none());
    window.click("Do not send");
    assert!(!window.desk().asks_to_insist());
    window.click("Send to ORAC");
    window.click("Send all the same");
    window.until("sent", |desk| desk.transfer_outcome().is_some());
    assert_eq!(window.desk().transfer_outcome(), Some(&Outcome::SentNotVerified));
}

#[test]
fn unsaved_work_is_asked_about_once() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.session().edit_part("longer", None, |part| part.length = 57.0);
    window.harness.run_steps(2);
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    window.harness.run_steps(3);
    assert_eq!(window.session().document().name, "QUEEN");
    window.click("Do not save");
    window.harness.run_steps(3);
    assert_eq!(window.session().document().name, "PART");
}

#[test]
fn a_document_is_saved_by_a_typed_path() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("queen.turn");
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    window.harness.run_steps(3);
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text(path.display().to_string()));
    window.harness.run_steps(2);
    window.harness.key_press(Key::Enter);
    let saved = path.clone();
    window.until("saved", move |_| saved.exists());
    window.until("noted", |desk| desk.session().is_some_and(|s| s.path().is_some()));
    assert_eq!(window.session().path(), Some(path.as_path()));
    assert!(!window.session().has_unsaved_work());
}

#[test]
fn panels_are_hidden_and_the_layout_is_remembered() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::TogglePane(Pane::Transfer));
    window.harness.run_steps(3);
    assert!(window.harness.query_by_label("Receive").is_none());
    let mut kept = std::collections::HashMap::new();
    window.desk().remember(|key, value| _ = kept.insert(key.to_owned(), value));
    let mut next = Window::open();
    next.desk().restore(|key| kept.get(key).cloned());
    next.open_example("QUEEN");
    assert!(next.harness.query_by_label("Receive").is_none());
    let ctx = next.harness.ctx.clone();
    next.desk().act(&ctx, Action::ResetLayout);
    next.harness.run_steps(3);
    assert!(next.harness.query_by_label("Receive").is_some());
}

#[test]
fn the_dark_window_is_drawn_too() {
    let mut window = Window::with_theme(egui::Theme::Dark);
    window.open_example("MASTER");
    assert!(window.picture().colors() > 8);
}

/// A window that goes without being closed, as in a crash: the edit is in the recovery file, and the next start offers it.
#[test]
fn an_edit_that_was_never_saved_survives_a_crash() {
    let folder = tempfile::tempdir().unwrap();
    let surroundings = Surroundings { recovery_folder: Some(folder.path().to_owned()), ..Surroundings::default() };
    let mut window = Window::with(egui::Theme::Light, surroundings.clone());
    window.open_example("QUEEN");
    window.session().edit_part("shorten the crown", None, |part| part.sections[11].d2 = 2.5);
    let is_file = |entry: std::io::Result<std::fs::DirEntry>| {
        entry.is_ok_and(|e| std::fs::read_to_string(e.path()).is_ok_and(|text| text.contains("QUEEN")))
    };
    window.until("the recovery file is written", |_| std::fs::read_dir(folder.path()).unwrap().any(is_file));
    drop(window);
    let mut next = Window::with(egui::Theme::Light, surroundings);
    next.click("Open QUEEN as it was");
    next.until_current();
    assert_eq!(next.session().part().sections[11].d2, 2.5);
    assert!(next.session().has_unsaved_work());
}
