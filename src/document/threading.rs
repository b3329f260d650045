//! How planned threads are cut on controls that take them pass by pass.

use serde::{Deserialize, Serialize};

/// Choices about planned threads. The ORAC cuts threads by its own cycle and ignores them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ThreadChoices {
    /// Direction in which the tool goes deeper.
    pub infeed: Infeed,
    /// Length over which a thread runs out of the work where no groove lets the tool out, in pitches; 0 is straight out.
    pub run_out: f64,
    /// Passes at full depth that take nothing but what the work's spring left.
    pub spring_passes: u8,
}

/// Direction in which a threading tool goes deeper from pass to pass. Every pass takes the same area of chip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Infeed {
    /// Square to the spindle: both flanks cut.
    Radial,
    /// Along the trailing flank, a degree off it: the leading flank cuts.
    #[default]
    Flank,
    /// Along one flank and the other in turn, so that both wear alike.
    Alternating,
}

impl Default for ThreadChoices {
    fn default() -> Self {
        Self { infeed: Infeed::default(), run_out: 1.0, spring_passes: 1 }
    }
}
