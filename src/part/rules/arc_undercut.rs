//! An arc must not run back under itself: the profile has one radius at every position.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::ShapeFault;

/// Arcs that pass their vertical tangent.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let undercut = table.faults().filter_map(|(row, fault)| match fault {
        ShapeFault::ArcUndercut { overhang } => Some((row, overhang)),
        _ => None,
    });
    undercut
        .map(|(row, overhang)| {
            let overhang = table.length(overhang);
            let message = format!(
                "The arc reaches {overhang} beyond its own ends along the spindle, where 0 is allowed. A straight line \
                 stands in for it."
            );
            Diagnostic::error("arc-undercut", row.at(Column::Radius), message)
                .with_hint("Enter a larger radius, or end the arc where it is square to the spindle.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_an_arc_past_its_vertical_tangent() {
        assert_eq!(places(&check(&table(&part(vec![convex(5.0, 2.0, 2.0, 20.0)])))), [(1, Column::Radius)]);
    }

    #[test]
    fn says_nothing_about_a_quarter() {
        assert!(check(&table(&part(vec![convex(5.0, 5.0, 10.0, 0.0)]))).is_empty());
    }
}
