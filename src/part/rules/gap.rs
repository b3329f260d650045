//! Between the clamped end and the last section every position needs a section; what lies in a gap can only be guessed.
//! A bore may begin anywhere: before its first section the material is solid.

use crate::diagnostic::{Column, Diagnostic, SectionTable};
use crate::part::check::{Row, Table};
use crate::part::shape::SAME_PLACE_MM;

/// Gaps between rows, and before the first one; the profile is filled straight there.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let ranges = table.ranges();
    let mut covered = match table.side {
        SectionTable::Outside => 0.0,
        SectionTable::Bore => ranges.first().map_or(0.0, |(_, z1, _)| *z1),
    };
    let mut before: Option<&Row> = None;
    let mut found = Vec::new();
    for (row, z1, z2) in ranges {
        if z1 > covered + SAME_PLACE_MM {
            found.push(report(table, row, before, covered, z1));
        }
        if z2 > covered {
            (covered, before) = (z2, Some(row));
        }
    }
    found
}

fn report(table: &Table<'_>, row: &Row, before: Option<&Row>, from: f64, to: f64) -> Diagnostic {
    let (from, to, width) = (table.length(from), table.length(to), table.length(to - from));
    let message = format!("No section covers {from} to {to}: a gap of {width}, where 0 is allowed.");
    let gap = Diagnostic::error("gap", row.at(Column::Z1), message)
        .with_hint("Begin this section where the one before it ends, or add a row between them.");
    before.map_or(gap.clone(), |before| gap.with_related(before.at(Column::Z2)))
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_between_two_rows_in_any_order() {
        let rows = vec![Section::line(2, 12.0, 10.0, 20.0, 10.0), Section::line(1, 0.0, 10.0, 10.0, 10.0)];
        let found = check(&table(&part(rows)));
        assert_eq!(places(&found), [(1, Column::Z1)]);
        assert!(found[0].message.contains("2.000 mm"));
        assert_eq!(found[0].related.len(), 1);
    }

    #[test]
    fn fires_before_the_first_row() {
        assert_eq!(check(&table(&part(vec![Section::line(1, 1.0, 10.0, 10.0, 10.0)]))).len(), 1);
    }

    #[test]
    fn fires_between_the_rows_of_a_bore_and_not_before_them() {
        let rows = vec![Section::line(1, 50.0, 8.0, 60.0, 8.0), Section::line(2, 61.0, 10.0, 100.0, 10.0)];
        assert_eq!(places(&check(&bore_table(&bored(rows)))), [(2, Column::Z1)]);
    }

    #[test]
    fn says_nothing_about_touching_rows() {
        let rows = vec![Section::line(1, 0.0, 10.0, 10.0, 10.0), Section::line(2, 10.0, 10.0, 20.0, 10.0)];
        assert!(check(&table(&part(rows))).is_empty());
    }
}
