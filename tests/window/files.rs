//! Files and the window: dropping one, opening one by a typed path, and closing with unsaved work.

use crate::common::Window;
use egui::{DroppedFile, Event, Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use turnwright::session::Verdict;
use turnwright::storage::{export, open_document};

/// A file as a file manager hands it over.
#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|reason| reason.to_string())
    }
}

fn drop_on(window: &mut Window, path: &Path) {
    window.harness.input_mut().dropped_files.push(Arc::new(Dropped(path.to_owned())));
    window.harness.run_steps(3);
}

/// Presses the window's close button; what the window asks the system for in that frame and the next two.
fn press_close(window: &mut Window) -> Vec<ViewportCommand> {
    let input = window.harness.input_mut();
    input.viewports.entry(ViewportId::ROOT).or_default().events.push(ViewportEvent::Close);
    window.harness.step();
    // The system says it once.
    window.harness.input_mut().viewports.entry(ViewportId::ROOT).or_default().events.clear();
    let mut asked = commands(window);
    for _ in 0..2 {
        window.harness.step();
        asked.extend(commands(window));
    }
    asked
}

fn commands(window: &Window) -> Vec<ViewportCommand> {
    window.harness.output().viewport_output.get(&ViewportId::ROOT).map(|v| v.commands.clone()).unwrap_or_default()
}

/// Clicks a button and hands back what the window asks the system for then.
fn click(window: &mut Window, name: &str) -> Vec<ViewportCommand> {
    use egui_kittest::kittest::Queryable;
    window.harness.get_by_label(name).click();
    let mut asked = Vec::new();
    for _ in 0..3 {
        window.harness.step();
        asked.extend(commands(window));
    }
    asked
}

fn type_path(window: &mut Window, path: &Path) {
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text(path.display().to_string()));
    window.harness.run_steps(2);
    window.harness.key_press(Key::Enter);
    window.harness.run_steps(3);
}

/// Answers the question for a file, and waits until that file is there.
fn save_in(window: &mut Window, path: &Path, written: &Path) -> Vec<u8> {
    type_path(window, path);
    window.until("the file is written", |_| written.exists());
    std::fs::read(written).unwrap()
}

#[test]
fn drawing_and_setup_sheet_are_saved_from_the_file_menu() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::open();
    window.open_example("SPIGOT");
    window.click("File");
    window.click("Save drawing");
    window.click("A3…");
    let path = folder.path().join("drawing.svg");
    let drawing = String::from_utf8(save_in(&mut window, &path, &path)).unwrap();
    assert!(drawing.contains("width=\"420mm\" height=\"297mm\"") && drawing.contains(">Ø 1.2<"), "{drawing}");
    window.click("File");
    window.click("Save setup sheet…");
    let path = folder.path().join("sheet");
    let sheet = save_in(&mut window, &path, &path.with_extension("pdf"));
    assert!(sheet.starts_with(b"%PDF"), "without an ending a PDF is written");
    assert!(String::from_utf8_lossy(&sheet).contains("/Count 2"), "a page for either end");
}

#[test]
fn a_paper_that_cannot_be_written_stops_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("File");
    window.click("Save setup sheet…");
    type_path(&mut window, &folder.path().join("none/sheet.pdf"));
    window.click("File");
    window.click("Save setup sheet…");
    let path = folder.path().join("sheet.pdf");
    assert!(save_in(&mut window, &path, &path).starts_with(b"%PDF"));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// The queen, lengthened and not saved.
fn edited() -> Window {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.session().edit_part("longer", None, |part| part.length = 57.0);
    window.harness.run_steps(2);
    window
}

/// The master part as a file of the kind that `name` ends in.
fn master_as(folder: &Path, name: &str) -> PathBuf {
    let example = turnwright::storage::examples().iter().find(|e| e.name == "MASTER").unwrap();
    let document = turnwright::storage::document_from_text("MASTER", example.text).unwrap();
    let path = folder.join(name);
    export::any(&document, &turnwright::machine::Catalog::shipped(), &path).unwrap();
    path
}

#[test]
fn a_file_dropped_on_the_window_is_opened() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::open();
    let own = master_as(folder.path(), "master.turn");
    drop_on(&mut window, &own);
    window.until_current();
    let session = window.session();
    assert_eq!((session.document().name.as_str(), session.path()), ("MASTER", Some(own.as_path())));
    let foreign = master_as(folder.path(), "other.CAD");
    drop_on(&mut window, &foreign);
    window.until_current();
    let session = window.session();
    assert_eq!((session.document().name.as_str(), session.path()), ("other", None));
}

#[test]
fn a_dropped_file_that_is_no_part_leaves_the_document_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("letter.turn");
    std::fs::write(&path, b"Dear Sir,\0\xff").unwrap();
    let mut window = Window::open();
    window.open_example("QUEEN");
    drop_on(&mut window, &path);
    assert_eq!(window.session().document().name, "QUEEN");
}

#[test]
fn dropping_a_file_on_unsaved_work_asks_first() {
    let folder = tempfile::tempdir().unwrap();
    let path = master_as(folder.path(), "master.turn");
    let mut window = edited();
    drop_on(&mut window, &path);
    assert_eq!(window.session().document().name, "QUEEN");
    window.click("Do not save");
    window.until_current();
    assert_eq!(window.session().document().name, "MASTER");
}

#[test]
fn a_dropped_program_is_proved_on_the_open_part_and_undone() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::open();
    window.open_example("QUEEN");
    let own = window.session().program().unwrap().clone();
    crate::common::change_one_z(&mut window);
    let path = folder.path().join("from-the-lathe.cnc");
    std::fs::write(&path, &window.session().program().unwrap().text).unwrap();
    window.session().undo();
    window.until_current();
    drop_on(&mut window, &path);
    window.until_current();
    let shown = window.session().program().unwrap().clone();
    assert_eq!(shown.text, std::fs::read_to_string(&path).unwrap());
    assert!(shown.edited && shown.text != own.text);
    assert!(matches!(window.session().verdict(), Verdict::Failed { .. }));
    assert_eq!(window.session().document().name, "QUEEN");
    window.session().undo();
    window.until_current();
    assert_eq!(window.session().program().unwrap().text, own.text);
}

#[test]
fn a_program_of_instructions_is_opened_as_pages_by_the_menu() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("typed.anc");
    std::fs::write(&path, "  1  INC\n  2  MM\n").unwrap();
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("File");
    window.click("Open program…");
    type_path(&mut window, &path);
    window.until_current();
    let text = &window.session().program().unwrap().text;
    assert!(text.contains("END-PROGRAM") && text.contains("MM-UNITS"), "{text:?}");
}

#[test]
fn a_program_that_cannot_be_read_leaves_the_one_that_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("letter.anc");
    std::fs::write(&path, "Dear Sir,\n").unwrap();
    let mut window = Window::open();
    drop_on(&mut window, &path);
    assert!(window.desk().session_mut().is_none(), "a program alone is no part");
    window.open_example("QUEEN");
    drop_on(&mut window, &path);
    assert!(window.session().part().overrides.is_empty());
    assert_eq!(window.session().history().undo_label(), None);
}

#[test]
fn a_file_is_opened_by_a_typed_path() {
    let folder = tempfile::tempdir().unwrap();
    let path = master_as(folder.path(), "master.turn");
    let mut window = Window::open();
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.harness.run_steps(3);
    type_path(&mut window, &path);
    window.until_current();
    assert_eq!(window.session().path(), Some(path.as_path()));
    assert!(!window.session().has_unsaved_work());
}

#[test]
fn closing_without_unsaved_work_is_not_held_up() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    assert!(!press_close(&mut window).contains(&ViewportCommand::CancelClose));
}

#[test]
fn closing_with_unsaved_work_asks_and_can_be_taken_back() {
    let mut window = edited();
    let asked = press_close(&mut window);
    assert!(asked.contains(&ViewportCommand::CancelClose) && !asked.contains(&ViewportCommand::Close), "{asked:?}");
    assert!(!click(&mut window, "Cancel").contains(&ViewportCommand::Close));
    assert_eq!(window.session().part().length, 57.0);
    press_close(&mut window);
    assert!(click(&mut window, "Do not save").contains(&ViewportCommand::Close));
}

#[test]
fn closing_can_save_first() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("queen.turn");
    let mut window = edited();
    press_close(&mut window);
    window.click("Save");
    type_path(&mut window, &path);
    window.until("closed", |desk| desk.session().is_none());
    assert_eq!(open_document(&path).unwrap().name, "QUEEN");
}

#[test]
fn a_save_that_is_given_up_forgets_that_the_window_was_to_close() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("queen.turn");
    let mut window = edited();
    press_close(&mut window);
    window.click("Save");
    // A question finds its place in its first frames.
    window.harness.run_steps(4);
    window.click("Cancel");
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::S);
    window.harness.run_steps(3);
    type_path(&mut window, &path);
    window.until("saved", |desk| desk.session().is_none_or(|s| !s.has_unsaved_work()));
    assert_eq!(window.session().path(), Some(path.as_path()), "the window stays open");
}
