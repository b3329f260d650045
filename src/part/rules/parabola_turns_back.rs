//! A parabola along z turns back at its vertex; beyond it the profile would have two radii at one position.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::Table;
use crate::part::shape::ShapeFault;

/// Parabolas whose vertex lies between their ends.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let back = table.faults().filter_map(|(row, fault)| match fault {
        ShapeFault::ParabolaTurnsBack { vertex } => Some((row, 2.0 * vertex)),
        _ => None,
    });
    back.map(|(row, vertex)| {
        let (vertex, d1, d2) = (table.length(vertex), table.length(row.section.d1), table.length(row.section.d2));
        let message = format!(
            "The parabola turns back at diameter {vertex}, between its ends at {d1} and {d2}. A straight line stands in \
             for it."
        );
        Diagnostic::error("parabola-turns-back", row.at(Column::D3), message)
            .with_hint("Enter another third point, or divide the row at the vertex.")
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_a_vertex_between_the_ends() {
        assert_eq!(places(&check(&table(&part(vec![along_z(12.0, 7.0)])))), [(1, Column::D3)]);
    }

    #[test]
    fn says_nothing_when_the_vertex_lies_beyond() {
        assert!(check(&table(&part(vec![along_z(5.5, 7.5)]))).is_empty());
    }
}
