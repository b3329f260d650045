//! A set of form-rolls from nothing: what a person tries first, and what every choice of the panels leads to.

use crate::common::Window;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use turnwright::app::Pane;
use turnwright::diagnostic::Severity;
use turnwright::document::{DevelopedWidth, Origin, RollSet};
use turnwright::rollform::developed::developed;
use turnwright::units::Unit;

fn set(window: &mut Window) -> RollSet {
    window.session().document().content.roll_set().unwrap().clone()
}

/// Types into a cell of a table that is named by how its label begins and ends.
fn type_into_cell(window: &mut Window, begin: &str, end: &str, text: &str) {
    let labels: Vec<String> =
        window.harness.get_all_by_role(Role::Cell).filter_map(|n| n.accesskit_node().label()).collect();
    let name = labels.iter().find(|l| l.contains(begin) && l.ends_with(end)).unwrap_or_else(|| panic!("{labels:?}"));
    window.click(&name.clone());
    window.type_text(text);
    window.press(Modifiers::NONE, Key::Enter);
}

fn new_set() -> Window {
    let mut window = Window::open();
    window.click("New roll set");
    window.until("opened", |desk| desk.session().is_some());
    window.until_designed();
    window
}

#[test]
fn from_nothing_to_a_channel_with_proved_rolls() {
    let mut window = new_set();
    window.until_current();
    assert_eq!(window.session().rolls_proved(), Some((12, 12)), "what a new set begins with is sound");
    window.keep_picture("new-set");
    // A wider base, thicker strip, and a flower for it.
    window.show(Pane::Elements);
    type_into_cell(&mut window, "1", ": 27.000", "35");
    window.type_into("Thickness", "2");
    window.until_designed();
    let section = set(&mut window).section;
    assert_eq!(section.thickness, 2.0);
    let openings: Vec<f64> = {
        let derived = window.session().derived().unwrap().clone();
        derived.rolls.as_ref().unwrap().design.stations.iter().map(|s| s.openings.drive).collect()
    };
    assert!(openings.iter().all(|drive| *drive == 2.0), "the rolls open as far as the strip is thick: {openings:?}");
    assert!(
        (developed(&section, section.developed_width).width - 2.0 * (35.0 + 17.0 + 3.0 * std::f64::consts::FRAC_PI_2))
            .abs()
            < 1e-3
    );
    window.show(Pane::Flower);
    window.show(Pane::Angles);
    window.click("suggest");
    window.harness.run_steps(3);
    window.click("Make this flower");
    window.until_current();
    let stations = set(&mut window).stations.len();
    assert_eq!(window.session().rolls_proved(), Some((2 * stations, 2 * stations)));
    let wrong: Vec<_> = window.session().problems().iter().filter(|d| d.severity == Severity::Error).cloned().collect();
    assert_eq!(wrong, []);
    window.keep_picture("new-channel");
}

#[test]
fn every_origin_and_method_can_be_chosen() {
    let mut window = new_set();
    window.show(Pane::Elements);
    window.choose("Width by", "own k");
    window.type_into("k", "0.4");
    assert_eq!(set(&mut window).section.developed_width, DevelopedWidth::Own { k: 0.4 });
    window.keep_picture("own-k");
    window.choose("Origin", "left to right");
    window.type_into("First slope", "-15");
    window.until_designed();
    let section = set(&mut window).section;
    assert_eq!((section.origin, section.first_angle_deg), (Origin::LeftToRight, -15.0));
    window.choose("Origin", "centre, right first");
    window.until_designed();
    let said = |window: &mut Window| window.session().problems().iter().map(|d| d.code.clone()).collect::<Vec<_>>();
    let before = said(&mut window);
    assert!(!before.is_empty(), "the second list is missing, and that is said");
    window.click("other side");
    window.click("+ Add");
    window.until_designed();
    assert_eq!(set(&mut window).section.other_side.len(), 1);
    assert_ne!(said(&mut window), before);
    window.keep_picture("two-lists");
}

#[test]
fn the_flower_is_played_sprung_back_and_the_clearance_coloured() {
    let mut window = Window::with_design_of("assets/examples/hat.turn");
    window.show(Pane::Flower);
    window.click("Stage flat");
    let place = |window: &Window| {
        window.harness.get_by_label("Stage of the flower").accesskit_node().numeric_value().unwrap_or(f64::NAN)
    };
    assert_eq!(place(&window), 0.0);
    window.click("play");
    window.harness.run_steps(20);
    let on_the_way = place(&window);
    assert!(on_the_way > 0.05 && on_the_way.fract() != 0.0, "{on_the_way}");
    window.until("played to the end", |_| true);
    window.harness.run_steps(700);
    assert_eq!(place(&window), 9.0, "it stops at the finished section");
    window.click("Stage 8");
    let canvas = window.harness.get_by_role_and_label(Role::Canvas, "Flower").rect();
    let before = window.picture().part(canvas);
    window.click("springback");
    window.harness.run_steps(3);
    assert!(window.picture().part(canvas) != before, "the strip after the rolls is drawn");
    window.keep_picture("flower-springback");
    window.show(Pane::Station);
    let before = window.picture();
    window.click("clearance");
    window.harness.remove_cursor();
    window.harness.run_steps(3);
    assert!(window.picture().colors() > before.colors(), "where rolls touch and where they are clear has colours");
    window.keep_picture("station-clearance");
}

#[test]
fn a_set_changes_its_unit_and_stays_the_same() {
    let mut window = Window::with_one_station();
    window.until_current();
    let contours = |window: &mut Window| {
        let derived = window.session().derived().unwrap().clone();
        let design = &derived.rolls.as_ref().unwrap().design;
        design.rolls().flat_map(|r| r.elements.iter().map(|e| e.segment.end()).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    let before = contours(&mut window);
    window.session().edit("in inches", None, |document| {
        let factor = 1.0 / Unit::Inch.in_mm();
        let set = document.content.roll_set().unwrap().scaled(factor);
        document.unit = Unit::Inch;
        document.content = turnwright::document::Content::RollSet(set);
    });
    window.until_current();
    assert_eq!(window.session().rolls_proved(), Some((2, 2)));
    let after = contours(&mut window);
    assert_eq!(before.len(), after.len());
    assert!(before.iter().zip(&after).all(|(a, b)| a.distance(*b) < 1e-6));
    window.show(Pane::StationData);
    window.keep_picture("inches");
}
