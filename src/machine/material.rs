//! Cutting data of a material.

use crate::units::Unit;
use serde::{Deserialize, Serialize};

/// One material. Published rows keep their unit; all other figures are metric.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Name; compared without regard to case.
    pub name: String,
    /// Unit of the row [`Self::orac`].
    #[serde(default)]
    pub unit: Unit,
    /// Name of another material whose force, mass and operations are this one's too, where it gives none itself. They are
    /// filled in when the catalog is loaded.
    #[serde(default)]
    pub like: Option<String>,
    /// Cutting data of the published ORAC generator; `None` for a material that it does not know.
    #[serde(default)]
    pub orac: Option<OracData>,
    /// Specific cutting force kc1.1, N/mm²: for a chip 1 mm wide and 1 mm thick.
    #[serde(default)]
    pub specific_cutting_force_n_per_mm2: Option<f64>,
    /// Exponent mc by which the specific cutting force falls with the chip's thickness.
    #[serde(default)]
    pub mc: Option<f64>,
    /// Mass, kg/dm³.
    #[serde(default)]
    pub density_kg_per_dm3: Option<f64>,
    /// Price per kg, in the currency of the machine's cost.
    #[serde(default)]
    pub price_per_kg: Option<f64>,
    /// Speed, feed and depth by operation and tool material.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub operations: Vec<OperationData>,
}

/// Cutting data of the published ORAC generator. Lengths in the material's unit, feeds in that unit per minute.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OracData {
    /// Feed through air per minute.
    pub feed_travel: f64,
    /// Feed while cutting per minute.
    pub feed_cut: f64,
    /// Feed while parting off per minute.
    pub feed_part_off: f64,
    /// Depth of a roughing cut, on the radius.
    pub depth_rough: f64,
    /// Depth of one of the two finishing cuts, on the radius.
    pub depth_finish: f64,
    /// Depth of one threading cut, on the radius.
    pub depth_thread: f64,
}

/// One row of a material's cutting data.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperationData {
    /// What is done.
    pub operation: CuttingOperation,
    /// What the tool's edge is made of.
    pub tool: ToolMaterial,
    /// Cutting speed, m/min.
    pub speed_m_per_min: f64,
    /// Feed, mm per turn.
    pub feed_mm_per_rev: f64,
    /// Depth of cut on the radius, mm; on a drill the depth between two retreats, for a thread that of the first pass, 0
    /// where the tool's width decides.
    pub depth_mm: f64,
}

/// What is done with a tool, as far as cutting data differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CuttingOperation {
    /// Roughing outside.
    Rough,
    /// Finishing outside.
    Finish,
    /// Facing.
    Face,
    /// Grooves.
    Groove,
    /// Parting off.
    PartOff,
    /// Drilling on the axis.
    Drill,
    /// Roughing a bore.
    BoreRough,
    /// Finishing a bore.
    BoreFinish,
    /// Threads.
    Thread,
}

/// What a tool's edge is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ToolMaterial {
    /// Coated carbide.
    #[default]
    Carbide,
    /// High-speed steel.
    Hss,
}

/// Speed, feed and depth for one operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CuttingData {
    /// Cutting speed, m/min.
    pub speed_m_per_min: f64,
    /// Feed, mm per turn.
    pub feed_mm_per_rev: f64,
    /// Depth as in [`OperationData::depth_mm`].
    pub depth_mm: f64,
}

impl Material {
    /// The material with its published row in mm and mm/min.
    #[must_use]
    pub fn in_mm(&self) -> Self {
        Self { unit: Unit::Mm, orac: self.orac.map(|row| row.scaled(self.unit.in_mm())), ..self.clone() }
    }

    /// Speed, feed and depth for an operation with a tool of this material: the row for it, or else the row of the nearest
    /// operation (a face as a roughing cut, a groove as parting off and the reverse, a bore as the outside). `None` if the
    /// table has neither.
    #[must_use]
    pub fn cutting(&self, operation: CuttingOperation, tool: ToolMaterial) -> Option<CuttingData> {
        use CuttingOperation::{BoreFinish, BoreRough, Drill, Face, Finish, Groove, PartOff, Rough, Thread};
        let stand_in = match operation {
            Face | BoreRough => Some(Rough),
            BoreFinish => Some(Finish),
            Groove => Some(PartOff),
            PartOff => Some(Groove),
            Rough | Finish | Drill | Thread => None,
        };
        let row = |wanted| self.operations.iter().find(|row| row.operation == wanted && row.tool == tool);
        let found = row(operation).or_else(|| row(stand_in?))?;
        Some(CuttingData {
            speed_m_per_min: found.speed_m_per_min,
            feed_mm_per_rev: found.feed_mm_per_rev,
            depth_mm: found.depth_mm,
        })
    }
}

impl Material {
    /// Takes from `other` what this material does not give itself.
    pub(super) fn fill_from(&mut self, other: &Self) {
        if self.operations.is_empty() {
            self.operations.clone_from(&other.operations);
        }
        if self.specific_cutting_force_n_per_mm2.is_none() {
            self.specific_cutting_force_n_per_mm2 = other.specific_cutting_force_n_per_mm2;
            self.mc = other.mc;
        }
        self.density_kg_per_dm3 = self.density_kg_per_dm3.or(other.density_kg_per_dm3);
        self.price_per_kg = self.price_per_kg.or(other.price_per_kg);
    }
}

impl OracData {
    fn scaled(&self, factor: f64) -> Self {
        Self {
            feed_travel: self.feed_travel * factor,
            feed_cut: self.feed_cut * factor,
            feed_part_off: self.feed_part_off * factor,
            depth_rough: self.depth_rough * factor,
            depth_finish: self.depth_finish * factor,
            depth_thread: self.depth_thread * factor,
        }
    }
}
