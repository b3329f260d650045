//! A strip has a thickness; without one there is nothing to bend.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};

/// A thickness of 0 or less.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let thickness = subject.set.section.thickness;
    if thickness > 0.0 {
        return Vec::new();
    }
    let message = format!("The strip is {} thick; it must be thicker than 0.", subject.length(thickness));
    vec![Diagnostic::error("strip-thickness", Place::Document, message)]
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_at_0_and_below() {
        for thickness in [0.0, -1.0] {
            let mut set = vee(&[90.0]);
            set.section.thickness = thickness;
            assert_eq!(found(check, &set).len(), 1);
        }
        assert!(found(check, &vee(&[90.0])).is_empty());
    }
}
