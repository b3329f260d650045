//! What the rolls of a set cost to make.

use serde::{Deserialize, Serialize};

/// Prices that hold for one set; what is absent is taken from the data of the machine and of the material.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rates {
    /// Name of the currency.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub currency: Option<String>,
    /// Machine and operator, per hour.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine_per_hour: Option<f64>,
    /// Material of the set, per kg of the blank; rolls of another material cost what the material table says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub price_per_kg: Option<f64>,
}
