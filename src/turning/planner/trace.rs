//! From a limit of a tool to the path along it, towards the chuck, as a control can take it.

use super::chain::Chain;
use super::corner::{sharpened, starting_at};
use super::piece::{Piece, SAME_MM};
use crate::geometry::{Point, Segment, Vector};
use crate::machine::Limits;

/// Segments shorter than this are joined to their neighbour, mm: a fifth of a control's smallest step.
const SHORTEST_MM: f64 = 0.0002;

/// How far lines may leave an arc that a control cannot take, mm; always on the side away from the part.
const FLATTENED_MM: f64 = 0.004;

/// Largest turn over which a corner stays a corner; a sharper one gets more than one line.
const LARGEST_TURN: f64 = 1.8;

/// Segments that one line takes the place of, at most: what is looked at stays short.
const MOST_PASSED: usize = 40;

/// What a control asks of arcs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ArcRules {
    pub(super) least_mm: f64,
    pub(super) most_mm: f64,
    pub(super) one_quadrant: bool,
}

impl From<&Limits> for ArcRules {
    fn from(limits: &Limits) -> Self {
        Self {
            least_mm: limits.arc_radius_min_mm,
            most_mm: limits.arc_radius_max_mm,
            one_quadrant: limits.arc_one_quadrant,
        }
    }
}

/// The path along `limit` from `z1` down to `z0`, connected; faces are vertical lines. Where the nose only rolls over a corner
/// of the part (an arc of `rolled` mm) it goes straight on to the meeting point: in air, and the corner stays sharp.
pub(super) fn trace(limit: &Chain, z0: f64, z1: f64, rolled: f64, rules: ArcRules) -> Vec<Segment> {
    let mut path: Vec<Segment> = Vec::new();
    for piece in limit.clipped(z0, z1).pieces.iter().rev() {
        append(&mut path, piece.towards_chuck());
    }
    let path = joined(&sharpened(&joined(&path), rolled));
    joined(&path.iter().flat_map(|s| allowed(s, rolled, rules)).collect::<Vec<_>>())
}

/// The path with fewer segments: lines on or above it that leave it by no more than `by` mm take the place of what they pass.
pub(super) fn simplified(path: &[Segment], by: f64) -> Vec<Segment> {
    let mut out: Vec<Segment> = Vec::new();
    let mut rest = path;
    while let Some(first) = rest.first() {
        let passed = (2..=rest.len().min(MOST_PASSED)).rev().find(|&n| rest.get(..n).is_some_and(|w| spans(w, by)));
        let single = |s: &Segment| matches!(s, Segment::Arc { .. }) && spans(&[*s], by);
        let count = passed.unwrap_or(1);
        match rest.get(count - 1) {
            Some(last) if passed.is_some() || single(first) => out.push(Segment::line(first.start(), last.end())),
            _ => out.push(*first),
        }
        rest = rest.get(count..).unwrap_or_default();
    }
    joined(&out)
}

/// True if the straight way over a part of a path lies on or above it, by no more than `by` mm.
fn spans(part: &[Segment], by: f64) -> bool {
    let (Some(first), Some(last)) = (part.first(), part.last()) else { return false };
    let Some(line) = Piece::of(&Segment::line(first.start(), last.end())) else { return false };
    // Corners tell most of them.
    let fits = |p: Point| (-SAME_MM.sqrt() - SAME_MM..=by + SAME_MM).contains(&(line.at(p.z) - p.r));
    if !part.iter().filter_map(Piece::of).all(|p| fits(p.left()) && fits(p.right())) {
        return false;
    }
    let way = Chain { pieces: part.iter().rev().filter_map(Piece::of).collect() };
    let line = Chain { pieces: vec![line] };
    way.runs_over(&line, SAME_MM.sqrt()).is_empty() && line.runs_over(&way, by).is_empty()
}

/// Adds a segment, with a vertical line where it does not begin at the end.
fn append(path: &mut Vec<Segment>, segment: Segment) {
    if let Some(last) = path.last_mut() {
        let (end, start) = (last.end(), segment.start());
        if end.distance(start) > SHORTEST_MM {
            path.push(Segment::line(end, Point::new(end.z, start.r)));
        }
    }
    path.push(segment);
}

/// A segment as the control can take it.
fn allowed(segment: &Segment, rolled: f64, rules: ArcRules) -> Vec<Segment> {
    let Segment::Arc { start, end, center, ccw } = *segment else { return vec![*segment] };
    let radius = start.distance(center);
    // Towards the chuck an arc that bulges outwards runs counter-clockwise.
    if ccw && radius <= rolled + SAME_MM.sqrt() {
        return around(segment, LARGEST_TURN);
    }
    if radius < rules.least_mm || radius > rules.most_mm {
        // A line along a chord or tangent of half angle h leaves the arc by radius·(1 − cos h).
        let half = (1.0 - FLATTENED_MM / radius).clamp(-1.0, 1.0).acos();
        return if ccw { around(segment, 2.0 * half) } else { chords(segment, 2.0 * half) };
    }
    if rules.one_quadrant && (start.z - center.z) * (end.z - center.z) < -SAME_MM {
        let top = Point::new(center.z, if ccw { center.r + radius } else { center.r - radius });
        let part = |start, end| Segment::Arc { start, end, center, ccw };
        return vec![part(start, top), part(top, end)];
    }
    vec![*segment]
}

fn equal_parts(arc: &Segment, largest_turn: f64) -> u32 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=1000")]
    let count = (arc.sweep().abs() / largest_turn).ceil().clamp(1.0, 1000.0) as u32;
    count
}

/// Lines outside an arc that touch it: at its ends and, if it turns further than `largest_turn`, in between.
fn around(arc: &Segment, largest_turn: f64) -> Vec<Segment> {
    let Segment::Arc { center, .. } = *arc else { return vec![*arc] };
    let count = equal_parts(arc, largest_turn);
    let share = |k: u32| f64::from(k) / f64::from(count);
    let mut out = Vec::new();
    let mut at = arc.start();
    for k in 0..count {
        let (a, b) = (arc.point_at(share(k)) - center, arc.point_at(share(k + 1)) - center);
        let middle = a + b;
        // The tangents meet on the line through the middle, radius / cos(half the turn) from the centre.
        let corner = center + middle * (a.norm_squared() / middle.dot(&a));
        out.push(Segment::line(at, corner));
        at = corner;
        if k + 1 == count {
            out.push(Segment::line(at, arc.end()));
        }
    }
    out
}

/// Lines between points of an arc.
fn chords(arc: &Segment, largest_turn: f64) -> Vec<Segment> {
    let count = equal_parts(arc, largest_turn);
    let at = |k: u32| arc.point_at(f64::from(k) / f64::from(count));
    (0..count).map(|k| Segment::line(at(k), at(k + 1))).collect()
}

/// The path with lines in one direction joined and what is too short left out.
fn joined(path: &[Segment]) -> Vec<Segment> {
    let mut out: Vec<Segment> = Vec::with_capacity(path.len());
    for segment in path {
        let start = out.last().map_or(segment.start(), Segment::end);
        let segment = starting_at(segment, start);
        if start.distance(segment.end()) < SHORTEST_MM {
            continue;
        }
        match (out.last_mut(), segment) {
            (Some(Segment::Line { start: first, end: last }), Segment::Line { end, .. })
                if one_direction(*first, *last, end) =>
            {
                *last = end;
            }
            (Some(Segment::Arc { center: c, ccw: w, end: last, .. }), Segment::Arc { end, center, ccw, .. })
                if *w == ccw && c.distance(center) < SAME_MM && (last.z - c.z) * (end.z - c.z) > 0.0 =>
            {
                *last = end;
            }
            _ => out.push(segment),
        }
    }
    out
}

/// True if `b` lies on the way from `a` to `c`.
pub(super) fn one_direction(a: Point, b: Point, c: Point) -> bool {
    /// A corner nearer than this to the straight way is none, mm.
    const STRAIGHT_MM: f64 = 1e-6;
    let (first, whole): (Vector, Vector) = (b - a, c - a);
    first.dot(&(c - b)) > 0.0 && first.perp(&whole).abs() <= STRAIGHT_MM * whole.norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_take_the_place_of_hollows_but_not_of_crests() {
        let p = Point::new;
        let hollow = [Segment::line(p(3.0, 2.0), p(2.0, 1.0)), Segment::line(p(2.0, 1.0), p(0.0, 0.0))];
        assert_eq!(simplified(&hollow, 1.0), [Segment::line(p(3.0, 2.0), p(0.0, 0.0))]);
        assert_eq!(simplified(&hollow, 0.1).len(), 2, "the line leaves the path by 0.33 mm");
        let crest = [Segment::line(p(3.0, 0.0), p(2.0, 2.0)), Segment::line(p(2.0, 2.0), p(0.0, 0.0))];
        assert_eq!(simplified(&crest, 9.0).len(), 2);
        let wall = [Segment::line(p(3.0, 0.0), p(2.0, 0.0)), Segment::line(p(2.0, 0.0), p(2.0, 5.0))];
        assert_eq!(simplified(&wall, 9.0), [Segment::line(p(3.0, 0.0), p(2.0, 5.0))]);
    }
}
