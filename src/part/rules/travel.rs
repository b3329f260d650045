//! The slides of a machine have a limited travel, and every operation goes from the datum to the work and back.

use crate::diagnostic::{Diagnostic, Place};
use crate::document::Ends;
use crate::part::PART_OFF_WIDTH_MM;
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, is_usable};
use crate::part::split::split;

/// Parts that need a longer way than the slides have.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let (limits, datum) = (&table.machine.limits, &table.machine.datum);
    let across = table.part.bar_diameter / 2.0 + datum.radial_clearance_mm;
    let along = machined_length(table) + datum.axial_clearance_mm;
    [("across", across, limits.travel_x_mm), ("along the spindle", along, limits.travel_z_mm)]
        .into_iter()
        .filter(|(_, way, limit)| is_usable(*way) && *way > limit + SAME_PLACE_MM)
        .map(|(direction, way, limit)| {
            let (way, limit, name) = (table.length(way), table.length(limit), &table.machine.name);
            let message = format!("From the datum the tool must go {way} {direction}; {name} travels {limit}.");
            Diagnostic::error("travel", Place::Stock, message)
        })
        .collect()
}

/// The longest way from the free end that is machined in one clamping, mm.
fn machined_length(table: &Table<'_>) -> f64 {
    let part = &table.part;
    match part.ends {
        Ends::One if part.part_off => part.length + PART_OFF_WIDTH_MM,
        Ends::One => part.length,
        Ends::Two { .. } => {
            let (split, _) = split(part, part.length, table.machine);
            split.max(part.length - split)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_a_part_that_is_too_long() {
        let found = check(&table(&TurnedPart { length: 330.1, ..part(vec![]) }));
        assert_eq!(found.len(), 1);
        assert!(found[0].message.contains("350.100 mm along") && found[0].message.contains("350.000 mm"));
    }

    #[test]
    fn says_nothing_when_the_long_part_is_divided() {
        let ends = Ends::Two { split: Some(165.0) };
        assert!(check(&table(&TurnedPart { length: 330.1, ends, ..part(vec![]) })).is_empty());
        assert!(check(&table(&TurnedPart { length: 330.0, ..part(vec![]) })).is_empty());
    }
}
