//! Without elements there is no strip, and no roll to design.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};

/// An empty list of elements.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    if !subject.set.section.elements.is_empty() {
        return Vec::new();
    }
    let message = "The cross-section has 0 elements; it needs at least 1.";
    vec![Diagnostic::error("no-elements", Place::Document, message).with_hint("Add a line to the table of elements.")]
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_without_elements() {
        let mut set = vee(&[90.0]);
        assert!(found(check, &set).is_empty());
        set.section.elements.clear();
        assert_eq!(found(check, &set).len(), 1);
    }
}
