//! The hole of a tube lies within its wall, and no bore can be smaller than the hole that is there.

use crate::diagnostic::{Column, Diagnostic, Place};
use crate::part::check::Table;
use crate::part::shape::{SAME_PLACE_MM, is_usable};

/// A hole that no bar has, and rows of the bore that it is too large for.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let (hole, bar) = (table.part.stock_bore_diameter, table.part.bar_diameter);
    if !is_usable(hole) || !is_usable(bar) {
        return Vec::new();
    }
    if hole < 0.0 || (hole > 0.0 && hole >= bar) {
        let (hole, zero, bar) = (table.length(hole), table.length(0.0), table.length(bar));
        let message = format!("The hole in the stock has a diameter of {hole}; it must be {zero} to less than {bar}.");
        return vec![Diagnostic::error("stock-bore", Place::Stock, message).with_hint("Enter 0 for solid bar.")];
    }
    let narrow = table.curves().map(|(row, curve)| (row, curve.start().r, 2.0 * curve.bounds().min.r));
    narrow
        .filter(|(_, _, least)| *least < hole - SAME_PLACE_MM)
        .map(|(row, start, least)| {
            let column = if 2.0 * start <= least + SAME_PLACE_MM { Column::D1 } else { Column::D2 };
            let (hole, least) = (table.length(hole), table.length(least));
            let message = format!("The bore has a diameter of {least}; the hole in the stock has {hole} already.");
            Diagnostic::error("stock-bore", row.at(column), message)
                .with_hint("Use stock with a smaller hole, or widen the bore.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    fn tube(stock_bore_diameter: f64) -> TurnedPart {
        TurnedPart { stock_bore_diameter, ..bored(vec![Section::line(1, 0.0, 12.0, 100.0, 10.0)]) }
    }

    #[test]
    fn fires_for_a_hole_that_is_larger_than_the_bore() {
        assert_eq!(places(&check(&bore_table(&tube(10.1)))), [(1, Column::D2)]);
    }

    #[test]
    fn fires_for_a_hole_that_no_bar_has() {
        assert_eq!(check(&bore_table(&tube(-1.0)))[0].at, Place::Stock);
        assert_eq!(check(&bore_table(&tube(26.2)))[0].at, Place::Stock);
    }

    #[test]
    fn says_nothing_about_a_hole_within_the_bore() {
        assert!(check(&bore_table(&tube(10.0))).is_empty() && check(&bore_table(&tube(0.0))).is_empty());
    }
}
