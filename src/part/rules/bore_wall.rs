//! Between bore and outside a wall must remain; only at the two ends of the part may they meet in an edge.

use crate::diagnostic::{Column, Diagnostic, Place};
use crate::part::bore::bore;
use crate::part::check::Table;
use crate::part::outside::{NO_SECTION, outside};
use crate::part::shape::{SAME_PLACE_MM, is_usable};
use crate::part::{Curve, Piece, PieceRole};
use std::collections::BTreeMap;

/// Places between the ends of two curves at which their distance is looked at.
const SAMPLES: u32 = 16;

/// Rows of the bore that leave no wall, each with its thinnest place.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let part = &table.part;
    if !is_usable(part.length) || part.length <= 0.0 || !is_usable(part.bar_diameter) {
        return Vec::new();
    }
    let inside = bore(&part.bore, part.length, table.hole_radius());
    let outside = outside(&part.sections, part.length, part.bar_diameter / 2.0);
    let mut thinnest: BTreeMap<u32, Thinnest> = BTreeMap::new();
    // A face ends where the surfaces beside it do.
    for piece in inside.iter().filter(|piece| piece.role != PieceRole::Face) {
        if let Some(found) = thinnest_under(piece, &outside, part.length) {
            let known = thinnest.entry(piece.section).or_insert(found);
            if found.wall() < known.wall() {
                *known = found;
            }
        }
    }
    thinnest.into_iter().map(|(section, place)| report(table, section, place)).collect()
}

/// A place with too thin a wall, mm.
#[derive(Clone, Copy)]
struct Thinnest {
    z: f64,
    inside: f64,
    outside: f64,
}

impl Thinnest {
    fn wall(&self) -> f64 {
        self.outside - self.inside
    }
}

/// The thinnest place over a piece of the bore if no wall is left there.
fn thinnest_under(piece: &Piece, outside: &[Piece], length: f64) -> Option<Thinnest> {
    let (from, to) = (piece.start().z, piece.end().z);
    let over = outside.iter().filter(|o| o.end().z >= from && o.start().z <= to);
    let places = over.flat_map(|o| stops(&piece.curve, &o.curve).into_iter().map(move |z| (z, o)));
    let walls = places.map(|(z, o)| Thinnest { z, inside: piece.curve.radius_at(z), outside: o.curve.radius_at(z) });
    let too_thin = |t: &Thinnest| {
        let at_end = t.z <= SAME_PLACE_MM || t.z >= length - SAME_PLACE_MM;
        t.wall() < if at_end { -SAME_PLACE_MM } else { SAME_PLACE_MM }
    };
    walls.filter(too_thin).min_by(|a, b| a.wall().total_cmp(&b.wall()))
}

/// Positions in the common range of two curves at which their distance is looked at: ends, turning points and some between.
fn stops(a: &Curve, b: &Curve) -> Vec<f64> {
    let (from, to) = (a.start().z.max(b.start().z), a.end().z.min(b.end().z));
    let between = (1..SAMPLES).map(|k| from + (to - from) * f64::from(k) / f64::from(SAMPLES));
    let turning = [a, b].into_iter().filter_map(Curve::turning_point_z).filter(|z| (from..=to).contains(z));
    [from, to].into_iter().chain(turning).chain(between).collect()
}

fn report(table: &Table<'_>, section: u32, place: Thinnest) -> Diagnostic {
    let (z, inside, outside) =
        (table.length(place.z), table.length(2.0 * place.inside), table.length(2.0 * place.outside));
    let row = table.all_rows.iter().find(|row| row.section.id == section).filter(|_| section != NO_SECTION);
    let (what, at) = row.map_or(("hole of the stock", Place::Stock), |row| ("bore", row.at(Column::D1)));
    let message = format!(
        "At {z} the {what} has a diameter of {inside}, the outside {outside}; a wall of more than {} must remain.",
        table.length(0.0)
    );
    Diagnostic::error("bore-wall", at, message).with_hint("Make the bore smaller there, or the outside larger.")
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;

    #[test]
    fn fires_where_the_bore_breaks_through() {
        let rows = vec![Section::line(1, 0.0, 10.0, 50.0, 10.0), Section::line(2, 50.0, 10.0, 80.0, 28.0)];
        let found = check(&bore_table(&bored([rows, vec![Section::line(3, 80.0, 10.0, 100.0, 10.0)]].concat())));
        assert_eq!(places(&found), [(2, Column::D1)]);
        assert!(found[0].message.contains("80.000 mm") && found[0].message.contains("28.000 mm"));
    }

    #[test]
    fn fires_for_the_hole_of_a_tube() {
        let mut part = TurnedPart { stock_bore_diameter: 12.0, ..bored(vec![]) };
        part.sections[0].d2 = 8.0;
        assert_eq!(check(&bore_table(&part))[0].at, Place::Stock);
    }

    #[test]
    fn says_nothing_about_a_wall_or_an_edge_at_the_end() {
        let part = bored(vec![Section::line(1, 0.0, 10.0, 90.0, 10.0), Section::line(2, 90.0, 10.0, 100.0, 26.2)]);
        assert!(check(&bore_table(&part)).is_empty());
    }
}
