//! Instructions for the published form-roll cycles: which elements, with which tool, how deep and how fast.

use serde::{Deserialize, Serialize};

/// One instruction for a published cycle. Lengths in the unit of the document.
///
/// Source: Wong, "Computer aided design and manufacture of form-rolls", 1983, Appendix 5 D.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Instruction {
    /// What is done.
    pub cycle: Cycle,
    /// Id of the row where cutting starts; a start beyond the end cuts towards the clamped end.
    pub from: u32,
    /// Id of the row where cutting ends.
    pub to: u32,
    /// Stock left on the contour.
    pub stock_left: f64,
    /// Turret station of the tool.
    pub tool: u32,
    /// Depth of cut on the radius; roughing and pocketing only.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub depth: f64,
    /// Cutting speed, m/min whatever the document's unit.
    pub speed_m_per_min: f64,
    /// Feed per turn.
    pub feed_per_rev: f64,
    /// Line along which the tool enters the material.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cut_in: Option<CutIn>,
}

/// The published cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Cycle {
    /// Strokes along the spindle down to the contour, then along the contour.
    Rough,
    /// Plunges with a blade.
    Groove,
    /// Once along the contour.
    Finish,
    /// Strokes along the spindle within a hollow, entered along the cut-in line.
    Pocket,
}

impl Cycle {
    /// Name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rough => "rough",
            Self::Groove => "groove",
            Self::Finish => "finish",
            Self::Pocket => "pocket",
        }
    }
}

/// A straight line along which a tool enters the material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CutIn {
    /// Position of a point of the line.
    pub z: f64,
    /// Diameter of that point.
    pub diameter: f64,
    /// Angle to the spindle, degrees, counter-clockwise with z to the right and the radius upwards.
    pub angle_deg: f64,
}

impl Instruction {
    /// Every figure with its key in a file.
    #[must_use]
    pub fn figures(&self) -> Vec<(&'static str, f64)> {
        let own = [
            ("stock_left", self.stock_left),
            ("depth", self.depth),
            ("speed_m_per_min", self.speed_m_per_min),
            ("feed_per_rev", self.feed_per_rev),
        ];
        let line = self
            .cut_in
            .map(|c| [("cut_in.z", c.z), ("cut_in.diameter", c.diameter), ("cut_in.angle_deg", c.angle_deg)]);
        own.into_iter().chain(line.into_iter().flatten()).collect()
    }

    /// The instruction with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            stock_left: self.stock_left * factor,
            depth: self.depth * factor,
            feed_per_rev: self.feed_per_rev * factor,
            cut_in: self.cut_in.map(|c| CutIn { z: c.z * factor, diameter: c.diameter * factor, ..c }),
            ..self.clone()
        }
    }
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
const fn is_zero(value: &f64) -> bool {
    *value == 0.0
}
