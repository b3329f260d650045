//! Turning only takes away: no section can be wider than the bar.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::{self, SAME_PLACE_MM, is_usable};

/// Rows that are somewhere wider than the bar.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let bar = table.part.bar_diameter;
    if !is_usable(bar) {
        return Vec::new();
    }
    let widest = table.rows().map(|row| {
        let (start, end) = shape::ends(&row.section);
        let highest = row.curve.as_ref().map_or(start.r.max(end.r), |curve| curve.bounds().max.r);
        let column = match () {
            () if start.r >= highest => Column::D1,
            () if end.r >= highest => Column::D2,
            () => row.shaping_column(),
        };
        (row, column, 2.0 * highest)
    });
    widest
        .filter(|(_, _, diameter)| *diameter > bar + SAME_PLACE_MM)
        .map(|(row, column, diameter)| {
            let (diameter, bar) = (table.length(diameter), table.length(bar));
            let message = format!("The section's largest diameter is {diameter}; the bar has {bar}.");
            Diagnostic::error("above-bar", row.at(column), message)
                .with_hint("Use a thicker bar, or a smaller diameter.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_at_the_end_or_at_the_bulge_that_is_too_wide() {
        let rows = vec![Section::line(1, 0.0, 20.0, 10.0, 26.3), convex(6.0, 10.0, 22.0, 22.0)];
        assert_eq!(places(&check(&table(&part(rows)))), [(1, Column::D2), (2, Column::Radius)]);
    }

    #[test]
    fn says_nothing_about_the_bar_itself() {
        assert!(check(&table(&part(vec![Section::line(1, 0.0, 26.2, 10.0, 26.2)]))).is_empty());
    }
}
