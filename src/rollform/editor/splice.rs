//! Inserting, replacing and deleting an element: neighbours are prolonged or cut to where they meet (chapters 6.6 to 6.8).

use super::carrier::Carrier;
use super::fault::{self, Reason};
use super::shape::{Between, carrier};
use crate::document::{ElementName, NewElement};
use crate::geometry::{Point, Segment};
use crate::rollform::roll::RollElement;

/// Puts a new element behind the one with this index.
pub(super) fn insert(
    elements: &mut Vec<RollElement>,
    index: usize,
    shape: &NewElement,
    name: ElementName,
) -> Result<(), Reason> {
    let (before, after) = (at(elements, index)?, at(elements, index + 1)?);
    let between = Between { before, after, near: before.end() };
    let new = new_segment(elements, shape, &between, before.end(), before.end())?;
    let (before, after) = (ending(&before, new.start())?, starting(&after, new.end())?);
    set(elements, index, before);
    set(elements, index + 1, after);
    elements.insert(index + 1, RollElement::new(new, name));
    Ok(())
}

/// Puts a new element in place of the one with this index.
pub(super) fn replace(
    elements: &mut [RollElement],
    index: usize,
    shape: &NewElement,
    name: ElementName,
) -> Result<(), Reason> {
    let (old, before, after) = (at(elements, index)?, left_of(elements, index)?, at(elements, index + 1)?);
    let between = Between { before, after, near: old.point_at(0.5) };
    let new = new_segment(elements, shape, &between, old.start(), old.end())?;
    let (before, after) = (ending(&before, new.start())?, starting(&after, new.end())?);
    set(elements, index - 1, before);
    set(elements, index + 1, after);
    if let Some(element) = elements.get_mut(index) {
        *element = RollElement::new(new, name);
    }
    Ok(())
}

/// Takes the element with this index out.
pub(super) fn delete(elements: &mut Vec<RollElement>, index: usize) -> Result<(), Reason> {
    let (old, before, after) = (at(elements, index)?, left_of(elements, index)?, at(elements, index + 1)?);
    let meeting = Carrier::of(&before).zip(Carrier::of(&after)).and_then(|(a, b)| a.meeting(b, old.point_at(0.5)));
    let meeting = meeting.ok_or_else(|| fault::no_meeting("The neighbours of the deleted element"))?;
    let (before, after) = (ending(&before, meeting)?, starting(&after, meeting)?);
    set(elements, index - 1, before);
    set(elements, index + 1, after);
    elements.remove(index);
    Ok(())
}

fn at(elements: &[RollElement], index: usize) -> Result<Segment, Reason> {
    let none = || ("edit-last", "Behind the last element nothing can be put.".to_owned(), "Choose another element.");
    elements.get(index).map(|e| e.segment).ok_or_else(none)
}

fn left_of(elements: &[RollElement], index: usize) -> Result<Segment, Reason> {
    let none = || ("edit-first", "The first element has nothing before it.".to_owned(), "Choose another element.");
    index.checked_sub(1).and_then(|i| elements.get(i)).map(|e| e.segment).ok_or_else(none)
}

fn set(elements: &mut [RollElement], index: usize, segment: Segment) {
    if let Some(element) = elements.get_mut(index) {
        element.segment = segment;
    }
}

/// The new element between the points where it meets its neighbours, nearest to `from` and `to`.
fn new_segment(
    elements: &[RollElement],
    shape: &NewElement,
    between: &Between,
    from: Point,
    to: Point,
) -> Result<Segment, Reason> {
    let new = carrier(elements, shape, between)?;
    let touches = matches!(shape, NewElement::CircleTangent { .. });
    let meet = |neighbour: &Segment, near: Point| {
        let other = Carrier::of(neighbour)?;
        match new {
            Carrier::Circle(center, _) if touches => other.nearest(center),
            _ => new.meeting(other, near),
        }
    };
    let start =
        meet(&between.before, from).ok_or_else(|| fault::no_meeting("The new element and the one before it"))?;
    let end = meet(&between.after, to).ok_or_else(|| fault::no_meeting("The new element and the one behind it"))?;
    Ok(match new {
        Carrier::Line(..) => Segment::line(start, end),
        Carrier::Circle(center, _) => {
            let ccw = if touches {
                // It goes on in the direction of the element before it.
                let along = between.before.direction_at(1.0);
                (start - center).perp(&along) > 0.0
            } else {
                (start - center).perp(&(end - center)) > 0.0
            };
            Segment::Arc { start, end, center, ccw }
        }
    })
}

/// A segment that ends elsewhere on its carrier.
fn ending(segment: &Segment, end: Point) -> Result<Segment, Reason> {
    let new = match *segment {
        Segment::Line { start, .. } => Segment::Line { start, end },
        Segment::Arc { start, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    };
    forward(segment, new)
}

/// A segment that starts elsewhere on its carrier.
fn starting(segment: &Segment, start: Point) -> Result<Segment, Reason> {
    let new = match *segment {
        Segment::Line { end, .. } => Segment::Line { start, end },
        Segment::Arc { end, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    };
    forward(segment, new)
}

/// The new segment, if it still runs the same way.
fn forward(old: &Segment, new: Segment) -> Result<Segment, Reason> {
    let along = (new.end() - new.start()).dot(&old.direction_at(0.5));
    let is_line = new.radius().is_none();
    if (is_line && along <= 0.0) || (!is_line && new.sweep().abs() > std::f64::consts::PI) {
        return Err(fault::turns_back(-along));
    }
    Ok(new)
}
