//! The window with a bored part: its second table, its handles, what holds it, and pictures of it.
//!
//! `WINDOW_PICTURES=FOLDER cargo test --test window bore::` writes the pictures to a folder.

use crate::common::Window;
use egui::{Event, Key};
use egui_kittest::kittest::Queryable;
use turnwright::app::Action;
use turnwright::document::{Ends, Holding};
use turnwright::part::{Section, SectionKind};

fn open() -> Window {
    Window::with_file("tests/cases/parts/bearing-housing.turn")
}

#[test]
fn the_bore_is_a_second_table_with_the_same_habits() {
    let mut window = open();
    window.click("bore");
    assert_eq!(window.session().selection.section, Some(5));
    window.keep_picture("bore-table");
    window.click("⌀ end of row 2: 42.000");
    window.type_text("1.5in");
    window.harness.key_press(Key::Enter);
    window.harness.run_steps(3);
    assert_eq!(window.session().part().bore[1].d2, 38.1);
    assert_eq!(window.session().history().undo_label(), Some("⌀ end of bore line 2"));
    window.session().undo();
    window.harness.run_steps(2);
    window.click("Row 3");
    window.harness.event(Event::Paste("line\t49\t42\t49.5\t43\nline\t49.5\t43\t50\t44\n".to_owned()));
    window.harness.run_steps(3);
    assert_eq!((window.session().part().bore.len(), window.session().part().sections.len()), (4, 4));
    window.harness.key_press(Key::Insert);
    window.harness.run_steps(2);
    assert_eq!(window.session().part().bore.len(), 5);
    window.click("outside");
    assert_eq!(window.session().selection.section, Some(1));
    assert!(window.harness.query_by_label("⌀ end of row 1: 66.000").is_some());
}

#[test]
fn a_node_of_the_bore_is_dragged_and_leaves_the_outside_alone() {
    let mut window = open();
    let node = window.harness.get_by_label_contains("Node z 22.000  ⌀ 42.000").rect().center();
    window.harness.hover_at(node);
    window.harness.drag_at(node);
    for step in 1..=6u8 {
        window.harness.hover_at(node + egui::vec2(-1.5, 0.0) * f32::from(step));
        window.harness.step();
    }
    window.until_current();
    window.keep_picture("bore-drag");
    window.harness.drop_at(node + egui::vec2(-9.0, 0.0));
    window.harness.run_steps(2);
    let part = window.session().part().clone();
    assert!(part.bore[1].z1 < 22.0, "{}", part.bore[1].z1);
    assert_eq!(part.bore[0].z2, part.bore[1].z1, "no gap opens");
    assert_eq!((part.sections[2].z1, part.sections[1].z2), (18.0, 18.0));
    window.session().undo();
    assert_eq!(window.session().part().bore[1].z1, 22.0, "a drag is one step of undo");
}

#[test]
fn a_message_about_the_bore_leads_to_its_table() {
    let mut window = open();
    window.session().edit_part("spoil", None, |part| part.bore[1].d1 = 60.0);
    window.until_current();
    let problem = window.session().problems().iter().find(|d| d.code == "bore-wall").cloned().expect("no wall is left");
    assert!(problem.at.to_string().starts_with("bore section 2"), "{}", problem.at);
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::GoTo(problem.at));
    window.harness.run_steps(3);
    assert!(window.harness.query_by_label("⌀ start of row 2: 60.000").is_some());
    window.keep_picture("bore-without-wall");
}

#[test]
fn blind_holes_tubes_both_ends_and_centres_are_drawn() {
    let mut window = open();
    window.click("3D");
    window.keep_picture("bore-in-the-round");
    window.session().edit_part("both ends", None, |part| {
        part.ends = Ends::Two { split: Some(20.0) };
        part.part_off = false;
        part.bore[0] =
            Section { kind: SectionKind::Convex { radius: 20.0 }, ..Section::line(5, 0.0, 44.0, 22.0, 28.0) };
    });
    window.until_current();
    window.keep_picture("bore-both-ends-first");
    window.click("second end");
    window.harness.run_steps(3);
    window.keep_picture("bore-both-ends-second");
    window.session().edit_part("blind", None, |part| {
        part.ends = Ends::One;
        part.bore.remove(0);
    });
    window.until_current();
    window.keep_picture("bore-blind");
    window.session().edit_part("between centres", None, |part| {
        part.holding = Holding::BetweenCentres;
        part.bore.clear();
        part.stock_bore_diameter = 28.0;
    });
    window.until_current();
    window.keep_picture("between-centres");
    assert!(window.session().setup().is_some_and(|s| s.setup.tailstock.is_some()));
}

#[test]
fn holding_and_generator_are_chosen_beside_the_stock() {
    let mut window = open();
    for name in ["Hole ⌀", "Facing", "Held", "Made by", "By stage"] {
        assert!(window.harness.query_all_by_label(name).next().is_some(), "{name}");
    }
    window.session().edit_part("generator", None, |part| part.generator = turnwright::document::Generator::default());
    window.harness.run_steps(3);
    assert!(window.harness.query_all_by_label("Optimize").next().is_some());
}
