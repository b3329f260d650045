//! The papers of a document.

use super::drawing::{DrawingChoice, drawing};
use super::page::Page;
use super::parts_list::parts_list;
use super::setup_sheet::setup_sheet;
use super::shell;
use super::strip::{section_drawing, stations, templates};
use crate::diagnostic::{Diagnostic, Place};
use crate::machine::Catalog;
use crate::regen::Derived;

/// Which papers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PaperKind {
    /// The dimensioned drawing of the finished part or shell.
    Drawing(DrawingChoice),
    /// The setup sheet of every clamping, or of a shell.
    SetupSheet,
    /// The finished cross-section of a set of form-rolls, with the table of its elements.
    Section(DrawingChoice),
    /// The strip of every station of a set, as large as the paper allows.
    Templates(DrawingChoice),
    /// The rolls of every station of a set as they stand in the line, with the strip.
    Stations(DrawingChoice),
    /// The list of all rolls of a set.
    PartsList,
}

impl PaperKind {
    /// What it is called in a sentence: `drawing`, `setup sheet`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Drawing(_) => "drawing",
            Self::SetupSheet => "setup sheet",
            Self::Section(_) => "drawing of the section",
            Self::Templates(_) => "templates",
            Self::Stations(_) => "drawings of the stations",
            Self::PartsList => "parts list",
        }
    }

    /// True for papers of a set of form-rolls as a whole; the others are about one part.
    #[must_use]
    pub const fn is_of_set(self) -> bool {
        matches!(self, Self::Section(_) | Self::Templates(_) | Self::Stations(_) | Self::PartsList)
    }

    /// The pages for `derived`, of a set those of every roll, whose machine and tools are in `catalog`.
    ///
    /// # Errors
    /// As [`drawing`]; a setup sheet needs a clamping, so the machine must exist.
    pub fn pages(self, derived: &Derived, catalog: &Catalog) -> Result<Vec<Page>, Diagnostic> {
        match (self, &derived.rolls) {
            (Self::Section(choice), _) => section_drawing(derived, choice),
            (Self::Templates(choice), _) => templates(derived, choice),
            (Self::Stations(choice), _) => stations(derived, choice),
            (Self::PartsList, _) => parts_list(derived),
            (_, Some(set)) => {
                let pages = set.rolls.iter().map(|roll| self.pages(&roll.derived, catalog));
                Ok(pages.collect::<Result<Vec<_>, _>>()?.concat())
            }
            (Self::Drawing(choice), None) if shell::is_shell(derived) => shell::drawing(derived, choice),
            (Self::SetupSheet, None) if shell::is_shell(derived) => shell::sheet(derived),
            (Self::Drawing(choice), None) => drawing(derived, choice),
            (Self::SetupSheet, None) if derived.setups.is_empty() => {
                let message = "There is no clamping that a setup sheet could describe.";
                let fault = Diagnostic::error("nothing-to-describe", Place::Document, message);
                Err(fault.with_hint(
                    "The part needs a length, and a machine and a material that exist; see what is said about them.",
                ))
            }
            (Self::SetupSheet, None) => {
                Ok(derived.setups.iter().flat_map(|item| setup_sheet(derived, item, catalog)).collect())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cancel::Cancel;
    use crate::document::{Content, Document, TurnedPart};
    use crate::papers::page::Item;
    use crate::part::Section;
    use crate::regen::{Cache, regenerate};
    use crate::units::Unit;
    use std::sync::Arc;

    fn made(part: TurnedPart) -> (Derived, Catalog) {
        let content = Content::TurnedPart(part);
        let document = Document { turnwright: 1, name: "PART".to_owned(), unit: Unit::Mm, content };
        let catalog = Catalog::shipped();
        let derived = regenerate(&Arc::new(document), &catalog, &mut Cache::default(), &Cancel::default());
        (derived.unwrap(), catalog)
    }

    #[test]
    fn without_a_machine_there_is_nothing_to_describe() {
        let (derived, catalog) = made(TurnedPart { machine: "none".to_owned(), ..TurnedPart::default() });
        let fault = PaperKind::SetupSheet.pages(&derived, &catalog).unwrap_err();
        assert_eq!(fault.code, "nothing-to-describe");
        let fault = PaperKind::Drawing(DrawingChoice::default()).pages(&derived, &catalog).unwrap_err();
        assert_eq!(fault.code, "nothing-to-draw");
    }

    #[test]
    fn impossible_parts_make_no_impossible_pages() {
        let sections = vec![Section::line(1, 0.0, 0.0, 0.0, 0.0), Section::line(2, 5.0, -3.0, 2.0, 1e5)];
        let impossible = TurnedPart { length: 1e-9, bar_diameter: 0.0, sections, ..TurnedPart::default() };
        let huge = TurnedPart {
            length: 9e5,
            bar_diameter: 8e5,
            sections: vec![Section::line(1, 0.0, 7e5, 9e5, 7e5)],
            ..TurnedPart::default()
        };
        for part in [TurnedPart::default(), impossible, huge] {
            let (derived, catalog) = made(part);
            let sheet = PaperKind::SetupSheet.pages(&derived, &catalog).unwrap_or_default();
            let drawing = PaperKind::Drawing(DrawingChoice::default()).pages(&derived, &catalog).unwrap_or_default();
            for item in sheet.iter().chain(&drawing).flat_map(|page| &page.items) {
                let finite = match item {
                    Item::Path { path, .. } => {
                        path.segments.iter().all(|s| s.start().is_finite() && s.end().is_finite())
                    }
                    Item::Text { at, .. } => at.is_finite(),
                };
                assert!(finite, "{item:?}");
            }
        }
    }
}
