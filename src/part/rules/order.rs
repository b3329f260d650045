//! Positions of a row must grow from its first to its second one, as the table counts from the clamped end.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::ShapeFault;

/// Rows that run backwards or have no width and are no wall; they are left out of the profile.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let backwards = table.faults().filter(|(_, fault)| *fault == ShapeFault::Order);
    backwards
        .map(|(row, _)| {
            let (z1, z2) = (table.length(row.section.z1), table.length(row.section.z2));
            let message = format!("The section ends at {z2}, which is not beyond its start at {z1}.");
            Diagnostic::error("order", row.at(Column::Z2), message).with_hint(
                "Exchange the two ends. Only a line may stand at one position, as a wall between two diameters.",
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_a_row_that_runs_backwards_and_for_an_arc_without_width() {
        let backwards = Section::line(1, 5.0, 10.0, 4.9, 8.0);
        assert_eq!(places(&check(&table(&part(vec![backwards, convex(9.0, 0.0, 10.0, 8.0)])))).len(), 2);
    }

    #[test]
    fn says_nothing_about_a_growing_row_or_a_wall() {
        let rows = vec![Section::line(1, 5.0, 10.0, 5.1, 8.0), Section::line(2, 5.1, 8.0, 5.1, 6.0)];
        assert!(check(&table(&part(rows))).is_empty());
    }
}
