//! From a document to everything that follows from it, in one pure call.
//!
//! A stage keeps one pair of input and output and compares inputs by value; an equal input gives the same `Arc` again, so
//! later stages see that nothing changed.

use crate::diagnostic::Diagnostic;
use crate::document::Document;
use crate::machine::{Machine, ToolOutline};
use crate::part::{PartContour, Setup, UnreachableArea};
use crate::post::PostOutput;
use crate::proof::{ProgramText, ProofReport};
use crate::turning::CutterPath;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Everything that follows from a document.
#[derive(Debug, Clone)]
pub struct Derived {
    /// The document it was made from.
    pub document: Arc<Document>,
    /// The machine, if the document names one that exists.
    pub machine: Option<Arc<Machine>>,
    /// The clampings in order of machining: one, or two for a part machined at both ends.
    pub setups: Vec<SetupDerived>,
    /// What the checks, the generator and the post have to say. Findings of proofs are in the set-ups.
    pub diagnostics: Vec<Diagnostic>,
}

/// Everything that follows for one clamping. All geometry is in the part space of the set-up, mm.
#[derive(Debug, Clone)]
pub struct SetupDerived {
    /// Name of the item: the document's name and the suffix of the end.
    pub name: String,
    /// Stock, profile, holding.
    pub setup: Arc<Setup>,
    /// The profile as lines and arcs.
    pub contour: Arc<PartContour>,
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
