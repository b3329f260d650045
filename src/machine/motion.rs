//! How fast the slides go.

use serde::{Deserialize, Serialize};

/// Rapid rates and acceleration of the slides, table `[motion]` of a machine file.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// Rapid rate of the cross slide, mm/min of its travel (not of the diameter).
    pub rapid_x_mm_per_min: f64,
    /// Rapid rate along the spindle, mm/min.
    pub rapid_z_mm_per_min: f64,
    /// Acceleration of both slides, mm/s².
    pub acceleration_mm_per_s2: f64,
}

/// A slide.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Across the spindle.
    X,
    /// Along the spindle.
    Z,
}
