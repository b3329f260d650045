//! What is watched during a run, and why a run stops.

use crate::spinning::published::{MM_PER_PULSE, MM_PER_STEP};
use std::fmt;

/// What the controller expects of the rig.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch {
    /// Distance off its path at which a run stops, mm: of the roller, of the carriage from where spindle and feed put it, and
    /// of readings that creep while the valve is shut.
    pub limit_mm: f64,
    /// Speed of the carriage by spindle speed and feed, mm/s.
    pub carriage_mm_per_s: f64,
}

/// Why a run stopped before its end. Every reason carries the measured value and its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StopReason {
    /// The operator pressed emergency stop.
    Emergency,
    /// The roller is too far off its path.
    OffPath {
        /// How far, mm; positive nearer to the axis.
        by_mm: f64,
        /// The limit, mm.
        limit_mm: f64,
    },
    /// The counted travel of the carriage differs from what spindle speed and feed give.
    Carriage {
        /// Counted, mm.
        counted_mm: f64,
        /// Expected, mm.
        expected_mm: f64,
        /// The limit of the difference, mm.
        limit_mm: f64,
    },
    /// The transducer's reading changes while the valve is shut.
    Creep {
        /// By how much altogether, mm.
        by_mm: f64,
        /// The limit, mm.
        limit_mm: f64,
    },
    /// The roller or carriage did not arrive in time.
    Late {
        /// What was waited for.
        what: &'static str,
        /// How long, s.
        waited_s: f64,
        /// The limit, s.
        limit_s: f64,
    },
    /// A target lies beyond what the transducer reads.
    OutOfReach {
        /// The reading that was asked for, steps.
        reading: i32,
        /// The largest reading, steps.
        limit: u16,
    },
}

impl fmt::Display for StopReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Emergency => write!(f, "Emergency stop by the operator."),
            Self::OffPath { by_mm, limit_mm } => {
                let side = if *by_mm > 0.0 { "towards" } else { "away from" };
                write!(
                    f,
                    "The roller is {:.2} mm off its path {side} the axis; the limit is {limit_mm:.2} mm.",
                    by_mm.abs()
                )
            }
            Self::Carriage { counted_mm, expected_mm, limit_mm } => write!(
                f,
                "The encoder counted {counted_mm:.2} mm of carriage travel where spindle and feed give {expected_mm:.2} mm; the \
                 limit of the difference is {limit_mm:.2} mm."
            ),
            Self::Creep { by_mm, limit_mm } => write!(
                f,
                "The roller's reading moves with the valve shut, by {by_mm:.2} mm in all; the limit is {limit_mm:.2} mm. \
                 Check whether the valve shuts, and the transducer's supply."
            ),
            Self::Late { what, waited_s, limit_s } => {
                write!(f, "{what} took {waited_s:.1} s; the limit is {limit_s:.1} s.")
            }
            Self::OutOfReach { reading, limit } => {
                write!(f, "A target asks for reading {reading}; the transducer reads 0 to {limit}.")
            }
        }
    }
}

/// Carriage travel by counts against that by time.
pub(super) fn carriage(watch: &Watch, pulses: u32, seconds: f64) -> Option<StopReason> {
    let counted_mm = f64::from(pulses) * MM_PER_PULSE;
    let expected_mm = watch.carriage_mm_per_s * seconds;
    let off = (counted_mm - expected_mm).abs() > watch.limit_mm;
    off.then_some(StopReason::Carriage { counted_mm, expected_mm, limit_mm: watch.limit_mm })
}

/// The roller's reading against the path; `wanted` is the reading that belongs to the carriage's place.
pub(super) fn off_path(watch: &Watch, reading: u16, wanted: f64) -> Option<StopReason> {
    let by_mm = (f64::from(reading) - wanted) * MM_PER_STEP;
    (by_mm.abs() > watch.limit_mm).then_some(StopReason::OffPath { by_mm, limit_mm: watch.limit_mm })
}

/// Adds up what the reading does while the valve is shut, and reckons what it did in all the time.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Creep {
    /// When the valve shut first.
    began_s: Option<f64>,
    shut_at_s: Option<f64>,
    rest: Option<(f64, i32)>,
    observed_s: f64,
    sum: i32,
}

impl Creep {
    /// The roller has come to rest this long after its valve has shut, s: several times its lag.
    const SETTLED_S: f64 = 0.15;
    /// Less than this is the transducer's own step to and fro.
    const LEAST_STEPS: i32 = 4;

    /// The valve opens.
    pub(super) const fn opened(&mut self) {
        self.shut_at_s = None;
        self.rest = None;
    }

    /// A reading with the valve shut; says when what it did in all is beyond the limit.
    pub(super) fn shut(&mut self, watch: &Watch, time_s: f64, reading: u16) -> Option<StopReason> {
        let began = *self.began_s.get_or_insert(time_s);
        let since = *self.shut_at_s.get_or_insert(time_s);
        if time_s - since < Self::SETTLED_S {
            return None;
        }
        let reading = i32::from(reading);
        if let Some((rest_s, rest)) = self.rest.replace((time_s, reading)) {
            self.sum += reading - rest;
            self.observed_s += time_s - rest_s;
        }
        if self.sum.abs() < Self::LEAST_STEPS || self.observed_s <= 0.0 {
            return None;
        }
        let by_mm = f64::from(self.sum.abs()) * MM_PER_STEP * (time_s - began) / self.observed_s;
        (by_mm > watch.limit_mm).then_some(StopReason::Creep { by_mm, limit_mm: watch.limit_mm })
    }
}
