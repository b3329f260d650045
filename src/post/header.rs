//! What a program says about itself.

use crate::document::{Document, Holding, TurnedPart};
use crate::machine::{Catalog, Machine};
use crate::units::trimmed;
use std::collections::BTreeMap;

/// Texts for the operator at the head of a program. Equal documents give equal texts: there is no clock in them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Header {
    /// Name of the part.
    pub part: String,
    /// Material.
    pub material: String,
    /// What to put into the machine: `BAR D160 X 159.303 MM`.
    pub stock: String,
    /// How it is held.
    pub holding: String,
    /// Name of the tool in each station.
    pub tools: BTreeMap<u32, String>,
}

impl Header {
    /// What the programs of `part`, which `document` holds in its own unit, say about themselves.
    #[must_use]
    pub fn new(document: &Document, part: &TurnedPart, machine: &Machine, catalog: &Catalog) -> Self {
        let name = |id: &str| catalog.tool(id).map_or_else(|| id.to_owned(), |tool| tool.name.clone());
        let holding = match part.holding {
            Holding::Chuck => "CHUCK",
            Holding::BetweenCentres => "BETWEEN CENTRES",
        };
        Self {
            part: document.name.clone(),
            material: part.material.clone(),
            stock: stock(document, part),
            holding: holding.to_owned(),
            tools: machine.tools.iter().map(|t| (t.station, name(&t.tool))).collect(),
        }
    }
}

fn stock(document: &Document, part: &TurnedPart) -> String {
    let decimals = document.unit.decimals();
    let figure = |value: f64| trimmed(value, decimals);
    let bore = if part.stock_bore_diameter > 0.0 {
        format!(" BORE D{}", figure(part.stock_bore_diameter))
    } else {
        String::new()
    };
    let length = figure(part.length + part.facing_allowance);
    format!("BAR D{}{bore} X {length} {}", figure(part.bar_diameter), document.unit.symbol().to_uppercase())
}
