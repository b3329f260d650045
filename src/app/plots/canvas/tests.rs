use super::*;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

/// A window with one canvas, and the scale of its last frame.
fn harness() -> Harness<'static, (CanvasView, f64)> {
    let show = |ui: &mut Ui, (view, scale): &mut (CanvasView, f64)| {
        let bounds = Bounds { min: Point::new(0.0, -10.0), max: Point::new(100.0, 10.0) };
        let size = ui.available_size();
        *scale = canvas(ui, view, size, bounds, "Test", false).screen.scale();
    };
    Harness::builder()
        .with_context_setup(crate::app::install_theme)
        .with_size(Vec2::new(600.0, 400.0))
        .with_max_steps(40)
        .build_ui_state(show, Default::default())
}

#[test]
fn a_box_is_zoomed_to_with_shift_and_fitted_again_with_f() {
    let mut harness = harness();
    harness.run();
    let fitted = harness.state().1;
    let middle = harness.get_by_label("Test").rect().center();
    harness.event(Event::ModifiersChanged(egui::Modifiers::SHIFT));
    harness.drag_at(middle - Vec2::new(30.0, 20.0));
    harness.run();
    harness.hover_at(middle + Vec2::new(30.0, 20.0));
    harness.run();
    harness.drop_at(middle + Vec2::new(30.0, 20.0));
    harness.event(Event::ModifiersChanged(egui::Modifiers::NONE));
    harness.run();
    assert!(harness.state().1 > 5.0 * fitted, "{} of {fitted}", harness.state().1);
    harness.get_by_label("Test").focus();
    harness.run();
    harness.key_press(Key::F);
    harness.run();
    assert!((harness.state().1 - fitted).abs() < 1e-9);
}

#[test]
fn dragging_the_empty_canvas_moves_the_picture_without_zooming() {
    let mut harness = harness();
    harness.run();
    let (before, fitted) = *harness.state();
    let middle = harness.get_by_label("Test").rect().center();
    harness.drag_at(middle);
    harness.run();
    harness.hover_at(middle + Vec2::new(50.0, 0.0));
    harness.run();
    harness.drop_at(middle + Vec2::new(50.0, 0.0));
    harness.run();
    assert!((harness.state().1 - fitted).abs() < 1e-9);
    assert_ne!(harness.state().0, before);
}

#[test]
fn keys_zoom_while_the_canvas_has_the_focus() {
    let mut harness = harness();
    harness.run();
    let fitted = harness.state().1;
    harness.get_by_label("Test").focus();
    harness.run();
    harness.key_press(Key::Plus);
    harness.run();
    assert!((harness.state().1 - fitted * KEY_ZOOM).abs() < 1e-9);
}
