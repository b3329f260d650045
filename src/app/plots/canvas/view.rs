//! Which part of the plane a canvas shows, and the way between plane and screen.

use crate::geometry::{Bounds, Point};
use egui::{Pos2, Rect, Vec2};

/// Smallest and largest scale, points per mm: from a 4 m long bar in 200 points to a micrometre in 20.
const SCALES: (f64, f64) = (0.05, 20_000.0);
/// Room kept free around what is fitted, points.
const FIT_MARGIN: f32 = 12.0;

/// The part of the plane on a canvas, kept from frame to frame.
///
/// A fitted view follows its content and its rectangle until it is zoomed or moved by hand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CanvasView {
    centre: Point,
    scale: f64,
    fitted: bool,
    /// Where a box zoom began.
    pub(super) box_from: Option<Pos2>,
}

impl Default for CanvasView {
    fn default() -> Self {
        Self { centre: Point::default(), scale: 1.0, fitted: true, box_from: None }
    }
}

impl CanvasView {
    /// Shows everything from the next frame on.
    pub const fn fit(&mut self) {
        self.fitted = true;
    }

    /// The transform for a canvas on `rect`.
    pub(super) const fn screen(&self, rect: Rect) -> Screen {
        Screen { rect, centre: self.centre, scale: self.scale }
    }

    /// If fitted: shows `bounds` in `rect`.
    pub(super) fn follow(&mut self, rect: Rect, bounds: Bounds) {
        if self.fitted {
            self.show_bounds(rect, bounds);
        }
    }

    fn show_bounds(&mut self, rect: Rect, bounds: Bounds) {
        let room = (rect.size() - Vec2::splat(2.0 * FIT_MARGIN)).max(Vec2::splat(1.0));
        let (width, height) = (bounds.max.z - bounds.min.z, bounds.max.r - bounds.min.r);
        let scale = (f64::from(room.x) / width.max(1e-9)).min(f64::from(room.y) / height.max(1e-9));
        if bounds.min.is_finite() && bounds.max.is_finite() {
            self.scale = scale.clamp(SCALES.0, SCALES.1);
            self.centre =
                Point::new(f64::midpoint(bounds.min.z, bounds.max.z), f64::midpoint(bounds.min.r, bounds.max.r));
        }
    }

    /// Multiplies the scale; what is at `pos` stays there.
    pub(super) fn zoom_at(&mut self, rect: Rect, pos: Pos2, factor: f64) {
        let fixed = self.screen(rect).point(pos);
        self.scale = (self.scale * factor).clamp(SCALES.0, SCALES.1);
        let moved = self.screen(rect).point(pos);
        self.centre = self.centre + (fixed - moved);
        self.fitted = false;
    }

    /// Moves the content by `delta` points on the screen.
    pub(super) fn pan(&mut self, delta: Vec2) {
        self.centre.z -= f64::from(delta.x) / self.scale;
        self.centre.r += f64::from(delta.y) / self.scale;
        self.fitted = false;
    }

    /// Shows what lies in `window`, a rectangle on the screen.
    pub(super) fn zoom_to(&mut self, rect: Rect, window: Rect) {
        let screen = self.screen(rect);
        let corners = [screen.point(window.min), screen.point(window.max)];
        if let Some(bounds) = Bounds::around(corners) {
            self.show_bounds(rect, bounds);
            self.fitted = false;
        }
    }
}

/// The transform of one frame: part space in mm to points on the screen, equal scales, r upwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::app::plots) struct Screen {
    /// Where the canvas is.
    pub(in crate::app::plots) rect: Rect,
    centre: Point,
    scale: f64,
}

impl Screen {
    /// A transform that shows `bounds` in `rect`.
    pub(in crate::app::plots) fn fitted(rect: Rect, bounds: Bounds) -> Self {
        let mut view = CanvasView::default();
        view.follow(rect, bounds);
        view.screen(rect)
    }

    /// Points on the screen for one mm.
    pub(in crate::app::plots) const fn scale(&self) -> f64 {
        self.scale
    }

    /// Where a part-space point is on the screen.
    #[allow(clippy::cast_possible_truncation, reason = "screen positions are f32 in egui")]
    pub(in crate::app::plots) fn pos(&self, p: Point) -> Pos2 {
        let middle = self.rect.center();
        let x = f64::from(middle.x) + (p.z - self.centre.z) * self.scale;
        let y = f64::from(middle.y) - (p.r - self.centre.r) * self.scale;
        Pos2::new(x as f32, y as f32)
    }

    /// The part-space point at a position on the screen.
    pub(in crate::app::plots) fn point(&self, pos: Pos2) -> Point {
        let from_middle = pos - self.rect.center();
        Point::new(
            self.centre.z + f64::from(from_middle.x) / self.scale,
            self.centre.r - f64::from(from_middle.y) / self.scale,
        )
    }

    /// A chord tolerance that the eye cannot see, mm: a quarter of a point, but no finer than 0.1 µm.
    pub(in crate::app::plots) const fn tolerance(&self) -> f64 {
        (0.25 / self.scale).max(1e-4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rect() -> Rect {
        Rect::from_min_size(Pos2::new(100.0, 50.0), Vec2::new(800.0, 400.0))
    }

    fn bounds() -> Bounds {
        Bounds { min: Point::new(0.0, -20.0), max: Point::new(100.0, 20.0) }
    }

    #[test]
    fn fitted_content_fills_the_canvas_within_its_margin() {
        let screen = Screen::fitted(rect(), bounds());
        assert_eq!(screen.pos(Point::new(50.0, 0.0)), rect().center());
        assert!((screen.pos(Point::new(0.0, 0.0)).x - (100.0 + FIT_MARGIN)).abs() < 1e-3);
        assert!(screen.pos(Point::new(0.0, 20.0)).y < screen.pos(Point::new(0.0, -20.0)).y, "r grows upwards");
    }

    #[test]
    fn zoom_keeps_the_point_under_the_pointer() {
        let mut view = CanvasView::default();
        view.follow(rect(), bounds());
        let pos = Pos2::new(333.0, 210.0);
        let before = view.screen(rect()).point(pos);
        view.zoom_at(rect(), pos, 3.0);
        assert!(view.screen(rect()).point(pos).distance(before) < 1e-9);
    }

    #[test]
    fn a_box_becomes_the_whole_canvas() {
        let mut view = CanvasView::default();
        view.follow(rect(), bounds());
        let window = Rect::from_center_size(rect().center(), Vec2::new(80.0, 40.0));
        let before = view.screen(rect()).scale();
        view.zoom_to(rect(), window);
        assert!(view.screen(rect()).scale() > 8.0 * before);
        view.follow(rect(), bounds());
        assert!(view.screen(rect()).scale() > 8.0 * before, "a view set by hand stays");
    }

    #[test]
    fn bounds_that_are_not_numbers_change_nothing() {
        let mut view = CanvasView::default();
        view.follow(rect(), Bounds { min: Point::new(f64::NAN, 0.0), max: Point::new(1.0, f64::INFINITY) });
        assert_eq!(view, CanvasView::default());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn screen_and_part_space_round_trip(z in -200.0..200.0_f64, r in -50.0..50.0_f64, zoom in 0.2..20.0_f64) {
            let mut view = CanvasView::default();
            view.follow(rect(), bounds());
            view.zoom_at(rect(), rect().center(), zoom);
            let screen = view.screen(rect());
            let p = Point::new(z, r);
            // Screen positions are f32: about 1e-3 points at these magnitudes.
            prop_assert!(screen.point(screen.pos(p)).distance(p) * screen.scale() < 0.02);
        }
    }
}
