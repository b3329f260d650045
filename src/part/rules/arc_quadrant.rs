//! Some generators and controls cut an arc of at most a quarter turn.
//!
//! The published QUEEN has arcs that cross the border of two quadrants, so that the sweep is what counts.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::Curve;
use crate::part::check::Table;

/// Rounding the ends of a 2 mm arc by 0.001 mm turns it by 0.03°, degrees.
const ROUNDING_DEG: f64 = 0.05;

/// Arcs that sweep more than a quarter turn on a machine with that limit.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    if !table.machine.limits.arc_one_quadrant {
        return Vec::new();
    }
    let sweeps = table.curves().filter_map(|(row, curve)| match curve {
        Curve::Segment(segment) => Some((row, segment.sweep().abs().to_degrees())),
        Curve::Parabola(_) => None,
    });
    sweeps
        .filter(|(_, sweep)| *sweep > 90.0 + ROUNDING_DEG)
        .map(|(row, sweep)| {
            let name = &table.machine.name;
            let message = format!("The arc turns by {sweep:.1}°; {name} cuts at most 90° in one arc.");
            Diagnostic::error("arc-quadrant", row.at(Column::Radius), message)
                .with_hint("Divide the arc into two rows.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_half_a_circle() {
        let found = check(&table(&part(vec![convex(5.0, 10.0, 20.0, 20.0)])));
        assert_eq!(places(&found), [(1, Column::Radius)]);
        assert!(found[0].message.contains("180.0°"));
    }

    #[test]
    fn says_nothing_about_a_quarter_or_without_the_limit() {
        assert!(check(&table(&part(vec![convex(5.0, 5.0, 10.0, 0.0)]))).is_empty());
        let mut free = crate::part::fixtures::orac();
        free.limits.arc_one_quadrant = false;
        let part = part(vec![convex(5.0, 10.0, 20.0, 20.0)]);
        assert!(check(&Table::new(&part, crate::units::Unit::Mm, &free)).is_empty());
    }
}
