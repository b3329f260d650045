//! A control interpolates arcs of a limited range of radii.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::SectionKind;
use crate::part::check::Table;
use crate::part::shape::SAME_PLACE_MM;

/// Arcs with a radius that the machine cannot cut.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let limits = &table.machine.limits;
    let (least, most) = (limits.arc_radius_min_mm, limits.arc_radius_max_mm);
    let arcs = table.rows().filter_map(|row| match row.section.kind {
        SectionKind::Concave { radius } | SectionKind::Convex { radius } => Some((row, radius)),
        _ => None,
    });
    arcs.filter(|(_, radius)| *radius < least - SAME_PLACE_MM || *radius > most + SAME_PLACE_MM)
        .map(|(row, radius)| {
            let (radius, least, most) = (table.length(radius), table.length(least), table.length(most));
            let name = &table.machine.name;
            let message = format!("The arc's radius is {radius}; {name} cuts radii from {least} to {most}.");
            Diagnostic::error("arc-radius", row.at(Column::Radius), message)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_below_and_above_the_range() {
        let rows = vec![convex(1.9, 1.0, 10.0, 8.0), convex(3001.0, 5.0, 10.0, 8.0)];
        assert_eq!(places(&check(&table(&part(rows)))), [(1, Column::Radius), (2, Column::Radius)]);
    }

    #[test]
    fn says_nothing_about_the_limits_themselves() {
        assert!(check(&table(&part(vec![convex(2.0, 1.0, 10.0, 8.0), convex(3000.0, 5.0, 10.0, 8.0)]))).is_empty());
    }
}
