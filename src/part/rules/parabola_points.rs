//! A parabola needs three points with different positions (with the axis along z: different diameters).

use crate::diagnostic::{Column, Diagnostic};
use crate::part::SectionKind;
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, ShapeFault};

/// Parabolas through points that no parabola passes.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let without = table.faults().filter(|(_, fault)| *fault == ShapeFault::ParabolaWithoutPoints);
    without
        .map(|(row, _)| {
            let (column, what) = match row.section.kind {
                SectionKind::ParabolaAlongZ { .. } => (Column::D3, "diameters"),
                _ => (Column::Z3, "positions"),
            };
            let limit = table.length(SAME_PLACE_MM);
            let message = format!(
                "Two of the parabola's three {what} are the same (no further apart than {limit}), so none passes \
                 through all points. A straight line stands in for it."
            );
            Diagnostic::error("parabola-points", row.at(column), message).with_hint("Enter another third point.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_a_third_point_at_an_end() {
        assert_eq!(places(&check(&table(&part(vec![along_x(10.0, 5.0)])))), [(1, Column::Z3)]);
        assert_eq!(places(&check(&table(&part(vec![along_z(5.0, 10.0)])))), [(1, Column::D3)]);
    }

    #[test]
    fn says_nothing_about_three_points() {
        assert!(check(&table(&part(vec![along_x(5.0, 9.0), along_z(5.0, 6.0)]))).is_empty());
    }
}
