//! Inserting, deleting, duplicating and moving rows.

use crate::document::TurnedPart;
use crate::part::Section;
use std::ops::RangeInclusive;

/// Inserts a straight row before row `index`, from the end of the row before to the start of the row after.
pub(crate) fn insert(part: &mut TurnedPart, index: usize) -> u32 {
    let index = index.min(part.sections.len());
    let before = index.checked_sub(1).and_then(|i| part.sections.get(i));
    let (z1, d1) = before.map_or((0.0, part.bar_diameter), |s| (s.z2, s.d2));
    let (z2, d2) = part.sections.get(index).map_or((part.length.max(z1), d1), |s| (s.z1, s.d1));
    let id = part.unused_section_id();
    part.sections.insert(index, Section::line(id, z1, d1, z2, d2));
    id
}

/// Deletes rows.
pub(crate) fn delete(part: &mut TurnedPart, rows: &RangeInclusive<usize>) {
    let mut index = 0;
    part.sections.retain(|_| {
        index += 1;
        !rows.contains(&(index - 1))
    });
}

/// Puts a copy of the rows after them, with ids of their own.
pub(crate) fn duplicate(part: &mut TurnedPart, rows: &RangeInclusive<usize>) {
    let copies: Vec<Section> = part.sections.iter().skip(*rows.start()).take(rows.clone().count()).cloned().collect();
    for (offset, copy) in copies.into_iter().enumerate() {
        let id = part.unused_section_id();
        let at = (rows.end() + 1 + offset).min(part.sections.len());
        part.sections.insert(at, Section { id, ..copy });
    }
}

/// Moves rows by one place; true if there was room.
pub(crate) fn shift(part: &mut TurnedPart, rows: &RangeInclusive<usize>, down: bool) -> bool {
    let (first, last) = (*rows.start(), *rows.end());
    let room = if down { last + 1 < part.sections.len() } else { first > 0 && last < part.sections.len() };
    if room {
        match part.sections.get_mut(if down { first..=last + 1 } else { first - 1..=last }) {
            Some(rows) if down => rows.rotate_right(1),
            Some(rows) => rows.rotate_left(1),
            None => {}
        }
    }
    room
}
