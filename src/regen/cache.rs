//! The stages that a document keeps between regenerations.

use super::Stage;
use super::roll_set::RollSetCache;
use super::shell::ShellCache;
use crate::diagnostic::Diagnostic;
use crate::document::TurnedPart;
use crate::machine::{Machine, Material, ToolOutline};
use crate::part::{PartContour, Profile, Setup};
use crate::post::{self, PostOutput};
use crate::proof::{ProofInput, ProofReport};
use crate::turning::{CutterPath, UnreachableArea};
use crate::units::Unit;
use std::collections::BTreeMap;
use std::sync::Arc;

pub(super) type Tools = BTreeMap<u32, ToolOutline>;

/// An output with what there is to say about it.
type Said<T> = (T, Vec<Diagnostic>);

/// What set-ups are made from.
type SetupsInput = (TurnedPart, Arc<Machine>);

/// What the generator works from.
type PathInput = (Arc<Setup>, TurnedPart, Arc<Machine>, Arc<Tools>, Material);

/// What programs are made from: the item's name, its path, choices, what the programs say of it, and the machine.
type PostInput = (String, Arc<CutterPath>, post::Options, post::Header, Arc<Machine>);

/// What the last regeneration left behind; one a document.
#[derive(Debug, Default)]
pub struct Cache {
    pub(super) part: PartCache,
    pub(super) rolls: RollSetCache,
    pub(super) shell: ShellCache,
}

/// The stages of a turned part.
#[derive(Debug, Default)]
pub(super) struct PartCache {
    pub(super) checks: Stage<(TurnedPart, Unit, Arc<Machine>), Vec<Diagnostic>>,
    pub(super) setups: Stage<SetupsInput, Said<Vec<Arc<Setup>>>>,
    pub(super) of_setup: Vec<SetupCache>,
}

/// The stages of one clamping.
#[derive(Debug, Default)]
pub(super) struct SetupCache {
    pub(super) contour: Stage<Profile, PartContour>,
    pub(super) bore: Stage<Option<Profile>, Option<PartContour>>,
    pub(super) unreachable: Stage<(Arc<Setup>, Arc<Tools>), Vec<UnreachableArea>>,
    pub(super) program: ProgramCache,
}

/// The stages from a clamping to its proved programs.
#[derive(Debug, Default)]
pub(super) struct ProgramCache {
    pub(super) path: Stage<PathInput, Said<Arc<CutterPath>>>,
    pub(super) post: Stage<PostInput, PostOutput>,
    pub(super) proof: Stage<ProofInput, ProofReport>,
}

/// How often each stage has run, all clampings together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StageRuns {
    /// Rules over the section table.
    pub checks: u64,
    /// Section table to set-ups.
    pub setups: u64,
    /// Profile to lines and arcs.
    pub contour: u64,
    /// Areas out of reach.
    pub unreachable: u64,
    /// Cutter location data.
    pub path: u64,
    /// Program text.
    pub post: u64,
    /// Proof.
    pub proof: u64,
}

impl Cache {
    /// How often each stage has run since the cache was made.
    #[must_use]
    pub fn runs(&self) -> StageRuns {
        let parts = || std::iter::once(&self.part).chain(self.rolls.parts());
        let sum = |count: fn(&SetupCache) -> u64| parts().flat_map(|p| &p.of_setup).map(count).sum();
        StageRuns {
            checks: parts().map(|p| p.checks.runs()).sum(),
            setups: parts().map(|p| p.setups.runs()).sum(),
            contour: sum(|s| s.contour.runs()),
            unreachable: sum(|s| s.unreachable.runs()),
            path: sum(|s| s.program.path.runs()),
            post: sum(|s| s.program.post.runs()),
            proof: sum(|s| s.program.proof.runs()),
        }
    }
}
