//! Everything that is designed from a set: strip and rolls of every station, in one call.

use crate::diagnostic::Diagnostic;
use crate::document::{RollRef, RollSet, TurnedPart};

/// Strip and rolls of every station, mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RollDesign {
    /// The stations in the direction of the strip.
    pub stations: Vec<StationDesign>,
    /// What there is to say about section, flower and line.
    pub diagnostics: Vec<Diagnostic>,
}

/// Strip and rolls of one station, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct StationDesign {
    /// Its rolls as they are to be turned.
    pub rolls: Vec<Roll>,
}

/// A roll of a set: its name and the part it is turned as.
#[derive(Debug, Clone, PartialEq)]
pub struct Roll {
    /// Which roll.
    pub roll: RollRef,
    /// Its name: `1470b-2T`.
    pub name: String,
    /// The part, mm.
    pub part: TurnedPart,
    /// What there is to say about it.
    pub diagnostics: Vec<Diagnostic>,
}

impl RollDesign {
    /// Every roll, station by station.
    pub fn rolls(&self) -> impl Iterator<Item = &Roll> {
        self.stations.iter().flat_map(|station| &station.rolls)
    }
}

/// Designs the set `name`, which is in mm.
#[must_use]
pub fn design(_name: &str, _set: &RollSet) -> RollDesign {
    RollDesign::default()
}
