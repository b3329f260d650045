//! Arrow heads of dimension lines and leaders.

use super::page::{Ink, Page, Pen};
use crate::geometry::{Contour, Point, Vector};

/// Length of an arrow head, mm (ISO 129-1: in proportion to the text).
pub(super) const LENGTH_MM: f64 = 2.5;
/// Half of its width, mm: 23° in all.
const HALF_MM: f64 = 0.5;
/// Width of its edge, mm: as little as possible, for the tip is the place that it points at.
const EDGE_MM: f64 = 0.1;

/// A filled arrow head at `tip` that points along `direction`.
pub(super) fn head(page: &mut Page, tip: Point, direction: Vector) {
    let Some(along) = direction.try_normalize(1e-9) else { return };
    let across = Vector::new(-along.y, along.x) * HALF_MM;
    let base = tip - along * LENGTH_MM;
    // Its edge shows it where areas stay empty, on a plotter and in CAD.
    let edge = Pen { width_mm: EDGE_MM, ..Pen::THIN };
    page.area(Contour::polygon(&[tip, base + across, base - across]).segments, Ink::Black, Some(edge));
}
