//! Rolls on upright axes beside the strip.

use super::face::{Face, NOTHING_MM, StripFace};
use super::frame::{Frame, mapped};
use super::merge::{Travel, merged};
use super::pair::{names, with_flanks};
use super::wing::Wing;
use super::{DesignedRoll, RollElement, reach};
use crate::document::{ElementName, ExtensionContour, Face as EndFace, RollKind, Side, SideEnd, SideRoll};
use crate::geometry::{Point, Segment, Vector};

/// What a side roll takes of a wing.
pub(super) struct Taken {
    /// On which face.
    face: StripFace,
    /// Its elements, from the inside outwards; seen as on the right.
    elements: Vec<RollElement>,
    /// How many elements of the face lie before it.
    before: usize,
}

impl Taken {
    fn ends(&self) -> (Point, Point) {
        let first = self.elements.first().map(|e| e.segment.start());
        let last = self.elements.last().map(|e| e.segment.end());
        (first.unwrap_or_default(), last.unwrap_or_default())
    }

    /// Its higher end.
    pub(super) fn upper_end(&self) -> Point {
        let (a, b) = self.ends();
        if a.r >= b.r { a } else { b }
    }

    /// Its lower end.
    pub(super) fn lower_end(&self) -> Point {
        let (a, b) = self.ends();
        if a.r >= b.r { b } else { a }
    }
}

/// What the side roll takes; `None` if its elements are not on this side.
pub(super) fn taken(wing: &Wing, roll: &SideRoll) -> Option<Taken> {
    let face = [roll.from.face, roll.to.face].into_iter().find_map(|face| match face {
        EndFace::Bottom => Some(StripFace::Bottom),
        EndFace::Top => Some(StripFace::Top),
        EndFace::Leading | EndFace::Trailing => None,
    });
    // Between two end faces it is the outer face of the strip.
    let face = face.unwrap_or_else(|| if wing.end_heading_rad() > 0.0 { StripFace::Bottom } else { StripFace::Top });
    let (a, b) = (extent(wing, roll.from)?, extent(wing, roll.to)?);
    let (inner, inner_end, outer, outer_end) =
        if a.0 <= b.0 { (a, roll.from.face, b, roll.to.face) } else { (b, roll.to.face, a, roll.from.face) };
    let first = if inner_end == EndFace::Trailing { inner.1 + 1 } else { inner.0 };
    let last = if outer_end == EndFace::Leading { outer.0 } else { outer.1 + 1 };
    let pieces = wing.pieces.get(first..last)?;
    let names = names(pieces);
    let chain = match face {
        StripFace::Bottom => &wing.bottom,
        StripFace::Top => &wing.top,
    };
    let is_its = |e: &&RollElement| e.names.iter().any(|name| names.contains(name));
    let before = chain.elements.iter().take_while(|e| !is_its(e)).count();
    let mut elements: Vec<RollElement> = chain.elements.iter().skip(before).take_while(is_its).cloned().collect();
    if outer_end == EndFace::Trailing && last == wing.pieces.len() {
        let other = if face == StripFace::Bottom { &wing.top } else { &wing.bottom };
        let edge = Segment::line(chain.end(), other.end());
        elements.push(RollElement::new(edge, ElementName::Edge { side: wing.side }));
    }
    (!elements.is_empty()).then_some(Taken { face, elements, before })
}

/// First and last piece of an element.
fn extent(wing: &Wing, end: SideEnd) -> Option<(usize, usize)> {
    let mut hits = wing.pieces.iter().enumerate().filter(|(_, p)| p.element == end.element).map(|(index, _)| index);
    let first = hits.next()?;
    Some((first, hits.next_back().unwrap_or(first)))
}

/// The roll that has the face otherwise ends where the side roll begins, set back by the tolerance; the other one ends with the
/// strip.
pub(super) fn give_way(wing: &mut Wing, taken: &Taken, tolerance: f64) {
    let face = match taken.face {
        StripFace::Bottom => &mut wing.bottom,
        StripFace::Top => &mut wing.top,
    };
    face.elements.truncate(taken.before);
    set_back(face, tolerance);
}

/// Takes a length off the last line, if it is longer.
fn set_back(face: &mut Face, tolerance: f64) {
    if let Some(RollElement { segment: Segment::Line { start, end }, .. }) = face.elements.last_mut()
        && start.distance(*end) > tolerance
    {
        *end = *end - (*end - *start).normalize() * tolerance;
    }
}

/// The side roll. Its contour is what can be reached from beside the strip.
pub(super) fn roll(taken: &Taken, roll: &SideRoll, side: Side) -> Option<DesignedRoll> {
    // Height becomes z, and outwards becomes r: then the roll lies above its contour as a top roll does.
    let swapped: Vec<RollElement> =
        taken.elements.iter().map(|e| e.mapped(|s| mapped(s, |p| Point::new(p.r, p.z), true))).collect();
    let (low, high) = (taken.lower_end().r, taken.upper_end().r);
    let mut elements = reach::upper(&swapped, low, high);
    add_level_edge(&mut elements, &swapped);
    let (first, last) = (elements.first()?.segment, elements.last()?.segment);
    let below = extension(roll.extensions.first(), mirrored_up(&first), Side::Left);
    let below: Vec<RollElement> = below.iter().rev().map(|e| e.mapped(|s| mirrored_up(s).reversed())).collect();
    let above = extension(roll.extensions.get(1), last, Side::Right);
    elements = below.into_iter().chain(elements).chain(above).collect();
    let (kind, axis) = match side {
        Side::Left => (RollKind::Left, -roll.axis_distance),
        Side::Right => (RollKind::Right, roll.axis_distance),
    };
    let frame = Frame { kind, face: elements.first()?.segment.start().z, axis };
    // Both sides are built as the right one: strip space mirrored gives the same roll space.
    let seen = Frame { kind: RollKind::Right, axis: roll.axis_distance, ..frame };
    let in_roll = elements.iter().map(|e| e.mapped(|s| mapped(s, |p| seen.point_to_roll(Point::new(p.r, p.z)), true)));
    Some(DesignedRoll { kind, elements: with_flanks(merged(in_roll.collect(), Travel::Forwards)), frame })
}

/// The edge of an upright strip lies square to the roll's axis, where an envelope only ends: it is added at its end.
fn add_level_edge(elements: &mut Vec<RollElement>, all: &[RollElement]) {
    let is_edge = |e: &&RollElement| e.names.iter().any(|name| matches!(name, ElementName::Edge { .. }));
    let Some(edge) = all.last().filter(is_edge) else { return };
    let (from, to) = (edge.segment.start(), edge.segment.end());
    let is_level = (from.z - to.z).abs() < NOTHING_MM && from.distance(to) > NOTHING_MM;
    let meets = |p: Option<Point>| is_level && p.is_some_and(|p| p.distance(from) < NOTHING_MM);
    if meets(elements.last().map(|e| e.segment.end())) {
        elements.push(edge.clone());
    } else if meets(elements.first().map(|e| e.segment.start())) {
        elements.insert(0, edge.mapped(Segment::reversed));
    }
}

/// The mirror image along the axis of the roll.
fn mirrored_up(segment: &Segment) -> Segment {
    segment.mirrored_at_z(0.0)
}

/// The extension contour beyond the end of a contour: along it, along the axis, towards the axis, along the axis.
fn extension(extension: Option<&ExtensionContour>, last: Segment, side: Side) -> Vec<RollElement> {
    let Some(extension) = extension else { return Vec::new() };
    let [first, second, third, fourth] = extension.lengths;
    let upwards = side == Side::Right;
    let (from, direction) = if upwards {
        (last.end(), last.direction_at(1.0))
    } else {
        // The contour runs away from its lower end; seen in the mirror its start is the end.
        (last.start(), -last.direction_at(0.0))
    };
    let forward = if direction.x > 0.0 { direction } else { Vector::zeros() };
    let one = from + forward * first;
    let two = one + Vector::new(second, 0.0);
    let three = two + Vector::new(0.0, third);
    let four = three + Vector::new(fourth, 0.0);
    let mut face = Face::at(from);
    for (part, to) in (1..).zip([one, two, three, four]) {
        face.line_to(to, ElementName::Extension { side, part });
    }
    face.elements
}
