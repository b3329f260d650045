//! Sections may overlap, as in the published master part, and the smaller radius is cut; more often it is a slip.

use crate::diagnostic::{Column, Diagnostic, SectionTable};
use crate::part::check::{Row, Table};
use crate::part::shape::{SAME_PLACE_MM, is_face_row};

/// Rows that begin before another one has ended.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let mut reaching: Option<(&Row, f64)> = None;
    let mut found = Vec::new();
    for (row, z1, z2) in table.ranges().into_iter().filter(|(row, ..)| !is_face_row(&row.section)) {
        if let Some((before, end)) = reaching.filter(|(_, end)| z1 < end - SAME_PLACE_MM) {
            found.push(report(table, row, before, end.min(z2) - z1));
        }
        if reaching.is_none_or(|(_, end)| z2 > end) {
            reaching = Some((row, z2));
        }
    }
    found
}

fn report(table: &Table<'_>, row: &Row, before: &Row, width: f64) -> Diagnostic {
    let (width, number) = (table.length(width), before.number);
    let cut = match table.side {
        SectionTable::Outside => "smaller",
        SectionTable::Bore => "larger",
    };
    let message = format!("The section overlaps section {number} by {width}; the {cut} radius is cut there.");
    Diagnostic::warning("overlap", row.at(Column::Z1), message)
        .with_hint("Begin this section where the other one ends, unless the overlap is meant.")
        .with_related(before.at(Column::Z2))
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_once_a_row_with_the_other_row_related() {
        let rows = vec![Section::line(1, 0.0, 10.0, 12.0, 10.0), Section::line(2, 10.0, 10.0, 20.0, 10.0)];
        let found = check(&table(&part(rows)));
        assert_eq!(places(&found), [(2, Column::Z1)]);
        assert!(found[0].message.contains("2.000 mm"));
        assert_eq!(found[0].severity, crate::diagnostic::Severity::Warning);
    }

    #[test]
    fn fires_in_the_bore_where_the_larger_radius_is_cut() {
        let rows = vec![Section::line(1, 0.0, 10.0, 12.0, 10.0), Section::line(2, 10.0, 10.0, 20.0, 10.0)];
        let found = check(&bore_table(&bored(rows)));
        assert!(found[0].message.contains("larger"));
    }

    #[test]
    fn says_nothing_about_touching_rows() {
        let rows = vec![Section::line(1, 0.0, 10.0, 10.0, 10.0), Section::line(2, 10.0, 10.0, 20.0, 10.0)];
        assert!(check(&table(&part(rows))).is_empty());
    }
}
