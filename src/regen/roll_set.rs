//! A set of form-rolls: every roll is turned like any part, each with stages of its own, the one on screen first.

use super::cache::PartCache;
use super::{Derived, Stage, Steps, file_stem, turned_part};
use crate::cancel::{Cancel, Cancelled};
use crate::diagnostic::{Diagnostic, Place, Severity, has_errors};
use crate::document::{Content, Document, FORMAT_VERSION, RollRef, RollSet, RollWork, fingerprint};
use crate::machine::Catalog;
use crate::proof::ProgramText;
use crate::rollform::flower::Flower;
use crate::rollform::{self, Roll, RollDesign};
use crate::units::Unit;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// Everything that follows from a set of form-rolls.
#[derive(Debug, Clone, Default)]
pub struct RollSetDerived {
    /// The strip at every stage with what is to be said about it, mm.
    pub flower: Arc<Flower>,
    /// Strip and rolls of every station, mm.
    pub design: Arc<RollDesign>,
    /// The rolls, station by station, as far as they can be turned.
    pub rolls: Vec<RollDerived>,
}

/// One roll of a set, as a turned part.
#[derive(Debug, Clone)]
pub struct RollDerived {
    /// Which roll.
    pub roll: RollRef,
    /// Its name: `1470b-2T`.
    pub name: String,
    /// What follows from it as a document of its own.
    pub derived: Arc<Derived>,
    /// Its clampings among those of the set.
    pub setups: Range<usize>,
    /// True if it is the roll as it is designed now, not as it was before the last edit.
    pub current: bool,
    /// True if there is nothing wrong with its design.
    pub sound: bool,
}

impl RollDerived {
    /// True if the roll is soundly designed and the programs of it as it is now passed their proofs.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        let derived = &self.derived;
        self.current
            && self.sound
            && !has_errors(&derived.diagnostics)
            && derived.setups.iter().any(|s| !s.programs.is_empty())
            && derived.setups.iter().all(|s| s.proof.passed)
    }
}

/// Whether a roll went to the lathe.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sent {
    /// Never, or not all of its programs.
    No,
    /// All its programs, as they are now.
    Yes,
    /// It has changed since.
    Before,
}

impl RollDerived {
    /// Whether the roll went to the lathe as it is now; `work` is what the document says of it.
    #[must_use]
    pub fn sent(&self, work: Option<&RollWork>) -> Sent {
        let Some(noted) = work.map(|work| &work.sent).filter(|sent| !sent.is_empty()) else { return Sent::No };
        let programs: Vec<_> = self.derived.setups.iter().flat_map(|s| s.programs.iter()).collect();
        let as_sent = |p: &&ProgramText| noted.get(&p.name).map(|of| *of == fingerprint(&p.text));
        let told: Vec<Option<bool>> = programs.iter().map(as_sent).collect();
        match () {
            () if !self.current || told.is_empty() || told.contains(&Some(false)) => Sent::Before,
            () if told.iter().all(|t| *t == Some(true)) => Sent::Yes,
            () => Sent::No,
        }
    }
}

impl RollSetDerived {
    /// The roll that has a program of this name.
    #[must_use]
    pub fn of_program(&self, name: &str) -> Option<&RollDerived> {
        let has = |r: &&RollDerived| r.derived.setups.iter().flat_map(|s| s.programs.iter()).any(|p| p.name == name);
        self.rolls.iter().find(has)
    }

    /// The roll that a clamping of the set belongs to.
    #[must_use]
    pub fn of_setup(&self, index: usize) -> Option<&RollDerived> {
        self.rolls.iter().find(|roll| roll.setups.contains(&index))
    }

    /// What follows from a roll.
    #[must_use]
    pub fn of_roll(&self, roll: RollRef) -> Option<&RollDerived> {
        self.rolls.iter().find(|r| r.roll == roll)
    }
}

/// What a roll is turned from: its name, the set's unit and the part in that unit.
type RollInput = (String, Unit, crate::document::TurnedPart);

/// The stages of a set.
#[derive(Debug, Default)]
pub(super) struct RollSetCache {
    flower: Stage<RollSet, Flower>,
    design: Stage<(String, RollSet), RollDesign>,
    rolls: BTreeMap<RollRef, RollCache>,
}

/// The stages of one roll, and what came of them last.
#[derive(Debug, Default)]
struct RollCache {
    document: Stage<RollInput, Document>,
    part: PartCache,
    last: Option<Arc<Derived>>,
}

impl RollSetCache {
    /// The stages of every roll.
    pub(super) fn parts(&self) -> impl Iterator<Item = &PartCache> {
        self.rolls.values().map(|roll| &roll.part)
    }
}

/// Makes everything that follows from `set`, which is the content of `document`. What can be shown before all rolls are made
/// is told: the design, then the first roll of `steps`.
pub(super) fn regenerate(
    document: &Arc<Document>,
    set: &RollSet,
    catalog: &Catalog,
    cache: &mut RollSetCache,
    cancel: &Cancel,
    steps: Steps<'_>,
) -> Result<Derived, Cancelled> {
    let Steps { first, tell } = steps;
    let Some(machine) = catalog.machine(&set.machine).cloned() else {
        let missing = turned_part::no_such_machine(&set.machine, catalog);
        return Ok(Derived::only(document, vec![missing]));
    };
    let set_mm = set.scaled(document.unit.in_mm());
    // The strip does not follow from what was decided about single rolls.
    let flower = cache.flower.get(RollSet { rolls: Vec::new(), ..set_mm.clone() }, Flower::of);
    let said = rollform::rules::check(&set_mm, &flower, document.unit);
    let design = cache.design.get((file_stem(&document.name), set_mm), |(name, set)| rollform::design(name, set));
    cancel.check()?;
    let rolls: Vec<&Roll> = design.rolls().collect();
    cache.rolls.retain(|known, _| rolls.iter().any(|roll| roll.roll == *known));
    for roll in &rolls {
        cache.rolls.entry(roll.roll).or_default().take(roll, document.unit);
    }
    let whole = Whole { document, flower, said, design: &design, machine: Arc::new(machine) };
    let mut waiting: Vec<&mut RollCache> = cache.rolls.values_mut().filter(|roll| !roll.is_current()).collect();
    if !waiting.is_empty() {
        drop(waiting);
        tell(whole.derived(&cache.rolls, false));
        if let Some(roll) = first.and_then(|first| cache.rolls.get_mut(&first))
            && !roll.is_current()
        {
            roll.make(catalog, cancel)?;
            tell(whole.derived(&cache.rolls, false));
        }
        waiting = cache.rolls.values_mut().filter(|roll| !roll.is_current()).collect();
        waiting.par_iter_mut().try_for_each(|roll| roll.make(catalog, cancel))?;
    }
    Ok(whole.derived(&cache.rolls, true))
}

impl RollCache {
    /// Takes over the roll as it is designed now.
    fn take(&mut self, roll: &Roll, unit: Unit) {
        let input = (roll.name.clone(), unit, roll.part.scaled(1.0 / unit.in_mm()));
        self.document.get(input, |(name, unit, part)| Document {
            turnwright: FORMAT_VERSION,
            name: name.clone(),
            unit: *unit,
            content: Content::TurnedPart(part.clone()),
        });
    }

    /// True if `last` was made from the roll as it is designed now.
    fn is_current(&self) -> bool {
        self.document.output().zip(self.last.as_ref()).is_some_and(|(now, last)| Arc::ptr_eq(now, &last.document))
    }

    fn make(&mut self, catalog: &Catalog, cancel: &Cancel) -> Result<(), Cancelled> {
        let Some(document) = self.document.output() else { return Ok(()) };
        let Content::TurnedPart(part) = &document.content else { return Ok(()) };
        let made = turned_part::regenerate(document, part, catalog, &mut self.part, cancel)?;
        self.last = Some(Arc::new(made));
        Ok(())
    }
}

/// What the results of all rolls are put together from.
struct Whole<'a> {
    document: &'a Arc<Document>,
    flower: Arc<Flower>,
    /// What there is to say about section and flower.
    said: Vec<Diagnostic>,
    design: &'a Arc<RollDesign>,
    machine: Arc<crate::machine::Machine>,
}

impl Whole<'_> {
    /// All that there is by now; `complete` if every roll is as it is designed.
    fn derived(&self, made: &BTreeMap<RollRef, RollCache>, complete: bool) -> Derived {
        let mut diagnostics = self.said.clone();
        diagnostics.extend(self.design.diagnostics.iter().cloned());
        let (mut setups, mut rolls) = (Vec::new(), Vec::new());
        for roll in self.design.rolls() {
            diagnostics.extend(roll.diagnostics.iter().cloned());
            let Some(of_roll) = made.get(&roll.roll) else { continue };
            let Some(derived) = &of_roll.last else { continue };
            let first = setups.len();
            setups.extend(derived.setups.iter().cloned());
            diagnostics.extend(of_the_roll(&roll.name, &derived.diagnostics));
            rolls.push(RollDerived {
                roll: roll.roll,
                name: roll.name.clone(),
                derived: Arc::clone(derived),
                setups: first..setups.len(),
                current: of_roll.is_current(),
                sound: self.design.is_sound(roll),
            });
        }
        let material = rolls.iter().find_map(|roll| roll.derived.material.clone());
        let rolls =
            Some(Arc::new(RollSetDerived { flower: Arc::clone(&self.flower), design: Arc::clone(self.design), rolls }));
        let machine = Some(Arc::clone(&self.machine));
        Derived { machine, material, setups, rolls, complete, ..Derived::only(self.document, diagnostics) }
    }
}

/// Messages about the part that a roll is turned as, as ones about the roll, which name the rows: what is said alike of both rows
/// at a corner is said once, and remarks of one kind are one that names all rows.
fn of_the_roll(name: &str, all: &[Diagnostic]) -> Vec<Diagnostic> {
    /// Messages of neighbouring rows are not further apart.
    const NEAR: usize = 4;
    let mut groups: Vec<(&Diagnostic, Vec<&Place>)> = Vec::new();
    for said in all {
        let alike = |other: &Diagnostic| (&other.code, &other.message) == (&said.code, &said.message);
        match groups.iter_mut().rev().take(NEAR).find(|(other, _)| is_of_part(&said.at) && alike(other)) {
            Some((_, places)) if !places.contains(&&said.at) => places.push(&said.at),
            _ => groups.push((said, vec![&said.at])),
        }
    }
    let is_remark = |said: &Diagnostic| is_of_part(&said.at) && said.severity == Severity::Info;
    let mut told: Vec<(&Diagnostic, Vec<Vec<&Place>>)> = Vec::new();
    for (said, places) in groups {
        match told.iter_mut().find(|(first, _)| is_remark(first) && is_remark(said) && first.code == said.code) {
            Some((_, all)) => all.push(places),
            None => told.push((said, vec![places])),
        }
    }
    told.into_iter()
        .map(|(said, at)| if is_of_part(&said.at) { renamed(name, said, &at) } else { said.clone() })
        .collect()
}

/// The names of rows that are neighbours.
fn named(places: &[&Place]) -> String {
    places.iter().map(ToString::to_string).collect::<Vec<_>>().join(" and ")
}

/// True if a place is one of the part, and not of its program, machine or tools.
const fn is_of_part(at: &Place) -> bool {
    !matches!(at, Place::Block { .. } | Place::Machine { .. } | Place::Tool { .. })
}

/// What is said of one stretch of rows, and of further ones alike.
fn renamed(name: &str, said: &Diagnostic, stretches: &[Vec<&Place>]) -> Diagnostic {
    let mut names = stretches.iter().map(|places| named(places));
    let first = names.next().unwrap_or_default();
    let others = names.collect::<Vec<_>>().join("; ");
    let also = if others.is_empty() { String::new() } else { format!(" Also at {others}.") };
    let places = stretches.iter().flatten().map(|place| (*place).clone());
    Diagnostic {
        at: Place::Roll { name: name.to_owned() },
        message: format!("{first}: {}{also}", said.message),
        related: places.chain(said.related.iter().cloned()).collect(),
        ..said.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::SectionTable;

    #[test]
    fn a_corner_is_told_once_with_both_rows_and_programs_keep_their_places() {
        let row = |row: usize| Place::Section { id: 1, table: SectionTable::Outside, row, column: None };
        let left = |at: Place, mm: &str| Diagnostic::error("not-reached", at, format!("{mm} mm are left."));
        let block = Place::Block { program: "X".to_owned(), block: 7 };
        let all = [left(row(2), "0.1"), left(row(3), "0.1"), left(row(3), "0.2"), left(block.clone(), "0.2")];
        let told = of_the_roll("1470b-2T", &all);
        let messages: Vec<&str> = told.iter().map(|d| d.message.as_str()).collect();
        let (a, b) = (row(2).to_string(), row(3).to_string());
        assert_eq!(
            messages,
            [format!("{a} and {b}: 0.1 mm are left."), format!("{b}: 0.2 mm are left."), "0.2 mm are left.".into()]
        );
        assert_eq!((told[0].related.as_slice(), &told[2].at), ([row(2), row(3)].as_slice(), &block));
    }

    #[test]
    fn remarks_of_one_kind_are_one_that_names_all_rows() {
        let row = |row: usize| Place::Section { id: 1, table: SectionTable::Outside, row, column: None };
        let left =
            |at: Place, mm: &str| Diagnostic::new(Severity::Info, "not-reached", at, format!("{mm} mm are left."));
        let mut all: Vec<Diagnostic> =
            [2, 3, 6, 7, 9].map(|k| left(row(k), if k < 6 { "0.1" } else { "0.2" })).to_vec();
        all.push(Diagnostic { severity: Severity::Warning, ..left(row(12), "3.0") });
        let told = of_the_roll("1470b-2T", &all);
        let [remark, warning] = told.as_slice() else { panic!("{told:?}") };
        let name = |k: usize| row(k).to_string();
        assert_eq!(
            remark.message,
            format!(
                "{} and {}: 0.1 mm are left. Also at {} and {} and {}.",
                name(2),
                name(3),
                name(6),
                name(7),
                name(9)
            )
        );
        assert_eq!(remark.related.len(), 5);
        assert!(warning.message.contains("3.0 mm"), "warnings stay by themselves: {}", warning.message);
    }
}
