//! A section that is described from its centre outwards has a list of elements for either side; any other has one list.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};

/// A second list that the origin does not ask for, or a missing one that it does.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let section = &subject.set.section;
    match (section.origin.has_other_side(), section.other_side.first()) {
        (false, Some(first)) => {
            let message = format!(
                "The section has {} elements of the other side; with this origin there is only one list.",
                section.other_side.len()
            );
            let found = Diagnostic::error("other-side", subject.element(first.id), message);
            vec![found.with_hint("Choose an origin in the centre, or delete these elements.")]
        }
        (true, None) => {
            let message =
                "The other side has 0 elements; with its origin in the centre the section needs at least 1 there.";
            let found = Diagnostic::error("other-side", Place::Document, message);
            vec![found.with_hint("Add a line to the other side, or choose another origin.")]
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::document::Origin;
    use crate::rollform::fixtures::{line, vee};

    #[test]
    fn fires_where_list_and_origin_differ() {
        for (origin, other, count) in [
            (Origin::LeftToRight, vec![], 0),
            (Origin::Symmetrical, vec![line(9, 5.0)], 1),
            (Origin::CentreRightFirst, vec![], 1),
            (Origin::CentreLeftFirst, vec![line(9, 5.0)], 0),
        ] {
            let mut set = vee(&[90.0]);
            (set.section.origin, set.section.other_side) = (origin, other);
            assert_eq!(found(check, &set).len(), count, "{origin:?}");
        }
    }
}
