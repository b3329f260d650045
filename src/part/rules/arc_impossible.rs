//! An arc joins two points only if its diameter is at least their distance.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::ShapeFault;

/// Arcs whose chord is longer than twice their radius.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let impossible = table.faults().filter_map(|(row, fault)| match fault {
        ShapeFault::ArcImpossible { chord } => Some((row, chord)),
        _ => None,
    });
    impossible
        .map(|(row, chord)| {
            let (length, smallest) = (table.length(chord), table.length(chord / 2.0));
            let message = format!(
                "The ends are {length} apart (on the radius); an arc between them needs a radius of at least {smallest}. \
                 A straight line stands in for it."
            );
            Diagnostic::error("arc-impossible", row.at(Column::Radius), message)
                .with_hint("Enter a larger radius, or move the ends closer together.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_at_the_radius() {
        let found = check(&table(&part(vec![convex(4.9, 10.0, 20.0, 20.0)])));
        assert_eq!(places(&found), [(1, Column::Radius)]);
        assert!(found[0].message.contains("10.000 mm") && found[0].message.contains("5.000 mm"));
    }

    #[test]
    fn says_nothing_about_half_a_circle() {
        assert!(check(&table(&part(vec![convex(5.0, 10.0, 20.0, 20.0)]))).is_empty());
    }
}
