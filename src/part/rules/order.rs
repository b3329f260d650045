//! Positions of a row must grow from its first to its second one, as the table counts from the clamped end.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::ShapeFault;

/// Rows that run backwards or have no width; they are left out of the profile.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let backwards = table.faults().filter(|(_, fault)| *fault == ShapeFault::Order);
    backwards
        .map(|(row, _)| {
            let (z1, z2) = (table.length(row.section.z1), table.length(row.section.z2));
            let message = format!("The section ends at {z2}, which is not beyond its start at {z1}.");
            Diagnostic::error("order", row.at(Column::Z2), message)
                .with_hint("Exchange the two ends, or delete the row if it is only a face: faces are implied.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_a_row_without_width() {
        assert_eq!(places(&check(&table(&part(vec![Section::line(1, 5.0, 10.0, 5.0, 8.0)])))), [(1, Column::Z2)]);
    }

    #[test]
    fn says_nothing_about_a_growing_row() {
        assert!(check(&table(&part(vec![Section::line(1, 5.0, 10.0, 5.1, 8.0)]))).is_empty());
    }
}
