//! A canvas with equal scales: zoom to the pointer, pan, box zoom, fit, rulers, keyboard.
//!
//! | gesture | what it does |
//! |---|---|
//! | wheel, pinch, `+` `-` | zoom to the pointer (keys: to the middle) |
//! | drag on empty, middle or secondary drag | move the picture |
//! | Ctrl or Shift and drag on empty | zoom to the box |
//! | double click on empty, `F` | show everything |
//! | arrow keys | move the picture, unless a plot uses them |

mod rulers;
mod view;

use super::palette::Palette;
use crate::geometry::{Bounds, Point};
use egui::{CursorIcon, Event, EventFilter, Key, PointerButton, Pos2, Rect, Response, Sense, Stroke, Ui, Vec2};
pub(super) use rulers::{Rulers, grid_step};
pub use view::CanvasView;
pub(super) use view::Screen;

/// Factor of the scale for one press of `+`.
const KEY_ZOOM: f64 = 1.25;
/// Movement for one press of an arrow key, points.
const KEY_PAN: f32 = 40.0;
/// Scrolling that multiplies the scale by e, points.
const SCROLL_FOR_E: f64 = 250.0;
/// A box smaller than this is a slip of the hand, points.
const SMALLEST_BOX: f32 = 6.0;

/// One frame of a canvas.
pub(super) struct Canvas {
    /// Transform of this frame.
    pub(super) screen: Screen,
    /// The empty canvas as a widget; what is drawn on it comes after and lies above.
    pub(super) response: Response,
    /// Where the pointer is, if it is over the canvas.
    pub(super) pointer: Option<Point>,
}

/// Lays a canvas of `size` out and does what mouse and keyboard ask of it. `name` is what a screen reader says.
pub(super) fn canvas(
    ui: &mut Ui,
    view: &mut CanvasView,
    size: Vec2,
    bounds: Bounds,
    name: &str,
    own_arrows: bool,
) -> Canvas {
    let response = ui.allocate_response(size, Sense::click_and_drag());
    let rect = response.rect;
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, name));
    if !ui.input(|i| i.pointer.any_down()) {
        view.follow(rect, bounds);
    }
    let over = ui.rect_contains_pointer(rect);
    if over {
        zoom_by_wheel(ui, view, rect);
    }
    drag(ui, view, &response);
    if response.clicked() {
        response.request_focus();
    }
    keys(ui, view, &response, over, own_arrows);
    if response.double_clicked() {
        view.fit();
    }
    let screen = view.screen(rect);
    let pointer = ui.input(|i| i.pointer.hover_pos()).filter(|_| over).map(|pos| screen.point(pos));
    Canvas { screen, response, pointer }
}

fn zoom_by_wheel(ui: &Ui, view: &mut CanvasView, rect: Rect) {
    let (scroll, pinch, pos) = ui.input(|i| (i.smooth_scroll_delta().y, i.zoom_delta(), i.pointer.hover_pos()));
    let factor = (f64::from(scroll) / SCROLL_FOR_E).exp() * f64::from(pinch);
    if let Some(pos) = pos.filter(|_| factor != 1.0) {
        view.zoom_at(rect, pos, factor);
    }
}

fn drag(ui: &Ui, view: &mut CanvasView, response: &Response) {
    let wants_box = ui.input(|i| i.modifiers.ctrl || i.modifiers.shift || i.modifiers.command);
    if response.drag_started_by(PointerButton::Primary) && wants_box {
        view.box_from = ui.input(|i| i.pointer.press_origin());
    }
    match view.box_from {
        Some(from) if response.drag_stopped() => {
            view.box_from = None;
            let window = box_window(ui, response, from);
            if window.width().max(window.height()) >= SMALLEST_BOX {
                view.zoom_to(response.rect, window);
            }
        }
        Some(_) => ui.set_cursor_icon(CursorIcon::Crosshair),
        None if response.dragged() => {
            view.pan(response.drag_delta());
            ui.set_cursor_icon(CursorIcon::Grabbing);
        }
        None => {}
    }
}

fn box_window(ui: &Ui, response: &Response, from: Pos2) -> Rect {
    let to = ui.input(|i| i.pointer.latest_pos()).unwrap_or(from);
    Rect::from_two_pos(from, to).intersect(response.rect)
}

fn keys(ui: &Ui, view: &mut CanvasView, response: &Response, over: bool, own_arrows: bool) {
    let focused = response.has_focus();
    if focused {
        let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|m| m.set_focus_lock_filter(response.id, filter));
    }
    let listens = focused || (over && ui.memory(|m| m.focused().is_none()));
    if !listens {
        return;
    }
    for event in ui.input(|i| i.events.clone()) {
        let Event::Key { key, pressed: true, modifiers, .. } = event else { continue };
        if modifiers.command || modifiers.alt {
            continue;
        }
        let middle = response.rect.center();
        match key {
            Key::F => view.fit(),
            Key::Plus | Key::Equals => view.zoom_at(response.rect, middle, KEY_ZOOM),
            Key::Minus => view.zoom_at(response.rect, middle, 1.0 / KEY_ZOOM),
            _ if focused && !own_arrows => arrow(key).into_iter().for_each(|way| view.pan(-way * KEY_PAN)),
            _ => {}
        }
    }
}

/// Direction of an arrow key on the screen.
pub(super) const fn arrow(key: Key) -> Option<Vec2> {
    match key {
        Key::ArrowLeft => Some(Vec2::new(-1.0, 0.0)),
        Key::ArrowRight => Some(Vec2::new(1.0, 0.0)),
        Key::ArrowUp => Some(Vec2::new(0.0, -1.0)),
        Key::ArrowDown => Some(Vec2::new(0.0, 1.0)),
        _ => None,
    }
}

/// Draws what lies above everything else: the box of a box zoom and the focus ring.
pub(super) fn overlay(ui: &Ui, view: &CanvasView, canvas: &Canvas, palette: &Palette) {
    let painter = ui.painter_at(canvas.response.rect);
    if let Some(from) = view.box_from {
        let window = box_window(ui, &canvas.response, from);
        let stroke = Stroke::new(1.0, palette.accent);
        painter.rect(window, 0.0, palette.accent.gamma_multiply(0.08), stroke, egui::StrokeKind::Inside);
    }
    if canvas.response.has_focus() {
        let ring = canvas.response.rect.shrink(0.5);
        painter.rect_stroke(ring, 4.0, Stroke::new(1.0, palette.accent.gamma_multiply(0.5)), egui::StrokeKind::Inside);
    }
}

#[cfg(test)]
mod tests;
