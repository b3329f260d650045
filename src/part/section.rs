//! One row of the section table.

use super::section_row::SectionRow;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// Starts that a thread may have: more than any catalogue of threads lists is a slip.
pub const STARTS: RangeInclusive<u32> = 1..=24;

/// One section of a turned part, between two positions along the spindle.
///
/// Positions count from the clamped end. Lengths are in the unit of the document that holds the row.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "SectionRow", into = "SectionRow")]
pub struct Section {
    /// Stable id; a row keeps it while it is edited and moved.
    pub id: u32,
    /// First position, towards the clamped end.
    pub z1: f64,
    /// Diameter at the first position; of a thread the surface before it is cut: outside the major (outside) diameter, in
    /// a bore the minor diameter.
    pub d1: f64,
    /// Second position, towards the free end.
    pub z2: f64,
    /// Diameter at the second position; of a thread its base (root): outside the minor diameter, in a bore the major
    /// (nominal) diameter.
    pub d2: f64,
    /// What lies between the two positions.
    pub kind: SectionKind,
}

/// The six section types of the turned-part table.
#[derive(Debug, Clone, PartialEq)]
pub enum SectionKind {
    /// A straight line: cylinder or taper; with both positions equal a wall square to the spindle.
    Line,
    /// A circular arc that is hollow in the material (its centre lies outside the part; of a bore in the hole).
    Concave {
        /// Radius of the arc.
        radius: f64,
    },
    /// A circular arc that bulges out of the material (its centre lies on the material's side).
    Convex {
        /// Radius of the arc.
        radius: f64,
    },
    /// A thread: `d1` the diameter before it is cut, `d2` its base diameter, both over the whole length.
    Thread {
        /// Distance from one groove to the next along the spindle; the lead of one turn is this times `starts`.
        pitch: f64,
        /// Grooves that run side by side; 1 for an ordinary thread.
        starts: u32,
    },
    /// A parabola whose axis is parallel to the spindle: position is a quadratic of the radius.
    ParabolaAlongZ {
        /// Position of a third point anywhere on the parabola.
        z3: f64,
        /// Diameter of the third point; may be negative.
        d3: f64,
        /// Chords that the published generator cuts it with.
        chords: u32,
    },
    /// A parabola whose axis is square to the spindle: radius is a quadratic of the position.
    ParabolaAlongX {
        /// Position of a third point anywhere on the parabola.
        z3: f64,
        /// Diameter of the third point; may be negative.
        d3: f64,
        /// Chords that the published generator cuts it with.
        chords: u32,
    },
}

impl SectionKind {
    /// Name of the section type, in tables and on screen.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Concave { .. } => "concave",
            Self::Convex { .. } => "convex",
            Self::Thread { .. } => "thread",
            Self::ParabolaAlongZ { .. } => "parabola along z",
            Self::ParabolaAlongX { .. } => "parabola along x",
        }
    }
}

impl Section {
    /// A straight section.
    #[must_use]
    pub const fn line(id: u32, z1: f64, d1: f64, z2: f64, d2: f64) -> Self {
        Self { id, z1, d1, z2, d2, kind: SectionKind::Line }
    }

    /// The same curve in a table of the other side: what is hollow outside bulges in a bore.
    ///
    /// Rows of a bore become rows whose curve lies where the same row of the outside would have it.
    #[must_use]
    pub fn seen_from_inside(&self) -> Self {
        let kind = match self.kind {
            SectionKind::Concave { radius } => SectionKind::Convex { radius },
            SectionKind::Convex { radius } => SectionKind::Concave { radius },
            ref other => other.clone(),
        };
        Self { kind, ..self.clone() }
    }

    /// The section with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let kind = match self.kind {
            SectionKind::Line => SectionKind::Line,
            SectionKind::Concave { radius } => SectionKind::Concave { radius: radius * factor },
            SectionKind::Convex { radius } => SectionKind::Convex { radius: radius * factor },
            SectionKind::Thread { pitch, starts } => SectionKind::Thread { pitch: pitch * factor, starts },
            SectionKind::ParabolaAlongZ { z3, d3, chords } => {
                SectionKind::ParabolaAlongZ { z3: z3 * factor, d3: d3 * factor, chords }
            }
            SectionKind::ParabolaAlongX { z3, d3, chords } => {
                SectionKind::ParabolaAlongX { z3: z3 * factor, d3: d3 * factor, chords }
            }
        };
        Self {
            id: self.id,
            z1: self.z1 * factor,
            d1: self.d1 * factor,
            z2: self.z2 * factor,
            d2: self.d2 * factor,
            kind,
        }
    }
}
