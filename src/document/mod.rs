//! What a user edits and saves: plain data, in the unit the user chose, and nothing derived from it.

mod row;

use crate::part::Section;
use crate::units::Unit;
use row::{EndsRow, ParabolaCutRow};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Newest version of the document format that this program writes and reads.
pub const FORMAT_VERSION: u32 = 1;

/// A document: one turned part (later also a roll set or a shell).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// Version of the format, [`FORMAT_VERSION`] when written by this program. First in the file.
    pub turnwright: u32,
    /// Name of the item; programs and exported files are named after it.
    pub name: String,
    /// Unit of every length in the document.
    #[serde(default)]
    pub unit: Unit,
    /// What the document describes.
    pub content: Content,
}

/// The kinds of document.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Content {
    /// A part turned from bar.
    TurnedPart(TurnedPart),
}

/// A part turned from bar, described by its section table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurnedPart {
    /// Machine id.
    pub machine: String,
    /// Material name, as in the material table of the machine.
    pub material: String,
    /// Diameter of the bar.
    pub bar_diameter: f64,
    /// Length of the finished part.
    pub length: f64,
    /// One or two ends machined.
    #[serde(default)]
    pub ends: Ends,
    /// Part the piece off the bar at the clamped end.
    #[serde(default)]
    pub part_off: bool,
    /// Emit the signals for an automatic tool changer and part handling.
    #[serde(default)]
    pub automatic: bool,
    /// Which generator makes the program.
    #[serde(default)]
    pub generator: Generator,
    /// Deviation from the contour that the proof allows: a deeper gouge is an error, more leftover a warning.
    pub form_tolerance: f64,
    /// The section table.
    pub sections: Vec<Section>,
    /// Programs edited by hand, by program name: the text that replaces the generated one.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub overrides: BTreeMap<String, String>,
}

/// How many ends of the part are machined.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(try_from = "EndsRow", into = "EndsRow")]
pub enum Ends {
    /// The free end only.
    #[default]
    One,
    /// The free end first, then the part is turned round.
    Two {
        /// Position that divides the ends; found by the program when absent.
        split: Option<f64>,
    },
}

/// Which generator makes the program.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "by", rename_all = "snake_case", deny_unknown_fields)]
pub enum Generator {
    /// The published generator: roughing by intervals, two finishing passes, the tool taken as a point.
    Oracap {
        /// How a parabola becomes lines or arcs.
        #[serde(default)]
        parabolas: ParabolaCut,
        /// Shorten the program with the published rules.
        #[serde(default = "yes")]
        optimize: bool,
    },
}

/// How a parabola becomes lines or arcs in a program.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(try_from = "ParabolaCutRow", into = "ParabolaCutRow")]
pub enum ParabolaCut {
    /// The number of chords in the row, as published.
    #[default]
    Chords,
    /// Tangent arcs.
    Arcs {
        /// Largest distance from the parabola.
        tolerance: f64,
    },
}

const fn yes() -> bool {
    true
}

impl Default for Generator {
    fn default() -> Self {
        Self::Oracap { parabolas: ParabolaCut::default(), optimize: true }
    }
}

impl TurnedPart {
    /// The same part with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            bar_diameter: self.bar_diameter * factor,
            length: self.length * factor,
            ends: match self.ends {
                Ends::Two { split: Some(split) } => Ends::Two { split: Some(split * factor) },
                other => other,
            },
            generator: match self.generator {
                Generator::Oracap { parabolas: ParabolaCut::Arcs { tolerance }, optimize } => {
                    Generator::Oracap { parabolas: ParabolaCut::Arcs { tolerance: tolerance * factor }, optimize }
                }
                other @ Generator::Oracap { .. } => other,
            },
            form_tolerance: self.form_tolerance * factor,
            sections: self.sections.iter().map(|s| s.scaled(factor)).collect(),
            ..self.clone()
        }
    }

    /// An id that no row has yet.
    #[must_use]
    pub fn unused_section_id(&self) -> u32 {
        self.sections.iter().map(|s| s.id).max().map_or(1, |id| id.saturating_add(1))
    }
}
