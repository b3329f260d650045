//! The published generator of the ORAC knows the outside of solid bar of the part's length and threads of one start.

use crate::diagnostic::{Column, Diagnostic, Place};
use crate::document::Generator;
use crate::part::SectionKind;
use crate::part::check::Table;
use crate::part::shape::is_usable;

const HINT: &str = "Let the planner make the program.";

/// What a part asks for that the published generator would leave uncut or cut wrongly.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    if !matches!(table.part.generator, Generator::Oracap { .. }) {
        return Vec::new();
    }
    let found = |at, message: String| Diagnostic::warning("published-generator", at, message).with_hint(HINT);
    let bored = table.bored_rows().next().map(|(row, curve)| {
        let diameter = table.length(2.0 * curve.bounds().max.r);
        found(row.at(Column::D1), format!("The published generator cuts no bore; this one of {diameter} is left."))
    });
    let allowance = Some(table.part.facing_allowance).filter(|a| is_usable(*a) && *a > 0.0 && table.side.is_outside());
    let facing = allowance.map(|allowance| {
        let allowance = table.length(allowance);
        found(Place::Stock, format!("The published generator does not face; the allowance of {allowance} is left."))
    });
    let starts = table.rows().filter_map(|row| match row.section.kind {
        SectionKind::Thread { starts, .. } if starts > 1 => {
            let message = format!("The thread has {starts} starts; the published generator cuts 1.");
            Some(found(row.at(Column::Starts), message))
        }
        _ => None,
    });
    bored.into_iter().chain(facing).chain(starts).collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    fn demanding() -> TurnedPart {
        let bore = vec![Section::line(1, 0.0, 10.0, 100.0, 10.0)];
        let kind = SectionKind::Thread { pitch: 1.0, starts: 2 };
        let sections = vec![Section { kind, ..thread(20.0, 18.0, 1.0) }];
        TurnedPart { sections, facing_allowance: 1.0, ..bored(bore) }
    }

    #[test]
    fn fires_for_bore_facing_and_starts() {
        assert_eq!(places(&check(&bore_table(&demanding()))), [(1, Column::D1)]);
        assert_eq!(places(&check(&table(&demanding()))), [(1, Column::Starts)]);
        assert_eq!(check(&table(&demanding())).len(), 2);
    }

    #[test]
    fn says_nothing_to_the_planner_or_about_plain_parts() {
        let planned = TurnedPart { generator: Generator::Planned { separate_programs: false }, ..demanding() };
        assert!(check(&table(&planned)).is_empty() && check(&bore_table(&planned)).is_empty());
        assert!(check(&table(&part(vec![thread(12.0, 10.0, 1.0)]))).is_empty());
    }
}
