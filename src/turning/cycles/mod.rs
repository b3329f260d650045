//! The published form-roll cycles: roughing, grooving, pocketing and finishing between given elements.

use super::{CutterPath, Task};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::Instruction;

/// The cutter path of the instructions, in order.
#[must_use]
pub fn generate(_task: &Task<'_>, instructions: &[Instruction]) -> (CutterPath, Vec<Diagnostic>) {
    let message =
        format!("The {} instructions of this part cannot be carried out by this version.", instructions.len());
    (CutterPath::default(), vec![Diagnostic::error("no-cycles", Place::Document, message)])
}
