//! One row of the section table.

use super::section_row::SectionRow;
use serde::{Deserialize, Serialize};

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
    /// Diameter at the first position; of a thread its outside diameter.
    pub d1: f64,
    /// Second position, towards the free end.
    pub z2: f64,
    /// Diameter at the second position; of a thread its base (root) diameter.
    pub d2: f64,
    /// What lies between the two positions.
    pub kind: SectionKind,
}

/// The six section types of the turned-part table.
#[derive(Debug, Clone, PartialEq)]
pub enum SectionKind {
    /// A straight line: cylinder or taper; with both positions equal a wall square to the spindle.
    Line,
    /// A circular arc that is hollow seen from outside (its centre lies outside the part).
    Concave {
        /// Radius of the arc.
        radius: f64,
    },
    /// A circular arc that bulges outwards (its centre lies on the spindle's side).
    Convex {
        /// Radius of the arc.
        radius: f64,
    },
    /// An outside thread: `d1` outside, `d2` base diameter over the whole length.
    Thread {
        /// Pitch per turn.
        pitch: f64,
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

    /// The section with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let kind = match self.kind {
            SectionKind::Line => SectionKind::Line,
            SectionKind::Concave { radius } => SectionKind::Concave { radius: radius * factor },
            SectionKind::Convex { radius } => SectionKind::Convex { radius: radius * factor },
            SectionKind::Thread { pitch } => SectionKind::Thread { pitch: pitch * factor },
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
