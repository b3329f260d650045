//! Three points on a line make no parabola; the line is cut, which may or may not be meant.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, ShapeFault};

/// Parabolas whose three points lie on a line.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let straight = table.faults().filter(|(_, fault)| *fault == ShapeFault::ParabolaStraight);
    straight
        .map(|(row, _)| {
            let limit = table.length(SAME_PLACE_MM);
            let message =
                format!("The parabola's three points lie within {limit} of a straight line; the line is cut.");
            Diagnostic::warning("parabola-straight", row.at(Column::D3), message)
                .with_hint("Make the row a line, or enter another third point.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_points_on_a_line() {
        assert_eq!(places(&check(&table(&part(vec![along_x(5.0, 7.5)])))), [(1, Column::D3)]);
    }

    #[test]
    fn says_nothing_about_a_curve() {
        assert!(check(&table(&part(vec![along_x(5.0, 7.0)]))).is_empty());
    }
}
