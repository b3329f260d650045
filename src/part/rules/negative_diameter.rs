//! A diameter on the part cannot be negative; only the third point of a parabola may lie beyond the axis.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;

/// Negative diameters at the ends of rows.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let ends = table.rows().flat_map(|row| [(row, Column::D1, row.section.d1), (row, Column::D2, row.section.d2)]);
    ends.filter(|(_, _, diameter)| *diameter < 0.0)
        .map(|(row, column, diameter)| {
            let message = format!("The diameter is {}; it must not be below 0.", table.length(diameter));
            Diagnostic::error("negative-diameter", row.at(column), message)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_at_the_column() {
        assert_eq!(places(&check(&table(&part(vec![Section::line(1, 0.0, 10.0, 5.0, -0.1)])))), [(1, Column::D2)]);
    }

    #[test]
    fn says_nothing_about_the_third_point_of_a_parabola() {
        let kind = SectionKind::ParabolaAlongZ { z3: 0.0, d3: -10.0, chords: 10 };
        assert!(check(&table(&part(vec![Section { kind, ..Section::line(1, 0.0, 10.0, 10.0, 0.0) }]))).is_empty());
    }
}
