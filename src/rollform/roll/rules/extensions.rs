//! The parts of an extension contour have lengths of 0 or more.

use super::Checked;
use crate::diagnostic::Diagnostic;

/// Lengths below 0.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let station = checked.station;
    let sides = [station.side_left.as_ref(), station.side_right.as_ref()];
    let of_sides = sides.into_iter().flatten().flat_map(|side| &side.extensions);
    let all = station.extension_left.iter().chain(&station.extension_right).chain(of_sides);
    let bad = all.flat_map(|contour| (1..).zip(contour.lengths)).filter(|(_, l)| !(l.is_finite() && *l >= 0.0));
    bad.map(|(part, length): (u32, f64)| {
        let message = format!("Part {part} of an extension contour is {length} mm long; it must be 0 mm or more.");
        Diagnostic::error("roll-extension", checked.at(), message).with_hint("Enter 0 to leave the part out.")
    })
    .collect()
}
