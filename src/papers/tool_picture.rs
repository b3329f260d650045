//! A tool in a box: its insert filled, its holder outlined.

use super::crop::within;
use super::page::{Ink, Page, Pen};
use super::view::View;
use crate::geometry::{Bounds, Contour, Point};
use crate::machine::{ToolKind, ToolOutline};

/// Part of the box's side that stays free around the insert.
const AIR: f64 = 0.15;
/// The box shows this many times the insert's larger side.
const AROUND: f64 = 1.9;
/// The box shows this many times a drill's length.
const AROUND_DRILL: f64 = 1.4;

/// Draws the tool's cutting end into the square with its lower left corner at `corner` and this side, mm.
pub(super) fn draw(page: &mut Page, tool: &ToolOutline, corner: Point, side: f64) {
    page.rectangle(corner, Point::new(corner.z + side, corner.r + side), Pen::THIN);
    let Some(insert) = tool.insert.bounds() else { return };
    let size = (insert.max.z - insert.min.z).max(insert.max.r - insert.min.r).max(f64::MIN_POSITIVE);
    let drill = tool.kind == ToolKind::Drill;
    let shown = size * if drill { AROUND_DRILL } else { AROUND };
    let scale = side / shown;
    let middle_z = f64::midpoint(insert.min.z, insert.max.z);
    // A drill lies on the axis; of every other tool the insert is below its holder or at its end.
    let low = if drill { -shown / 2.0 } else { insert.min.r - shown * AIR };
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
    within(&points, boxed)
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
