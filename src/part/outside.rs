//! The outside of a part in document positions, from its section table.

use super::envelope::{Run, Surface, runs};
use super::shape::{self, SAME_PLACE_MM};
use super::{Curve, Piece, PieceRole, Section, SectionKind};
use crate::diagnostic::SectionTable;
use crate::geometry::Point;

/// Row id of pieces that no row describes.
pub(super) const NO_SECTION: u32 = 0;

/// The connected outside from position 0 to `length`, both in mm, without the face of either end.
///
/// Impossible rows and gaps become straight fillers; beyond the last row the part has no radius. A table without a
/// usable row leaves the bar as it is.
pub(super) fn outside(sections: &[Section], length: f64, bar_radius: f64) -> Vec<Piece> {
    let surfaces = surfaces(sections);
    let walls = walls(sections);
    let runs = runs(SectionTable::Outside, &surfaces, 0.0, length);
    let mut pieces: Vec<Piece> = Vec::with_capacity(runs.len());
    for (index, run) in runs.iter().enumerate() {
        let next = runs.get(index + 1).and_then(|run| run.surface.map(|s| (s, run.z1)));
        let piece = piece_of(run, pieces.last(), next, bar_radius);
        append(&mut pieces, piece, &walls);
    }
    pieces
}

/// The rows that stand for a face each. They shape nothing, but the face between their neighbours is their piece.
pub(super) fn walls(sections: &[Section]) -> Vec<Section> {
    sections.iter().filter(|s| shape::is_face_row(s) && shape::curve(s).is_ok()).cloned().collect()
}

/// The face of the profile at `from.z` from one radius to another, divided among the rows that stand for it, in the order
/// of the table; what no row claims belongs to `section`.
pub(super) fn faces(walls: &[Section], from: Point, to_r: f64, section: u32) -> Vec<Piece> {
    let face = |from: Point, r: f64, section| Piece {
        curve: Curve::line(from, Point::new(from.z, r)),
        section,
        role: PieceRole::Face,
    };
    let mut at = from;
    let mut pieces = Vec::new();
    for wall in walls.iter().filter(|w| (w.z1 - from.z).abs() <= SAME_PLACE_MM) {
        let r = (wall.d2 / 2.0).clamp(at.r.min(to_r), at.r.max(to_r));
        if (r - at.r).abs() > SAME_PLACE_MM {
            // A last sliver is rounding of the table and no face of its own.
            let r = if (r - to_r).abs() <= SAME_PLACE_MM { to_r } else { r };
            pieces.push(face(at, r, wall.id));
            at.r = r;
        }
    }
    if (at.r - to_r).abs() > SAME_PLACE_MM {
        pieces.push(face(at, to_r, section));
    }
    pieces
}

/// The surfaces of all rows that have one, in order of position.
pub(super) fn surfaces(sections: &[Section]) -> Vec<Surface> {
    let mut surfaces: Vec<Surface> = sections.iter().filter(|s| !shape::is_face_row(s)).filter_map(surface).collect();
    surfaces.sort_by(|a, b| a.curve.start().z.total_cmp(&b.curve.start().z));
    surfaces
}

fn surface(section: &Section) -> Option<Surface> {
    let role = if matches!(section.kind, SectionKind::Thread { .. }) { PieceRole::Thread } else { PieceRole::Surface };
    match shape::curve(section) {
        Ok(curve) => Some(Surface { curve, section: section.id, role }),
        Err(fault) if fault.keeps_ends() => {
            let (start, end) = shape::ends(section);
            Some(Surface { curve: Curve::line(start, end), section: section.id, role: PieceRole::Filler })
        }
        Err(_) => None,
    }
}

/// The piece of one run: its surface, a filler between its neighbours, or no radius beyond the last row.
fn piece_of(run: &Run<'_>, before: Option<&Piece>, next: Option<(&Surface, f64)>, bar_radius: f64) -> Piece {
    if let Some(surface) = run.surface {
        return Piece { curve: surface.curve.between(run.z1, run.z2), section: surface.section, role: surface.role };
    }
    let r_before = before.map(|piece| piece.end().r);
    let r_next = next.map(|(surface, z)| surface.curve.radius_at(z));
    let line = |r1, r2| Curve::line(Point::new(run.z1, r1), Point::new(run.z2, r2));
    let filler = |curve, section| Piece { curve, section, role: PieceRole::Filler };
    match (before, next) {
        (None, None) => filler(line(bar_radius, bar_radius), NO_SECTION),
        (Some(last), None) => Piece { curve: line(0.0, 0.0), section: last.section, role: PieceRole::Surface },
        (_, Some((surface, _))) => {
            let r2 = r_next.unwrap_or(bar_radius);
            filler(line(r_before.unwrap_or(r2), r2), surface.section)
        }
    }
}

/// Adds a piece, with a face before it where the radius steps.
pub(super) fn append(pieces: &mut Vec<Piece>, piece: Piece, walls: &[Section]) {
    let Some(end) = pieces.last().map(Piece::end) else {
        pieces.push(piece);
        return;
    };
    if (end.r - piece.start().r).abs() <= SAME_PLACE_MM {
        pieces.push(Piece { curve: piece.curve.starting_at(end), ..piece });
    } else {
        pieces.extend(faces(walls, end, piece.start().r, piece.section));
        pieces.push(piece);
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures;
    use super::*;
    use crate::geometry::Segment;

    fn roles(pieces: &[Piece]) -> Vec<(u32, PieceRole)> {
        pieces.iter().map(|p| (p.section, p.role)).collect()
    }

    #[test]
    fn sections_of_different_diameter_have_a_face_between_them() {
        let rows = [Section::line(1, 0.0, 20.0, 10.0, 20.0), Section::line(2, 10.0, 12.0, 30.0, 12.0)];
        let pieces = outside(&rows, 30.0, 13.0);
        assert_eq!(roles(&pieces), [(1, PieceRole::Surface), (2, PieceRole::Face), (2, PieceRole::Surface)]);
    }

    #[test]
    fn face_rows_are_the_faces_that_they_describe() {
        let rows = [
            Section::line(1, 0.0, 20.0, 10.0, 20.0),
            Section::line(2, 10.0, 20.0, 10.0, 16.0),
            Section::line(3, 10.0, 16.0, 10.0, 12.0),
            Section::line(4, 10.0, 12.0, 30.0, 12.0),
        ];
        let pieces = outside(&rows, 30.0, 13.0);
        let expected = [(1, PieceRole::Surface), (2, PieceRole::Face), (3, PieceRole::Face), (4, PieceRole::Surface)];
        assert_eq!(roles(&pieces), expected);
        assert_eq!(pieces[1].end(), Point::new(10.0, 8.0));
        let without: Vec<Section> = rows.iter().filter(|r| r.id == 1 || r.id == 4).cloned().collect();
        assert_eq!(outside(&without, 30.0, 13.0)[1].end(), pieces[2].end());
    }

    #[test]
    fn a_face_row_that_goes_too_far_is_cut_off_at_its_neighbours() {
        let rows = [
            Section::line(1, 0.0, 20.0, 10.0, 20.0),
            Section::line(2, 10.0, 24.0, 10.0, 4.0),
            Section::line(3, 10.0, 12.0, 30.0, 12.0),
        ];
        let pieces = outside(&rows, 30.0, 13.0);
        assert_eq!((pieces[1].start().r, pieces[1].end().r), (10.0, 6.0));
        assert_eq!(pieces.len(), 3);
    }

    #[test]
    fn a_gap_is_filled_straight_and_the_excess_is_machined_away() {
        let rows = [Section::line(2, 12.0, 12.0, 28.0, 12.0), Section::line(1, 0.0, 20.0, 10.0, 20.0)];
        let pieces = outside(&rows, 30.0, 13.0);
        let expected = [
            (1, PieceRole::Surface),
            (2, PieceRole::Filler),
            (2, PieceRole::Surface),
            (2, PieceRole::Face),
            (2, PieceRole::Surface),
        ];
        assert_eq!(roles(&pieces), expected);
        assert_eq!(pieces[4].end(), Point::new(30.0, 0.0));
    }

    #[test]
    fn the_smaller_radius_of_overlapping_sections_is_the_outside() {
        let rows = [Section::line(1, 0.0, 10.0, 20.0, 10.0), Section::line(2, 10.0, 14.0, 20.0, 4.0)];
        let pieces = outside(&rows, 20.0, 13.0);
        assert_eq!(roles(&pieces), [(1, PieceRole::Surface), (2, PieceRole::Surface)]);
        assert!(pieces[0].end().distance(Point::new(14.0, 5.0)) < 1e-12);
    }

    #[test]
    fn sphere_of_the_master_part_takes_the_end_of_its_thread() {
        let master = fixtures::master();
        let pieces = outside(&master.sections, master.length, master.bar_diameter / 2.0);
        let last_two = &roles(&pieces)[pieces.len() - 2..];
        assert_eq!(last_two, [(6, PieceRole::Thread), (7, PieceRole::Surface)]);
        assert!((pieces[pieces.len() - 1].start().z - 34.0).abs() < 1e-5);
        assert!(matches!(pieces[pieces.len() - 1].curve, Curve::Segment(Segment::Arc { .. })));
    }

    #[test]
    fn an_impossible_arc_is_replaced_by_its_chord() {
        let rows = [Section { kind: SectionKind::Convex { radius: 1.0 }, ..Section::line(1, 0.0, 20.0, 10.0, 10.0) }];
        let pieces = outside(&rows, 10.0, 13.0);
        assert_eq!(roles(&pieces), [(1, PieceRole::Filler)]);
        assert!((pieces[0].curve.radius_at(5.0) - 7.5).abs() < 1e-12);
    }

    #[test]
    fn without_rows_the_bar_is_left() {
        let pieces = outside(&[], 10.0, 13.0);
        assert_eq!(pieces[0].end(), Point::new(10.0, 13.0));
    }
}
