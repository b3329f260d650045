//! What goes wrong on a rig.

use std::fmt;

/// A fault, from the moment on when the carriage has moved `after_pulses` past the former's tip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// The counter misses pulses at once, as the published counter board did.
    LostCounts {
        /// When.
        after_pulses: u32,
        /// How many.
        count: u32,
    },
    /// The supply of the transducer drifts, and every reading with it.
    DriftingSupply {
        /// Percent a minute; the published supply drifted by 1.1 % in half an hour.
        percent_per_min: f64,
    },
    /// The valve does not answer any more.
    StuckValve {
        /// When.
        after_pulses: u32,
        /// Stuck as it opens for the roller to draw back; else stuck shut.
        open: bool,
    },
    /// The carriage stands while the spindle turns: the feed has slipped.
    StalledCarriage {
        /// When.
        after_pulses: u32,
    },
}

impl Fault {
    /// One of each kind at a place in the middle of a run, for people to try.
    #[must_use]
    pub const fn all() -> [Self; 5] {
        [
            Self::LostCounts { after_pulses: 200, count: 60 },
            Self::DriftingSupply { percent_per_min: 20.0 },
            Self::StuckValve { after_pulses: 200, open: false },
            Self::StuckValve { after_pulses: 200, open: true },
            Self::StalledCarriage { after_pulses: 200 },
        ]
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LostCounts { count, .. } => write!(f, "{count} encoder counts lost"),
            Self::DriftingSupply { percent_per_min } => write!(f, "transducer supply drifts {percent_per_min} %/min"),
            Self::StuckValve { open: true, .. } => write!(f, "valve stuck open"),
            Self::StuckValve { open: false, .. } => write!(f, "valve stuck shut"),
            Self::StalledCarriage { .. } => write!(f, "carriage stalled"),
        }
    }
}
