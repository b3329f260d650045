//! Where the time goes: one bar, a piece for every operation.

use super::cut::clock;
use super::palette::Palette;
use egui::{Color32, Rect, Response, Sense, Ui, Vec2};

/// Height of the bar, points.
const HEIGHT: f32 = 10.0;
/// Width of the gap between two pieces, points.
const GAP: f32 = 1.0;

/// A piece of the bar.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeShare {
    /// What takes the time.
    pub name: String,
    /// Its colour.
    pub color: Color32,
    /// Its time, s.
    pub time_s: f64,
}

/// Draws `shares` as one bar over the width of `ui`; a piece says its name and time on hover.
pub fn time_bar(ui: &mut Ui, shares: &[TimeShare], palette: &Palette) -> Response {
    let response = ui.allocate_response(Vec2::new(ui.available_width(), HEIGHT), Sense::hover());
    let total: f64 = shares.iter().map(|share| share.time_s).sum();
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, format!("Time {}", clock(total))));
    let painter = ui.painter_at(response.rect);
    painter.rect_filled(response.rect, 2.0, palette.steel);
    let mut from = response.rect.left();
    let mut under_pointer = None;
    for share in shares {
        let piece = piece(response.rect, from, share.time_s / total);
        from = piece.right();
        painter.rect_filled(piece.with_max_x(piece.right() - GAP), 0.0, share.color);
        if response.hover_pos().is_some_and(|pos| piece.contains(pos)) {
            under_pointer = Some(format!("{}  {}", share.name, clock(share.time_s)));
        }
    }
    match under_pointer {
        Some(text) => response.on_hover_text_at_pointer(text),
        None => response,
    }
}

#[allow(clippy::cast_possible_truncation, reason = "a share of a width on the screen")]
fn piece(bar: Rect, from: f32, share: f64) -> Rect {
    let width = if share.is_finite() { bar.width() * share as f32 } else { 0.0 };
    Rect::from_x_y_ranges(from..=(from + width).min(bar.right()), bar.y_range())
}
