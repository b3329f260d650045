//! The window: what a person does on it, and what becomes of the document.

use crate::common::Window;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use turnwright::app::{Action, Pane, Surroundings};
use turnwright::diagnostic::Severity;
use turnwright::part::Section;
use turnwright::post::orac::{Instruction, compress};
use turnwright::proof::BlockRef;
use turnwright::session::{Hovered, Verdict};
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
    window.type_text("1in-0.4");
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
    window.type_text("2..1");
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
fn of_many_problems_the_worst_are_listed_and_the_others_on_request() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.session().edit_part("spoil", None, |part| {
        part.sections = (0..450).map(|row| Section::line(row + 1, 10.0, 90.0, 20.0, 95.0)).collect();
    });
    window.until_current();
    let all = window.session().problems().len();
    assert!(all > 400, "{all} problems");
    window.click("Problems");
    let listed = |window: &Window| window.harness.query_all_by_label_contains(": ").count();
    let at_first = listed(&window);
    assert!((200..400).contains(&at_first), "{at_first} listed");
    let more = format!("Show 200 more of the {} that are not listed", all - 200);
    window.harness.get_by_label(&more).click_accesskit();
    window.harness.run_steps(3);
    assert!(listed(&window) >= at_first + 200);
    assert!(window.harness.query_by_label(&more).is_none());
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
    crate::common::change_one_z(&mut window);
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
fn an_instruction_is_entered_as_on_the_keypad() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let program = window.session().program().cloned().unwrap();
    let before = compress(&program.text, &program.name).0;
    window.session().selection.block = Some(4);
    window.harness.run_steps(2);
    window.click("+ Insert");
    window.click("Enter");
    // X and z are typed; feed, tool and speed are taken over by an empty answer.
    for answer in ["-0.1", "0.1", "", "", ""] {
        if !answer.is_empty() {
            window.harness.event(Event::Text(answer.to_owned()));
        }
        window.harness.run_steps(2);
        window.harness.key_press(Key::Enter);
        window.harness.run_steps(2);
    }
    window.until_current();
    let program = window.session().program().cloned().unwrap();
    let after = compress(&program.text, &program.name).0;
    assert_eq!(after.len(), before.len() + 1);
    assert!(matches!(after[4], Instruction::Ptp { x: -100, z: 100, .. }), "{:?}", after[4]);
    assert_eq!(window.session().selection.block, Some(5));
    window.session().undo();
    assert!(window.session().part().overrides.is_empty());
}

#[test]
fn nothing_is_inserted_into_a_program_that_cannot_be_read() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let name = window.session().program().unwrap().name.clone();
    window.session().edit_part("by hand", None, |part| {
        part.overrides.insert(name, "\u{2}PAGE 01 HOVER\r\n\u{2}PAGE 02 END-PROGRAM..M02\r\n".to_owned());
    });
    window.until_current();
    // Its few blocks left, the play goes on in the next program.
    window.click("QUEEN1");
    assert_eq!(window.session().program().unwrap().name, "QUEEN1");
    assert!(window.harness.query_by_label("+ Insert").is_none());
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

#[test]
fn row_segment_and_blocks_light_up_together() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let row_7 = window.session().part().sections[6].id;
    let block = BlockRef { program: 1, block: 15 };
    window.harness.get_by_label("Row 7").hover();
    window.harness.run_steps(3);
    assert_eq!(window.session().lit().sections, [row_7]);
    assert_eq!(window.session().lit().blocks, [block]);
    window.harness.remove_cursor();
    window.harness.run_steps(3);
    assert!(window.session().lit().blocks.is_empty() && window.session().lit().sections.is_empty());
    window.session().select_block("QUEEN2", 15);
    window.harness.run_steps(4);
    window.harness.get_by_label_contains("Line 15: ").hover();
    window.harness.run_steps(3);
    assert_eq!(window.session().lit().sections, [row_7]);
    assert_eq!(window.session().lit().blocks, [block]);
}

#[test]
fn the_line_under_the_pointer_stays_lit_in_the_profile() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let node = |window: &Window, name: &str| window.harness.get_by_label_contains(name).rect().center();
    let (from, to) = (node(&window, "Node z 38.600  ⌀ 10.200"), node(&window, "Node z 41.000  ⌀ 10.200"));
    window.harness.hover_at(from + (to - from) * 0.5);
    window.harness.run_steps(6);
    let row_7 = window.session().part().sections[6].id;
    assert_eq!(window.session().lit().sections, [row_7]);
    assert_eq!(window.session().lit().blocks, [BlockRef { program: 1, block: 15 }]);
}

#[test]
fn a_gouging_block_lights_the_row_that_it_spoils() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    crate::common::change_one_z(&mut window);
    let proof = window.session().setup().unwrap().proof.clone();
    let gouge = proof.errors().find(|f| f.kind == turnwright::proof::FindingKind::Gouge).unwrap();
    let program = window.session().setup().unwrap().programs.iter().position(|p| p.name == gouge.program).unwrap();
    window.session().hover(Some(Hovered::Block(BlockRef { program, block: gouge.block })));
    assert!(!window.session().lit().sections.is_empty());
}

#[test]
fn a_cell_takes_effect_while_it_is_typed() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("⌀ end of row 1: 25.400");
    window.type_text("24");
    assert_eq!(window.session().part().sections[0].d2, 24.0);
    window.type_text(".5");
    assert_eq!(window.session().part().sections[0].d2, 24.5);
    window.type_text("+");
    assert_eq!(window.session().part().sections[0].d2, 25.4, "a text that is no length leaves the old value");
    window.type_text("0.5");
    assert_eq!(window.session().part().sections[0].d2, 25.0);
    window.press(Modifiers::NONE, Key::Enter);
    assert_eq!(window.session().part().sections[0].d2, 25.0);
    assert_eq!(window.session().history().undo_label(), Some("⌀ end of line 1"));
    window.session().undo();
    assert_eq!(window.session().part().sections[0].d2, 25.4);
    assert_eq!(window.session().history().undo_label(), None, "one step");
}

#[test]
fn escape_puts_the_value_before_the_edit_back() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("⌀ end of row 1: 25.400");
    window.type_text("24");
    window.press(Modifiers::NONE, Key::Escape);
    assert_eq!(window.session().part().sections[0].d2, 25.4);
    assert_eq!(window.session().history().undo_label(), None);
    assert!(window.harness.query_by_label("⌀ end of row 1: 25.400").is_some());
}

#[test]
fn a_bad_text_after_a_good_one_leaves_the_value_before_the_edit() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("z end of row 1: 2.000");
    window.type_text("3");
    assert_eq!(window.session().part().sections[0].z2, 3.0);
    window.type_text("..1");
    window.press(Modifiers::NONE, Key::Tab);
    assert_eq!(window.session().part().sections[0].z2, 2.0);
    assert!(window.harness.query_by_label("z end of row 1: 3..1").is_some());
    assert_eq!(window.session().history().undo_label(), None);
}

#[test]
fn fields_take_effect_while_they_are_typed() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.click("Bar ⌀");
    window.type_text("30");
    assert_eq!(window.session().part().bar_diameter, 30.0);
    window.type_text("+");
    assert_eq!(window.session().part().bar_diameter, 26.2);
    window.type_text("1");
    assert_eq!(window.session().part().bar_diameter, 31.0);
    window.press(Modifiers::NONE, Key::Escape);
    assert_eq!(window.session().part().bar_diameter, 26.2);
    assert_eq!(window.session().history().undo_label(), None);
    window.click("Row 1");
    window.click("⌀ end");
    window.type_text("2");
    window.type_text("4");
    assert_eq!(window.session().part().sections[0].d2, 24.0);
    window.press(Modifiers::NONE, Key::Enter);
    assert_eq!(window.session().part().sections[0].d2, 24.0);
    window.session().undo();
    assert_eq!(window.session().part().sections[0].d2, 25.4);
    assert_eq!(window.session().history().undo_label(), None, "one step");
}

#[test]
fn a_program_of_an_older_document_does_not_leave_the_window() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    assert_eq!(window.session().outdated(), None);
    window.session().edit_part("longer", None, |part| part.length = 57.0);
    assert!(window.session().outdated().is_some_and(|reason| reason.contains("made anew")));
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::Send);
    window.desk().act(&ctx, Action::SendAllTheSame);
    assert!(window.desk().transfer_progress().is_none() && window.desk().transfer_outcome().is_none());
    window.until_current();
    assert_eq!(window.session().outdated(), None);
}

#[test]
fn programs_shown_and_received_are_saved_to_files() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.desk().set_paced(false);
    let text = window.session().program().unwrap().text.clone();
    let save_as = |window: &mut Window, name: &str| {
        let path = folder.path().join(name);
        window.harness.run_steps(3);
        window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        window.type_text(&path.display().to_string());
        window.press(Modifiers::NONE, Key::Enter);
        let saved = path.clone();
        window.until("saved", move |_| saved.exists());
        std::fs::read_to_string(path).unwrap()
    };
    window.click("File");
    window.click("Save QUEEN1…");
    assert_eq!(save_as(&mut window, "shown.cnc"), text);
    window.click("Send to ORAC");
    window.until("sent", |desk| desk.transfer_outcome().is_some());
    window.click("Receive");
    window.until("received", |desk| matches!(desk.transfer_outcome(), Some(Outcome::Received { .. })));
    window.click("Save…");
    assert_eq!(save_as(&mut window, "received.cnc"), text);
    assert!(window.session().path().is_none(), "a program is not the document");
}

#[test]
fn leftover_is_told_by_the_row_that_the_user_sees() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    window.session().edit_part("closer", None, |part| part.form_tolerance = 0.05);
    window.until_current();
    let leftover: Vec<String> = {
        let problems = window.session().problems();
        problems.iter().filter(|d| d.code == "leftover").map(|d| d.message.clone()).collect()
    };
    assert!(leftover.iter().any(|message| message.contains("left on concave 4 at z")), "{leftover:?}");
    assert!(leftover.iter().all(|message| !message.contains(" id ")));
}
