//! The part that is shown: that of the document, or a roll of a set as the part that it is turned as.

use super::{GestureId, Session};
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::document::{Content, Document, RollRef, RollWork, TurnedPart, fingerprint};
use crate::regen::{Derived, RollSetDerived};
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

impl Session {
    /// The turned part in the document, or the roll of a set that is shown, as a part; one without sections if there is none.
    #[must_use]
    pub fn part(&self) -> &TurnedPart {
        static NONE: LazyLock<TurnedPart> = LazyLock::new(TurnedPart::default);
        let shown = || self.setup().map(|setup| setup.part.as_ref());
        self.document.content.turned_part().or_else(shown).unwrap_or(&NONE)
    }

    /// The roll of a set that is shown.
    #[must_use]
    pub fn roll(&self) -> Option<RollRef> {
        self.selection.roll.or_else(|| self.rolls()?.of_setup(self.selection.setup).map(|roll| roll.roll))
    }

    fn rolls(&self) -> Option<&RollSetDerived> {
        self.derived.as_ref()?.rolls.as_deref()
    }

    /// Shows another roll of a set, with its station.
    pub fn select_roll(&mut self, roll: RollRef) {
        self.selection.roll = Some(roll);
        self.selection.station = Some(roll.station);
        self.selection.program = 0;
        self.selection.block = None;
        self.selection.operation = None;
        self.keep_selection_in_range();
    }

    /// What follows from what is shown: of a set, from its roll as a document of its own, if that can be turned.
    #[must_use]
    pub fn shown(&self) -> Option<&Arc<Derived>> {
        match self.rolls() {
            Some(rolls) => rolls.of_roll(self.roll()?).map(|roll| &roll.derived),
            None => self.derived.as_ref(),
        }
    }

    /// How many rolls of a set are proved, and how many there are; `None` for other documents.
    #[must_use]
    pub fn rolls_proved(&self) -> Option<(usize, usize)> {
        let set = self.rolls()?;
        Some((set.rolls.iter().filter(|roll| roll.is_proved()).count(), set.design.rolls().count()))
    }

    /// Errors that keep what is shown from the lathe: those of other rolls of a set do not.
    pub(super) fn errors_of_shown(&self) -> usize {
        let errors = self.problems().iter().filter(|d| d.severity == Severity::Error);
        match (self.rolls(), self.roll()) {
            (Some(set), Some(roll)) => errors.filter(|error| concerns(error, set, roll)).count(),
            _ => errors.count(),
        }
    }

    /// Changes the part; see [`Self::edit`]. Of a roll, what is decided about its turning is changed; its shape is designed.
    pub fn edit_part(&mut self, label: &str, gesture: Option<GestureId>, change: impl FnOnce(&mut TurnedPart)) {
        let shown = self.shown_roll();
        self.edit(label, gesture, |document| change_part(document, shown, change));
    }

    /// Types into the part; see [`Self::type_in`] and [`Self::edit_part`].
    pub fn type_in_part(&mut self, label: &str, change: impl FnOnce(&mut TurnedPart)) {
        let shown = self.shown_roll();
        self.type_in(label, |document| change_part(document, shown, change));
    }

    /// Notes in the document that a program went to the lathe, if it is one of a roll of the set.
    pub fn note_sent(&mut self, program: &str, text: &str) {
        let Some(roll) = self.rolls().and_then(|set| Some(set.of_program(program)?.roll)) else { return };
        let (program, fingerprint) = (program.to_owned(), fingerprint(text));
        self.edit(&format!("note that {program} was sent"), None, |document| {
            if let Content::RollSet(set) = &mut document.content {
                set.roll_mut(roll).sent.insert(program, fingerprint);
            }
        });
    }

    /// The text of a program as it was edited by hand, if it was.
    #[must_use]
    pub fn text_by_hand(&self, program: &str) -> Option<&String> {
        match &self.document.content {
            Content::Shell(shell) => shell.overrides.get(program),
            Content::TurnedPart(_) | Content::RollSet(_) => self.part().overrides.get(program),
        }
    }

    /// Puts a text in the place of a generated program, or gives up the one that was there.
    pub fn put_by_hand(&mut self, label: &str, gesture: Option<GestureId>, program: &str, text: Option<String>) {
        let name = program.to_owned();
        let change = |overrides: &mut BTreeMap<String, String>| match text {
            Some(text) => _ = overrides.insert(name, text),
            None => _ = overrides.remove(&name),
        };
        if !matches!(self.document.content, Content::Shell(_)) {
            self.edit_part(label, gesture, |part| change(&mut part.overrides));
            return;
        }
        self.edit(label, gesture, |document| {
            if let Content::Shell(shell) = &mut document.content {
                change(&mut shell.overrides);
            }
        });
    }

    fn shown_roll(&self) -> Option<(RollRef, TurnedPart)> {
        Some((self.roll()?, self.setup()?.part.as_ref().clone()))
    }
}

/// True if an error is about this roll, its station or all of the set.
fn concerns(error: &Diagnostic, set: &RollSetDerived, roll: RollRef) -> bool {
    match &error.at {
        Place::Roll { name } => set.design.roll(roll).is_some_and(|r| r.name == *name),
        Place::Station { id, .. } => *id == roll.station,
        Place::Block { program, .. } => set
            .of_roll(roll)
            .is_some_and(|made| made.derived.setups.iter().flat_map(|s| s.programs.iter()).any(|p| p.name == *program)),
        _ => true,
    }
}

/// Changes the part that is shown: that of the document, or, of a set, the roll `shown` with the part it is turned as.
///
/// A roll's shape follows from its design, so that only what is decided about its turning goes into the document.
fn change_part(document: &mut Document, shown: Option<(RollRef, TurnedPart)>, change: impl FnOnce(&mut TurnedPart)) {
    match (&mut document.content, shown) {
        (Content::TurnedPart(part), _) => change(part),
        (Content::RollSet(set), Some((roll, mut before))) => {
            // What is shown may be older than the document.
            set.roll(roll).cloned().unwrap_or_else(|| RollWork::of(roll)).put_into(&mut before);
            before.machine.clone_from(&set.machine);
            set.material_of(roll).clone_into(&mut before.material);
            let mut after = before.clone();
            change(&mut after);
            if after == before {
                return;
            }
            set.machine.clone_from(&after.machine);
            let of_set = set.material.clone();
            let work = set.roll_mut(roll);
            work.take_from(&before, after);
            work.material = work.material.take().filter(|own| !own.eq_ignore_ascii_case(&of_set));
        }
        (Content::RollSet(_) | Content::Shell(_), _) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{FORMAT_VERSION, Origin, RollKind, RollSet};
    use crate::rollform::fixtures;
    use crate::units::Unit;

    const TOP: RollRef = RollRef { station: 1, kind: RollKind::Top };

    fn document() -> Document {
        let elements = vec![fixtures::line(1, 20.0), fixtures::bend(2, 2.0, 90.0), fixtures::line(3, 10.0)];
        let set = fixtures::set(1.0, Origin::Symmetrical, elements, vec![fixtures::station(1, &[(2, 30.0)])]);
        let content = Content::RollSet(set);
        Document { turnwright: FORMAT_VERSION, name: "SET".to_owned(), unit: Unit::Mm, content }
    }

    fn set(document: &Document) -> &RollSet {
        document.content.roll_set().unwrap()
    }

    #[test]
    fn only_what_was_changed_is_decided_and_nothing_leaves_no_trace() {
        let mut edited = document();
        let shown = TurnedPart { bar_diameter: 140.0, ..TurnedPart::default() };
        change_part(&mut edited, Some((TOP, shown.clone())), |_| {});
        assert_eq!(edited, document());
        change_part(&mut edited, Some((TOP, shown)), |part| part.bar_diameter = 150.0);
        let work = set(&edited).roll(TOP).unwrap();
        assert_eq!(*work, RollWork { blank_diameter: Some(150.0), ..RollWork::of(TOP) });
    }

    #[test]
    fn a_roll_has_a_material_of_its_own_until_it_is_that_of_the_set() {
        let mut edited = document();
        let shown = TurnedPart::default();
        let choose = |edited: &mut Document, name: &str| {
            change_part(edited, Some((TOP, shown.clone())), |part| name.clone_into(&mut part.material));
        };
        choose(&mut edited, "C45");
        let other = RollRef { kind: RollKind::Bottom, ..TOP };
        let of = |edited: &Document, roll| set(edited).material_of(roll).to_owned();
        assert_eq!((of(&edited, TOP).as_str(), of(&edited, other).as_str()), ("C45", "STEEL"));
        choose(&mut edited, "steel");
        assert_eq!(set(&edited).roll(TOP).unwrap().material, None);
    }

    #[test]
    fn a_second_edit_keeps_the_first_though_what_is_shown_is_older() {
        let mut edited = document();
        let shown = TurnedPart::default();
        let put = |name: &str| (name.to_owned(), "M30".to_owned());
        for name in ["A", "B"] {
            change_part(&mut edited, Some((TOP, shown.clone())), |part| part.overrides.extend([put(name)]));
        }
        assert_eq!(set(&edited).roll(TOP).unwrap().overrides, [put("A"), put("B")].into());
    }
}
