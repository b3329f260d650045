//! A control cuts threads of a limited range of pitches.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::SectionKind;
use crate::part::check::Table;
use crate::part::shape::SAME_PLACE_MM;

/// Threads with a pitch that the machine cannot cut.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let limits = &table.machine.limits;
    let (least, most) = (limits.pitch_min_mm, limits.pitch_max_mm);
    let threads = table.rows().filter_map(|row| match row.section.kind {
        SectionKind::Thread { pitch } => Some((row, pitch)),
        _ => None,
    });
    threads
        .filter(|(_, pitch)| *pitch < least - SAME_PLACE_MM || *pitch > most + SAME_PLACE_MM)
        .map(|(row, pitch)| {
            let (pitch, least, most) = (table.length(pitch), table.length(least), table.length(most));
            let name = &table.machine.name;
            let message = format!("The thread's pitch is {pitch}; {name} cuts pitches from {least} to {most}.");
            Diagnostic::error("pitch", row.at(Column::Pitch), message)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_outside_the_range() {
        let rows = vec![thread(12.0, 10.0, 0.3), thread(12.0, 10.0, 4.0), thread(12.0, 10.0, -1.0)];
        assert_eq!(check(&table(&part(rows))).len(), 3);
    }

    #[test]
    fn says_nothing_within_it() {
        assert!(check(&table(&part(vec![thread(12.0, 10.0, 0.35), thread(12.0, 10.0, 3.5)]))).is_empty());
    }
}
