//! The profile as lines and arcs that the control knows: parabolas become chords or tangent arcs.

use crate::document::{ParabolaCut, TurnedPart};
use crate::geometry::{Point, Segment};
use crate::machine::Machine;
use crate::part::{Curve, Parabola, Piece, Setup, contour};

/// The segments of the set-up's profile in order of z.
pub(super) fn segments(setup: &Setup, part_mm: &TurnedPart, machine: &Machine) -> Vec<Segment> {
    match part_mm.generator.parabolas() {
        ParabolaCut::Chords => setup.profile.pieces.iter().flat_map(|p| piece_with_chords(p, setup, part_mm)).collect(),
        ParabolaCut::Arcs { tolerance } => {
            let arcs = contour(&setup.profile, tolerance).contour.segments;
            arcs.into_iter().map(|s| flat_as_line(s, machine.limits.arc_radius_max_mm)).collect()
        }
    }
}

/// An arc that is flatter than the control can cut is a line.
fn flat_as_line(segment: Segment, largest_radius: f64) -> Segment {
    if segment.radius().is_some_and(|r| r > largest_radius) {
        Segment::line(segment.start(), segment.end())
    } else {
        segment
    }
}

fn piece_with_chords(piece: &Piece, setup: &Setup, part_mm: &TurnedPart) -> Vec<Segment> {
    match piece.curve {
        Curve::Segment(segment) => vec![segment],
        Curve::Parabola(parabola) => {
            let row = row_limits(piece.section, setup, part_mm).unwrap_or((parabola.start.z, parabola.end.z));
            chords(&parabola, row)
        }
    }
}

/// Where the whole row lies along z in the set-up: a parabola that is cut short by a neighbour keeps the chords of its row.
fn row_limits(section: u32, setup: &Setup, part_mm: &TurnedPart) -> Option<(f64, f64)> {
    let row = part_mm.sections.iter().find(|s| s.id == section)?;
    let place = |z: f64| if setup.turned_round { setup.length - z } else { z };
    let (a, b) = (place(row.z1), place(row.z2));
    Some((a.min(b), a.max(b)))
}

/// Chords between corners that divide the row into equal widths along z; corners outside the piece are left out.
fn chords(parabola: &Parabola, row: (f64, f64)) -> Vec<Segment> {
    /// Corners nearer than this to an end of the piece are that end, mm.
    const AT_END_MM: f64 = 1e-6;
    let count = parabola.chords.max(1);
    let (start, end) = (parabola.start, parabola.end);
    let curve = Curve::Parabola(*parabola);
    let inner = (1..count)
        .map(|k| row.0 + (row.1 - row.0) * f64::from(k) / f64::from(count))
        .filter(|&z| z > start.z + AT_END_MM && z < end.z - AT_END_MM)
        .map(|z| Point::new(z, curve.radius_at(z)));
    let corners: Vec<Point> = std::iter::once(start).chain(inner).chain([end]).collect();
    corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::ParabolaAxis;

    /// z = 0.5·r² from (0.5, 1) to (8, 4).
    fn along_z() -> Parabola {
        Parabola::through(Point::new(0.5, 1.0), Point::new(8.0, 4.0), ParabolaAxis::AlongZ, 0.5, 5)
    }

    #[test]
    fn chords_have_equal_widths_and_their_corners_on_the_parabola() {
        let lines = chords(&along_z(), (0.5, 8.0));
        assert_eq!(lines.len(), 5);
        for line in &lines {
            assert!((line.end().z - line.start().z - 1.5).abs() < 1e-12);
            assert!((0.5 * line.end().r.powi(2) - line.end().z).abs() < 1e-9);
        }
    }

    #[test]
    fn a_shortened_parabola_keeps_the_corners_of_its_row() {
        let whole = chords(&along_z(), (0.5, 8.0));
        let short = Parabola { end: Point::new(4.5, 3.0), ..along_z() };
        let lines = chords(&short, (0.5, 8.0));
        assert_eq!(lines.len(), 3);
        assert_eq!(lines[..2], whole[..2]);
    }
}
