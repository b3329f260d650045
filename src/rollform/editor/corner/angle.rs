//! The angle between the lines of a corner must be below 135°: flatter corners need none.

use super::Reason;
use crate::geometry::Segment;

/// Largest angle between the lines, degrees, not included (Wong 1983, 6.9).
const MOST_DEG: f64 = 135.0;

/// Checks the angle between two lines, the first of which ends where the second one starts.
pub(super) fn below_135(before: &Segment, after: &Segment) -> Result<(), Reason> {
    let (u, v) = (before.direction_at(1.0), after.direction_at(0.0));
    let included = 180.0 - u.perp(&v).abs().atan2(u.dot(&v)).to_degrees();
    if included < MOST_DEG {
        return Ok(());
    }
    let message = format!("The lines include {included:.1}°; a corner can be modified below {MOST_DEG}°.");
    Err(("edit-corner-angle", message, "Leave so flat a corner as it is, or insert a tangent circle."))
}
