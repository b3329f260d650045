//! Joining elements that are one curve.

use super::RollElement;
use crate::geometry::{Point, Segment, Vector};

/// Shorter elements are absorbed, mm; the published lists have none below 0.24 mm, their sections lines of 0.001 mm.
const SHORT_MM: f64 = 0.005;

/// Directions that differ by less are the same, radians.
const SAME_RAD: f64 = 1e-7;

/// Radii that differ by less are the same, mm.
const SAME_RADIUS_MM: f64 = 1e-6;

/// Direction in which the contour is travelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Travel {
    Forwards,
    Backwards,
}

/// The same contour with fewer elements.
pub(super) fn merged(elements: Vec<RollElement>, travel: Travel) -> Vec<RollElement> {
    match travel {
        Travel::Forwards => arcs(without_short(lines(elements))),
        Travel::Backwards => turned(arcs(without_short(lines(turned(elements))))),
    }
}

fn turned(elements: Vec<RollElement>) -> Vec<RollElement> {
    elements
        .into_iter()
        .rev()
        .map(|e| RollElement { segment: e.segment.reversed(), names: e.names.into_iter().rev().collect() })
        .collect()
}

/// Level and upright lines are joined all, inclined ones in pairs.
fn lines(elements: Vec<RollElement>) -> Vec<RollElement> {
    let mut all: Vec<RollElement> = Vec::with_capacity(elements.len());
    let mut is_pair = false;
    for element in elements {
        match all.last_mut() {
            Some(last) if collinear(&last.segment, &element.segment) && (!is_pair || is_square(&last.segment)) => {
                last.segment = Segment::line(last.segment.start(), element.segment.end());
                last.names.extend(element.names);
                is_pair = true;
            }
            _ => {
                all.push(element);
                is_pair = false;
            }
        }
    }
    all
}

fn collinear(a: &Segment, b: &Segment) -> bool {
    let (Segment::Line { .. }, Segment::Line { .. }) = (a, b) else { return false };
    let (u, v) = (a.direction_at(0.0), b.direction_at(0.0));
    u.perp(&v).abs() <= SAME_RAD.max(1e-9 / a.length().min(b.length())) && u.dot(&v) > 0.0
}

/// True for a line along the axis or square to it.
fn is_square(line: &Segment) -> bool {
    let direction = line.direction_at(0.0);
    direction.x.abs().min(direction.y.abs()) <= SAME_RAD
}

/// Elements without those that are too short; their neighbours meet at one of their ends.
fn without_short(elements: Vec<RollElement>) -> Vec<RollElement> {
    let mut all: Vec<RollElement> = Vec::with_capacity(elements.len());
    let mut moved: Option<Point> = None;
    let count = elements.len();
    for (index, mut element) in elements.into_iter().enumerate() {
        if let Some(start) = moved.take() {
            element.segment = with_ends(&element.segment, start, element.segment.end());
        }
        if element.segment.length() > SHORT_MM || count == 1 {
            all.push(element);
            continue;
        }
        let is_last = index + 1 == count;
        match all.last_mut() {
            Some(last) if is_last || last.segment.radius().is_none() => {
                last.segment = with_ends(&last.segment, last.segment.start(), element.segment.end());
                last.names.extend(element.names);
            }
            _ => moved = Some(element.segment.start()),
        }
    }
    all
}

/// Concentric arcs become one.
fn arcs(elements: Vec<RollElement>) -> Vec<RollElement> {
    let mut all: Vec<RollElement> = Vec::with_capacity(elements.len());
    for element in elements {
        match all.last_mut() {
            Some(last) if concentric(&last.segment, &element.segment) => {
                last.segment = with_ends(&last.segment, last.segment.start(), element.segment.end());
                last.names.extend(element.names);
            }
            _ => all.push(element),
        }
    }
    all
}

fn concentric(a: &Segment, b: &Segment) -> bool {
    let (Segment::Arc { center: c, ccw: p, .. }, Segment::Arc { center: d, ccw: q, .. }) = (a, b) else { return false };
    let radii = a.radius().zip(b.radius());
    p == q
        && c.distance(*d) <= SHORT_MM
        && radii.is_some_and(|(r, s)| (r - s).abs() <= SAME_RADIUS_MM)
        && (a.sweep() + b.sweep()).abs() < std::f64::consts::PI
}

/// A segment with other ends; an arc keeps its radius, and its centre follows.
fn with_ends(segment: &Segment, start: Point, end: Point) -> Segment {
    let Segment::Arc { center, ccw, .. } = *segment else { return Segment::line(start, end) };
    let radius = segment.radius().unwrap_or_default();
    let chord = end - start;
    let Some(along) = chord.try_normalize(0.0) else { return *segment };
    let left = Vector::new(-along.y, along.x);
    let middle = start + chord * 0.5;
    let height = (radius * radius - chord.norm_squared() / 4.0).max(0.0).sqrt();
    let side = if (center - middle).dot(&left) >= 0.0 { 1.0 } else { -1.0 };
    Segment::Arc { start, end, center: middle + left * (side * height), ccw }
}
