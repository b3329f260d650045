//! A set of form-rolls: every roll is turned like any part, each with stages of its own.

use super::Derived;
use super::cache::PartCache;
use crate::cancel::{Cancel, Cancelled};
use crate::document::{Document, RollRef, RollSet};
use crate::machine::Catalog;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// Everything that follows from a set of form-rolls.
#[derive(Debug, Clone, Default)]
pub struct RollSetDerived {
    /// The rolls, station by station.
    pub rolls: Vec<RollDerived>,
}

/// One roll of a set, as a turned part.
#[derive(Debug, Clone)]
pub struct RollDerived {
    /// Which roll.
    pub roll: RollRef,
    /// What follows from it as a document of its own.
    pub derived: Arc<Derived>,
    /// Its clampings among those of the set.
    pub setups: Range<usize>,
}

impl RollSetDerived {
    /// The roll that a clamping of the set belongs to.
    #[must_use]
    pub fn of_setup(&self, index: usize) -> Option<&RollDerived> {
        self.rolls.iter().find(|roll| roll.setups.contains(&index))
    }
}

/// The stages of a set.
#[derive(Debug, Default)]
pub(super) struct RollSetCache {
    rolls: BTreeMap<RollRef, PartCache>,
}

impl RollSetCache {
    /// The stages of every roll.
    pub(super) fn parts(&self) -> impl Iterator<Item = &PartCache> {
        self.rolls.values()
    }
}

/// Makes everything that follows from `set`, which is the content of `document`.
pub(super) fn regenerate(
    document: &Arc<Document>,
    _set: &RollSet,
    _catalog: &Catalog,
    _cache: &mut RollSetCache,
    cancel: &Cancel,
) -> Result<Derived, Cancelled> {
    cancel.check()?;
    Ok(Derived { rolls: Some(Arc::default()), ..Derived::only(document, Vec::new()) })
}
