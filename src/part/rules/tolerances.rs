//! A tolerance of zero can never be met, and a negative one means nothing.

use crate::diagnostic::{Diagnostic, Place};
use crate::part::check::Table;
use crate::part::shape::is_usable;

/// Tolerances that are not above zero.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let tolerances = table.tolerances().into_iter();
    tolerances
        .filter(|(_, tolerance)| is_usable(*tolerance) && *tolerance <= 0.0)
        .map(|(what, tolerance)| {
            let message = format!("The {what} tolerance is {}; it must be above 0.", table.length(tolerance));
            Diagnostic::error("tolerance", Place::Document, message)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;
    use crate::document::{Generator, ParabolaCut};

    #[test]
    fn fires_for_zero() {
        assert_eq!(check(&table(&TurnedPart { form_tolerance: 0.0, ..part(vec![]) })).len(), 1);
        let generator = Generator::Oracap { parabolas: ParabolaCut::Arcs { tolerance: -1.0 }, optimize: true };
        assert_eq!(check(&table(&TurnedPart { generator, ..part(vec![]) })).len(), 1);
    }

    #[test]
    fn says_nothing_about_a_tolerance() {
        assert!(check(&table(&part(vec![]))).is_empty());
    }
}
