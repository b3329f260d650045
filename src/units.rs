//! Length units of documents and files. The core works in mm; inches exist at the edges only.

mod figure;
mod length;

pub use figure::trimmed;
pub use length::parse_length;
use serde::{Deserialize, Serialize};

/// Millimetres in one inch.
pub const MM_PER_INCH: f64 = 25.4;

/// Length unit of a document or a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Unit {
    /// Millimetre.
    #[default]
    Mm,
    /// Inch.
    Inch,
}

impl Unit {
    /// Millimetres in one of this unit.
    #[must_use]
    pub const fn in_mm(self) -> f64 {
        match self {
            Self::Mm => 1.0,
            Self::Inch => MM_PER_INCH,
        }
    }

    /// Short name: `mm` or `in`.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Inch => "in",
        }
    }

    /// Decimals that a figure of this unit is shown with.
    #[must_use]
    pub const fn decimals(self) -> usize {
        match self {
            Self::Mm => 3,
            Self::Inch => 4,
        }
    }
}
