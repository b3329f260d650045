//! What a roll can reach: the envelope of the strip's outline, seen from the roll.

use super::RollElement;
use super::face::NOTHING_MM;
use crate::document::ElementName;
use crate::geometry::{Point, Segment, Vector};
use std::f64::consts::PI;

/// Positions closer than this are the same, mm.
const SAME_MM: f64 = 1e-7;

/// The upper envelope of `outline` from `from` to `to` along z: what is seen from above. Where it jumps, a line square to z
/// stands, named by the element from whose edge it falls.
pub(super) fn upper(outline: &[RollElement], from: f64, to: f64) -> Vec<RollElement> {
    let spans: Vec<Span> = outline.iter().flat_map(Span::of).collect();
    let stops = stops(&spans, from, to);
    let mut all: Vec<RollElement> = Vec::new();
    for (&left, &right) in stops.iter().zip(stops.iter().skip(1)) {
        let middle = f64::midpoint(left, right);
        let over = spans.iter().filter(|s| s.covers(middle));
        let Some(top) = over.max_by(|a, b| a.height_at(middle).total_cmp(&b.height_at(middle))) else { continue };
        push(&mut all, top.between(left, right));
    }
    all
}

/// Appends an element; one of the same curve is joined, a jump becomes an upright line.
fn push(all: &mut Vec<RollElement>, element: RollElement) {
    let Some(last) = all.last_mut() else { return all.push(element) };
    let (here, next) = (last.segment.end(), element.segment.start());
    if last.names == element.names && same_curve(&last.segment, &element.segment) {
        last.segment = with_end(&last.segment, element.segment.end());
        return;
    }
    if here.distance(next) > SAME_MM {
        let name = upright_name(if here.r > next.r { last } else { &element });
        let upright = RollElement::new(Segment::line(here, next), name);
        all.push(upright);
    }
    all.push(element);
}

/// The name of an upright line that falls from the edge of an element.
pub(super) fn upright_name(element: &RollElement) -> ElementName {
    match element.names.first() {
        Some(&ElementName::Strip { element, side, .. } | &ElementName::Unreached { element, side }) => {
            ElementName::Unreached { element, side }
        }
        Some(&ElementName::Edge { side }) => ElementName::Unreached { element: 0, side },
        Some(&name) => name,
        None => ElementName::Unreached { element: 0, side: crate::document::Side::Right },
    }
}

fn same_curve(a: &Segment, b: &Segment) -> bool {
    if a.end().distance(b.start()) > SAME_MM {
        return false;
    }
    match (a, b) {
        (Segment::Line { .. }, Segment::Line { .. }) => a.direction_at(1.0).perp(&b.direction_at(0.0)).abs() < SAME_MM,
        (Segment::Arc { center: c, .. }, Segment::Arc { center: d, .. }) => c.distance(*d) < SAME_MM,
        _ => false,
    }
}

fn with_end(segment: &Segment, end: Point) -> Segment {
    match *segment {
        Segment::Line { start, .. } => Segment::Line { start, end },
        Segment::Arc { start, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

/// Where the highest element can change: ends of elements and crossings.
fn stops(spans: &[Span], from: f64, to: f64) -> Vec<f64> {
    let mut stops = vec![from, to];
    stops.extend(spans.iter().flat_map(|s| [s.segment.start().z, s.segment.end().z]));
    for (index, a) in spans.iter().enumerate() {
        let bounds = a.segment.bounds();
        for b in spans.iter().skip(index + 1).filter(|b| b.segment.bounds().touches(bounds)) {
            stops.extend(a.segment.intersection(&b.segment, SAME_MM).points().iter().map(|p| p.z));
        }
    }
    stops.retain(|z| (from..=to).contains(z));
    stops.sort_by(f64::total_cmp);
    stops.dedup_by(|a, b| (*a - *b).abs() <= SAME_MM);
    stops
}

/// A part of an element that has one height at every z, from left to right.
struct Span<'a> {
    segment: Segment,
    names: &'a [ElementName],
}

impl<'a> Span<'a> {
    /// The spans of an element; an upright line has none.
    fn of(element: &'a RollElement) -> Vec<Self> {
        let span = |segment: Segment| {
            let rightwards = if segment.start().z <= segment.end().z { segment } else { segment.reversed() };
            Self { segment: rightwards, names: &element.names }
        };
        let all = halves(&element.segment).into_iter().map(span);
        all.filter(|s| s.segment.end().z - s.segment.start().z > NOTHING_MM).collect()
    }

    fn covers(&self, z: f64) -> bool {
        self.segment.start().z <= z && z <= self.segment.end().z
    }

    fn height_at(&self, z: f64) -> f64 {
        let (start, end) = (self.segment.start(), self.segment.end());
        if (z - start.z).abs() <= SAME_MM {
            return start.r;
        }
        if (z - end.z).abs() <= SAME_MM {
            return end.r;
        }
        match self.segment {
            Segment::Line { .. } => start.r + (end.r - start.r) * ((z - start.z) / (end.z - start.z)),
            Segment::Arc { center, ccw, .. } => {
                let radius = start.distance(center);
                let height = (radius * radius - (z - center.z).powi(2)).max(0.0).sqrt();
                if ccw { center.r - height } else { center.r + height }
            }
        }
    }

    fn between(&self, left: f64, right: f64) -> RollElement {
        let (start, end) = (Point::new(left, self.height_at(left)), Point::new(right, self.height_at(right)));
        let segment = match self.segment {
            Segment::Line { .. } => Segment::Line { start, end },
            Segment::Arc { center, ccw, .. } => Segment::Arc { start, end, center, ccw },
        };
        RollElement { segment, names: self.names.to_vec() }
    }
}

/// An arc cut at its upright tangents.
fn halves(segment: &Segment) -> Vec<Segment> {
    let Segment::Arc { start, end, center, ccw } = *segment else { return vec![*segment] };
    let radius = start.distance(center);
    let sweep = segment.sweep();
    let from = (start - center).y.atan2((start - center).x);
    // Multiples of half a turn within the sweep, in its direction.
    let (low, high) = (from.min(from + sweep), from.max(from + sweep));
    let first = (low / PI).ceil();
    let mut cuts: Vec<f64> =
        (0..4).map(|k| (first + f64::from(k)) * PI).filter(|&a| a < high - 1e-12 && a > low + 1e-12).collect();
    if !ccw {
        cuts.reverse();
    }
    let on = |angle: f64| center + Vector::new(angle.cos(), angle.sin()) * radius;
    let ends: Vec<Point> = [start].into_iter().chain(cuts.into_iter().map(on)).chain([end]).collect();
    let pairs = ends.iter().zip(ends.iter().skip(1));
    pairs.map(|(&start, &end)| Segment::Arc { start, end, center, ccw }).collect()
}
