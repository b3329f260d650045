//! The roll editor: choosing a corner in the plot, preparing a chamfer, making it and taking it back.

use crate::common::Window;
use egui::{Modifiers, PointerButton, Pos2, accesskit::Role, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use turnwright::app::Action;
use turnwright::document::{RollKind, RollRef};
use turnwright::session::Session;

/// The window with the published set, its station 1 shown in the roll editor.
fn opened() -> Window {
    let mut window = Window::with_design_of("assets/examples/1470b.turn");
    window.session().select_roll(RollRef { station: 1, kind: RollKind::Top });
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::ShowPane(turnwright::app::Pane::RollEditor));
    window.harness.run_steps(4);
    window
}

fn edits(window: &mut Window) -> usize {
    let document = window.session().document().clone();
    let roll = RollRef { station: 1, kind: RollKind::Top };
    document.content.roll_set().and_then(|set| set.roll(roll)).map_or(0, |work| work.edits.len())
}

/// Presses and releases the mouse at a place of the plot.
fn click_at(window: &mut Window, at: Pos2) {
    for pressed in [true, false] {
        window.harness.event(egui::Event::PointerMoved(at));
        let modifiers = Modifiers::NONE;
        window.harness.event(egui::Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers,
        });
        window.harness.step();
    }
    window.harness.run_steps(2);
}

/// Clicks along the lower left of the plot until the left side face is hit.
fn choose_side_face(window: &mut Window) -> Pos2 {
    let plot = window.harness.get_by_label("Roll contour").rect();
    // The left side face is the left border of the fitted contour; a place in the middle of its height.
    for step in 0..60 {
        let at = pos2(plot.left() + 6.0 + step as f32, plot.center().y + plot.height() * 0.3);
        click_at(window, at);
        if window.harness.query_by_label_contains("from the left side face").is_some() {
            return at;
        }
    }
    panic!("the side face was never hit");
}

/// Where the pointer is in the roll by the status bar: z and diameter, mm.
fn read_out(window: &mut Window, at: Pos2) -> (f64, f64) {
    window.harness.hover_at(at);
    window.harness.run_steps(3);
    let labels = window.harness.query_all_by_label_contains("  ⌀ ");
    let texts: Vec<String> = labels.filter_map(|node| node.value().or_else(|| node.accesskit_node().label())).collect();
    let text = texts.iter().find(|t| t.starts_with("z ")).unwrap_or_else(|| panic!("no place in {texts:?}"));
    let figures: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    (figures[0], figures[1])
}

/// Chooses another kind of edit.
fn choose_tool(window: &mut Window, tool: &str) {
    choose(window, "Edit", tool);
}

/// Chooses from a list.
fn choose(window: &mut Window, list: &str, what: &str) {
    window.harness.get_by_role_and_label(Role::ComboBox, list).click();
    window.harness.run_steps(4);
    window.harness.get_by_label(what).click();
    window.harness.run_steps(4);
}

#[test]
fn a_roll_is_made_the_same_as_another_one_and_its_own_again() {
    let mut window = opened();
    let designed = |window: &mut Window, station: u32| {
        window.until("designed", |desk| desk.session().is_some_and(Session::is_designed));
        let rolls = window.session().derived().unwrap().rolls.clone().unwrap();
        rolls.design.roll(RollRef { station, kind: RollKind::Top }).unwrap().elements.clone()
    };
    let own = designed(&mut window, 1);
    choose(&mut window, "Contour", "as 2T");
    let same = designed(&mut window, 1);
    assert_eq!(same, designed(&mut window, 2));
    assert_ne!(same, own);
    choose(&mut window, "Contour", "as 2T, turned");
    let turned = designed(&mut window, 1);
    assert_eq!(turned.len(), same.len());
    assert_ne!(turned, same, "its edits are not the same on both sides");
    choose(&mut window, "Contour", "designed here");
    assert_eq!(designed(&mut window, 1), own);
}

fn value_of(window: &Window, field: &str) -> f64 {
    let node = window.harness.get_by_label(field);
    node.value().unwrap().parse().unwrap()
}

#[test]
fn points_are_picked_in_the_plot_and_choose_no_element() {
    let mut window = opened();
    let face = choose_side_face(&mut window);
    choose_tool(&mut window, "line by two points");
    let plot = window.harness.get_by_label("Roll contour").rect();
    // The first one on the side face itself, which is chosen; the second one on the contour in the middle.
    for (name, at) in [("First point", face), ("Second point", plot.center())] {
        let (z, diameter) = read_out(&mut window, at);
        window.harness.query_all_by_label("pick in the plot").nth(usize::from(name == "Second point")).unwrap().click();
        window.harness.run_steps(2);
        assert!(window.harness.query_by_label("click in the plot").is_some());
        click_at(&mut window, at);
        assert!(window.harness.query_by_label("click in the plot").is_none(), "one click is one point");
        let got = (value_of(&window, &format!("{name} z")), value_of(&window, &format!("{name} ⌀")));
        assert!((got.0 - z).abs() < 1e-3 && (got.1 - diameter).abs() < 1e-3, "{name}: {got:?} for {:?}", (z, diameter));
    }
    assert!(window.harness.query_by_label_contains("from the left side face").is_some(), "the same element is chosen");
    // An element that is asked for is taken, and chosen is still the first one.
    choose_tool(&mut window, "line parallel to another");
    window.harness.query_all_by_label("pick in the plot").last().unwrap().click();
    window.harness.run_steps(2);
    click_at(&mut window, face);
    assert!(window.harness.query_by_label("the left side face").is_some(), "parallel to the face");
    assert!(window.harness.query_by_label_contains("from the left side face").is_some());
}

#[test]
fn a_box_is_zoomed_to_and_a_double_click_fits_again() {
    let mut window = opened();
    let plot = window.harness.get_by_label("Roll contour").rect();
    let ends = [plot.left_center() + vec2(2.0, 0.0), plot.right_center() - vec2(2.0, 0.0)];
    let span = |window: &mut Window| read_out(window, ends[1]).0 - read_out(window, ends[0]).0;
    let whole = span(&mut window);
    let (from, to) = (plot.center() - plot.size() / 8.0, plot.center() + plot.size() / 8.0);
    let wanted = read_out(&mut window, to).0 - read_out(&mut window, from).0;
    let shift = Modifiers::SHIFT;
    let button =
        |pos, pressed| egui::Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers: shift };
    window.harness.event(egui::Event::ModifiersChanged(shift));
    for event in [egui::Event::PointerMoved(from), button(from, true)] {
        window.harness.event(event);
    }
    window.harness.step();
    for part in 1..=4u8 {
        window.harness.event(egui::Event::PointerMoved(from + (to - from) * (f32::from(part) / 4.0)));
        window.harness.step();
    }
    window.harness.event(button(to, false));
    window.harness.step();
    window.harness.event(egui::Event::ModifiersChanged(Modifiers::NONE));
    window.harness.run_steps(3);
    let zoomed = span(&mut window);
    assert!((wanted..wanted * 1.35).contains(&zoomed), "{wanted} mm were in the box, {zoomed} mm are shown of {whole}");
    window.click("Roll contour");
    window.harness.key_press(egui::Key::F);
    window.harness.run_steps(3);
    assert!((span(&mut window) - whole).abs() < whole * 1e-3);
}

#[test]
fn a_corner_is_chosen_in_the_plot_and_chamfered() {
    let mut window = opened();
    choose_side_face(&mut window);
    assert!(window.harness.query_by_label_contains("behind the left side face").is_some());
    window.screenshot("rolls-editor-chamfer");
    window.click("Apply");
    window.until("designed", |desk| desk.session().is_some_and(Session::is_designed));
    assert_eq!(edits(&mut window), 1);
    window.screenshot("rolls-editor-chamfered");
    window.click("remove");
    window.harness.run_steps(4);
    assert_eq!(edits(&mut window), 0);
}
