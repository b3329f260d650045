//! The neutral line lies in the strip: its distance from the inside is a part of the thickness.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::DevelopedWidth;

/// An own k outside 0 to 1.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let DevelopedWidth::Own { k } = subject.set.section.developed_width else { return Vec::new() };
    if (0.0..=1.0).contains(&k) {
        return Vec::new();
    }
    let message = format!("The factor k of the developed width is {k}; it must be 0 to 1.");
    vec![Diagnostic::error("developed-width", Place::Document, message)]
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_outside_the_strip() {
        for (k, count) in [(-0.01, 1), (0.0, 0), (0.44, 0), (1.0, 0), (1.01, 1)] {
            let mut set = vee(&[90.0]);
            set.section.developed_width = DevelopedWidth::Own { k };
            assert_eq!(found(check, &set).len(), count, "{k}");
        }
    }
}
