//! A tool as a picture: the whole of it, and its tip with nose and programmed point.

use super::canvas::Screen;
use super::lines::{DASHED, dashed};
use super::palette::Palette;
use super::profile::draw::on_screen;
use super::regions::Triangles;
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::machine::ToolOutline;
use egui::{Color32, Painter, Rect, Shape, Stroke, Vec2};

/// Part of the width that shows the whole tool.
const WHOLE: f32 = 0.34;
/// Room around the insert in the picture of the tip, as a part of its size.
const AROUND: f64 = 0.18;
/// Width of the edges that cut, points.
const EDGE: f32 = 2.4;

/// Draws `tool` in `rect`: on the left the whole tool, on the right its tip, both with r upwards and the chuck on the left.
pub fn tool_picture(painter: &Painter, rect: Rect, tool: &ToolOutline, palette: &Palette) {
    let (left, right) = rect.split_left_right_at_fraction(WHOLE);
    if let (Some(insert), Some(holder)) = (sound(tool.insert.bounds()), sound(tool.holder.bounds())) {
        let both = Bounds::around([insert.min, insert.max, holder.min, holder.max]);
        if let Some(both) = both {
            view(painter, left, both, tool, palette, false);
        }
    }
    if let Some(insert) = sound(tool.insert.bounds()) {
        let size = (insert.max.z - insert.min.z).max(insert.max.r - insert.min.r) * AROUND;
        let around = Bounds {
            min: Point::new(insert.min.z - size, insert.min.r - size),
            max: Point::new(insert.max.z + size, insert.max.r + size),
        };
        view(painter, right, around, tool, palette, true);
    }
}

fn sound(bounds: Option<Bounds>) -> Option<Bounds> {
    bounds.filter(|b| b.min.is_finite() && b.max.is_finite())
}

fn view(painter: &Painter, rect: Rect, bounds: Bounds, tool: &ToolOutline, palette: &Palette, tip: bool) {
    let painter = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
    let screen = Screen::fitted(rect, bounds);
    outline(&painter, &screen, &tool.holder, palette.steel, palette.steel_edge);
    outline(&painter, &screen, &tool.insert, palette.insert, palette.edge);
    if !tip {
        return;
    }
    for edge in tool.cutting_edges() {
        let line: Vec<Point> = std::iter::once(edge.start()).chain(edge.polyline_points(screen.tolerance())).collect();
        painter.add(Shape::line(on_screen(&screen, &line), Stroke::new(EDGE, palette.accent)));
    }
    nose(&painter, &screen, tool, palette);
    programmed_point(&painter, &screen, palette);
}

fn outline(painter: &Painter, screen: &Screen, contour: &Contour, fill: Color32, edge: Color32) {
    let mut ring = contour.polyline(screen.tolerance());
    ring.pop();
    Triangles::of(std::slice::from_ref(&ring)).fill(painter, screen, fill);
    painter.add(Shape::closed_line(on_screen(screen, &ring), Stroke::new(1.2, edge)));
}

/// The circle of the nose, and the way from its centre to the programmed point, which is the orientation.
fn nose(painter: &Painter, screen: &Screen, tool: &ToolOutline, palette: &Palette) {
    if tool.nose_radius <= 0.0 || !tool.nose_radius.is_finite() || !tool.nose_center.is_finite() {
        return;
    }
    let (center, radius) = (tool.nose_center, tool.nose_radius);
    let [right, left] = [1.0, -1.0].map(|side| Point::new(center.z + side * radius, center.r));
    for (start, end) in [(right, left), (left, right)] {
        let half = Segment::Arc { start, end, center, ccw: true };
        let points: Vec<Point> = std::iter::once(start).chain(half.polyline_points(screen.tolerance())).collect();
        dashed(painter, &on_screen(screen, &points), DASHED, Stroke::new(1.0, palette.text));
    }
    let at = screen.pos(center);
    painter.line_segment([at, screen.pos(Point::default())], Stroke::new(1.4, palette.text));
    painter.circle_filled(at, 2.0, palette.text);
}

fn programmed_point(painter: &Painter, screen: &Screen, palette: &Palette) {
    let at = screen.pos(Point::default());
    for arm in [Vec2::new(9.0, 0.0), Vec2::new(0.0, 9.0)] {
        painter.line_segment([at - arm, at + arm], Stroke::new(1.4, palette.wrong));
    }
    painter.circle_stroke(at, 4.5, Stroke::new(1.4, palette.wrong));
}
