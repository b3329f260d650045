//! Where the contour of a roll comes from, edits taken over from another roll, and what it is made of.

use crate::app::rolls::set_mut;
use crate::app::widgets::{choice, form_label};
use crate::document::{Document, RollCopy, RollKind, RollRef, RollSet};
use crate::machine::Catalog;
use crate::rollform::Roll;
use crate::rollform::editor::{begin_own, decided, edits_for, follows_right, may_follow_right};
use crate::session::Session;
use egui::Ui;

/// Width of the label and of the field, points; those of the form below.
const LABEL: f32 = 92.0;
const FIELD: f32 = 158.0;

/// What the contour of a roll is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Contour {
    /// As designed for its station, and edited.
    Own,
    /// That of the right roll, mirrored at the middle of the strip.
    AsRight,
    /// That of another roll, edits included.
    As(RollCopy),
}

/// Shows the fields.
pub(super) fn show(ui: &mut Ui, session: &mut Session, set: &RollSet, roll: &Roll, catalog: &Catalog) {
    let at = roll.roll;
    let others = others(set, at);
    let chosen = row(ui, "Contour", &contour(set, at), &contours(set, at, &others));
    if let Some(contour) = chosen {
        change(session, "contour of a roll", |document| put_contour(document, at, contour));
    }
    let all = edits_of_others(set, &others);
    if all.len() > 1
        && let Some(Some(copy)) = row(ui, "Copy edits", &None, &all)
    {
        change(session, "copied edits of a roll", |document| copy_edits(document, copy, at));
    }
    if let Some(material) = row(ui, "Own material", &own_material(set, at), &materials(set, at, catalog, session)) {
        change(session, "material of a roll", |document| {
            if let Some(set) = set_mut(document) {
                set.roll_mut(at).material = material;
            }
        });
    }
}

fn row<T: PartialEq + Clone>(ui: &mut Ui, label: &str, present: &T, all: &[(T, String)]) -> Option<T> {
    let row = ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 8.0;
        form_label(ui, label, LABEL);
        choice(ui, label, present, all, FIELD)
    });
    row.inner
}

fn change(session: &mut Session, label: &str, change: impl FnOnce(&mut Document)) {
    session.edit(label, None, change);
}

fn contour(set: &RollSet, roll: RollRef) -> Contour {
    let same_as = set.roll(roll).and_then(|work| work.same_as);
    let own = if follows_right(set, roll) { Contour::AsRight } else { Contour::Own };
    same_as.map_or(own, Contour::As)
}

fn put_contour(document: &mut Document, roll: RollRef, contour: Contour) {
    let Some(set) = set_mut(document) else { return };
    let may_follow = may_follow_right(set, roll);
    let work = set.roll_mut(roll);
    work.same_as = if let Contour::As(copy) = contour { Some(copy) } else { None };
    work.own_contour = may_follow && contour == Contour::Own;
    if contour == Contour::AsRight {
        work.edits.clear();
    }
}

/// Gives a roll the edits of another one in place of its own.
fn copy_edits(document: &mut Document, from: RollCopy, to: RollRef) {
    let in_mm = document.unit.in_mm();
    let Some(set) = set_mut(document) else { return };
    if let Some(edits) = edits_for(&set.scaled(in_mm), from.roll, to, from.mirrored) {
        let work = begin_own(set, to);
        work.same_as = None;
        work.edits = edits.iter().map(|edit| edit.scaled(1.0 / in_mm)).collect();
    }
}

/// Every other roll on such an axis, with its name.
fn others(set: &RollSet, own: RollRef) -> Vec<(RollRef, String)> {
    let upright = |kind| matches!(kind, RollKind::Left | RollKind::Right);
    let stations = (1_usize..).zip(&set.stations).filter(|(_, station)| !station.without_rolls);
    let others = stations.flat_map(|(number, station)| {
        let kinds = RollKind::ALL.into_iter().filter(|kind| match kind {
            RollKind::Left | RollKind::Right => station.side_right.is_some() || station.side_left.is_some(),
            RollKind::Top | RollKind::Bottom => true,
        });
        kinds.map(move |kind| (RollRef { station: station.id, kind }, format!("{number}{}", kind.letter())))
    });
    others.filter(|(roll, _)| *roll != own && upright(roll.kind) == upright(own.kind)).collect()
}

/// Its own design, and every other roll, each as it is and turned round.
fn contours(set: &RollSet, own: RollRef, others: &[(RollRef, String)]) -> Vec<(Contour, String)> {
    let mut all = vec![(Contour::Own, "designed here".to_owned())];
    if may_follow_right(set, own) {
        all.insert(0, (Contour::AsRight, "as the right roll".to_owned()));
    }
    all.extend(others.iter().flat_map(|other| both_ways("as", other)).map(|(copy, text)| (Contour::As(copy), text)));
    all
}

/// The rolls whose edits can be taken over.
fn edits_of_others(set: &RollSet, others: &[(RollRef, String)]) -> Vec<(Option<RollCopy>, String)> {
    let edited = others.iter().filter(|(roll, _)| !decided(set, *roll).edits.is_empty());
    let copies = edited.flat_map(|other| both_ways("from", other)).map(|(copy, text)| (Some(copy), text));
    std::iter::once((None, "from another roll …".to_owned())).chain(copies).collect()
}

fn both_ways(word: &str, (roll, name): &(RollRef, String)) -> [(RollCopy, String); 2] {
    [
        (RollCopy { roll: *roll, mirrored: false }, format!("{word} {name}")),
        (RollCopy { roll: *roll, mirrored: true }, format!("{word} {name}, turned")),
    ]
}

fn own_material(set: &RollSet, roll: RollRef) -> Option<String> {
    set.roll(roll).and_then(|work| work.material.as_ref()).map(|name| name.to_lowercase())
}

/// The material of the set, and those of the table.
fn materials(set: &RollSet, roll: RollRef, catalog: &Catalog, session: &Session) -> Vec<(Option<String>, String)> {
    let names = super::super::words::material_names(catalog, session.document().unit, own_material(set, roll));
    let as_set = (None, format!("as the set: {}", set.material.to_lowercase()));
    std::iter::once(as_set).chain(names.into_iter().map(|name| (Some(name.clone()), name))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Content, EditAction, ElementName, FORMAT_VERSION, RollEdit, Side};
    use crate::rollform::design;
    use crate::rollform::fixtures::published_rolls;
    use crate::units::Unit;

    fn document(set: RollSet) -> Document {
        Document { turnwright: FORMAT_VERSION, name: "x".to_owned(), unit: Unit::Mm, content: Content::RollSet(set) }
    }

    fn set_of(document: &Document) -> &RollSet {
        document.content.roll_set().unwrap()
    }

    #[test]
    fn every_choice_is_a_roll_that_can_be_taken() {
        let set = published_rolls();
        for (kind, count) in [(RollKind::Top, 1 + 2 * 5), (RollKind::Left, 2 + 2)] {
            let own = RollRef { station: 3, kind };
            let all = contours(&set, own, &others(&set, own));
            assert_eq!(all.len(), count, "{all:?}");
            for (choice, name) in all {
                let mut document = document(set.clone());
                put_contour(&mut document, own, choice);
                assert_eq!(contour(set_of(&document), own), choice, "{name}");
                let design = design("x", set_of(&document));
                let roll = design.roll(own).unwrap();
                assert!(!roll.diagnostics.iter().any(|d| d.code == "roll-copy"), "{name}");
            }
        }
    }

    #[test]
    fn copied_edits_are_independent() {
        let (top, bottom) = [RollKind::Top, RollKind::Bottom].map(|kind| RollRef { station: 1, kind }).into();
        let mut set = published_rolls();
        let after = ElementName::Flank { side: Side::Left };
        set.roll_mut(top).edits = vec![RollEdit { id: 3, action: EditAction::Chamfer { after, depth: 2.0 } }];
        assert_eq!(edits_of_others(&set, &others(&set, bottom)).len(), 3);
        let mut document = document(set);
        copy_edits(&mut document, RollCopy { roll: top, mirrored: false }, bottom);
        assert_eq!(set_of(&document).roll(bottom).unwrap().edits, set_of(&document).roll(top).unwrap().edits);
        set_mut(&mut document).unwrap().roll_mut(top).edits.clear();
        assert_eq!(set_of(&document).roll(bottom).unwrap().edits.len(), 1);
    }
}
