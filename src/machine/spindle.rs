//! The spindle: how its speed is chosen, its ranges and its power.

use serde::{Deserialize, Serialize};

/// The spindle of a machine, table `[spindle]` of a machine file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spindle {
    /// How the speed follows the radius that is cut.
    pub speed: SpeedRule,
    /// Lowest speed, rev/min.
    #[serde(default = "one")]
    pub min_rpm: f64,
    /// Threads are cut at `thread_feed_mm_per_min / pitch` at most, rev/min.
    pub thread_feed_mm_per_min: f64,
    /// Rated power of the motor, kW; unknown without.
    #[serde(default)]
    pub power_kw: Option<f64>,
    /// Speed from which the motor gives its rated power, rev/min; below it the torque is constant. Rated power everywhere
    /// without.
    #[serde(default)]
    pub full_power_rpm: Option<f64>,
    /// Part of the motor's power that reaches the cut.
    #[serde(default = "usual_efficiency")]
    pub efficiency: f64,
    /// Gear ranges; one range of all speeds without.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ranges: Vec<SpindleRange>,
}

/// How the spindle speed follows the radius that is cut.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "by", rename_all = "lowercase", deny_unknown_fields)]
pub enum SpeedRule {
    /// A line over the radius, the same for every material: `at_center_rpm - per_mm_radius_rpm * radius`.
    Radius {
        /// Speed at the spindle axis, rev/min.
        at_center_rpm: f64,
        /// Fall of the speed per mm of radius, rev/min.
        per_mm_radius_rpm: f64,
    },
    /// The cutting speed of the material, kept constant by the control.
    Surface,
    /// The cutting speed of the material, by the next lower speed of the control's table, `words.speed_codes`.
    Table,
}

/// A gear range of the spindle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpindleRange {
    /// Code that selects it: `M41`.
    pub code: String,
    /// Lowest speed, rev/min.
    pub min_rpm: f64,
    /// Highest speed, rev/min.
    pub max_rpm: f64,
}

const fn one() -> f64 {
    1.0
}

/// Belt and gear drives lose about a fifth (Sandvik Coromant, Metalcutting technical guide, "Machine efficiency").
const fn usual_efficiency() -> f64 {
    0.8
}

impl Spindle {
    /// Speed at `radius` mm where it depends on the radius alone, rev/min, not below 0; `None` where the material decides.
    #[must_use]
    pub fn rpm_by_radius(&self, radius: f64) -> Option<f64> {
        match self.speed {
            SpeedRule::Radius { at_center_rpm, per_mm_radius_rpm } => {
                Some((at_center_rpm - per_mm_radius_rpm * radius).max(0.0))
            }
            SpeedRule::Surface | SpeedRule::Table => None,
        }
    }
}
