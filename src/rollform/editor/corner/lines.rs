//! Both elements of a corner must be lines: the published modification is worked out for those only.

use super::Reason;
use crate::geometry::Segment;
use crate::rollform::roll::RollElement;

/// The lines before and behind the corner at the end of the element with this index.
pub(super) fn both_lines(elements: &[RollElement], index: usize) -> Result<(Segment, Segment), Reason> {
    let at = |index: usize| elements.get(index).map(|e| e.segment);
    match (at(index), at(index + 1)) {
        (Some(before @ Segment::Line { .. }), Some(after @ Segment::Line { .. })) => Ok((before, after)),
        (Some(before), Some(_)) => {
            let which = if before.radius().is_some() { "before" } else { "behind" };
            let message = format!("The element {which} the corner is an arc; a corner of two lines is needed.");
            Err(("edit-corner-lines", message, "Insert a circle that touches both elements instead."))
        }
        _ => Err((
            "edit-corner-lines",
            "Behind the last element there is no corner.".to_owned(),
            "Choose another corner.",
        )),
    }
}
