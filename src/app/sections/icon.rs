//! Small pictures of the section types.

use crate::part::SectionKind;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, vec2};

/// Draws the picture of a type into `rect`.
pub(crate) fn paint(painter: &Painter, rect: Rect, kind: &SectionKind, color: Color32) {
    let stroke = Stroke::new(1.3, color);
    let at = |x: f32, y: f32| rect.min + vec2(rect.width() * x, rect.height() * y);
    let curve = |bulge: f32| -> Vec<Pos2> {
        (0u8..=10).map(|i| f32::from(i) / 10.0).map(|t| at(t, 0.5 + bulge * (4.0 * t * (1.0 - t) - 0.5))).collect()
    };
    match kind {
        SectionKind::Line => painter.add(Shape::line_segment([at(0.0, 0.5), at(1.0, 0.5)], stroke)),
        SectionKind::Convex { .. } => painter.add(Shape::line(curve(-0.45), stroke)),
        SectionKind::Concave { .. } => painter.add(Shape::line(curve(0.45), stroke)),
        SectionKind::Thread { .. } => {
            let teeth = (0u8..=6).map(|i| at(f32::from(i) / 6.0, if i % 2 == 0 { 0.75 } else { 0.25 }));
            painter.add(Shape::line(teeth.collect(), stroke))
        }
        SectionKind::ParabolaAlongZ { .. } => {
            let points = (0u8..=10).map(|i| f32::from(i) / 10.0).map(|t| at(t, 1.0 - t.sqrt()));
            painter.add(Shape::line(points.collect(), stroke))
        }
        SectionKind::ParabolaAlongX { .. } => {
            let points = (0u8..=10).map(|i| f32::from(i) / 10.0).map(|t| at(t, 1.0 - t * t));
            painter.add(Shape::line(points.collect(), stroke))
        }
    };
}
