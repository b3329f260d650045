//! Why a run on a rig behind a line stopped.

use super::frame::Frame;
use crate::spinning::control::StopReason;
use std::fmt;

/// A reason with its measured value and its limit, as it crosses the line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Why {
    word: String,
    value: i64,
    limit: i64,
}

#[allow(clippy::cast_possible_truncation, reason = "thousandths of figures of a lathe")]
fn thousandths(value: f64) -> i64 {
    (value * 1000.0).round() as i64
}

impl Why {
    pub(super) fn word(word: &str) -> Self {
        Self { word: word.to_owned(), value: 0, limit: 0 }
    }

    /// What a controller's reason is on the line.
    #[must_use]
    pub fn of(reason: &StopReason) -> Self {
        let (word, value, limit) = match *reason {
            StopReason::Emergency => return Self::word("emergency"),
            StopReason::OffPath { by_mm, limit_mm } => ("path", thousandths(by_mm), thousandths(limit_mm)),
            StopReason::Carriage { counted_mm, expected_mm, limit_mm } => {
                ("carriage", thousandths(counted_mm - expected_mm), thousandths(limit_mm))
            }
            StopReason::Creep { by_mm, limit_mm } => ("creep", thousandths(by_mm), thousandths(limit_mm)),
            StopReason::Late { waited_s, limit_s, .. } => ("late", thousandths(waited_s), thousandths(limit_s)),
            StopReason::OutOfReach { reading, limit } => ("reach", i64::from(reading), i64::from(limit)),
        };
        Self { word: word.to_owned(), value, limit }
    }

    pub(super) fn frame(&self) -> Frame {
        Frame { letter: 'Y', words: vec![self.word.clone(), self.value.to_string(), self.limit.to_string()] }
    }

    pub(super) fn read(frame: &Frame) -> Option<Self> {
        let [word, value, limit] = frame.words.as_slice() else { return None };
        Some(Self { word: word.clone(), value: value.parse().ok()?, limit: limit.parse().ok()? })
    }
}

impl fmt::Display for Why {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (value, limit) = (self.value as f64 / 1000.0, self.limit as f64 / 1000.0);
        match self.word.as_str() {
            "path" => StopReason::OffPath { by_mm: value, limit_mm: limit }.fmt(f),
            "creep" => StopReason::Creep { by_mm: value, limit_mm: limit }.fmt(f),
            "carriage" => write!(
                f,
                "The encoder counted {:.2} mm {} than spindle and feed give; the limit is {limit:.2} mm.",
                value.abs(),
                if value > 0.0 { "more" } else { "less" }
            ),
            "late" => {
                write!(f, "The roller or the carriage did not arrive within {value:.1} s; the limit is {limit:.1} s.")
            }
            "reach" => {
                write!(f, "A target asks for reading {}; the transducer reads 0 to {}.", self.value, self.limit)
            }
            "emergency" => StopReason::Emergency.fmt(f),
            "silence" => write!(f, "The rig heard nothing on its line and stopped by itself; check the cable."),
            _ => write!(f, "The rig stopped and gave no reason; look at it."),
        }
    }
}
