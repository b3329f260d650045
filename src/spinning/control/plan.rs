//! What a run is to do.

use super::watch::Watch;
use crate::spinning::interpolation::SetPoint;
use crate::spinning::published::PublishedPoint;
use crate::spinning::rig::valve;

/// How the end of a step is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Moves {
    /// As a place: an overshoot is not carried on. The published version 2.
    #[default]
    Absolute,
    /// As a distance from where the roller stands: every overshoot is carried on. The published version 1.
    Relative,
}

/// A place that the roller goes to when the carriage has come so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Target {
    /// Carriage travel from the tip, pulses.
    pub pulses: u32,
    /// Distance from the start of the roller, steps.
    pub steps: i32,
}

/// A run: where the roller begins, where it goes, how fast, and what is watched.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Reading of the transducer where the roller begins, steps.
    pub roller_position: i32,
    /// Targets in order of travel.
    pub targets: Vec<Target>,
    /// How the steps are given.
    pub moves: Moves,
    /// Code of the valve to advance.
    pub advance: u8,
    /// Code of the valve to retract.
    pub retract: u8,
    /// What is watched; the published controller watched nothing.
    pub watch: Option<Watch>,
}

impl Plan {
    /// A run along exact set points, which begin at 0.
    #[must_use]
    pub fn along(points: &[SetPoint], roller_position: i32) -> Self {
        let targets = points.iter().filter(|p| p.pulses > 0).map(|p| Target { pulses: p.pulses, steps: p.steps });
        Self::of(targets.collect(), roller_position)
    }

    /// A run along points of the published controller.
    #[must_use]
    pub fn published(points: &[PublishedPoint], roller_position: i32) -> Self {
        let target =
            |p: &PublishedPoint| Target { pulses: p.pulses, steps: i32::try_from(p.steps).unwrap_or(i32::MAX) };
        let advance = valve::ADVANCE_AS_LISTED;
        Self { advance, ..Self::of(points.iter().map(target).collect(), roller_position) }
    }

    const fn of(targets: Vec<Target>, roller_position: i32) -> Self {
        Self {
            roller_position,
            targets,
            moves: Moves::Absolute,
            advance: valve::ADVANCE,
            retract: valve::RETRACT,
            watch: None,
        }
    }

    /// The same, watched.
    #[must_use]
    pub fn watched(self, watch: Watch) -> Self {
        Self { watch: Some(watch), ..self }
    }

    /// Distance of the roller from its start that belongs to a carriage travel, steps, between the targets in proportion.
    #[must_use]
    pub fn wanted(&self, pulses: u32) -> f64 {
        self.wanted_at(f64::from(pulses))
    }

    /// As [`Self::wanted`], for a travel between two pulses.
    #[must_use]
    pub fn wanted_at(&self, pulses: f64) -> f64 {
        let next = self.targets.partition_point(|t| f64::from(t.pulses) < pulses);
        let before = next.checked_sub(1).and_then(|i| self.targets.get(i));
        let (p0, s0) = before.map_or((0.0, 0.0), |t| (f64::from(t.pulses), f64::from(t.steps)));
        match self.targets.get(next) {
            Some(t) if f64::from(t.pulses) > p0 => {
                s0 + (f64::from(t.steps) - s0) * (pulses.max(0.0) - p0) / (f64::from(t.pulses) - p0)
            }
            Some(t) => f64::from(t.steps),
            None => s0,
        }
    }
}
