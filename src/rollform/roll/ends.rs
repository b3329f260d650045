//! The end of the strip: tolerance, end face and extension contour.

use super::face::Face;
use super::wing::Wing;
use crate::document::{ElementName, ExtensionContour, ExtensionKind, PieceKind};
use crate::geometry::{Point, Vector};
use crate::rollform::strip::along;

/// A strip that ends within this of the horizontal ends level, radians.
const LEVEL_RAD: f64 = 1e-9;

/// Prolongs the last line of both faces by the tolerance.
pub(super) fn prolong(wing: &mut Wing, tolerance: f64) {
    let forward = along(wing.end_heading_rad()) * tolerance;
    for face in [&mut wing.bottom, &mut wing.top] {
        lengthen(face, forward, wing.pieces.last().map_or(0, |p| p.element), wing.side);
    }
}

fn lengthen(face: &mut Face, forward: Vector, element: u32, side: crate::document::Side) {
    let to = face.end() + forward;
    face.move_end(to, ElementName::Strip { element, side, kind: PieceKind::Line });
}

/// Closes the opening with an end face square to the strip, on the roll that can reach it, and goes on with the extension
/// contour, which both rolls share.
pub(super) fn close(wing: &mut Wing, extension: Option<&ExtensionContour>) {
    let heading = wing.end_heading_rad();
    let edge = ElementName::Edge { side: wing.side };
    if ends_upwards(heading) {
        let to = wing.bottom.end();
        wing.top.line_to(to, edge);
    } else {
        let to = wing.top.end();
        wing.bottom.line_to(to, edge);
    }
    extend(wing, extension, Some(heading));
}

/// Appends the extension contour to both faces, which end at one point. `heading` is the direction of its first part, absent where
/// the strip's own direction cannot be reached.
pub(super) fn extend(wing: &mut Wing, extension: Option<&ExtensionContour>, heading: Option<f64>) {
    let Some(extension) = extension else { return };
    let upwards = ends_upwards(wing.end_heading_rad());
    let from = if upwards { wing.bottom.end() } else { wing.top.end() };
    let points = points(extension, from, heading, upwards);
    for (part, to) in (1..).zip(points) {
        let name = ElementName::Extension { side: wing.side, part };
        wing.bottom.line_to(to, name);
        wing.top.line_to(to, name);
    }
}

/// The ends of the four parts of a spigot.
fn points(extension: &ExtensionContour, from: Point, heading: Option<f64>, upwards: bool) -> [Point; 4] {
    let [first, second, third, fourth] = extension.lengths;
    let back = match (extension.kind, upwards) {
        (ExtensionKind::SpigotA | ExtensionKind::SideRoll, false) | (ExtensionKind::SpigotB, true) => 1.0,
        (ExtensionKind::SpigotA | ExtensionKind::SideRoll, true) | (ExtensionKind::SpigotB, false) => -1.0,
    };
    let one = from + heading.map_or_else(Vector::zeros, along) * first;
    let two = one + Vector::new(second, 0.0);
    let three = two + Vector::new(0.0, back * third);
    [one, two, three, three + Vector::new(fourth, 0.0)]
}

/// True if a strip with this direction at its end ends upwards: then the end face is the top roll's.
pub(super) fn ends_upwards(heading: f64) -> bool {
    heading > LEVEL_RAD
}
