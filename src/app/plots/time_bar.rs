//! Where the time goes: one bar, a piece for every operation.

use super::cut::{clock, operation_of};
use super::palette::Palette;
use crate::proof::Motion;
use crate::regen::SetupDerived;
use crate::turning::OperationKind;
use egui::{Rect, Response, Sense, Ui, Vec2};

/// Height of the bar, points.
const HEIGHT: f32 = 10.0;
/// Width of the gap between two pieces, points.
const GAP: f32 = 1.0;

/// Cutting time of one operation, and what is no cutting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeShare {
    /// Operation; `None` for rapid moves, dwells and tool changes.
    pub operation: Option<OperationKind>,
    /// Its time, s.
    pub time_s: f64,
}

impl TimeShare {
    /// What the share is called.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self.operation {
            Some(kind) => kind.name(),
            None => "Rapid, tool changes",
        }
    }
}

/// Times of a set-up by operation, in order of cutting; what is no cutting comes last.
#[must_use]
pub fn time_shares(derived: &SetupDerived) -> Vec<TimeShare> {
    let mut shares: Vec<TimeShare> = Vec::new();
    for m in &derived.proof.moves {
        let cuts = matches!(m.motion, Motion::Feed | Motion::Thread);
        let operation = if cuts { operation_of(derived, m) } else { None };
        match shares.iter_mut().find(|share| share.operation == operation) {
            Some(share) => share.time_s += m.lasts_s,
            None => shares.push(TimeShare { operation, time_s: m.lasts_s }),
        }
    }
    shares.sort_by_key(|share| share.operation.is_none());
    shares
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
        painter.rect_filled(piece.with_max_x(piece.right() - GAP), 0.0, palette.operation(share.operation));
        if response.hover_pos().is_some_and(|pos| piece.contains(pos)) {
            under_pointer = Some(format!("{}  {}", share.name(), clock(share.time_s)));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::plots::sample;

    #[test]
    fn all_time_is_in_one_share() {
        let derived = sample::with_program(sample::derived(&sample::pawn()));
        let shares = time_shares(&derived);
        let sum: f64 = shares.iter().map(|share| share.time_s).sum();
        assert_eq!(sum, derived.proof.times.total_s);
        assert_eq!(shares.last().map(TimeShare::name), Some("Rapid, tool changes"));
    }
}
