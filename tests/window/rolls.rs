//! The desk of a set of form-rolls: the published section with all its rolls, its papers, and what keeps a roll from the lathe.
//!
//! `UPDATE_SCREENSHOTS=1 cargo test --test window rolls::` draws the picture in `screenshots/` anew.

use crate::common::Window;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use turnwright::app::Action;
use turnwright::document::{Content, EditAction, RollKind, RollRef};
use turnwright::papers::{DrawingChoice, PaperKind};
use turnwright::session::Verdict;

const TOP_1: RollRef = RollRef { station: 1, kind: RollKind::Top };
const TOP_2: RollRef = RollRef { station: 2, kind: RollKind::Top };

fn open() -> Window {
    Window::with_file("assets/examples/1470b.turn")
}

#[test]
fn the_published_section_is_on_the_desk_with_all_its_rolls() {
    let mut window = open();
    let derived = window.session().derived().unwrap().clone();
    window.screenshot("roll-set");
    assert_eq!(derived.rolls.as_ref().unwrap().rolls.len(), 8);
    assert_eq!(window.session().rolls_proved(), Some((8, 8)));
}

#[test]
fn papers_of_the_set_and_of_the_roll_shown_are_saved() {
    let mut window = open();
    let folder = tempfile::tempdir().unwrap();
    let choice = DrawingChoice::default();
    let kinds = [
        PaperKind::Section(choice),
        PaperKind::Templates(choice),
        PaperKind::Stations(choice),
        PaperKind::PartsList,
        PaperKind::Drawing(choice),
        PaperKind::SetupSheet,
    ];
    for (number, kind) in kinds.into_iter().enumerate() {
        let path = folder.path().join(format!("{number}.pdf"));
        let ctx = window.harness.ctx.clone();
        window.desk().act(&ctx, Action::WritePapers(path.clone(), kind));
        window.until(kind.name(), |_| path.exists());
    }
}

#[test]
fn edits_that_do_not_fit_keep_their_roll_from_the_lathe_and_no_other() {
    let mut window = open();
    window.session().edit("far too deep", None, |document| {
        let Content::RollSet(set) = &mut document.content else { panic!("a set") };
        for edit in &mut set.roll_mut(TOP_2).edits {
            if let EditAction::Chamfer { depth, .. } = &mut edit.action {
                *depth = 500.0;
            }
        }
    });
    window.until_current();
    let session = window.session();
    let said = session.problems().iter().filter(|d| d.message.starts_with("Edit ")).count();
    assert_eq!((said, session.rolls_proved()), (2, Some((7, 8))), "both chamfers are named");
    session.select_roll(TOP_2);
    assert!(matches!(session.verdict(), Verdict::Failed { .. }), "{:?}", session.verdict());
    session.select_roll(TOP_1);
    assert!(matches!(session.verdict(), Verdict::Proved { .. }), "{:?}", session.verdict());
}

#[test]
fn station_and_line_are_seen_in_the_round() {
    let mut window = Window::with_design_of("assets/examples/1470b.turn");
    window.session().select_roll(RollRef { station: 3, kind: RollKind::Top });
    window.show(turnwright::app::Pane::Solid);
    let canvas = window.harness.get_by_label("Station in the round").rect();
    window.screenshot("rolls-3d-station");
    let seen = |window: &Window| window.picture().part(canvas);
    let before = seen(&window);
    let middle = canvas.center();
    window.harness.hover_at(middle);
    window.harness.drag_at(middle);
    window.harness.hover_at(middle + egui::vec2(48.0, 24.0));
    window.harness.step();
    window.harness.drop_at(middle + egui::vec2(48.0, 24.0));
    window.harness.run_steps(2);
    assert!(seen(&window) != before, "it is turned by dragging");
    window.click("line");
    window.harness.remove_cursor();
    window.harness.run_steps(3);
    assert!(window.harness.query_by_label("Strip through the line in the round").is_some());
    window.screenshot("rolls-3d-line");
}

/// Two rolls, made.
fn small() -> Window {
    let mut window = Window::with_one_station();
    window.until_current();
    window.harness.run_steps(3);
    window
}

#[test]
fn an_element_is_chosen_in_the_cross_section_and_told() {
    let mut window = Window::with_design_of("assets/examples/u-channel.turn");
    window.show(turnwright::app::Pane::CrossSection);
    let canvas = window.harness.get_by_role_and_label(Role::Canvas, "Cross-section").rect();
    // The base of the channel is the lowest thing in the middle of the plot.
    let mut hit = false;
    for step in 1..30u8 {
        let at = canvas.center_bottom() - egui::vec2(-12.0, f32::from(step) * canvas.height() / 30.0);
        window.harness.hover_at(at);
        window.harness.drag_at(at);
        window.harness.drop_at(at);
        window.harness.run_steps(2);
        hit = window.session().selection.element == Some(1);
        if hit {
            break;
        }
    }
    assert!(hit, "the base was never hit");
    window.keep_picture("rolls-section");
}

#[test]
fn bends_are_formed_in_parts_and_radii_sharpened_in_tables() {
    let mut window = Window::with_design_of("assets/examples/u-channel.turn");
    window.click("parts");
    window.click("+ Bend");
    window.harness.run_steps(4);
    let composites = |window: &mut Window| window.session().document().content.roll_set().unwrap().composites.clone();
    let added = composites(&mut window);
    assert_eq!((added.len(), added[0].percent, added[0].fixed), (1, [25.0, 50.0, 25.0], None));
    window.keep_picture("rolls-parts");
    window.session().undo();
    assert!(composites(&mut window).is_empty());
    window.click("parts");
    window.harness.run_steps(2);
    let sharp = window.harness.query_all_by_label_contains("open").count();
    assert!(sharp >= 7, "every station has a cell that says how its radii are: {sharp}");
}

#[test]
fn rolls_cost_what_an_hour_and_a_kilogram_cost() {
    let mut window = small();
    assert!(window.harness.query_by_label_contains("cost –").is_some(), "no rates are known");
    window.session().edit("rates", None, |document| {
        let Content::RollSet(set) = &mut document.content else { panic!("a set") };
        set.rates.machine_per_hour = Some(60.0);
        set.rates.price_per_kg = Some(2.0);
        set.rates.currency = Some("EUR".to_owned());
    });
    window.until_current();
    let derived = window.session().derived().unwrap().clone();
    let lines = turnwright::papers::roll_lines(&derived);
    let hours: f64 = lines.iter().filter_map(|l| l.time_s).sum::<f64>() / 3600.0;
    let kg: f64 = lines.iter().filter_map(|l| l.blank_kg).sum();
    let whole = format!("cost {:.2}", lines.iter().filter_map(turnwright::papers::RollLine::cost).sum::<f64>());
    assert!(
        (lines.iter().filter_map(turnwright::papers::RollLine::cost).sum::<f64>() - 60.0 * hours - 2.0 * kg).abs()
            < 1e-6
    );
    assert!(window.harness.query_by_label_contains(&whole).is_some(), "{whole}");
    let csv = turnwright::papers::parts_list_csv(&lines);
    assert!(csv.lines().nth(1).unwrap().contains("EUR"), "{csv}");
    window.keep_picture("rolls-costs");
}

#[test]
fn a_roll_is_sent_until_it_is_another_one() {
    let mut window = small();
    window.session().select_roll(TOP_1);
    window.harness.run_steps(2);
    let program = window.session().program().unwrap().clone();
    assert!(window.harness.query_by_label("Roll 1470b-1T: proved").is_some());
    window.desk().set_paced(false);
    window.harness.get_by_label_contains("Send to").click();
    window.until("sent", |desk| desk.transfer_outcome().is_some());
    window.until_current();
    window.harness.get_by_role_and_label(Role::Tab, "Rolls").click();
    window.harness.run_steps(3);
    let outcome = window.desk().transfer_outcome().map(ToString::to_string);
    assert!(window.harness.query_by_label("Roll 1470b-1T: sent").is_some(), "{}: {outcome:?}", program.name);
    window.session().edit("another tolerance", None, |document| {
        let Content::RollSet(set) = &mut document.content else { panic!("a set") };
        set.stations[0].pass_height += 0.1;
    });
    window.until_current();
    assert!(window.harness.query_by_label("Roll 1470b-1T: proved").is_some(), "it is another roll now");
    window.session().undo();
    window.until_current();
    assert!(window.harness.query_by_label("Roll 1470b-1T: sent").is_some(), "that one went to the lathe");
}
