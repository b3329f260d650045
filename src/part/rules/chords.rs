//! A parabola is cut with a number of chords: at least one, and no more than a program can hold by far.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::SectionKind;
use crate::part::check::Table;

/// Most chords of one parabola; ten full programs of 99 pages.
const MOST: u32 = 1000;

/// Parabolas with no or far too many chords.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let parabolas = table.rows().filter_map(|row| match row.section.kind {
        SectionKind::ParabolaAlongZ { chords, .. } | SectionKind::ParabolaAlongX { chords, .. } => Some((row, chords)),
        _ => None,
    });
    parabolas
        .filter(|(_, chords)| !(1..=MOST).contains(chords))
        .map(|(row, chords)| {
            let message = format!("The parabola has {chords} chords; 1 to {MOST} are possible.");
            Diagnostic::error("chords", row.at(Column::Chords), message).with_hint("A chord of 1 mm is usual.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    fn with_chords(chords: u32) -> TurnedPart {
        let kind = SectionKind::ParabolaAlongX { z3: 5.0, d3: 9.0, chords };
        part(vec![Section { kind, ..Section::line(1, 0.0, 10.0, 10.0, 5.0) }])
    }

    #[test]
    fn fires_outside_the_range() {
        assert_eq!(places(&check(&table(&with_chords(0)))), [(1, Column::Chords)]);
        assert_eq!(places(&check(&table(&with_chords(1001)))), [(1, Column::Chords)]);
    }

    #[test]
    fn says_nothing_within_it() {
        assert!(check(&table(&with_chords(1))).is_empty() && check(&table(&with_chords(1000))).is_empty());
    }
}
