//! Work between centres cannot be bored: the tailstock's centre stands in the hole.

use crate::diagnostic::{Column, Diagnostic};
use crate::document::Holding;
use crate::part::check::Table;

/// The first row of the bore that is to be cut between centres. A hole that the stock has already is no matter.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    if table.part.holding != Holding::BetweenCentres {
        return Vec::new();
    }
    let widest = table.bored_rows().max_by(|(_, a), (_, b)| a.bounds().max.r.total_cmp(&b.bounds().max.r));
    widest
        .map(|(row, curve)| {
            let (bore, hole) = (table.length(2.0 * curve.bounds().max.r), table.length(2.0 * table.hole_radius()));
            let message = format!(
                "The bore is cut to a diameter of {bore} where the stock has {hole}; between centres the tailstock stands \
                 in the way."
            );
            Diagnostic::error("bore-between-centres", row.at(Column::D1), message)
                .with_hint("Hold the work in the chuck, or use stock that is bored already.")
        })
        .into_iter()
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    fn between(stock_bore_diameter: f64) -> TurnedPart {
        let bore = vec![Section::line(1, 0.0, 10.0, 100.0, 10.0)];
        TurnedPart { holding: Holding::BetweenCentres, stock_bore_diameter, ..bored(bore) }
    }

    #[test]
    fn fires_for_a_bore_that_is_cut() {
        assert_eq!(places(&check(&bore_table(&between(8.0)))), [(1, Column::D1)]);
    }

    #[test]
    fn says_nothing_about_a_hole_on_a_mandrel_or_in_the_chuck() {
        assert!(check(&bore_table(&between(10.0))).is_empty());
        assert!(check(&bore_table(&TurnedPart { holding: Holding::Chuck, ..between(8.0) })).is_empty());
    }
}
