//! The roll editor: choosing a corner in the plot, preparing a chamfer, making it and taking it back.

use crate::common::Window;
use egui::{Modifiers, PointerButton, pos2};
use egui_kittest::kittest::Queryable;
use turnwright::app::Action;
use turnwright::document::{RollKind, RollRef};
use turnwright::session::Session;

/// The window with the published set, its station 1 shown in the roll editor.
fn opened() -> Window {
    let mut window = Window::open();
    window.open_example("1470b");
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

#[test]
fn a_corner_is_chosen_in_the_plot_and_chamfered() {
    let mut window = opened();
    let plot = window.harness.get_by_label("Roll contour").rect();
    // The left side face is the left border of the fitted contour; a place in the middle of its height.
    let mut chosen = false;
    for step in 0..60 {
        let at = pos2(plot.left() + 6.0 + step as f32, plot.center().y + plot.height() * 0.3);
        for pressed in [true, false] {
            window.harness.event(egui::Event::PointerMoved(at));
            window.harness.event(egui::Event::PointerButton {
                pos: at,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            });
            window.harness.step();
        }
        window.harness.run_steps(2);
        if window.harness.query_by_label_contains("behind the left side face").is_some() {
            chosen = true;
            break;
        }
    }
    assert!(chosen, "the side face was never hit");
    window.screenshot("rolls-editor-chamfer");
    window.click("Apply");
    window.until("designed", |desk| desk.session().is_some_and(Session::is_designed));
    assert_eq!(edits(&mut window), 1);
    window.screenshot("rolls-editor-chamfered");
    window.click("remove");
    window.harness.run_steps(4);
    assert_eq!(edits(&mut window), 0);
}
