//! Sections lie between the clamped end and the end of the part; what is beyond would be cut off the profile.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, is_usable};

/// Rows that begin before the clamped end or end beyond the part.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let length = table.part.length;
    if !is_usable(length) {
        return Vec::new();
    }
    let ends = table.rows().flat_map(|row| [(row, Column::Z1, row.section.z1), (row, Column::Z2, row.section.z2)]);
    ends.filter(|(_, _, z)| *z < -SAME_PLACE_MM || *z > length + SAME_PLACE_MM)
        .map(|(row, column, z)| {
            let (z, from, to) = (table.length(z), table.length(0.0), table.length(length));
            let message = format!("The position {z} is outside the part, which reaches from {from} to {to}.");
            Diagnostic::error("outside-part", row.at(column), message)
                .with_hint("Move the end of the section, or change the length of the part.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_at_both_ends() {
        let rows = vec![Section::line(1, -1.0, 20.0, 50.0, 20.0), Section::line(2, 50.0, 20.0, 100.1, 20.0)];
        assert_eq!(places(&check(&table(&part(rows)))), [(1, Column::Z1), (2, Column::Z2)]);
    }

    #[test]
    fn says_nothing_within_the_part() {
        assert!(check(&table(&part(vec![Section::line(1, 0.0, 20.0, 100.0, 20.0)]))).is_empty());
    }
}
