//! A thread is cut into its cylinder, so its base is the smaller diameter outside and the larger one in a bore.

use crate::diagnostic::{Column, Diagnostic, SectionTable};
use crate::part::SectionKind;
use crate::part::check::Table;

/// Threads whose base diameter lies on the wrong side of the diameter before they are cut.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let threads = table.rows().filter(|row| matches!(row.section.kind, SectionKind::Thread { .. }));
    let wrong = threads.filter(|row| match row.side {
        SectionTable::Outside => row.section.d2 >= row.section.d1,
        SectionTable::Bore => row.section.d2 <= row.section.d1,
    });
    wrong
        .map(|row| {
            let (surface, base) = (table.length(row.section.d1), table.length(row.section.d2));
            let message = match row.side {
                SectionTable::Outside => {
                    format!("The thread's base diameter is {base}; it must be below the outside diameter, {surface}.")
                }
                SectionTable::Bore => format!(
                    "The inside thread's major diameter is {base}; it must be above the minor diameter, {surface}, to \
                     which it is bored before."
                ),
            };
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

    #[test]
    fn looks_the_other_way_in_a_bore() {
        assert_eq!(places(&check(&bore_table(&bored(vec![thread(12.0, 10.0, 1.75)])))), [(1, Column::D2)]);
        assert!(check(&bore_table(&bored(vec![thread(10.2, 12.0, 1.75)]))).is_empty());
    }
}
