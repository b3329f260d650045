//! Material for facing lies in front of the free end, and the tools start in front of it.

use crate::diagnostic::{Diagnostic, Place};
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, is_usable};

/// An allowance below nothing, or beyond where the tools start.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let (allowance, start) = (table.part.facing_allowance, table.machine.datum.axial_clearance_mm);
    if !is_usable(allowance) || (0.0..start - SAME_PLACE_MM).contains(&allowance) {
        return Vec::new();
    }
    let (allowance, zero, start) = (table.length(allowance), table.length(0.0), table.length(start));
    let message = format!(
        "The facing allowance is {allowance}; it must be {zero} to less than {start}, where the tools start in front of \
         the free end."
    );
    vec![
        Diagnostic::error("facing-allowance", Place::Stock, message)
            .with_hint("Enter 0 for stock of the part's length."),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    fn with_allowance(facing_allowance: f64) -> TurnedPart {
        TurnedPart { facing_allowance, ..part(vec![]) }
    }

    #[test]
    fn fires_below_zero_and_at_the_start_of_the_tools() {
        assert_eq!(check(&table(&with_allowance(-0.1))).len(), 1);
        assert!(check(&table(&with_allowance(20.0)))[0].message.contains("20.000 mm"));
    }

    #[test]
    fn says_nothing_between_them() {
        assert!(check(&table(&with_allowance(0.0))).is_empty() && check(&table(&with_allowance(2.0))).is_empty());
    }
}
