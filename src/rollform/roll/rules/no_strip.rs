//! Rolls need a strip: elements with a length and a thickness above 0, and openings that are numbers.

use super::Checked;
use crate::diagnostic::Diagnostic;

/// A station without strip between its rolls.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let strip = &checked.design.strip;
    let (length, thickness) = (strip.mean_length(), strip.thickness);
    if thickness > 0.0 && length > 0.0 && thickness.is_finite() && length.is_finite() {
        return Vec::new();
    }
    let message = format!(
        "The strip is {length:.3} mm wide and {thickness:.3} mm thick; both must be more than 0 mm. The station has no rolls."
    );
    vec![Diagnostic::error("roll-no-strip", checked.at(), message).with_hint("Complete the cross-section.")]
}
