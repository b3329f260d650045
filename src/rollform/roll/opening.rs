//! The openings between the rolls of a station.

use crate::document::{Pinch, Station};

/// What an opening of "thickness with clearance" is above the thickness before the clearance is added (Wong 1983, app. 5 C).
const THICKNESS_FACTOR: f64 = 1.08;

/// Openings between top and bottom roll, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Openings {
    /// On the drive surface.
    pub drive: f64,
    /// Elsewhere.
    pub clearance: f64,
    /// Thickness of the strip.
    pub thickness: f64,
}

impl Openings {
    /// The openings of a station in mm for a strip of this thickness.
    #[must_use]
    pub fn of(station: &Station, thickness: f64) -> Self {
        let (drive, clearance) = match station.pinch {
            Pinch::None => (thickness, thickness),
            Pinch::Gaps { drive, clearance } => (drive, clearance),
            Pinch::Clearance { added } => (thickness, THICKNESS_FACTOR * thickness + added),
        };
        Self { drive, clearance, thickness }
    }

    /// True if both openings are more than nothing.
    #[must_use]
    pub fn are_usable(&self) -> bool {
        [self.drive, self.clearance, self.thickness].into_iter().all(|v| v.is_finite() && v > 0.0)
    }

    /// By how much the drive opening exceeds the thickness; less than 0 if the rolls pinch.
    pub(super) fn drive_excess(&self) -> f64 {
        self.drive - self.thickness
    }

    /// By how much the clearance exceeds the thickness; never less than on the drive surface.
    pub(super) fn relief(&self) -> f64 {
        (self.clearance - self.thickness).max(self.drive_excess())
    }
}
