//! What has to be said about an outline so that it can be made: diameters, radii, chamfers, threads and positions.

use super::figure;
use super::outline::{Outline, SAME_MM, is_cylinder, is_face};
use crate::geometry::{Point, Segment};
use crate::papers::number::number;
use crate::part::{Curve, Piece, PieceRole, Section};
use crate::units::Unit;

/// Difference of rise and run of a chamfer that is still 45°, mm.
const CHAMFER_MM: f64 = 0.002;

/// A figure and the place of the outline that it belongs to, mm of the part.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mark {
    /// The place.
    pub(super) at: Point,
    /// How its line leaves the place.
    pub(super) line: Line,
    /// The figure.
    pub(super) text: String,
}

/// The line from a place to its figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Line {
    /// A leader that points at the surface; it leaves a little towards smaller (−1) or larger (1) positions, or straight (0).
    Leader(f64),
    /// An extension line of a running dimension.
    Extension,
}

impl Line {
    /// To which side the line leaves its place: −1, 0 or 1.
    pub(super) const fn lean(self) -> f64 {
        match self {
            Self::Leader(side) => side,
            Self::Extension => 0.0,
        }
    }
}

/// The table that an outline is made from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a> {
    /// Rows, mm.
    pub(super) rows_mm: &'a [Section],
    /// True for a bore.
    pub(super) inside: bool,
    /// Unit of the figures.
    pub(super) unit: Unit,
}

/// Diameters, radii, chamfers and threads, in order of position.
///
/// A cylinder is told once. Where two pieces meet their diameter is told unless a cylinder or a 45° chamfer beside it tells it.
pub(super) fn leaders(outline: &Outline, source: Source<'_>) -> Vec<Mark> {
    let pieces = &outline.pieces;
    let mut marks: Vec<Mark> = Vec::new();
    let mut told = std::collections::BTreeSet::new();
    for (piece, neighbours) in pieces.iter().zip(neighbours(pieces)) {
        // An arc that others interrupt is one row and one radius.
        let first_of_row = told.insert((piece.section, piece.role == PieceRole::Face));
        marks.extend(surface(piece, neighbours, source).filter(|_| first_of_row || is_cylinder(piece)));
    }
    marks.extend(meetings(pieces).iter().filter_map(|meeting| corner(meeting, source.unit)));
    marks.sort_by(|a, b| a.at.z.total_cmp(&b.at.z).then(a.at.r.total_cmp(&b.at.r)));
    marks.dedup_by(|a, b| a.text == b.text && a.at.distance(b.at) < SAME_MM);
    marks
}

/// Positions where the outline changes, counted from the clamped end, each at its largest radius.
pub(super) fn positions(outline: &Outline, unit: Unit) -> Vec<Mark> {
    let pieces = &outline.pieces;
    let meetings = meetings(pieces);
    let told = meetings.iter().filter(|meeting| !meeting.is_inner_end_of_chamfer());
    let mut points: Vec<Point> = told.map(|meeting| meeting.at).collect();
    points.sort_by(|a, b| a.z.total_cmp(&b.z).then(b.r.total_cmp(&a.r)));
    points.dedup_by(|a, b| (a.z - b.z).abs() < SAME_MM);
    points.into_iter().map(|at| Mark { at, line: Line::Extension, text: number(at.z, unit) }).collect()
}

/// The pieces before and behind a piece.
type Neighbours<'a> = (Option<&'a Piece>, Option<&'a Piece>);

/// What is told about a piece itself.
fn surface(piece: &Piece, neighbours: Neighbours<'_>, source: Source<'_>) -> impl Iterator<Item = Mark> {
    let mark = |at: Point, text: String| Some(Mark { at, line: Line::Leader(0.0), text });
    let (start, end) = (piece.start(), piece.end());
    let middle = Point::new(f64::midpoint(start.z, end.z), f64::midpoint(start.r, end.r));
    let told = match piece.curve {
        Curve::Segment(_) if piece.role == PieceRole::Thread => {
            let row = source.rows_mm.iter().find(|row| row.id == piece.section);
            row.and_then(|row| mark(middle, figure::thread(row, source.inside, source.unit)))
        }
        _ if is_face(piece) => None,
        _ if is_cylinder(piece) => mark(middle, figure::diameter(start.r, source.unit)),
        _ if is_chamfer(piece, neighbours) => mark(middle, figure::chamfer(end.z - start.z, source.unit)),
        Curve::Segment(segment @ Segment::Arc { .. }) => {
            let radius = number(segment.radius().unwrap_or_default(), source.unit);
            mark(segment.point_at(0.5), format!("R {radius}"))
        }
        Curve::Segment(Segment::Line { .. }) => None,
        Curve::Parabola(parabola) => mark(parabola.point_at(0.5), figure::parabola(&parabola, source.unit)),
    };
    told.into_iter()
}

/// The diameter where two pieces meet, if nothing else tells it.
fn corner(meeting: &Meeting<'_>, unit: Unit) -> Option<Mark> {
    let Meeting { at, before, after, chamfer } = *meeting;
    // Where a face ends at the hole of a bore or of a tube, the table of the bore tells the diameter.
    let at_hole = (before.is_none() || after.is_none()) && meeting.pieces().any(is_face);
    let told = meeting.pieces().any(|piece| is_cylinder(piece) || piece.role == PieceRole::Thread);
    if at.r < SAME_MM || told || at_hole || chamfer {
        return None;
    }
    // A leader must not run along a face that rises from here: it leaves to the other side.
    let rises = |face: &Piece| is_face(face) && face.start().r.max(face.end().r) > at.r + SAME_MM;
    let line = match (before, after) {
        (_, Some(face)) if rises(face) => Line::Leader(-1.0),
        (Some(face), _) if rises(face) => Line::Leader(1.0),
        _ => Line::Leader(0.0),
    };
    Some(Mark { at, line, text: figure::diameter(at.r, unit) })
}

/// A place where two pieces meet, or an end of the outline.
struct Meeting<'a> {
    at: Point,
    before: Option<&'a Piece>,
    after: Option<&'a Piece>,
    /// One of the two is a 45° chamfer.
    chamfer: bool,
}

impl<'a> Meeting<'a> {
    fn pieces(&self) -> impl Iterator<Item = &'a Piece> {
        [self.before, self.after].into_iter().flatten()
    }

    /// True where a chamfer meets its cylinder: its length tells this position.
    fn is_inner_end_of_chamfer(&self) -> bool {
        self.chamfer && self.before.is_some() && self.after.is_some() && !self.pieces().any(is_face)
    }
}

/// Every place where pieces meet, the ends of the outline included.
fn meetings(pieces: &[Piece]) -> Vec<Meeting<'_>> {
    let chamfers: Vec<bool> =
        pieces.iter().zip(neighbours(pieces)).map(|(piece, beside)| is_chamfer(piece, beside)).collect();
    let piece = |k: Option<usize>| k.and_then(|k| Some((pieces.get(k)?, *chamfers.get(k)?)));
    let meeting = |k: usize| {
        let (before, after) = (piece(k.checked_sub(1)), piece(Some(k)));
        let at = before.map(|(p, _)| p.end()).or(after.map(|(p, _)| p.start()))?;
        let chamfer = [before, after].into_iter().flatten().any(|(_, chamfer)| chamfer);
        Some(Meeting { at, before: before.map(|b| b.0), after: after.map(|a| a.0), chamfer })
    };
    (0..=pieces.len()).filter_map(meeting).collect()
}

/// What stands before and behind every piece.
fn neighbours(pieces: &[Piece]) -> impl Iterator<Item = Neighbours<'_>> {
    (0..pieces.len()).map(|k| (k.checked_sub(1).and_then(|i| pieces.get(i)), pieces.get(k + 1)))
}

/// True for a 45° line between a cylinder and a face or the end of the part.
fn is_chamfer(piece: &Piece, (before, after): Neighbours<'_>) -> bool {
    let (start, end) = (piece.start(), piece.end());
    let straight = matches!(piece.curve, Curve::Segment(Segment::Line { .. })) && !is_face(piece);
    let slope = ((end.z - start.z) - (end.r - start.r).abs()).abs() < CHAMFER_MM && end.z - start.z > SAME_MM;
    let round = |piece: Option<&Piece>| piece.is_some_and(|p| is_cylinder(p) || p.role == PieceRole::Thread);
    let flat = |piece: Option<&Piece>| piece.is_none_or(is_face);
    straight && slope && ((round(before) && flat(after)) || (flat(before) && round(after)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::PartContour;
    use crate::part::Profile;

    fn outline(points: &[(f64, f64)]) -> Outline {
        let points: Vec<Point> = points.iter().map(|(z, d)| Point::new(*z, d / 2.0)).collect();
        let piece = |(section, pair): (u32, &[Point])| Piece {
            curve: Curve::line(pair[0], pair[1]),
            section,
            role: if pair[0].z == pair[1].z { PieceRole::Face } else { PieceRole::Surface },
        };
        let profile = Profile { pieces: (1..).zip(points.windows(2)).map(piece).collect() };
        Outline::new(&profile, &PartContour::default())
    }

    fn texts(marks: &[Mark]) -> Vec<&str> {
        marks.iter().map(|m| m.text.as_str()).collect()
    }

    const SOURCE: Source<'static> = Source { rows_mm: &[], inside: false, unit: Unit::Mm };

    #[test]
    fn cylinders_are_told_once_and_chamfers_by_their_length() {
        let part =
            outline(&[(0.0, 20.0), (4.0, 20.0), (10.0, 20.0), (10.0, 12.0), (28.0, 12.0), (30.0, 8.0), (30.0, 0.0)]);
        assert_eq!(texts(&leaders(&part, SOURCE)), ["Ø 20", "Ø 12", "2 × 45°"]);
        assert_eq!(texts(&positions(&part, Unit::Mm)), ["0", "10", "30"]);
        assert_eq!(positions(&part, Unit::Mm)[1].at.r, 10.0, "from the larger diameter");
    }

    #[test]
    fn a_taper_is_told_by_both_ends_and_a_leader_keeps_off_the_face() {
        let part = outline(&[(0.0, 20.0), (10.0, 14.0), (10.0, 30.0), (20.0, 30.0), (20.0, 0.0)]);
        let marks = leaders(&part, SOURCE);
        assert_eq!(texts(&marks), ["Ø 20", "Ø 14", "Ø 30"]);
        assert_eq!(marks[1].line, Line::Leader(-1.0), "the face rises behind it");
        assert_eq!(texts(&positions(&part, Unit::Mm)), ["0", "10", "20"]);
    }
}
