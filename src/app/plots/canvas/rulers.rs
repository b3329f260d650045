//! Rulers in the document's unit and the grid that goes with them.

use super::Screen;
use crate::app::plots::coordinates::{Coordinates, fixed, round_step};
use crate::app::plots::palette::Palette;
use crate::geometry::Point;
use egui::{Align2, FontId, Painter, Rect, Stroke};

/// Least distance of two labels along z, points.
const LABEL_Z: f64 = 44.0;
/// Least distance of two diameter labels, points.
const LABEL_D: f64 = 26.0;
/// Least width of a step that nodes snap to, points: round figures that still feel free.
const SNAP: f64 = 1.0;
/// More lines than this are never drawn, whatever the zoom.
const MOST_LINES: u32 = 400;
/// Size of the figures, points.
const TEXT: f32 = 10.0;
/// Room that the z ruler takes at the top of a canvas, points.
const TOP: f32 = 16.0;
/// Room that the diameter ruler takes at the left of a canvas, points.
const LEFT: f32 = 30.0;

/// Step that positions snap to at this zoom, in the document's unit: 1, 2 or 5 times a power of ten.
pub(in crate::app::plots) fn grid_step(screen: &Screen, coordinates: Coordinates) -> f64 {
    round_step(SNAP / screen.scale() / coordinates.unit.in_mm())
}

/// The rulers of a canvas.
pub(in crate::app::plots) struct Rulers {
    /// How positions are written.
    pub(in crate::app::plots) coordinates: Coordinates,
    /// Draw grid lines too.
    pub(in crate::app::plots) grid: bool,
    /// Label diameters on both sides of the centre line.
    pub(in crate::app::plots) mirrored: bool,
}

impl Rulers {
    /// Draws grid lines and figures: z along the top, diameter at the left.
    pub(in crate::app::plots) fn draw(&self, painter: &Painter, screen: &Screen, palette: &Palette) {
        let (z_step, d_step) = self.steps(screen);
        let (top_left, bottom_right) = (screen.point(screen.rect.min), screen.point(screen.rect.max));
        let c = self.coordinates;
        for z in multiples(c.document_z(top_left.z), c.document_z(bottom_right.z), z_step) {
            self.z_line(painter, screen, palette, z, decimals(z_step));
        }
        let diameter = |r: f64| 2.0 * r / c.unit.in_mm();
        for d in multiples(diameter(bottom_right.r), diameter(top_left.r), d_step) {
            if self.mirrored || d > -d_step / 2.0 {
                self.d_line(painter, screen, palette, d, decimals(d_step));
            }
        }
    }

    fn steps(&self, screen: &Screen) -> (f64, f64) {
        let unit = screen.scale() * self.coordinates.unit.in_mm();
        (round_step(LABEL_Z / unit), round_step(2.0 * LABEL_D / unit))
    }

    fn z_line(&self, painter: &Painter, screen: &Screen, palette: &Palette, z: f64, decimals: usize) {
        let rect = screen.rect;
        let x = painter.round_to_pixel_center(screen.pos(self.coordinates.point(z, 0.0)).x);
        if self.grid {
            painter.vline(x, rect.top() + TOP..=rect.bottom(), Stroke::new(1.0, palette.grid));
        }
        if x > rect.left() + LEFT && x < rect.right() - 8.0 {
            let at = egui::pos2(x, rect.top() + 2.0);
            painter.text(at, Align2::CENTER_TOP, fixed(z, decimals), FontId::proportional(TEXT), palette.quiet);
        }
    }

    fn d_line(&self, painter: &Painter, screen: &Screen, palette: &Palette, d: f64, decimals: usize) {
        let rect = screen.rect;
        let r = d * self.coordinates.unit.in_mm() / 2.0;
        let y = painter.round_to_pixel_center(screen.pos(Point::new(0.0, r)).y);
        if self.grid {
            painter.hline(rect.left() + LEFT..=rect.right(), y, Stroke::new(1.0, palette.grid));
        }
        if y > rect.top() + TOP + 6.0 && y < rect.bottom() - 6.0 {
            let at = egui::pos2(rect.left() + LEFT - 6.0, y);
            let text = fixed(d.abs(), decimals);
            painter.text(at, Align2::RIGHT_CENTER, text, FontId::proportional(TEXT), palette.quiet);
        }
    }

    /// The part of `rect` that the rulers leave free.
    pub(in crate::app::plots) fn free(rect: Rect) -> Rect {
        Rect::from_min_max(rect.min + egui::vec2(LEFT, TOP), rect.max)
    }
}

/// Multiples of `step` between two values in any order, at most [`MOST_LINES`].
fn multiples(a: f64, b: f64, step: f64) -> impl Iterator<Item = f64> {
    let (from, to) = (a.min(b), a.max(b));
    let first = (from / step).ceil() * step;
    (0..MOST_LINES).map(move |k| first + f64::from(k) * step).take_while(move |&v| v <= to)
}

/// Decimals that a multiple of `step` needs, at most 6.
fn decimals(step: f64) -> usize {
    let whole = |value: f64| (value - value.round()).abs() < 1e-6;
    std::iter::successors(Some(step), |value| Some(value * 10.0)).take(6).position(whole).unwrap_or(6)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_lie_between_their_ends() {
        assert_eq!(multiples(12.0, -3.0, 5.0).collect::<Vec<_>>(), vec![0.0, 5.0, 10.0]);
        assert!(multiples(0.0, 1e9, 1.0).count() <= MOST_LINES as usize);
    }

    #[test]
    fn figures_have_the_decimals_of_their_step() {
        assert_eq!([5.0, 0.5, 0.02, 0.001].map(decimals), [0, 1, 2, 3]);
    }
}
