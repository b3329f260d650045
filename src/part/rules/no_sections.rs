//! A part needs at least one section: without any there is nothing to machine.

use crate::diagnostic::{Diagnostic, Place};
use crate::part::check::Table;

/// An empty table.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    if !table.all_rows.is_empty() {
        return Vec::new();
    }
    let message = "The table has 0 sections; a part needs at least 1.";
    vec![Diagnostic::error("no-sections", Place::Document, message).with_hint("Add a row to the section table.")]
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_an_empty_table() {
        assert_eq!(check(&table(&part(vec![]))).len(), 1);
    }

    #[test]
    fn says_nothing_about_one_section() {
        assert!(check(&table(&part(vec![Section::line(1, 0.0, 10.0, 10.0, 10.0)]))).is_empty());
    }
}
