//! Bar and part must have a size: everything is measured against them.

use crate::diagnostic::{Diagnostic, Place};
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, is_usable};

/// A bar without diameter or a part without length.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let part = &table.part;
    [("bar", "a diameter", part.bar_diameter), ("part", "a length", part.length)]
        .into_iter()
        .filter(|(_, _, value)| is_usable(*value) && *value <= SAME_PLACE_MM)
        .map(|(what, measure, value)| {
            let message = format!("The {what} has {measure} of {}; it must be above 0.", table.length(value));
            Diagnostic::error("stock-size", Place::Stock, message)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_each_figure() {
        let empty = TurnedPart { bar_diameter: 0.0, length: -1.0, ..part(vec![]) };
        assert_eq!(check(&table(&empty)).len(), 2);
    }

    #[test]
    fn says_nothing_about_a_bar() {
        assert!(check(&table(&part(vec![]))).is_empty());
    }
}
