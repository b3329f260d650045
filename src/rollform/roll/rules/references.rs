//! Drive surfaces and side rolls name elements of the section.

use super::Checked;
use crate::diagnostic::Diagnostic;

/// Elements that are named and not there.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let station = checked.station;
    let drive = [station.drive_left, station.drive_right].into_iter().flatten();
    let drive = drive.flat_map(|d| [("drive surface", d.first), ("drive surface", d.last)]);
    let sides = [station.side_left.as_ref(), station.side_right.as_ref()].into_iter().flatten();
    let sides = sides.flat_map(|s| [("side roll", s.from.element), ("side roll", s.to.element)]);
    let known = |id: u32| checked.set.section.all().any(|e| e.id == id);
    let unknown = drive.chain(sides).filter(|(_, id)| !checked.design.strip.pieces.is_empty() && !known(*id));
    unknown
        .map(|(what, id)| {
            let message = format!("The {what} names element {id}, which the section has not.");
            Diagnostic::error("roll-element-unknown", checked.at(), message).with_hint("Choose another element.")
        })
        .collect()
}
