//! A thread has at least one start, and not more than any catalogue of threads lists.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::{STARTS, SectionKind};

/// Threads with no or far too many starts.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let threads = table.rows().filter_map(|row| match row.section.kind {
        SectionKind::Thread { starts, .. } => Some((row, starts)),
        _ => None,
    });
    threads
        .filter(|(_, starts)| !STARTS.contains(starts))
        .map(|(row, starts)| {
            let (least, most) = (STARTS.start(), STARTS.end());
            let message = format!("The thread has {starts} starts; {least} to {most} are possible.");
            Diagnostic::error("starts", row.at(Column::Starts), message).with_hint("An ordinary thread has 1 start.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    fn with_starts(starts: u32) -> TurnedPart {
        part(vec![Section { kind: SectionKind::Thread { pitch: 1.0, starts }, ..thread(12.0, 10.0, 1.0) }])
    }

    #[test]
    fn fires_outside_the_range() {
        assert_eq!(places(&check(&table(&with_starts(0)))), [(1, Column::Starts)]);
        assert_eq!(places(&check(&table(&with_starts(25)))), [(1, Column::Starts)]);
    }

    #[test]
    fn says_nothing_within_it() {
        assert!(check(&table(&with_starts(1))).is_empty() && check(&table(&with_starts(24))).is_empty());
    }
}
