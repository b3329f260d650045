//! A wall stands between its neighbours: it begins on the diameter where the row before ends and ends where the next begins.

use crate::diagnostic::{Column, Diagnostic};
use crate::part::check::{Row, Table};
use crate::part::shape::{self, SAME_PLACE_MM};

/// Walls with an end that meets no neighbour; the face of the profile goes between the neighbours.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let rows: Vec<&Row> = table.curves().map(|(row, _)| row).collect();
    let walls = rows.iter().enumerate().filter(|(_, row)| shape::is_face_row(&row.section));
    walls
        .flat_map(|(index, wall)| {
            let before = index.checked_sub(1).and_then(|i| rows.get(i));
            let next = rows.get(index + 1);
            let (start, end) = shape::ends(&wall.section);
            [
                before.map(|row| (*row, Column::D1, start, shape::ends(&row.section).1)),
                next.map(|row| (*row, Column::D2, end, shape::ends(&row.section).0)),
            ]
            .into_iter()
            .flatten()
            .filter(|(_, _, own, other)| own.distance(*other) > SAME_PLACE_MM)
            .map(|(row, column, own, other)| report(table, wall, row, column, (own.z, own.r), (other.z, other.r)))
            .collect::<Vec<_>>()
        })
        .collect()
}

fn report(
    table: &Table<'_>,
    wall: &Row,
    neighbour: &Row,
    column: Column,
    own: (f64, f64),
    other: (f64, f64),
) -> Diagnostic {
    let place = |(z, r): (f64, f64)| format!("{}, ⌀ {}", table.length(z), table.length(2.0 * r));
    let (own, other, number) = (place(own), place(other), neighbour.number);
    let message = format!("The wall's end at {own} does not meet section {number} at {other}.");
    Diagnostic::warning("wall-apart", wall.at(column), message)
        .with_hint("Give both the same position and diameter; the face is cut between the neighbouring sections.")
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    fn rows(d1: f64, d2: f64) -> Vec<Section> {
        vec![
            Section::line(1, 0.0, 20.0, 10.0, 20.0),
            Section::line(2, 10.0, d1, 10.0, d2),
            Section::line(3, 10.0, 12.0, 100.0, 12.0),
        ]
    }

    #[test]
    fn fires_at_the_end_that_meets_nothing() {
        assert_eq!(places(&check(&table(&part(rows(20.0, 14.0))))), [(2, Column::D2)]);
        assert_eq!(places(&check(&table(&part(rows(19.0, 12.0))))), [(2, Column::D1)]);
    }

    #[test]
    fn says_nothing_about_a_wall_between_its_neighbours() {
        assert!(check(&table(&part(rows(20.0, 12.0)))).is_empty());
    }
}
