//! A part as a small picture, for the start page.

use super::canvas::Screen;
use super::lines::thinned;
use super::palette::Palette;
use super::profile::draw::with_ends_on_axis;
use super::regions::{Triangles, mirrored};
use crate::geometry::{Bounds, Contour, Point};
use egui::{Painter, Rect, Shape, Stroke};

/// Draws the strip at every station, `stages` in their order, as large as `rect` allows; the last one strong.
pub fn flower_thumbnail(painter: &Painter, rect: Rect, stages: &[Contour], palette: &Palette) {
    let Some(bounds) = stages.iter().filter_map(Contour::bounds).reduce(Bounds::union) else { return };
    if !(bounds.min.is_finite() && bounds.max.is_finite()) {
        return;
    }
    let screen = Screen::fitted(rect, bounds);
    let painter = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
    let last = stages.len().saturating_sub(1);
    for (index, stage) in stages.iter().enumerate() {
        let stroke =
            if index == last { Stroke::new(2.4, palette.wrong) } else { Stroke::new(1.0, palette.edge_mirror) };
        let points = stage.polyline(screen.tolerance()).into_iter().map(|p| screen.pos(p));
        painter.add(Shape::line(thinned(points), stroke));
    }
}

/// Draws the finished outside `contour` (clamped end to free end) with its mirrored half, as large as `rect` allows.
pub fn thumbnail(painter: &Painter, rect: Rect, contour: &Contour, palette: &Palette) {
    let Some(bounds) = contour.bounds().filter(|b| b.min.is_finite() && b.max.is_finite()) else { return };
    let whole = Bounds { min: Point::new(bounds.min.z, -bounds.max.r), max: bounds.max };
    let screen = Screen::fitted(rect, whole);
    let line = contour.polyline(screen.tolerance());
    let region = Triangles::under(&line);
    let painter = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
    region.fill_mirrored(&painter, &screen, palette.part_mirror);
    region.fill(&painter, &screen, palette.part);
    let closed = with_ends_on_axis(&line);
    let below = thinned(closed.iter().map(|&p| screen.pos(mirrored(p))));
    painter.add(Shape::line(below, Stroke::new(0.8, palette.edge_mirror)));
    painter.add(Shape::line(thinned(closed.iter().map(|&p| screen.pos(p))), Stroke::new(1.4, palette.edge)));
    super::profile::draw::centre_line(&painter, &screen, palette);
}
