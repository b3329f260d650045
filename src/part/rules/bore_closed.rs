//! A bore is cut from an end of the part: it must come out there, and at the free end if only that is machined.

use crate::diagnostic::{Column, Diagnostic};
use crate::document::Ends;
use crate::part::check::{Row, Table};
use crate::part::shape::{SAME_PLACE_MM, is_usable};

/// A bore that no tool can enter.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let length = table.part.length;
    let rows: Vec<&Row> = table.bored_rows().map(|(row, _)| row).collect();
    let from = rows.iter().map(|row| row.section.z1).fold(f64::INFINITY, f64::min);
    let last = rows.iter().max_by(|a, b| a.section.z2.total_cmp(&b.section.z2));
    let Some(last) = last.filter(|_| is_usable(length)) else { return Vec::new() };
    let open_behind = from <= SAME_PLACE_MM && table.part.ends != Ends::One;
    let through_hole = table.hole_radius() > SAME_PLACE_MM;
    if last.section.z2 >= length - SAME_PLACE_MM || open_behind || through_hole {
        return Vec::new();
    }
    let (end, free) = (table.length(last.section.z2), table.length(length));
    let clamped = from <= SAME_PLACE_MM;
    let message = if clamped {
        format!("The bore ends at {end} and comes out at the clamped end only; the free end at {free} is machined.")
    } else {
        format!("The bore ends at {end}, before the free end at {free}, and comes out nowhere.")
    };
    let hint =
        if clamped { "Machine both ends, or turn the part round." } else { "Let the bore reach an end of the part." };
    vec![Diagnostic::error("bore-closed", last.at(Column::Z2), message).with_hint(hint)]
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_for_a_hollow_and_for_a_hole_in_the_clamped_end() {
        let hollow = bored(vec![Section::line(1, 20.0, 10.0, 50.0, 10.0)]);
        assert_eq!(places(&check(&bore_table(&hollow))), [(1, Column::Z2)]);
        let behind = bored(vec![Section::line(1, 0.0, 10.0, 50.0, 10.0)]);
        assert!(check(&bore_table(&behind))[0].message.contains("clamped end only"));
    }

    #[test]
    fn says_nothing_about_a_hole_that_a_tool_enters() {
        let part = bored(vec![Section::line(1, 20.0, 10.0, 100.0, 10.0)]);
        assert!(check(&bore_table(&part)).is_empty());
        let behind = bored(vec![Section::line(1, 0.0, 10.0, 50.0, 10.0)]);
        let both = TurnedPart { ends: Ends::Two { split: Some(50.0) }, ..behind.clone() };
        assert!(check(&bore_table(&both)).is_empty());
        assert!(check(&bore_table(&TurnedPart { stock_bore_diameter: 6.0, ..behind })).is_empty());
    }
}
