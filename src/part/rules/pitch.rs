//! A control cuts threads of a limited range of pitches; what it couples to the spindle is the lead of one turn.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::SectionKind;
use crate::part::check::Table;
use crate::part::shape::SAME_PLACE_MM;

/// Threads with a lead that the machine cannot cut.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let limits = &table.machine.limits;
    let (least, most) = (limits.pitch_min_mm, limits.pitch_max_mm);
    let threads = table.rows().filter_map(|row| match row.section.kind {
        SectionKind::Thread { pitch, starts } => Some((row, starts, pitch * f64::from(starts.max(1)))),
        _ => None,
    });
    threads
        .filter(|(_, _, lead)| *lead < least - SAME_PLACE_MM || *lead > most + SAME_PLACE_MM)
        .map(|(row, starts, lead)| {
            let (lead, least, most) = (table.length(lead), table.length(least), table.length(most));
            let name = &table.machine.name;
            let measured = if starts > 1 {
                format!("The thread's lead over its {starts} starts is {lead}")
            } else {
                format!("The thread's pitch is {lead}")
            };
            let message = format!("{measured}; {name} cuts pitches from {least} to {most}.");
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
    fn fires_for_the_lead_of_several_starts() {
        let row = Section { kind: SectionKind::Thread { pitch: 2.0, starts: 2 }, ..thread(12.0, 10.0, 2.0) };
        let found = check(&table(&part(vec![row])));
        assert!(found[0].message.contains("2 starts is 4.000 mm"));
    }

    #[test]
    fn says_nothing_within_it() {
        assert!(check(&table(&part(vec![thread(12.0, 10.0, 0.35), thread(12.0, 10.0, 3.5)]))).is_empty());
    }
}
