//! A tool in a box: its insert filled, its holder outlined.

use super::page::{Ink, Page, Pen};
use super::view::View;
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::machine::ToolOutline;

/// Part of the box's side that stays free around the insert.
const AIR: f64 = 0.15;
/// The box shows this many times the insert's larger side.
const AROUND: f64 = 1.9;

/// Draws the tool's cutting end into the square with its lower left corner at `corner` and this side, mm.
pub(super) fn draw(page: &mut Page, tool: &ToolOutline, corner: Point, side: f64) {
    page.rectangle(corner, Point::new(corner.z + side, corner.r + side), Pen::THIN);
    let Some(insert) = tool.insert.bounds() else { return };
    let size = (insert.max.z - insert.min.z).max(insert.max.r - insert.min.r).max(f64::MIN_POSITIVE);
    let shown = size * AROUND;
    let scale = side / shown;
    let middle_z = f64::midpoint(insert.min.z, insert.max.z);
    let low = insert.min.r - shown * AIR;
    let origin = Point::new(corner.z + side / 2.0 - middle_z * scale, corner.r - low * scale);
    let view = View { origin, scale };
    let boxed = Bounds { min: corner, max: Point::new(corner.z + side, corner.r + side) };
    let holder = polygon_within(&view, &tool.holder, boxed);
    if holder.len() > 2 {
        page.area(Contour::polygon(&holder).segments, Ink::Pale, Some(Pen::THIN));
    }
    let insert = polygon_within(&view, &tool.insert, boxed);
    if insert.len() > 2 {
        let edge = Pen { width_mm: 0.35, ..Pen::EDGE };
        page.area(Contour::polygon(&insert).segments, Ink::Sand, Some(edge));
    }
}

/// The outline on paper as a polygon, cut off at the box.
fn polygon_within(view: &View, outline: &Contour, boxed: Bounds) -> Vec<Point> {
    /// Largest distance of a chord from its arc, mm on paper.
    const CHORD_MM: f64 = 0.02;
    let on_paper = Contour::new(view.segments(&outline.segments));
    let mut points = on_paper.polyline(CHORD_MM);
    if points.first() == points.last() {
        points.pop();
    }
    let points = cut(&points, |p| p.z - boxed.min.z);
    let points = cut(&points, |p| boxed.max.z - p.z);
    let points = cut(&points, |p| p.r - boxed.min.r);
    cut(&points, |p| boxed.max.r - p.r)
}

/// The part of a polygon where `inside` is not negative (Sutherland and Hodgman, 1974).
fn cut(polygon: &[Point], inside: impl Fn(Point) -> f64) -> Vec<Point> {
    let next = polygon.iter().cycle().skip(1);
    let mut kept = Vec::new();
    for (&a, &b) in polygon.iter().zip(next) {
        let (at_a, at_b) = (inside(a), inside(b));
        if at_a >= 0.0 {
            kept.push(a);
        }
        if (at_a >= 0.0) != (at_b >= 0.0) {
            kept.push(Segment::line(a, b).point_at(at_a / (at_a - at_b)));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;
    use crate::papers::Item;

    #[test]
    fn every_shipped_tool_stays_in_its_box() {
        for tool in &Catalog::shipped().tools {
            let mut page = Page::new(100.0, 100.0, "");
            draw(&mut page, &tool.outline(), Point::new(10.0, 10.0), 20.0);
            for item in &page.items {
                let Item::Path { path, .. } = item else { continue };
                let bounds = path.bounds().unwrap();
                let within = bounds.min.z >= 10.0 - 1e-6 && bounds.max.z <= 30.0 + 1e-6;
                assert!(within && bounds.min.r >= 10.0 - 1e-6 && bounds.max.r <= 30.0 + 1e-6, "{}", tool.id);
            }
            assert!(page.items.len() >= 2, "{} shows nothing", tool.id);
        }
    }
}
