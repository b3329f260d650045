//! Cutting data of a material.

use crate::units::Unit;
use serde::{Deserialize, Serialize};

/// One row of a material table. Lengths in `unit`, feeds in `unit` per minute.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Name; compared without regard to case.
    pub name: String,
    /// Unit of the row.
    #[serde(default)]
    pub unit: Unit,
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

impl Material {
    /// The row in mm and mm/min.
    #[must_use]
    pub fn in_mm(&self) -> Self {
        let f = self.unit.in_mm();
        Self {
            name: self.name.clone(),
            unit: Unit::Mm,
            feed_travel: self.feed_travel * f,
            feed_cut: self.feed_cut * f,
            feed_part_off: self.feed_part_off * f,
            depth_rough: self.depth_rough * f,
            depth_finish: self.depth_finish * f,
            depth_thread: self.depth_thread * f,
        }
    }
}
