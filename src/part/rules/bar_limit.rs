//! The spindle and chuck of a machine take bars up to a diameter.

use crate::diagnostic::{Diagnostic, Place};
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, is_usable};

/// A bar that the machine cannot hold.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let (bar, limit) = (table.part.bar_diameter, table.machine.limits.bar_diameter_mm);
    if !is_usable(bar) || bar <= limit + SAME_PLACE_MM {
        return Vec::new();
    }
    let (bar, limit, name) = (table.length(bar), table.length(limit), &table.machine.name);
    let message = format!("The bar's diameter is {bar}; {name} takes bars up to {limit}.");
    vec![Diagnostic::error("bar-limit", Place::Stock, message)]
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_above_the_limit() {
        assert_eq!(check(&table(&TurnedPart { bar_diameter: 40.1, ..part(vec![]) })).len(), 1);
    }

    #[test]
    fn says_nothing_at_the_limit() {
        assert!(check(&table(&TurnedPart { bar_diameter: 40.0, ..part(vec![]) })).is_empty());
    }
}
