//! Reading parts from other programs' files.

mod any;
mod cad;
mod dxf;
mod dxf_profile;
mod dxf_segments;
mod instructions;
mod roll;
mod roll_set;
mod table;

pub use any::{any, section_drawing, with_design, with_flower, with_instructions};
pub use cad::{CadTexts, cad};
pub use dxf::dxf;
pub use instructions::instructions;
pub use roll::roll;
pub use roll_set::{MidLineThickness, roll_design, roll_flower, roll_section, roll_section_dxf};
pub use table::tsv;

use crate::diagnostic::Diagnostic;
use crate::document::{Content, Document, Ends, FORMAT_VERSION, TurnedPart};
use crate::part::Section;
use crate::storage::check;
use crate::units::Unit;
use std::path::Path;

/// A document made of imported rows, with what came with it.
#[derive(Debug, Clone, PartialEq)]
struct Imported {
    name: String,
    unit: Unit,
    machine: String,
    material: String,
    bar_diameter: f64,
    length: f64,
    ends: Ends,
    part_off: bool,
    automatic: bool,
    sections: Vec<Section>,
    bore: Vec<Section>,
}

impl Imported {
    /// Rows of outside and bore alone: the bar is the largest diameter, the length the largest position, the material aluminium.
    fn of_rows(name: String, unit: Unit, machine: &str, [sections, bore]: [Vec<Section>; 2]) -> Self {
        Self {
            name,
            unit,
            machine: machine.to_owned(),
            material: "ALUMINUM".to_owned(),
            bar_diameter: largest_diameter(&sections),
            length: largest_position(&sections),
            ends: Ends::One,
            part_off: false,
            automatic: false,
            sections,
            bore,
        }
    }

    /// The document, if it fulfils what every document fulfils.
    fn document(self, file: &str) -> Result<Document, Vec<Diagnostic>> {
        let document = Document {
            turnwright: FORMAT_VERSION,
            name: self.name,
            unit: self.unit,
            content: Content::TurnedPart(TurnedPart {
                machine: self.machine,
                material: self.material,
                bar_diameter: self.bar_diameter,
                length: self.length,
                ends: self.ends,
                part_off: self.part_off,
                automatic: self.automatic,
                form_tolerance: default_form_tolerance(self.unit),
                sections: self.sections,
                bore: self.bore,
                ..TurnedPart::default()
            }),
        };
        let faults = check::faults(&document);
        if faults.is_empty() {
            return Ok(document);
        }
        let at = crate::textfile::file_place(Path::new(file));
        Err(faults
            .into_iter()
            .map(|f| Diagnostic::error("document-value", at.clone(), f.message).with_related(f.at))
            .collect())
    }
}

/// The form tolerance of a part whose file names none, in `unit`: the published generator takes the tool as a point, and
/// a 0.2 mm nose then deviates by as much on 45-degree surfaces.
const fn default_form_tolerance(unit: Unit) -> f64 {
    match unit {
        Unit::Mm => 0.25,
        Unit::Inch => 0.01,
    }
}

/// Largest diameter of any row.
fn largest_diameter(sections: &[Section]) -> f64 {
    sections.iter().flat_map(|s| [s.d1, s.d2]).fold(0.0, f64::max)
}

/// Largest position of any row.
fn largest_position(sections: &[Section]) -> f64 {
    sections.iter().flat_map(|s| [s.z1, s.z2]).fold(0.0, f64::max)
}

/// A document name from a file name: its stem, without the characters that no document name has.
fn name_of(path: &Path) -> String {
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let clean: String =
        stem.chars().map(|c| if c.is_control() || "/\\:*?\"<>|".contains(c) { '-' } else { c }).take(60).collect();
    let clean = clean.trim_start_matches('.').trim();
    if clean.is_empty() { "PART".to_owned() } else { clean.to_owned() }
}
