//! The first element may slope by at most a right angle; on the centre line of a symmetrical section it lies level, or the
//! two sides would meet in a kink.

use super::subject::{Subject, degrees};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::Origin;

/// Steepest slope of the first element, degrees (the published range).
const STEEPEST_DEG: f64 = 90.0;

/// A slope beyond a right angle, or any slope of a symmetrical section.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let section = &subject.set.section;
    let is_symmetrical = section.origin == Origin::Symmetrical;
    let limit = if is_symmetrical { 0.0 } else { STEEPEST_DEG };
    if section.first_angle_deg.abs() <= limit {
        return Vec::new();
    }
    let slope = degrees(section.first_angle_deg);
    let message = if is_symmetrical {
        format!("The first element slopes by {slope}; in a symmetrical section it must be 0°.")
    } else {
        format!("The first element slopes by {slope}; the limits are -90° and 90°.")
    };
    let place = section.elements.first().map_or(Place::Document, |e| subject.element(e.id));
    vec![Diagnostic::error("first-slope", place, message)]
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_beyond_the_range_of_the_origin() {
        for (origin, slope, count) in [
            (Origin::LeftToRight, -90.0, 0),
            (Origin::LeftToRight, 90.5, 1),
            (Origin::Symmetrical, 0.0, 0),
            (Origin::Symmetrical, 5.0, 1),
        ] {
            let mut set = vee(&[90.0]);
            (set.section.origin, set.section.first_angle_deg) = (origin, slope);
            assert_eq!(found(check, &set).len(), count, "{origin:?} {slope}");
        }
    }
}
