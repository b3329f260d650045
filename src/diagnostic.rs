//! What the program has to say about a document, a file or a machine: one type for every message.
//!
//! A diagnostic names its place, the measured value and the limit, and says what to do. It never carries a panic or an
//! error code from below as its text.

use serde::{Deserialize, Serialize};
use std::fmt;

/// How much a diagnostic matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// Worth knowing; nothing is wrong.
    Info,
    /// Probably not what was wanted, but the result is usable.
    Warning,
    /// The result must not be used as it is.
    Error,
}

/// Where a diagnostic points.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(tag = "place", rename_all = "snake_case")]
pub enum Place {
    /// The document as a whole.
    Document,
    /// A row of the section table, by its stable id, and the column if one is meant.
    Section {
        /// Stable id of the row.
        id: u32,
        /// The table that holds it.
        #[serde(default, skip_serializing_if = "SectionTable::is_outside")]
        table: SectionTable,
        /// Position of the row in the table, from 1, at the time of the message.
        row: usize,
        /// Column of the table.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        column: Option<Column>,
    },
    /// The stock (bar) settings.
    Stock,
    /// A figure of the document, by its path in the file: `roller.nose_radius`.
    Setting {
        /// The path.
        path: String,
    },
    /// The machine, by id.
    Machine {
        /// Machine id.
        id: String,
    },
    /// A tool, by turret station.
    Tool {
        /// Turret station.
        station: u32,
    },
    /// An element of a cross-section.
    Element {
        /// Stable id of the element.
        id: u32,
        /// Position in its list, from 1, at the time of the message.
        number: usize,
        /// True if it is in the list of the other side.
        #[serde(default, skip_serializing_if = "is_false")]
        other_side: bool,
    },
    /// A station of a forming line.
    Station {
        /// Stable id of the station.
        id: u32,
        /// Its number in the line, from 1, at the time of the message.
        number: usize,
    },
    /// A form-roll.
    Roll {
        /// Its name: `1470b-2T`.
        name: String,
    },
    /// A block of a program. On the ORAC a block is a page.
    Block {
        /// Program name without extension.
        program: String,
        /// Number of the block from 1 in the order of the text.
        block: usize,
    },
    /// A line of a file.
    Line {
        /// File name as given.
        file: String,
        /// Line from 1.
        line: usize,
        /// Column from 1, where known.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        column: Option<usize>,
    },
    /// A file as a whole.
    File {
        /// File name as given.
        file: String,
    },
}

/// The section tables of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SectionTable {
    /// The outside.
    #[default]
    Outside,
    /// The bore.
    Bore,
}

/// A column of the section table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Column {
    /// Section type.
    Kind,
    /// First position along the spindle.
    Z1,
    /// Diameter at the first position (outside diameter of a thread).
    D1,
    /// Second position along the spindle.
    Z2,
    /// Diameter at the second position (base diameter of a thread).
    D2,
    /// Arc radius.
    Radius,
    /// Thread pitch.
    Pitch,
    /// Starts of a thread.
    Starts,
    /// Position of the third point of a parabola.
    Z3,
    /// Diameter of the third point of a parabola.
    D3,
    /// Number of chords of a parabola.
    Chords,
}

/// One message.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Diagnostic {
    /// How much it matters.
    pub severity: Severity,
    /// Stable short name of the rule, kebab-case: `arc-impossible`.
    pub code: String,
    /// Where it is.
    pub at: Place,
    /// A sentence with the measured value, the limit and their units.
    pub message: String,
    /// What to do about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
    /// Other places that belong to it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub related: Vec<Place>,
}

impl Diagnostic {
    /// A diagnostic without hint or related places.
    pub fn new(severity: Severity, code: &str, at: Place, message: impl Into<String>) -> Self {
        Self { severity, code: code.to_owned(), at, message: message.into(), hint: None, related: Vec::new() }
    }

    /// An error.
    pub fn error(code: &str, at: Place, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, at, message)
    }

    /// A warning.
    pub fn warning(code: &str, at: Place, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, at, message)
    }

    /// Adds what to do about it.
    #[must_use]
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// Adds another place that belongs to it.
    #[must_use]
    pub fn with_related(mut self, place: Place) -> Self {
        self.related.push(place);
        self
    }
}

/// True if any of `diagnostics` is an error.
#[must_use]
pub fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|d| d.severity == Severity::Error)
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        })
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Document => write!(f, "document"),
            Self::Section { table, row, column, .. } => {
                write!(f, "{table} {row}")?;
                column.map_or(Ok(()), |c| write!(f, ", {c}"))
            }
            Self::Stock => write!(f, "stock"),
            Self::Setting { path } => write!(f, "{path}"),
            Self::Machine { id } => write!(f, "machine {id}"),
            Self::Tool { station } => write!(f, "tool {station}"),
            Self::Element { number, other_side: false, .. } => write!(f, "element {number}"),
            Self::Element { number, .. } => write!(f, "element {number} of the other side"),
            Self::Station { number, .. } => write!(f, "station {number}"),
            Self::Roll { name } => write!(f, "roll {name}"),
            Self::Block { program, block } => write!(f, "{program} block {block}"),
            Self::Line { file, line, column } => {
                write!(f, "{file}:{line}")?;
                column.map_or(Ok(()), |c| write!(f, ":{c}"))
            }
            Self::File { file } => write!(f, "{file}"),
        }
    }
}

impl SectionTable {
    /// True for the table of the outside.
    #[must_use]
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
    pub const fn is_outside(&self) -> bool {
        matches!(self, Self::Outside)
    }
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
const fn is_false(value: &bool) -> bool {
    !*value
}

/// What one row of the table is called.
impl fmt::Display for SectionTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Outside => "section",
            Self::Bore => "bore section",
        })
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Kind => "type",
            Self::Z1 => "z start",
            Self::D1 => "⌀ start",
            Self::Z2 => "z end",
            Self::D2 => "⌀ end",
            Self::Radius => "radius",
            Self::Pitch => "pitch",
            Self::Starts => "starts",
            Self::Z3 => "z third",
            Self::D3 => "⌀ third",
            Self::Chords => "chords",
        })
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: {} [{}]", self.at, self.severity, self.message, self.code)?;
        self.hint.as_ref().map_or(Ok(()), |hint| write!(f, "\n  hint: {hint}"))
    }
}
