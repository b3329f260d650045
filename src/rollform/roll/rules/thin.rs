//! A roll has a wall around its bore: its least radius is more than that of its shaft.

use super::Checked;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::ElementName;
use crate::rollform::Roll;
use crate::rollform::part::bore_diameter;

/// Rolls that are thinner than their bore somewhere.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    checked.design.rolls.iter().filter_map(|roll| thin(checked, roll)).collect()
}

fn thin(checked: &Checked<'_>, roll: &Roll) -> Option<Diagnostic> {
    let surface = roll.elements.iter().filter(|e| !e.names.iter().any(|n| matches!(n, ElementName::Flank { .. })));
    let least = surface.map(|e| e.segment.bounds().min.r).min_by(f64::total_cmp)?;
    let bore = bore_diameter(checked.set, roll.roll.kind);
    if 2.0 * least > bore {
        return None;
    }
    let message = format!(
        "The roll's smallest diameter is {:.3} mm; it must be more than its bore of {bore:.3} mm.",
        2.0 * least
    );
    let at = Place::Roll { name: roll.name.clone() };
    Some(
        Diagnostic::error("roll-thin", at, message)
            .with_hint("Increase the distance of the axes, or use a thinner shaft."),
    )
}
