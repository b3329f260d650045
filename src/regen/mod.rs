//! From a document to everything that follows from it, in one pure call.
//!
//! A stage keeps one pair of input and output and compares inputs by value; an equal input gives the same `Arc` again, so
//! later stages see that nothing changed.

mod cache;
mod operations;
mod roll_set;
mod shell;
mod stage;
mod turned_part;

use crate::cancel::{Cancel, Cancelled};
use crate::diagnostic::Diagnostic;
use crate::document::{Content, Document, RollRef, TurnedPart};
use crate::machine::{Catalog, Machine, Material, ToolOutline};
use crate::part::{PartContour, Setup};
use crate::post::PostOutput;
use crate::proof::{ProgramText, ProofReport};
use crate::turning::{CutterPath, UnreachableArea};
pub use cache::{Cache, StageRuns};
pub use operations::{OperationTime, Operations};
pub use roll_set::{RollDerived, RollSetDerived, Sent};
pub use shell::ShellDerived;
pub use stage::Stage;
use std::collections::BTreeMap;
use std::sync::Arc;
pub use turned_part::{post_options, proof_input};

/// Everything that follows from a document.
#[derive(Debug, Clone)]
pub struct Derived {
    /// The document it was made from.
    pub document: Arc<Document>,
    /// The machine, if the document names one that exists.
    pub machine: Option<Arc<Machine>>,
    /// The material in mm: the document's, or the first of the table if it is not known.
    pub material: Option<Material>,
    /// The clampings in order of machining: one, or two for a part machined at both ends; those of every roll of a set, roll by
    /// roll.
    pub setups: Vec<SetupDerived>,
    /// What the checks, the generator and the post have to say. Findings of proofs are in the set-ups.
    pub diagnostics: Vec<Diagnostic>,
    /// What follows from a set of form-rolls before its rolls are turned.
    pub rolls: Option<Arc<RollSetDerived>>,
    /// False while rolls of a set are still as they were before the last edit.
    pub complete: bool,
    /// What follows from a shell.
    pub shell: Option<Arc<ShellDerived>>,
}

/// Everything that follows for one clamping. All geometry is in the part space of the set-up, mm.
#[derive(Debug, Clone)]
pub struct SetupDerived {
    /// Name of the item: the document's name and the suffix of the end.
    pub name: String,
    /// The part in the unit of the document.
    pub part: Arc<TurnedPart>,
    /// Stock, profile, holding.
    pub setup: Arc<Setup>,
    /// The profile as lines and arcs.
    pub contour: Arc<PartContour>,
    /// The bore as lines and arcs, if there is one.
    pub bore: Arc<Option<PartContour>>,
    /// Areas that the tools cannot reach.
    pub unreachable: Arc<Vec<UnreachableArea>>,
    /// Cutter location data.
    pub path: Arc<CutterPath>,
    /// Programs and side files as generated.
    pub post: Arc<PostOutput>,
    /// The programs as they will be sent: generated, or edited by hand.
    pub programs: Arc<Vec<ProgramText>>,
    /// Proof of `programs`.
    pub proof: Arc<ProofReport>,
    /// Outline of every tool of the machine by turret station.
    pub tools: Arc<BTreeMap<u32, ToolOutline>>,
}

/// Distance that lines and arcs may keep from a parabola when it is drawn, exported and proved, mm.
pub const CONTOUR_TOLERANCE_MM: f64 = 0.0005;

/// Makes everything that follows from `document`; what has not changed since the last call with the same `cache` is kept.
///
/// # Errors
/// [`Cancelled`] once `cancel` was called; the cache stays usable.
pub fn regenerate(
    document: &Arc<Document>,
    catalog: &Catalog,
    cache: &mut Cache,
    cancel: &Cancel,
) -> Result<Derived, Cancelled> {
    regenerate_in_steps(document, catalog, cache, cancel, Steps { first: None, tell: &mut |_| {} })
}

/// What is wanted early of a document that takes long.
pub struct Steps<'a> {
    /// The roll of a set to be made before the others.
    pub first: Option<RollRef>,
    /// Called with what there is before everything is made; not [`Derived::complete`] then.
    pub tell: &'a mut dyn FnMut(Derived),
}

/// As [`regenerate`], telling what there is before all of it is made.
///
/// # Errors
/// [`Cancelled`] once `cancel` was called; the cache stays usable.
pub fn regenerate_in_steps(
    document: &Arc<Document>,
    catalog: &Catalog,
    cache: &mut Cache,
    cancel: &Cancel,
    steps: Steps<'_>,
) -> Result<Derived, Cancelled> {
    match &document.content {
        Content::TurnedPart(part) => turned_part::regenerate(document, part, catalog, &mut cache.part, cancel),
        Content::RollSet(set) => roll_set::regenerate(document, set, catalog, &mut cache.rolls, cancel, steps),
        Content::Shell(shell) => shell::regenerate(document, shell, catalog, &mut cache.shell, cancel),
    }
}

impl Derived {
    /// Nothing but the document and what there is to say about it.
    fn only(document: &Arc<Document>, diagnostics: Vec<Diagnostic>) -> Self {
        Self {
            document: Arc::clone(document),
            machine: None,
            material: None,
            setups: Vec::new(),
            diagnostics,
            rolls: None,
            complete: true,
            shell: None,
        }
    }
}

/// Adds what is not there yet: two stages may see the same mistake.
fn add_new(all: &mut Vec<Diagnostic>, more: &[Diagnostic]) {
    for diagnostic in more {
        let known = all.iter().any(|d| d.code == diagnostic.code && d.at == diagnostic.at);
        if !known {
            all.push(diagnostic.clone());
        }
    }
}

/// The name of a document as the beginning of file names: letters, digits, `-` and `_`; anything else becomes `_`.
#[must_use]
pub fn file_stem(name: &str) -> String {
    let stem: String =
        name.trim().chars().map(|c| if c.is_alphanumeric() || "-_".contains(c) { c } else { '_' }).collect();
    if stem.is_empty() { "PART".to_owned() } else { stem }
}
