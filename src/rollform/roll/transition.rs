//! Arcs of the roll faces: concentric with the strip, and where the opening changes.

use super::face::{Face, NOTHING_MM, StripFace, name_of};
use crate::geometry::{Point, Segment};
use crate::rollform::strip::{Piece, along};

/// A piece that stands off the strip by `relief` all along.
pub(super) fn plain(face: &mut Face, piece: &Piece, of: StripFace, relief: f64) {
    let (start, end) = ends(piece, of, relief);
    if !piece.is_bent() {
        face.line_to(end, name_of(piece));
        return;
    }
    let radius = radius(piece, of, relief);
    if radius > NOTHING_MM {
        let center = center(piece, of, start, radius);
        face.arc(start, end, center, piece.angle_rad > 0.0, name_of(piece));
    } else {
        corner(face, piece, start, end);
    }
}

/// The inside of a bend whose radius is not larger than the relief: the lines before and after it meet.
fn corner(face: &mut Face, piece: &Piece, start: Point, end: Point) {
    let before = Segment::line(start, start + along(piece.heading_rad));
    let after = Segment::line(end, end + along(piece.end_heading_rad()));
    match before.prolonged_meeting(&after, start) {
        Some(meeting) if meeting.distance(start) <= piece.mean.length() => face.move_end(meeting, name_of(piece)),
        _ => {
            face.line_to(start, name_of(piece));
            face.line_to(end, name_of(piece));
        }
    }
}

/// The outer face of an arc in which the relief grows: the fillet that touches the prolonged line before it and ends on the normal
/// of the arc's end, `to` off the strip.
///
/// With the growth d and the angle θ: the line before is prolonged by d·sin θ/(1 − cos θ) = d·cot(θ/2), and the radius is
/// R − d·cos θ/(1 − cos θ) = R − d/(tan θ·tan(θ/2)). Returns radius and centre; `None` if the arc is too flat for it and becomes
/// a chord, which is off the strip by d·t² at least at t of its length.
pub(super) fn outer(face: &mut Face, piece: &Piece, from: f64, to: f64) -> Option<(f64, Point)> {
    let of = StripFace::outer(piece);
    let (start, _) = ends(piece, of, from);
    let (_, end) = ends(piece, of, to);
    let (sin, cos) = piece.angle_rad.abs().sin_cos();
    let growth = to - from;
    let radius = radius(piece, of, from) - growth * cos / (1.0 - cos);
    let prolonged = growth * sin / (1.0 - cos);
    if radius <= NOTHING_MM || prolonged < 0.0 {
        face.line_to(start, name_of(piece));
        face.line_to(end, name_of(piece));
        return None;
    }
    let start = start + along(piece.heading_rad) * prolonged;
    face.move_end(start, name_of(piece));
    let center = center(piece, of, start, radius);
    face.arc(start, end, center, piece.angle_rad > 0.0, name_of(piece));
    Some((radius, center))
}

/// The inner face of the same arc where its relief ends: the outer arc less the clearance, moved by the relief along the normal of
/// its start, away from the strip, as in the published rolls. `fillet` is the outer arc.
pub(super) fn inner(face: &mut Face, piece: &Piece, from: f64, clearance: f64, fillet: Option<(f64, Point)>) {
    let of = StripFace::outer(piece).other();
    let (_, end) = ends(piece, of, 0.0);
    let inner = fillet.map(|(radius, center)| (radius - clearance, center)).filter(|(radius, _)| *radius > NOTHING_MM);
    let Some((radius, center)) = inner else {
        face.line_to(end, name_of(piece));
        return;
    };
    // Beyond a right angle the moved arc would end within the strip; it stays where it is.
    let moved = if piece.angle_rad.cos() >= 0.0 { from } else { 0.0 };
    let center = center + of.start_normal(piece) * moved;
    let start = center - of.start_normal(piece) * radius;
    face.move_end(start, name_of(piece));
    face.arc(start, center - of.end_normal(piece) * radius, center, piece.angle_rad > 0.0, name_of(piece));
}

/// Start and end of a piece on a face that stands off by `relief`.
pub(super) fn ends(piece: &Piece, of: StripFace, relief: f64) -> (Point, Point) {
    let segment = of.of(piece);
    (segment.start() + of.start_normal(piece) * relief, segment.end() + of.end_normal(piece) * relief)
}

/// Radius of an arc on a face that stands off by `relief`.
fn radius(piece: &Piece, of: StripFace, relief: f64) -> f64 {
    let thickness = piece.bottom.start().distance(piece.top.start());
    if of == StripFace::outer(piece) { piece.inside_radius + thickness + relief } else { piece.inside_radius - relief }
}

/// Centre of an arc that starts here.
fn center(piece: &Piece, of: StripFace, start: Point, radius: f64) -> Point {
    let away = of.start_normal(piece);
    if of == StripFace::outer(piece) { start - away * radius } else { start + away * radius }
}
