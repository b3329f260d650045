//! What a roll on an upright axis is designed by: its axis, the run of elements with their faces, its extension contours.

use super::{Fields, Side};
use crate::document::{
    Element, ElementKind, ExtensionContour, ExtensionKind, Face, Origin, SideEnd, SideRoll, Station,
};
use crate::session::Session;
use egui::Ui;

/// Faces of an element that bound the contour (published 1 to 4).
const FACES: [(Face, &str); 4] =
    [(Face::Bottom, "bottom"), (Face::Top, "top"), (Face::Leading, "leading end"), (Face::Trailing, "trailing end")];

/// Which end of the contour.
#[derive(Clone, Copy)]
enum End {
    From,
    To,
}

impl End {
    const fn of(self, roll: &SideRoll) -> SideEnd {
        match self {
            Self::From => roll.from,
            Self::To => roll.to,
        }
    }

    const fn of_mut(self, roll: &mut SideRoll) -> &mut SideEnd {
        match self {
            Self::From => &mut roll.from,
            Self::To => &mut roll.to,
        }
    }
}

impl Fields<'_> {
    /// The fields of one side roll.
    pub(super) fn side_roll(&self, ui: &mut Ui, session: &mut Session, side: Side, label: &str) {
        let present = side.roll(self.station);
        let fresh = self.usual_side_roll(side);
        let all = [(false, self.unless_as_right(side, "none")), (true, "side roll".to_owned())];
        self.choice(ui, session, label, &present.is_some(), &all, |station, wanted| {
            *side.roll_mut(station) = if wanted { fresh } else { None };
        });
        let Some(roll) = present else { return };
        self.length(ui, session, &format!("{label} axis"), roll.axis_distance, |station, value| {
            in_roll(station, side, |roll| roll.axis_distance = value);
        });
        for (end, word) in [(End::From, "from"), (End::To, "to")] {
            self.end(ui, session, side, end, &format!("{label} {word}"));
        }
        for (index, word) in ["below", "above"].into_iter().enumerate() {
            self.beyond(ui, session, side, index, &format!("{label} {word}"));
        }
    }

    /// The element and the face at which a contour begins or ends.
    fn end(&self, ui: &mut Ui, session: &mut Session, side: Side, end: End, label: &str) {
        let Some(present) = side.roll(self.station).map(|roll| end.of(roll)) else { return };
        let numbers: Vec<(u32, String)> = (1..)
            .zip(self.elements_of(side))
            .map(|(number, e): (usize, _)| (e.id, format!("element {number}")))
            .collect();
        self.choice(ui, session, label, &present.element, &numbers, |station, element| {
            in_roll(station, side, |roll| end.of_mut(roll).element = element);
        });
        let faces = FACES.map(|(face, name)| (face, name.to_owned()));
        self.choice(ui, session, &format!("{label} face"), &present.face, &faces, |station, face| {
            in_roll(station, side, |roll| end.of_mut(roll).face = face);
        });
    }

    /// What a contour goes on with, below (0) or above (1).
    fn beyond(&self, ui: &mut Ui, session: &mut Session, side: Side, index: usize, label: &str) {
        let Some(roll) = side.roll(self.station) else { return };
        let lengths = roll.extensions.get(index).map_or([0.0; 4], |e| e.lengths);
        for (part, length) in lengths.into_iter().enumerate() {
            self.length(ui, session, &format!("{label} {}", part + 1), length, |station, value| {
                in_roll(station, side, |roll| {
                    let none = ExtensionContour { kind: ExtensionKind::SideRoll, lengths: [0.0; 4] };
                    roll.extensions.resize(roll.extensions.len().max(index + 1), none);
                    if let Some(length) = roll.extensions.get_mut(index).and_then(|e| e.lengths.get_mut(part)) {
                        *length = value;
                    }
                });
            });
        }
    }

    /// The elements on a side, from the origin outwards.
    fn elements_of(&self, side: Side) -> &[Element] {
        let section = &self.set.section;
        match (section.origin, side) {
            (Origin::CentreRightFirst, Side::Left) | (Origin::CentreLeftFirst, Side::Right) => &section.other_side,
            _ => &section.elements,
        }
    }

    /// A side roll on the outside of all that is bent, as far out as the shafts of the station are apart.
    fn usual_side_roll(&self, side: Side) -> Option<SideRoll> {
        let elements = self.elements_of(side);
        let bent = elements.iter().find(|e| matches!(e.kind, ElementKind::Bend { .. }))?;
        let down = matches!(bent.kind, ElementKind::Bend { angle_deg, .. } if angle_deg < 0.0);
        let face = if down { Face::Top } else { Face::Bottom };
        Some(SideRoll {
            axis_distance: self.station.centre_distance,
            from: SideEnd { element: bent.id, face },
            to: SideEnd { element: elements.last()?.id, face },
            extensions: Vec::new(),
        })
    }
}

fn in_roll(station: &mut Station, side: Side, change: impl FnOnce(&mut SideRoll)) {
    if let Some(roll) = side.roll_mut(station) {
        change(roll);
    }
}
