//! The planner: from stock, contour, holding, tools and material to a complete ordered plan.

use super::{CutterPath, Task};
use crate::diagnostic::{Diagnostic, Place};

/// The planned cutter path of a set-up.
#[must_use]
pub fn plan(_task: &Task<'_>) -> (CutterPath, Vec<Diagnostic>) {
    let message = "This version cannot plan operations; choose the published generator.";
    (CutterPath::default(), vec![Diagnostic::error("no-planner", Place::Document, message)])
}
