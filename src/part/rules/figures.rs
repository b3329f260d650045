//! Every figure must be a number that can be calculated with: a NaN would spread through everything derived.

use crate::diagnostic::{Diagnostic, Place, SectionTable};
use crate::part::check::Table;
use crate::part::shape::{LARGEST_FIGURE_MM, is_usable};

/// Figures that are not numbers, infinite, or beyond what any lathe holds.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let rows = table.all_rows.iter().flat_map(|row| row.figures().into_iter().map(|(c, value)| (row.at(c), value)));
    let part = &table.part;
    let stock = [part.bar_diameter, part.length, part.stock_bore_diameter, part.facing_allowance];
    let stock = stock.map(|value| (Place::Stock, value));
    let tolerances = table.tolerances().into_iter().map(|(_, value)| (Place::Document, value));
    let of_part = stock.into_iter().chain(tolerances).filter(|_| table.side == SectionTable::Outside);
    let all = rows.chain(of_part);
    all.filter(|(_, value)| !is_usable(*value)).map(|(at, value)| report(table, at, value)).collect()
}

fn report(table: &Table<'_>, at: Place, value: f64) -> Diagnostic {
    let limit = table.length(LARGEST_FIGURE_MM);
    let message = if value.is_finite() {
        format!("The figure {value:e} mm is beyond {limit}, the most that is calculated with.")
    } else {
        format!("A figure is not a number; it must lie between −{limit} and {limit}.")
    };
    Diagnostic::error("figure", at, message).with_hint("Enter the figure again.")
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;
    use crate::diagnostic::Column;

    #[test]
    fn fires_at_the_cell() {
        let found = check(&table(&part(vec![Section::line(4, 0.0, f64::NAN, 1e300, 10.0)])));
        assert_eq!(places(&found), [(1, Column::D1), (1, Column::Z2)]);
    }

    #[test]
    fn fires_for_the_bar() {
        let found = check(&table(&TurnedPart { bar_diameter: f64::INFINITY, ..part(vec![]) }));
        assert_eq!(found[0].at, Place::Stock);
    }

    #[test]
    fn says_nothing_about_ordinary_figures() {
        assert!(check(&table(&part(vec![Section::line(1, 0.0, 10.0, 10.0, 10.0)]))).is_empty());
    }
}
