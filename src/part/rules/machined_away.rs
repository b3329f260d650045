//! A part longer than its last section has no material there: the excess bar is machined away, as published.

use crate::diagnostic::{Column, Diagnostic, Severity};
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, is_usable};

/// A last section that ends before the part does.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let length = table.part.length;
    if !is_usable(length) {
        return Vec::new();
    }
    let last = table.ranges().into_iter().max_by(|a, b| a.2.total_cmp(&b.2));
    last.filter(|(_, _, end)| *end < length - SAME_PLACE_MM)
        .map(|(row, _, end)| {
            let (end, length, excess) = (table.length(end), table.length(length), table.length(length - end));
            let message = format!(
                "The last section ends at {end}, the part at {length}; the {excess} between them are machined away."
            );
            Diagnostic::new(Severity::Info, "machined-away", row.at(Column::Z2), message)
                .with_hint("Shorten the part, or add a section, if this is not meant.")
        })
        .into_iter()
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_the_last_row() {
        let found = check(&table(&part(vec![Section::line(1, 0.0, 20.0, 98.0, 20.0)])));
        assert_eq!(places(&found), [(1, Column::Z2)]);
        assert!(found[0].message.contains("2.000 mm"));
    }

    #[test]
    fn says_nothing_about_a_part_that_ends_with_its_last_row() {
        assert!(check(&table(&part(vec![Section::line(1, 0.0, 20.0, 100.0, 20.0)]))).is_empty());
    }
}
