//! A control that steps both axes cannot hold a taper that is nearly a cylinder or nearly a face.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::SectionKind;
use crate::part::check::Table;
use crate::part::shape::SAME_PLACE_MM;

/// Tapers with one leg too many times longer than the other.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let limit = table.machine.limits.taper_ratio;
    let lines = table.curves().filter(|(row, _)| row.section.kind == SectionKind::Line);
    let tapers = lines.map(|(row, curve)| {
        let legs = curve.end() - curve.start();
        (row, legs.x.abs(), legs.y.abs())
    });
    tapers
        .filter(|(_, along, across)| along.min(*across) > SAME_PLACE_MM)
        .filter(|(_, along, across)| along.max(*across) / along.min(*across) >= limit)
        .map(|(row, along, across)| {
            let ratio = along.max(across) / along.min(across);
            let (along, across, name) = (table.length(along), table.length(across), &table.machine.name);
            let message = format!(
                "The taper has a ratio of {ratio:.1}:1 ({along} along, {across} on the radius); {name} cuts tapers \
                 below {limit:.0}:1."
            );
            Diagnostic::error("taper", row.at(Column::D2), message).with_hint("Make it a cylinder, or steeper.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_at_the_limit() {
        let found = check(&table(&part(vec![Section::line(1, 0.0, 20.0, 20.0, 18.0)])));
        assert_eq!(places(&found), [(1, Column::D2)]);
        assert!(found[0].message.contains("20.0:1"));
    }

    #[test]
    fn says_nothing_about_cylinders_and_steeper_tapers() {
        let rows = vec![Section::line(1, 0.0, 20.0, 20.0, 17.9), Section::line(2, 20.0, 20.0, 90.0, 20.0)];
        assert!(check(&table(&part(rows))).is_empty());
    }
}
