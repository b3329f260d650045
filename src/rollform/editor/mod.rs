//! The roll editor: a list of edits replayed on a designed contour.
//!
//! Every edit finds the element it belongs to by what made it, so that a changed design keeps its edits. An edit that no longer
//! fits is left out and reported; the others are carried out.
//!
//! The operations and the conditions of corners are those of Wong, "Computer aided design and manufacture of form-rolls", 1983,
//! chapter 6.

mod carrier;
mod copy;
mod corner;
mod fault;
mod shape;
mod splice;
mod symmetry;

#[cfg(test)]
mod tests;

use super::roll::RollElement;
use crate::document::{EditAction, ElementName, RollEdit};
pub use copy::{copied_edits, edits_for, twin_edit};
pub use fault::{EditFault, described};
pub use symmetry::{begin_own, decided, follows_right, may_follow_right};

/// What became of the edits of a contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Edited {
    /// The contour.
    pub elements: Vec<RollElement>,
    /// Edits that do not fit, with the reason.
    pub faults: Vec<EditFault>,
}

/// The contour with its edits, which are in mm.
#[must_use]
pub fn edited(designed: &[RollElement], edits: &[RollEdit]) -> Edited {
    let mut elements = designed.to_vec();
    let mut faults = Vec::new();
    for edit in edits {
        if let Err(fault) = carry_out(&mut elements, edit) {
            faults.push(fault);
        }
    }
    Edited { elements, faults }
}

/// Carries out one edit; the contour is as before if it does not fit.
fn carry_out(elements: &mut Vec<RollElement>, edit: &RollEdit) -> Result<(), EditFault> {
    let fault = |(code, message, hint)| EditFault { edit: edit.id, code, message, hint };
    let name = ElementName::Edit { edit: edit.id };
    match edit.action {
        EditAction::Chamfer { after, depth } => {
            let index = find_last(elements, after).map_err(fault)?;
            let corner = corner::Corner::at(elements, index, depth, "depth").map_err(fault)?;
            corner.chamfer(elements, depth, name).map_err(fault)
        }
        EditAction::Blend { after, radius } => {
            let index = find_last(elements, after).map_err(fault)?;
            let corner = corner::Corner::at(elements, index, radius, "radius").map_err(fault)?;
            corner.blend(elements, radius, name).map_err(fault)
        }
        EditAction::Insert { after, ref shape } => {
            let index = find_last(elements, after).map_err(fault)?;
            splice::insert(elements, index, shape, name).map_err(fault)
        }
        EditAction::Replace { element, ref shape } => {
            let index = find(elements, element).map_err(fault)?;
            splice::replace(elements, index, shape, name).map_err(fault)
        }
        EditAction::Delete { element } => {
            let index = find(elements, element).map_err(fault)?;
            splice::delete(elements, index).map_err(fault)
        }
    }
}

/// The first element with this name.
fn find(elements: &[RollElement], name: ElementName) -> Result<usize, fault::Reason> {
    elements.iter().position(|e| e.has(name)).ok_or_else(|| fault::lost(name))
}

/// The last element with this name: the one whose end is the corner behind it.
fn find_last(elements: &[RollElement], name: ElementName) -> Result<usize, fault::Reason> {
    elements.iter().rposition(|e| e.has(name)).ok_or_else(|| fault::lost(name))
}
