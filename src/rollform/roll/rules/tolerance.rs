//! The tolerance at an edge of the strip is room for it; less than none cuts into the strip.

use super::Checked;
use crate::diagnostic::Diagnostic;

/// Tolerances below 0.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let station = checked.station;
    let sides = [("left", station.tolerance_left), ("right", station.tolerance_right)];
    sides
        .into_iter()
        .filter(|(_, value)| !(value.is_finite() && *value >= 0.0))
        .map(|(side, value)| {
            let message = format!("The {side} tolerance is {value} mm; it must be 0 mm or more.");
            Diagnostic::error("roll-tolerance", checked.at(), message).with_hint("Enter 0 or a positive figure.")
        })
        .collect()
}
