//! Geared rolls run alike: their drive diameters are inversely as the speeds of their shafts, or one slips on the strip.

use super::Checked;
use crate::diagnostic::Diagnostic;

/// Most that the surface speeds of top and bottom roll may differ by, as a part of the bottom roll's: a guide value of practice.
const MOST_DIFFERENCE: f64 = 0.02;

/// Drive diameters that do not fit the gear ratio, and a ratio of the station that is none.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    if let Some(ratio) = checked.station.gear_ratio.filter(|ratio| *ratio <= 0.0) {
        let message = format!("The gear ratio of the station is {ratio}; it must be greater than 0.");
        let error = Diagnostic::error("gear-ratio", checked.at(), message);
        return vec![error.with_hint("Enter the speed of the top shaft divided by that of the bottom shaft.")];
    }
    misfit(checked).into_iter().collect()
}

fn misfit(checked: &Checked<'_>) -> Option<Diagnostic> {
    let drive = checked.design.drive?;
    let (bottom, top, ratio) = (drive.bottom?, drive.top?, drive.gear_ratio.filter(|ratio| *ratio > 0.0)?);
    let (difference, fitting) = (drive.top_runs_faster_by()?, drive.fitting_ratio()?);
    if difference.abs() <= MOST_DIFFERENCE {
        return None;
    }
    let word = if difference > 0.0 { "faster" } else { "slower" };
    let message = format!(
        "The drive diameters are {bottom:.3} mm (bottom) and {top:.3} mm (top): at the gear ratio {ratio} the top roll's surface \
         runs {:.1} % {word} than the bottom roll's and slips; at most {:.0} % is usual (guide value).",
        difference.abs() * 100.0,
        MOST_DIFFERENCE * 100.0
    );
    let hint = format!("Enter the gear ratio {fitting:.3}, or change pass height and distance of the axes.");
    Some(Diagnostic::warning("roll-drive-ratio", checked.at(), message).with_hint(hint))
}
