//! A copy of a roll's edits for another roll, or for the other side of the same one: from then on both have their own.
//!
//! An edit keeps its place at the strip. What it names is named by the side on which it lies there; what it has in figures
//! keeps its distance from the middle of the strip and from its base, for rolls of other stations have other faces and axes.

use super::symmetry::{begin_own, decided};
use super::{carry_out, find, find_last};
use crate::document::{
    EditAction, ElementName, NewElement, RollEdit, RollKind, RollPoint, RollRef, RollSet, TangentSide,
};
use crate::geometry::{Point, Segment};
use crate::rollform::roll::{Frame, RollElement, contour};
use crate::rollform::{Roll, design};

/// The edits of a roll for another one, mm; `turned` round on its shaft, left and right (of a side roll lower and upper)
/// exchanged. Edits that do not fit the other roll are copied too: they are reported there.
#[must_use]
pub fn copied_edits(from: &Roll, to: &Roll, edits: &[RollEdit], turned: bool) -> Vec<RollEdit> {
    Copy::new(from, to.frame, turned).edits(edits)
}

/// The edits of a roll of the set for another one, which is designed for its own station; see [`copied_edits`]. Everything in mm;
/// `None` if one of the rolls is not there.
#[must_use]
pub fn edits_for(set: &RollSet, from: RollRef, to: RollRef, turned: bool) -> Option<Vec<RollEdit>> {
    let mut own = set.clone();
    begin_own(&mut own, to).same_as = None;
    let design = design("", &own);
    Some(copied_edits(design.roll(from)?, design.roll(to)?, &decided(set, from).edits, turned))
}

/// An edit of a roll as it has to be on the other side of the same roll; `None` if that is no other edit, or does not fit.
#[must_use]
pub fn twin_edit(roll: &Roll, edit: &RollEdit, id: u32) -> Option<RollEdit> {
    let copy = Copy::new(roll, roll.frame, true);
    let twin = RollEdit { id, action: copy.action(&edit.action, &roll.elements) };
    let mut elements = roll.elements.clone();
    (twin.action != edit.action && carry_out(&mut elements, edit).is_ok() && carry_out(&mut elements, &twin).is_ok())
        .then_some(twin)
}

/// The edits of the right roll of a station for its left one, between which the strip lies mirrored.
pub(super) fn for_left_roll(edits: &[RollEdit]) -> Vec<RollEdit> {
    let copy = Copy { from: &[], other_strip: true, turned: false, width: 0.0, shift: 0.0, up: 0.0 };
    copy.edits(edits)
}

/// From which roll to which.
struct Copy<'a> {
    /// The roll's elements as designed.
    from: &'a [RollElement],
    /// True if the strip lies on the other side of the roll's own: names of its pieces change sides.
    other_strip: bool,
    turned: bool,
    /// From face to face.
    width: f64,
    /// Added along the axis, after turning.
    shift: f64,
    /// Added to radii.
    up: f64,
}

impl<'a> Copy<'a> {
    fn new(from: &'a Roll, to: Frame, turned: bool) -> Self {
        let (here, width) = (from.frame, contour(&from.designed).bounds().map_or(0.0, |b| b.max.z));
        let level = is_level(here.kind);
        // Turned round, a roll on a level axis lies mirrored at the middle of the strip; one beside it stays where it is.
        let face = if turned && level { -(here.face + width) } else { here.face };
        Self {
            from: &from.designed,
            other_strip: if level { turned } else { here.kind != to.kind },
            turned,
            width,
            shift: face - to.face,
            up: to.axis.abs() - here.axis.abs(),
        }
    }

    fn edits(&self, edits: &[RollEdit]) -> Vec<RollEdit> {
        let mut elements = self.from.to_vec();
        let copied = |edit: &RollEdit| {
            let action = self.action(&edit.action, &elements);
            // An edit that does not fit changes nothing, and is copied as it is.
            _ = carry_out(&mut elements, edit);
            RollEdit { id: edit.id, action }
        };
        edits.iter().map(copied).collect()
    }

    /// What is done, on `elements` as they are before it.
    fn action(&self, action: &EditAction, elements: &[RollElement]) -> EditAction {
        let corner = |name| self.corner(name, elements);
        match *action {
            EditAction::Chamfer { after, depth } => EditAction::Chamfer { after: corner(after), depth },
            EditAction::Blend { after, radius } => EditAction::Blend { after: corner(after), radius },
            EditAction::Delete { element } => EditAction::Delete { element: self.name(element) },
            EditAction::Insert { after, ref shape } => {
                let before = find_last(elements, after).ok();
                let neighbours = (before, before.map(|index| index + 1));
                EditAction::Insert { after: corner(after), shape: self.shape(shape, elements, neighbours) }
            }
            EditAction::Replace { element, ref shape } => {
                let at = find(elements, element).ok();
                let neighbours = (at.and_then(|index| index.checked_sub(1)), at.map(|index| index + 1));
                EditAction::Replace { element: self.name(element), shape: self.shape(shape, elements, neighbours) }
            }
        }
    }

    fn name(&self, name: ElementName) -> ElementName {
        let of_strip =
            matches!(name, ElementName::Strip { .. } | ElementName::Edge { .. } | ElementName::Unreached { .. });
        let changes = if of_strip { self.other_strip } else { self.turned };
        if changes { name.mirrored() } else { name }
    }

    /// The element before a corner: run the other way it is the one behind it.
    fn corner(&self, after: ElementName, elements: &[RollElement]) -> ElementName {
        let behind = || elements.get(find_last(elements, after).ok()? + 1)?.names.first().copied();
        let before = if self.turned { behind() } else { None };
        self.name(before.unwrap_or(after))
    }

    fn point(&self, p: RollPoint) -> RollPoint {
        let z = if self.turned { self.width - p.z } else { p.z };
        RollPoint { z: z + self.shift, diameter: p.diameter + 2.0 * self.up }
    }

    fn shape(
        &self,
        shape: &NewElement,
        elements: &[RollElement],
        (before, after): (Option<usize>, Option<usize>),
    ) -> NewElement {
        let angle = |deg: f64| if self.turned { 180.0 - deg } else { deg };
        match *shape {
            NewElement::LineTwoPoints { first, second } => {
                NewElement::LineTwoPoints { first: self.point(first), second: self.point(second) }
            }
            NewElement::LineAngle { point, angle_deg } => {
                NewElement::LineAngle { point: self.point(point), angle_deg: angle(angle_deg) }
            }
            NewElement::LineParallel { point, to } => {
                NewElement::LineParallel { point: self.point(point), to: self.name(to) }
            }
            NewElement::CircleRadius { center, radius } => {
                NewElement::CircleRadius { center: self.point(center), radius }
            }
            NewElement::CirclePoint { center, point } => {
                NewElement::CirclePoint { center: self.point(center), point: self.point(point) }
            }
            NewElement::CircleMoved { of, dz, dr } => {
                NewElement::CircleMoved { of: self.name(of), dz: if self.turned { -dz } else { dz }, dr }
            }
            NewElement::CircleTangent { radius, before: first, after: second } if self.turned => {
                let side = |side, index: Option<usize>| turned_side(side, index.and_then(|index| elements.get(index)));
                NewElement::CircleTangent { radius, before: side(second, after), after: side(first, before) }
            }
            NewElement::CircleTangent { .. } => shape.clone(),
        }
    }
}

const fn is_level(kind: RollKind) -> bool {
    matches!(kind, RollKind::Top | RollKind::Bottom)
}

/// Beside an upright line, left becomes right; above stays above.
fn turned_side(side: TangentSide, element: Option<&RollElement>) -> TangentSide {
    let upright = |p: Point, q: Point| (p.z - q.z).abs() <= 0.0;
    let is_upright = element.is_some_and(|e| matches!(e.segment, Segment::Line { start, end } if upright(start, end)));
    match side {
        TangentSide::Above if is_upright => TangentSide::Below,
        TangentSide::Below if is_upright => TangentSide::Above,
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{PieceKind, RollCopy, Side};
    use crate::rollform::editor::edited;
    use crate::rollform::fixtures::published_rolls;

    fn part(side: Side, part: u32) -> ElementName {
        ElementName::Extension { side, part }
    }

    fn top(station: u32) -> RollRef {
        RollRef { station, kind: RollKind::Top }
    }

    /// One edit of every kind on the right of a top roll with a spigot, and one on an element that an edit made.
    fn all_kinds() -> Vec<RollEdit> {
        let right = |number| part(Side::Right, number);
        let at = |z, diameter| RollPoint { z, diameter };
        let last = ElementName::Strip { element: 21, side: Side::Right, kind: PieceKind::Line };
        let actions = [
            EditAction::Chamfer { after: right(4), depth: 2.0 },
            EditAction::Insert {
                after: right(3),
                shape: NewElement::CircleTangent { radius: 1.5, before: TangentSide::Below, after: TangentSide::Above },
            },
            EditAction::Replace {
                element: right(4),
                shape: NewElement::LineAngle { point: at(153.0, 131.336), angle_deg: -2.0 },
            },
            EditAction::Blend { after: last, radius: 3.0 },
            EditAction::Insert {
                after: right(2),
                shape: NewElement::LineTwoPoints { first: at(144.0, 147.336), second: at(146.303, 144.0) },
            },
            EditAction::Delete { element: ElementName::Edit { edit: 5 } },
            EditAction::Replace {
                element: ElementName::Edit { edit: 1 },
                shape: NewElement::LineParallel { point: at(158.3, 131.0), to: last },
            },
        ];
        (1..).zip(actions).map(|(id, action)| RollEdit { id, action }).collect()
    }

    /// Largest distance of the ends of the elements of `a` from the contour `b`, mm.
    fn distance(a: &[RollElement], b: &[RollElement]) -> f64 {
        let ends = a.iter().flat_map(|e| [e.segment.start(), e.segment.end()]);
        let to_b = |p: Point| b.iter().map(|e| e.segment.distance_to(p)).fold(f64::INFINITY, f64::min);
        ends.map(to_b).fold(0.0, f64::max)
    }

    #[test]
    fn edits_copied_to_the_other_side_make_the_mirror_image() {
        let mut set = published_rolls();
        set.stations[1].tolerance_left = set.stations[1].tolerance_right;
        let design = design("x", &set);
        let roll = design.roll(top(2)).unwrap();
        let edits = all_kinds();
        let here = edited(&roll.designed, &edits);
        assert_eq!(here.faults, []);
        let there = edited(&roll.designed, &copied_edits(roll, roll, &edits, true));
        assert_eq!(there.faults, []);
        let width = contour(&roll.designed).bounds().unwrap().max.z;
        let mirrored: Vec<RollElement> = there
            .elements
            .iter()
            .map(|e| RollElement { segment: e.segment.mirrored_at_z(width / 2.0), ..e.clone() })
            .collect();
        assert!(distance(&here.elements, &mirrored) < 1e-6 && distance(&mirrored, &here.elements) < 1e-6);
        assert!(distance(&here.elements, &there.elements) > 1.0, "they are on the other side");
        // Turned twice they are as before.
        let back = copied_edits(roll, roll, &copied_edits(roll, roll, &edits, true), true);
        assert!(distance(&edited(&roll.designed, &back).elements, &here.elements) < 1e-6);
    }

    #[test]
    fn edits_keep_their_place_at_the_strip_on_the_roll_of_another_station() {
        let mut set = published_rolls();
        let spigots = set.stations[1].extension_right.clone();
        set.stations[0].extension_right = spigots;
        let design = design("x", &set);
        let (from, to) = (design.roll(top(2)).unwrap(), design.roll(top(1)).unwrap());
        let cut = |z: f64, diameter: f64| EditAction::Insert {
            after: part(Side::Right, 2),
            shape: NewElement::LineAngle { point: RollPoint { z, diameter }, angle_deg: -45.0 },
        };
        let edits = [RollEdit { id: 4, action: cut(132.0, 147.0) }];
        let copied = copied_edits(from, to, &edits, false);
        let EditAction::Insert { shape: NewElement::LineAngle { point, .. }, .. } = copied[0].action else {
            unreachable!("a line at an angle")
        };
        let strip = |roll: &Roll, p: RollPoint| roll.frame.point_to_strip(Point::new(p.z, p.diameter / 2.0));
        let before = strip(from, RollPoint { z: 132.0, diameter: 147.0 });
        assert!(strip(to, point).distance(before) < 1e-9);
        assert_eq!(copied[0].id, 4);
        // A roll that was the same as another one gets them for its own contour.
        set.roll_mut(top(2)).edits = edits.to_vec();
        set.roll_mut(top(1)).same_as = Some(RollCopy { roll: top(2), mirrored: false });
        assert_eq!(edits_for(&set, top(2), top(1), false), Some(copied));
        assert_eq!(edits_for(&set, top(2), top(99), false), None);
    }

    #[test]
    fn the_left_roll_takes_names_of_the_strip_on_its_own_side_and_faces_as_they_are() {
        let mut set = published_rolls();
        set.stations[2].tolerance_left = set.stations[2].tolerance_right;
        let right = RollRef { station: 3, kind: RollKind::Right };
        let left = RollRef { kind: RollKind::Left, ..right };
        let strip = ElementName::Strip { element: 19, side: Side::Right, kind: PieceKind::Line };
        let edits =
            [ElementName::Flank { side: Side::Left }, strip].map(|after| EditAction::Chamfer { after, depth: 0.5 });
        let edits: Vec<RollEdit> = (1..).zip(edits).map(|(id, action)| RollEdit { id, action }).collect();
        let design_of = |set: &_| design("x", set);
        let plain = design_of(&set);
        let copied = copied_edits(plain.roll(right).unwrap(), plain.roll(left).unwrap(), &edits, false);
        let names: Vec<EditAction> = copied.iter().map(|e| e.action.clone()).collect();
        let mirrored = ElementName::Strip { element: 19, side: Side::Left, kind: PieceKind::Line };
        let wanted = [ElementName::Flank { side: Side::Left }, mirrored];
        assert_eq!(names, wanted.map(|after| EditAction::Chamfer { after, depth: 0.5 }));
        set.roll_mut(right).edits = edits[..1].to_vec();
        set.roll_mut(left).edits = copied[..1].to_vec();
        let both = design_of(&set);
        let elements = |roll| both.roll(roll).unwrap().elements.clone();
        assert!(distance(&elements(left), &elements(right)) < 1e-9);
    }

    #[test]
    fn a_twin_is_another_edit_that_fits() {
        let design = design("x", &published_rolls());
        let roll = design.roll(top(2)).unwrap();
        let chamfer = |after, depth| RollEdit { id: 1, action: EditAction::Chamfer { after, depth } };
        let face = ElementName::Flank { side: Side::Left };
        let twin = twin_edit(roll, &chamfer(face, 2.0), 2).unwrap();
        assert_eq!(twin, RollEdit { id: 2, ..chamfer(part(Side::Right, 4), 2.0) });
        assert_eq!(twin_edit(roll, &chamfer(face, 1000.0), 2), None);
    }
}
