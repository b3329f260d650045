//! Corners of a path: where the nose only rolls over an edge of the part, its neighbours are prolonged to their meeting point.
//!
//! A neighbour bends less than the nose and leaves the rolled arc tangentially, so its continuation lies in air. The edge stays
//! sharp, and the path has one segment less.

use super::piece::SAME_MM;
use crate::geometry::{Point, Segment, Vector};

/// The meeting point may lie this many radii from the rolled arc's centre: a corner that turns by more than 120 degrees keeps
/// its arc.
const FURTHEST_RADII: f64 = 2.0;

/// `path` with every arc of `rolled` mm that bulges outwards replaced by a corner where its neighbours meet.
pub(super) fn sharpened(path: &[Segment], rolled: f64) -> Vec<Segment> {
    let mut out: Vec<Segment> = Vec::with_capacity(path.len());
    let mut start: Option<Point> = None;
    for (k, segment) in path.iter().enumerate() {
        let segment = start.take().map_or(*segment, |p| starting_at(segment, p));
        let meeting = is_rolled(&segment, rolled)
            .filter(|_| bulges(out.last(), &segment, path.get(k + 1)))
            .and_then(|center| meeting(out.last()?, path.get(k + 1)?, center, rolled, segment.point_at(0.5)));
        match (meeting, out.last_mut()) {
            (Some(corner), Some(before)) => {
                *before = ending_at(before, corner);
                start = Some(corner);
            }
            _ => out.push(segment),
        }
    }
    out
}

/// The centre of an arc over which the nose rolls.
fn is_rolled(segment: &Segment, rolled: f64) -> Option<Point> {
    match *segment {
        Segment::Arc { start, center, ccw: true, .. } if start.distance(center) <= rolled + SAME_MM.sqrt() => {
            Some(center)
        }
        _ => None,
    }
}

/// True if the path turns the arc's way at both of its ends, or not at all: where it turns the other way, in a hollow corner, a
/// neighbour prolonged would run under the arc.
fn bulges(before: Option<&Segment>, arc: &Segment, after: Option<&Segment>) -> bool {
    /// Sine of a turn that rounding makes.
    const STRAIGHT: f64 = 1e-6;
    let turn = |a: Vector, b: Vector| a.perp(&b) >= -STRAIGHT;
    before.is_some_and(|s| turn(s.direction_at(1.0), arc.direction_at(0.0)))
        && after.is_some_and(|s| turn(arc.direction_at(1.0), s.direction_at(0.0)))
}

/// Where the way before, prolonged, meets the way after, prolonged backwards.
fn meeting(before: &Segment, after: &Segment, center: Point, rolled: f64, middle: Point) -> Option<Point> {
    let (out, back) = (before.direction_at(1.0), -after.direction_at(0.0));
    let fits = |p: &Point| {
        let far = p.distance(center);
        far >= rolled - SAME_MM.sqrt()
            && far <= FURTHEST_RADII * rolled
            // An arc prolonged past its side would come back.
            && p.z <= before.end().z + SAME_MM.sqrt()
            && p.z >= after.start().z - SAME_MM.sqrt()
            && (*p - before.end()).dot(&out) >= -SAME_MM
            && (*p - after.start()).dot(&back) >= -SAME_MM
    };
    let near = |a: &Point, b: &Point| a.distance(middle).total_cmp(&b.distance(middle));
    crossings(before, after).into_iter().filter(fits).min_by(near)
}

/// Points that the lines or circles of two segments share.
fn crossings(a: &Segment, b: &Segment) -> Vec<Point> {
    match (*a, *b) {
        (Segment::Line { start, end }, Segment::Line { start: from, end: to }) => {
            let (along, other) = (end - start, to - from);
            let cross = along.perp(&other);
            if cross == 0.0 { Vec::new() } else { vec![start + along * ((from - start).perp(&other) / cross)] }
        }
        (Segment::Line { start, end }, Segment::Arc { start: on, center, .. })
        | (Segment::Arc { start: on, center, .. }, Segment::Line { start, end }) => {
            let along = (end - start).normalize();
            let foot = start + along * (center - start).dot(&along);
            both_sides(foot, along, on.distance(center), foot.distance(center))
        }
        (Segment::Arc { start: p, center: c, .. }, Segment::Arc { start: q, center: d, .. }) => {
            let (r, s, apart) = (p.distance(c), q.distance(d), c.distance(d));
            let along = (d - c) / apart;
            let to_chord = f64::midpoint(apart, (r - s) * (r + s) / apart);
            both_sides(c + along * to_chord, Vector::new(-along.y, along.x), r, to_chord.abs())
        }
    }
}

fn both_sides(foot: Point, along: Vector, radius: f64, away: f64) -> Vec<Point> {
    let half = ((radius - away) * (radius + away)).sqrt();
    if half.is_finite() { vec![foot + along * half, foot - along * half] } else { Vec::new() }
}

/// The segment from `start`.
pub(super) fn starting_at(segment: &Segment, start: Point) -> Segment {
    match *segment {
        Segment::Line { end, .. } => Segment::line(start, end),
        Segment::Arc { end, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

/// The segment up to `end`.
fn ending_at(segment: &Segment, end: Point) -> Segment {
    match *segment {
        Segment::Line { start, .. } => Segment::line(start, end),
        Segment::Arc { start, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_between_lines_and_arcs_is_where_they_meet() {
        let p = Point::new;
        let nose = Segment::Arc { start: p(1.0, 2.0), end: p(0.0, 3.0), center: p(0.0, 2.0), ccw: true };
        let square = [Segment::line(p(1.0, 0.0), p(1.0, 2.0)), nose, Segment::line(p(0.0, 3.0), p(-5.0, 3.0))];
        let sharp = sharpened(&square, 1.0);
        assert_eq!(sharp, [Segment::line(p(1.0, 0.0), p(1.0, 3.0)), Segment::line(p(1.0, 3.0), p(-5.0, 3.0))]);
        let hollow = Segment::Arc { start: p(0.0, 3.0), end: p(-4.0, 7.0), center: p(0.0, 7.0), ccw: false };
        let into_arc = sharpened(&[square[0], nose, hollow], 1.0);
        assert_eq!(into_arc.len(), 2);
        assert!((into_arc[1].start().distance(p(0.0, 7.0)) - 4.0).abs() < 1e-12);
        assert_eq!(sharpened(&square, 0.5).len(), 3, "an arc of the part stays");
        // The foot of a hollow whose circle meets the way behind the corner beyond its own side.
        let foot = Segment::Arc { start: p(3.0, 0.0), end: p(1.05, 1.7), center: p(3.0, 2.0), ccw: false };
        let over = Segment::Arc { start: p(1.05, 1.7), end: p(0.2, 2.6), center: p(0.05, 1.6), ccw: true };
        let beyond = [foot, over, Segment::line(p(0.2, 2.6), p(-5.0, 1.8))];
        assert!(sharpened(&beyond, 1.02).windows(2).all(|w| w[1].start().z <= 1.05 + 1e-9));
        let into_hollow = [Segment::line(p(3.0, 4.0), p(1.0, 2.0)), nose, square[2]];
        assert_eq!(sharpened(&into_hollow, 1.0).len(), 3, "a line that runs into the arc from above stays");
    }
}
