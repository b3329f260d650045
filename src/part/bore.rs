//! The inside of a part in document positions, from the section table of its bore.

use super::envelope::{Run, runs};
use super::outside::{NO_SECTION, append, surfaces, walls};
use super::shape::SAME_PLACE_MM;
use super::{Curve, Piece, PieceRole, Section};
use crate::diagnostic::SectionTable;
use crate::geometry::Point;

/// The connected inside between position 0 and `length`, both in mm, without a face at an open end; empty in a solid part.
///
/// Where no row says anything the hole of the stock remains, `hole_radius`; a gap between rows becomes a straight filler.
/// The bottom of a blind hole is a face down to the axis.
pub(super) fn bore(sections: &[Section], length: f64, hole_radius: f64) -> Vec<Piece> {
    let rows: Vec<Section> = sections.iter().map(Section::seen_from_inside).collect();
    let (surfaces, walls) = (surfaces(&rows), walls(&rows));
    let runs = runs(SectionTable::Bore, &surfaces, 0.0, length);
    let mut pieces: Vec<Piece> = Vec::with_capacity(runs.len());
    for (index, run) in runs.iter().enumerate() {
        let piece = match run.surface {
            Some(surface) => {
                Piece { curve: surface.curve.between(run.z1, run.z2), section: surface.section, role: surface.role }
            }
            None => between_rows(run, index.checked_sub(1).and_then(|i| runs.get(i)), runs.get(index + 1), hole_radius),
        };
        append(&mut pieces, piece, &walls);
    }
    without_solid_ends(pieces)
}

/// The piece of a run without a row: a filler between two rows, the hole of the stock before the first and behind the last.
fn between_rows(run: &Run<'_>, before: Option<&Run<'_>>, next: Option<&Run<'_>>, hole_radius: f64) -> Piece {
    let row = |run: Option<&Run<'_>>, z: f64| run?.surface.map(|s| (s.curve.radius_at(z), s.section));
    let line = |r1, r2| Curve::line(Point::new(run.z1, r1), Point::new(run.z2, r2));
    match (row(before, run.z1), row(next, run.z2)) {
        (Some((r1, _)), Some((r2, section))) => Piece { curve: line(r1, r2), section, role: PieceRole::Filler },
        _ => Piece { curve: line(hole_radius, hole_radius), section: NO_SECTION, role: PieceRole::Surface },
    }
}

/// The pieces without the solid material, a line on the axis, at either end.
fn without_solid_ends(mut pieces: Vec<Piece>) -> Vec<Piece> {
    let solid = |piece: &Piece| piece.start().r <= SAME_PLACE_MM && piece.end().r <= SAME_PLACE_MM;
    while pieces.last().is_some_and(solid) {
        pieces.pop();
    }
    let first = pieces.iter().position(|piece| !solid(piece)).unwrap_or(pieces.len());
    pieces.split_off(first)
}

/// True if the bore comes out at position `z`, where it begins or ends.
pub(super) fn is_open_at(end: Option<Point>, z: f64) -> bool {
    end.is_some_and(|p| (p.z - z).abs() <= SAME_PLACE_MM && p.r > SAME_PLACE_MM)
}

/// Least and greatest position at which the bore is narrowest, and its radius there, mm.
pub(super) fn narrowest(pieces: &[Piece]) -> Option<(f64, f64, f64)> {
    let stops = pieces.iter().flat_map(|piece| {
        let turning = piece.curve.turning_point_z().map(|z| Point::new(z, piece.curve.radius_at(z)));
        [Some(piece.start()), Some(piece.end()), turning].into_iter().flatten()
    });
    let stops: Vec<Point> = stops.collect();
    let least = stops.iter().map(|p| p.r).reduce(f64::min)?;
    let mut there = stops.iter().filter(|p| p.r <= least + SAME_PLACE_MM).map(|p| p.z);
    let first = there.next()?;
    let (low, high) = there.fold((first, first), |(low, high), z| (low.min(z), high.max(z)));
    Some((low, high, least))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::SectionKind;

    fn ends(pieces: &[Piece]) -> (Point, Point) {
        (pieces[0].start(), pieces[pieces.len() - 1].end())
    }

    #[test]
    fn a_through_bore_has_open_ends_and_faces_between_its_steps() {
        let rows = [Section::line(1, 0.0, 8.0, 12.0, 8.0), Section::line(2, 12.0, 14.0, 30.0, 14.0)];
        let pieces = bore(&rows, 30.0, 0.0);
        assert_eq!(ends(&pieces), (Point::new(0.0, 4.0), Point::new(30.0, 7.0)));
        assert_eq!(pieces[1].role, PieceRole::Face);
        assert_eq!(narrowest(&pieces), Some((0.0, 12.0, 4.0)));
    }

    #[test]
    fn a_blind_hole_is_closed_at_its_bottom_from_either_end() {
        let pieces = bore(&[Section::line(1, 12.0, 8.0, 30.0, 8.0)], 30.0, 0.0);
        assert_eq!(ends(&pieces), (Point::new(12.0, 0.0), Point::new(30.0, 4.0)));
        let pieces = bore(&[Section::line(1, 0.0, 8.0, 12.0, 8.0)], 30.0, 0.0);
        assert_eq!(ends(&pieces), (Point::new(0.0, 4.0), Point::new(12.0, 0.0)));
    }

    #[test]
    fn the_point_of_a_drill_needs_no_face() {
        let rows = [Section::line(1, 10.0, 0.0, 12.0, 8.0), Section::line(2, 12.0, 8.0, 30.0, 8.0)];
        let pieces = bore(&rows, 30.0, 0.0);
        assert_eq!((pieces.len(), pieces[0].start()), (2, Point::new(10.0, 0.0)));
    }

    #[test]
    fn a_row_without_diameter_is_a_web_between_two_holes() {
        let rows = [
            Section::line(1, 0.0, 8.0, 10.0, 8.0),
            Section::line(2, 10.0, 0.0, 20.0, 0.0),
            Section::line(3, 20.0, 12.0, 30.0, 12.0),
        ];
        let pieces = bore(&rows, 30.0, 0.0);
        assert_eq!(pieces.len(), 5);
        assert_eq!(narrowest(&pieces), Some((10.0, 20.0, 0.0)));
    }

    #[test]
    fn the_hole_of_a_tube_remains_where_nothing_is_bored() {
        let pieces = bore(&[Section::line(1, 20.0, 16.0, 30.0, 16.0)], 30.0, 5.0);
        assert_eq!(ends(&pieces), (Point::new(0.0, 5.0), Point::new(30.0, 8.0)));
        assert_eq!(pieces[0].section, NO_SECTION);
        assert_eq!(bore(&[], 30.0, 5.0).len(), 1);
        assert!(bore(&[], 30.0, 0.0).is_empty());
    }

    #[test]
    fn the_larger_radius_of_overlapping_rows_is_the_bore_and_a_gap_is_filled() {
        let rows = [Section::line(1, 0.0, 8.0, 20.0, 8.0), Section::line(2, 10.0, 14.0, 30.0, 14.0)];
        let pieces = bore(&rows, 40.0, 0.0);
        assert_eq!(pieces[0].end(), Point::new(10.0, 4.0));
        let rows = [Section::line(1, 0.0, 8.0, 10.0, 8.0), Section::line(2, 20.0, 14.0, 40.0, 14.0)];
        let pieces = bore(&rows, 40.0, 0.0);
        assert_eq!((pieces[1].role, pieces[1].end()), (PieceRole::Filler, Point::new(20.0, 7.0)));
    }

    #[test]
    fn a_hollow_in_the_wall_has_its_centre_in_the_hole() {
        let hollow = Section { kind: SectionKind::Concave { radius: 10.0 }, ..Section::line(1, 0.0, 12.0, 16.0, 12.0) };
        let pieces = bore(&[hollow], 16.0, 0.0);
        assert!((pieces[0].curve.radius_at(8.0) - 10.0).abs() < 1e-9);
    }
}
