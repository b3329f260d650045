//! The papers of a document.

use super::drawing::{DrawingChoice, drawing};
use super::page::Page;
use super::setup_sheet::setup_sheet;
use crate::diagnostic::Diagnostic;
use crate::machine::Catalog;
use crate::regen::Derived;

/// Which papers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PaperKind {
    /// The dimensioned drawing of the finished part.
    Drawing(DrawingChoice),
    /// The setup sheet of every clamping.
    SetupSheet,
}

impl PaperKind {
    /// What it is called in a sentence: `drawing`, `setup sheet`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Drawing(_) => "drawing",
            Self::SetupSheet => "setup sheet",
        }
    }

    /// The pages for `derived`, whose machine and tools are in `catalog`.
    ///
    /// # Errors
    /// As [`drawing`]; a setup sheet can always be made.
    pub fn pages(self, derived: &Derived, catalog: &Catalog) -> Result<Vec<Page>, Diagnostic> {
        match self {
            Self::Drawing(choice) => drawing(derived, choice),
            Self::SetupSheet => {
                Ok(derived.setups.iter().flat_map(|item| setup_sheet(derived, item, catalog)).collect())
            }
        }
    }
}
