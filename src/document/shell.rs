//! A flow-turned shell. Lengths are in the unit of the document, angles in degrees.

use serde::{Deserialize, Serialize};

/// A shell that is flow-turned over a former.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shell {
    /// Machine id of the spinning lathe.
    pub machine: String,
    /// Thickness of the blank.
    pub blank_thickness: f64,
}

impl Shell {
    /// The same shell with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self { blank_thickness: self.blank_thickness * factor, ..self.clone() }
    }
}
