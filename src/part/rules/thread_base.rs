//! An outside thread is cut into its outside cylinder, so its base is the smaller diameter.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::SectionKind;
use crate::part::check::Table;

/// Threads whose base diameter is not below their outside diameter.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let threads = table.rows().filter(|row| matches!(row.section.kind, SectionKind::Thread { .. }));
    threads
        .filter(|row| row.section.d2 >= row.section.d1)
        .map(|row| {
            let (outside, base) = (table.length(row.section.d1), table.length(row.section.d2));
            let message =
                format!("The thread's base diameter is {base}; it must be below the outside diameter, {outside}.");
            Diagnostic::error("thread-base", row.at(Column::D2), message)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_when_base_and_outside_are_equal() {
        assert_eq!(places(&check(&table(&part(vec![thread(12.0, 12.0, 1.75)])))), [(1, Column::D2)]);
    }

    #[test]
    fn says_nothing_about_a_thread() {
        assert!(check(&table(&part(vec![thread(12.0, 10.0, 1.75)]))).is_empty());
    }
}
