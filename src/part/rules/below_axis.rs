//! The outside of a part cannot lie below the spindle axis; hollow arcs and parabolas can dip there between their ends.

use crate::diagnostic::Diagnostic;
use crate::part::check::Table;
use crate::part::shape::ShapeFault;

/// Curves that cross the axis.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let below = table.faults().filter_map(|(row, fault)| match fault {
        ShapeFault::BelowAxis { lowest } => Some((row, lowest)),
        _ => None,
    });
    below
        .map(|(row, lowest)| {
            let depth = table.length(-lowest);
            let message =
                format!("The curve dips {depth} below the axis, where 0 is allowed. A straight line stands in for it.");
            Diagnostic::error("below-axis", row.at(row.shaping_column()), message)
                .with_hint("Enter a larger radius or another third point, or larger diameters at the ends.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;
    use crate::diagnostic::Column;

    #[test]
    fn fires_for_a_hollow_that_is_too_deep() {
        let kind = SectionKind::Concave { radius: 6.0 };
        let row = Section { kind, ..Section::line(1, 0.0, 4.0, 10.0, 4.0) };
        assert_eq!(places(&check(&table(&part(vec![row])))), [(1, Column::Radius)]);
    }

    #[test]
    fn says_nothing_about_a_shallow_hollow() {
        let kind = SectionKind::Concave { radius: 6.0 };
        assert!(check(&table(&part(vec![Section { kind, ..Section::line(1, 0.0, 8.0, 10.0, 8.0) }]))).is_empty());
    }
}
