//! A chamfer's depth or an arc's radius may be at most 60 % of either line, so that something of both is left.

use super::Reason;

/// Largest part of a line's length (Wong 1983, 6.9).
const MOST: f64 = 0.6;

/// Rounding of the published figures, as part of the limit: 2.0 mm of 3.333 mm is allowed.
const ROUNDING: f64 = 1e-9;

/// Checks a size against the lengths of both lines, mm. `name` is what the size is called.
pub(super) fn at_most_60_percent(lengths: [f64; 2], size: f64, name: &str) -> Result<(), Reason> {
    let [before, after] = lengths;
    let shorter = before.min(after);
    if size <= MOST * shorter * (1.0 + ROUNDING) {
        return Ok(());
    }
    let which = if before <= after { "before" } else { "behind" };
    let message = format!(
        "The {name} of {size} mm is more than {:.3} mm, 60 % of the line of {shorter:.3} mm {which} the corner.",
        MOST * shorter
    );
    Err(("edit-corner-size", message, "Enter a smaller figure."))
}
