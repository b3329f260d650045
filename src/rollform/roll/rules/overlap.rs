//! Rolls of a station do not stand in one another; they may touch.

use super::Checked;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Bounds, Contour, Location, Point};
use crate::rollform::Roll;

/// Contours that lie in one another by less touch, mm.
const TOUCHING_MM: f64 = 0.001;

/// Distance of the points that are looked at from their arcs, mm.
const CHORD_MM: f64 = 0.01;

/// Pairs of rolls that overlap.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let rolls = &checked.design.rolls;
    let outlines: Vec<(&Roll, Contour)> = rolls.iter().map(|roll| (roll, roll.outline())).collect();
    let mut found = Vec::new();
    for (index, (a, first)) in outlines.iter().enumerate() {
        for (b, second) in outlines.iter().skip(index + 1) {
            if let Some(at) = common(first, second).or_else(|| common(second, first)) {
                found.push(said(a, b, at));
            }
        }
    }
    found
}

/// A point of the first outline within the second one.
fn common(first: &Contour, second: &Contour) -> Option<Point> {
    let (a, b) = (first.bounds()?, second.bounds()?);
    if !a.touches(b) {
        return None;
    }
    let corners = first.polyline(CHORD_MM);
    let middles = corners.iter().zip(corners.iter().skip(1)).map(|(p, q)| *p + (*q - *p) * 0.5);
    let mut candidates = corners.iter().copied().chain(middles).filter(|p| b.touches(Bounds { min: *p, max: *p }));
    candidates.find(|p| second.locate(*p, TOUCHING_MM) == Location::Inside)
}

fn said(a: &Roll, b: &Roll, at: Point) -> Diagnostic {
    let name = |roll: &Roll| roll.name.clone();
    let message = format!(
        "The rolls {} and {} stand in one another at {:.3} mm across and {:.3} mm height of the strip; there must be none or more \
         between them.",
        name(a),
        name(b),
        at.z,
        at.r
    );
    Diagnostic::error("roll-overlap", Place::Roll { name: name(a) }, message)
        .with_related(Place::Roll { name: name(b) })
        .with_hint("Change the extension contours, or the distance of the axes.")
}
