//! What a user edits and saves: plain data, in the unit the user chose, and nothing derived from it.

mod cycles;
mod operations;
mod program;
mod roll_set;
mod row;
mod shell;
mod threading;

use crate::diagnostic::SectionTable;
use crate::part::Section;
use crate::units::Unit;
pub use cycles::{CutIn, Cycle, Instruction};
pub use operations::{OperationEdit, OperationKind, OperationRef, PlanEdits};
pub use program::ProgramChoices;
pub use roll_set::{
    BendAngle, Composite, CrossSection, DevelopedWidth, DriveSurface, EditAction, Element, ElementKind, ElementName,
    ExtensionContour, ExtensionKind, Face, FixedComposite, FormingLine, NewElement, Opening, Origin, PieceKind, Pinch,
    Rates, RollCopy, RollEdit, RollKind, RollPoint, RollRef, RollSet, RollWork, Sharpening, Side, SideEnd, SideRoll,
    Station, StripMaterial, TangentSide, fingerprint,
};
use row::{EndsRow, ParabolaCutRow};
use serde::{Deserialize, Serialize};
pub use shell::{Blank, Former, FormerShape, Forming, RigChoices, Roller, Shell, Speeds};
use std::collections::BTreeMap;
pub use threading::{Infeed, ThreadChoices};

/// Newest version of the document format that this program writes and reads.
pub const FORMAT_VERSION: u32 = 1;

/// A document: a turned part, a set of form-rolls or a flow-turned shell.
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
    /// A set of form-rolls.
    RollSet(RollSet),
    /// A flow-turned shell.
    Shell(Shell),
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
    /// How the bar is held.
    #[serde(default, skip_serializing_if = "is_default")]
    pub holding: Holding,
    /// Material beyond the free end before facing.
    #[serde(default, skip_serializing_if = "is_default")]
    pub facing_allowance: f64,
    /// Diameter of the hole in a tube; 0 for solid bar.
    #[serde(default, skip_serializing_if = "is_default")]
    pub stock_bore_diameter: f64,
    /// Which generator makes the program.
    #[serde(default)]
    pub generator: Generator,
    /// What was changed of the planner's operations.
    #[serde(default, skip_serializing_if = "is_default")]
    pub plan: PlanEdits,
    /// How planned threads are cut.
    #[serde(default, skip_serializing_if = "is_default")]
    pub threading: ThreadChoices,
    /// How the programs are written.
    #[serde(default, skip_serializing_if = "is_default")]
    pub program: ProgramChoices,
    /// Deviation from the contour that the proof allows: a deeper gouge is an error, more leftover a warning.
    pub form_tolerance: f64,
    /// The section table.
    pub sections: Vec<Section>,
    /// The section table of the bore, from the clamped to the free end; empty without one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bore: Vec<Section>,
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

/// How the bar is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Holding {
    /// In the chuck or collet: only cuts towards the headstock.
    #[default]
    Chuck,
    /// On a mandrel or between centres with the tailstock: cuts in both directions.
    BetweenCentres,
}

/// Which generator makes the program.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "by", rename_all = "snake_case", deny_unknown_fields)]
pub enum Generator {
    /// The published generator of the ORAC: roughing by intervals, two finishing passes, the tool taken as a point.
    Oracap {
        /// How a parabola becomes lines or arcs.
        #[serde(default)]
        parabolas: ParabolaCut,
        /// Shorten the program with the published rules.
        #[serde(default = "yes")]
        optimize: bool,
    },
    /// The published form-roll cycles, as instructed.
    Cycles {
        /// Instructions in order of cutting.
        instructions: Vec<Instruction>,
    },
    /// The planner: nothing asked that it can find out.
    Planned {
        /// A program of its own for every stage, so that an operator can restart at any.
        #[serde(default)]
        separate_programs: bool,
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

/// The kinds of document, by name alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// A part turned from bar.
    TurnedPart,
    /// A set of form-rolls.
    RollSet,
    /// A flow-turned shell.
    Shell,
}

impl Content {
    /// Which kind it is.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::TurnedPart(_) => Kind::TurnedPart,
            Self::RollSet(_) => Kind::RollSet,
            Self::Shell(_) => Kind::Shell,
        }
    }

    /// The turned part, if it is one.
    #[must_use]
    pub const fn turned_part(&self) -> Option<&TurnedPart> {
        if let Self::TurnedPart(part) = self { Some(part) } else { None }
    }

    /// The turned part, to be changed, if it is one.
    pub const fn turned_part_mut(&mut self) -> Option<&mut TurnedPart> {
        if let Self::TurnedPart(part) = self { Some(part) } else { None }
    }

    /// The set of form-rolls, if it is one.
    #[must_use]
    pub const fn roll_set(&self) -> Option<&RollSet> {
        if let Self::RollSet(set) = self { Some(set) } else { None }
    }

    /// The flow-turned shell, if it is one.
    #[must_use]
    pub const fn shell(&self) -> Option<&Shell> {
        if let Self::Shell(shell) = self { Some(shell) } else { None }
    }

    /// The same with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::TurnedPart(part) => Self::TurnedPart(part.scaled(factor)),
            Self::RollSet(set) => Self::RollSet(set.scaled(factor)),
            Self::Shell(shell) => Self::Shell(shell.scaled(factor)),
        }
    }

    /// Machine id of the lathe that everything is made on.
    #[must_use]
    pub fn machine(&self) -> &str {
        match self {
            Self::TurnedPart(part) => &part.machine,
            Self::RollSet(set) => &set.machine,
            Self::Shell(shell) => &shell.machine,
        }
    }

    /// The machine id, to be changed.
    pub const fn machine_mut(&mut self) -> &mut String {
        match self {
            Self::TurnedPart(part) => &mut part.machine,
            Self::RollSet(set) => &mut set.machine,
            Self::Shell(shell) => &mut shell.machine,
        }
    }
}

const fn yes() -> bool {
    true
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

impl Generator {
    /// How a parabola becomes lines or arcs; only one generator asks.
    #[must_use]
    pub const fn parabolas(&self) -> ParabolaCut {
        match self {
            Self::Oracap { parabolas, .. } => *parabolas,
            Self::Cycles { .. } | Self::Planned { .. } => ParabolaCut::Chords,
        }
    }

    /// The instructions of the published form-roll cycles; none by other generators.
    #[must_use]
    pub fn instructions(&self) -> &[Instruction] {
        match self {
            Self::Cycles { instructions } => instructions,
            Self::Oracap { .. } | Self::Planned { .. } => &[],
        }
    }

    fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Oracap { parabolas: ParabolaCut::Arcs { tolerance }, optimize } => {
                Self::Oracap { parabolas: ParabolaCut::Arcs { tolerance: tolerance * factor }, optimize: *optimize }
            }
            Self::Cycles { instructions } => {
                Self::Cycles { instructions: instructions.iter().map(|i| i.scaled(factor)).collect() }
            }
            other @ (Self::Oracap { .. } | Self::Planned { .. }) => other.clone(),
        }
    }
}

impl Default for TurnedPart {
    /// A part of no length for the shipped training lathe, for a caller to fill in.
    fn default() -> Self {
        Self {
            machine: "orac".to_owned(),
            material: "ALUMINUM".to_owned(),
            bar_diameter: 0.0,
            length: 0.0,
            ends: Ends::One,
            part_off: false,
            automatic: false,
            holding: Holding::Chuck,
            facing_allowance: 0.0,
            stock_bore_diameter: 0.0,
            generator: Generator::default(),
            plan: PlanEdits::default(),
            threading: ThreadChoices::default(),
            program: ProgramChoices::default(),
            form_tolerance: 0.0,
            sections: Vec::new(),
            bore: Vec::new(),
            overrides: BTreeMap::new(),
        }
    }
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
            facing_allowance: self.facing_allowance * factor,
            stock_bore_diameter: self.stock_bore_diameter * factor,
            generator: self.generator.scaled(factor),
            plan: self.plan.scaled(factor),
            form_tolerance: self.form_tolerance * factor,
            sections: self.sections.iter().map(|s| s.scaled(factor)).collect(),
            bore: self.bore.iter().map(|s| s.scaled(factor)).collect(),
            ..self.clone()
        }
    }

    /// The rows of a section table.
    #[must_use]
    pub const fn table(&self, table: SectionTable) -> &Vec<Section> {
        match table {
            SectionTable::Outside => &self.sections,
            SectionTable::Bore => &self.bore,
        }
    }

    /// The rows of a section table, to be changed.
    pub const fn table_mut(&mut self, table: SectionTable) -> &mut Vec<Section> {
        match table {
            SectionTable::Outside => &mut self.sections,
            SectionTable::Bore => &mut self.bore,
        }
    }

    /// The row with this id, its table and its position there, from 0.
    #[must_use]
    pub fn row(&self, id: u32) -> Option<(SectionTable, usize, &Section)> {
        [SectionTable::Outside, SectionTable::Bore].into_iter().find_map(|table| {
            let (index, section) = self.table(table).iter().enumerate().find(|(_, s)| s.id == id)?;
            Some((table, index, section))
        })
    }

    /// The row with this id, to be changed.
    pub fn row_mut(&mut self, id: u32) -> Option<&mut Section> {
        self.sections.iter_mut().chain(&mut self.bore).find(|s| s.id == id)
    }

    /// An id that no row has yet.
    #[must_use]
    pub fn unused_section_id(&self) -> u32 {
        self.sections.iter().chain(&self.bore).map(|s| s.id).max().map_or(1, |id| id.saturating_add(1))
    }
}
