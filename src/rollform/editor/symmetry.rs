//! Left and right roll of a symmetrical section: the left one is as the right one until it is given a contour of its own.

use super::copy::for_left_roll;
use crate::document::{Origin, RollCopy, RollKind, RollRef, RollSet, RollWork};
use std::borrow::Cow;

/// What is decided about a roll: of a left roll that follows the right one, with the edits of that one.
#[must_use]
pub fn decided(set: &RollSet, roll: RollRef) -> Cow<'_, RollWork> {
    let own = set.roll(roll);
    if !follows_right(set, roll) {
        return own.map_or_else(|| Cow::Owned(RollWork::of(roll)), Cow::Borrowed);
    }
    let right = set.roll(RollRef { kind: RollKind::Right, ..roll });
    let mut work = own.cloned().unwrap_or_else(|| RollWork::of(roll));
    work.edits = right.map(|right| for_left_roll(&right.edits)).unwrap_or_default();
    work.same_as = right.and_then(|right| right.same_as).map(of_other_side);
    Cow::Owned(work)
}

/// True of a left roll that may follow the right one: the section is symmetrical, and so is the side roll.
#[must_use]
pub fn may_follow_right(set: &RollSet, roll: RollRef) -> bool {
    roll.kind == RollKind::Left
        && set.section.origin == Origin::Symmetrical
        && set.station(roll.station).is_some_and(|(_, station)| station.side_left.is_none())
}

/// True of a left roll whose contour is that of the right one, mirrored.
#[must_use]
pub fn follows_right(set: &RollSet, roll: RollRef) -> bool {
    let is_own = |work: &RollWork| work.own_contour || work.same_as.is_some() || !work.edits.is_empty();
    may_follow_right(set, roll) && !set.roll(roll).is_some_and(is_own)
}

/// What is decided about a roll, to be changed: one that followed the right one goes on from there by itself.
pub fn begin_own(set: &mut RollSet, roll: RollRef) -> &mut RollWork {
    let follows = follows_right(set, roll).then(|| decided(set, roll).into_owned());
    let work = set.roll_mut(roll);
    if let Some(begun) = follows {
        *work = RollWork { own_contour: true, ..begun };
    }
    work
}

fn of_other_side(copy: RollCopy) -> RollCopy {
    let kind = match copy.roll.kind {
        RollKind::Left => RollKind::Right,
        RollKind::Right => RollKind::Left,
        level => level,
    };
    RollCopy { roll: RollRef { kind, ..copy.roll }, ..copy }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{EditAction, ElementName, RollEdit, Side};
    use crate::rollform::fixtures::published_rolls;
    use crate::rollform::{Roll, design};

    const RIGHT: RollRef = RollRef { station: 3, kind: RollKind::Right };
    const LEFT: RollRef = RollRef { station: 3, kind: RollKind::Left };

    fn chamfered() -> RollSet {
        let mut set = published_rolls();
        let after = ElementName::Flank { side: Side::Left };
        set.roll_mut(RIGHT).edits = vec![RollEdit { id: 1, action: EditAction::Chamfer { after, depth: 1.0 } }];
        set
    }

    fn rolls(set: &RollSet) -> (Roll, Roll) {
        let design = design("x", set);
        (design.roll(LEFT).unwrap().clone(), design.roll(RIGHT).unwrap().clone())
    }

    #[test]
    fn the_left_roll_keeps_to_the_right_one() {
        let mut set = chamfered();
        set.stations[2].tolerance_left = set.stations[2].tolerance_right;
        let (left, right) = rolls(&set);
        let ends = left.elements.iter().zip(&right.elements).map(|(l, r)| l.segment.end().distance(r.segment.end()));
        assert!(ends.fold(0.0, f64::max) < 1e-9 && left.elements.len() == right.elements.len());
        assert_ne!(right.elements, right.designed);
    }

    #[test]
    fn symmetry_is_broken_on_purpose_only() {
        let mut set = chamfered();
        assert_eq!(begin_own(&mut set, LEFT).edits.len(), 1);
        assert!(!follows_right(&set, LEFT));
        set.roll_mut(RIGHT).edits.clear();
        let (left, right) = rolls(&set);
        assert!(left.elements != left.designed && right.elements == right.designed);
        // A contour of its own without an edit.
        set = chamfered();
        set.roll_mut(LEFT).own_contour = true;
        let (left, right) = rolls(&set);
        assert!(left.elements == left.designed && right.elements != right.designed);
        // Of a section that is not symmetrical nothing follows.
        set = chamfered();
        set.section.origin = Origin::LeftToRight;
        assert!(!may_follow_right(&set, LEFT));
    }
}
