//! The aperture of a die block for the finished section, for cutting by wire.

use super::dxf::{add, empty, text_of};
use crate::diagnostic::Diagnostic;
use crate::geometry::Contour;
use crate::units::Unit;

/// Layer of the outline.
const APERTURE: &str = "APERTURE";

/// A closed outline as DXF, x across the line and y the height, in `unit`; lines and arcs follow one another.
///
/// # Errors
/// A diagnostic if the drawing cannot be written as text.
pub fn die_dxf(outline: &Contour, unit: Unit) -> Result<String, Diagnostic> {
    let mut drawing = empty(unit, &[(APERTURE, 7)]);
    for segment in &outline.segments {
        add(&mut drawing, APERTURE, segment, 1.0 / unit.in_mm());
    }
    text_of(&drawing)
}
