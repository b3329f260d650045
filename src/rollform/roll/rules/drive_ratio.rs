//! Geared rolls run alike: their drive diameters are inversely as the speeds of their shafts, or one slips on the strip.
//!
//! A ratio of 1 of a line about whose drive nothing else is said is what older files filled in by themselves. Whether it is meant
//! nobody knows, so that it is told once for the line, and no station is warned of.

use super::Checked;
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::document::RollSet;
use crate::rollform::StationDesign;

/// Most that the surface speeds of top and bottom roll may differ by, as a part of the bottom roll's: a guide value of practice.
const MOST_DIFFERENCE: f64 = 0.02;

/// Drive diameters that do not fit the gear ratio, and a ratio of the station that is none.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    if let Some(ratio) = checked.station.gear_ratio.filter(|ratio| *ratio <= 0.0) {
        let message = format!("The gear ratio of the station is {ratio}; it must be greater than 0.");
        let error = Diagnostic::error("gear-ratio", checked.at(), message);
        return vec![error.with_hint("Enter the speed of the top shaft divided by that of the bottom shaft.")];
    }
    let misfit = Misfit::of(checked.design).filter(|_| !is_filled_in(checked.set));
    misfit.map(|misfit| misfit.said(checked.at())).into_iter().collect()
}

/// Says once of a ratio that nobody entered at which stations it would not fit.
pub(super) fn check_line(set: &RollSet, stations: &[StationDesign]) -> Option<Diagnostic> {
    if !is_filled_in(set) {
        return None;
    }
    let fitting: Vec<f64> = stations.iter().filter_map(|station| Some(Misfit::of(station)?.fitting)).collect();
    let least = fitting.iter().copied().min_by(f64::total_cmp)?;
    let most = fitting.iter().copied().max_by(f64::total_cmp)?;
    let message = format!(
        "The gear ratio of the line is 1, which {} of {} stations would not run with: their drive diameters want {least:.3} to \
         {most:.3}. Older files said 1 without being asked.",
        fitting.len(),
        stations.len()
    );
    let hint = "Enter the ratio of the line, or empty the field if it is not known.";
    Some(Diagnostic::new(Severity::Info, "roll-drive-ratio-assumed", Place::Document, message).with_hint(hint))
}

/// True if the ratio is 1 and nothing else is said about how the line is driven.
fn is_filled_in(set: &RollSet) -> bool {
    let is_one = set.line.gear_ratio.is_some_and(|ratio| (ratio - 1.0).abs() <= 0.0);
    is_one && set.line.bottom_rpm.is_none() && set.stations.iter().all(|station| station.gear_ratio.is_none())
}

/// Drive diameters that do not fit the gear ratio.
struct Misfit {
    bottom: f64,
    top: f64,
    ratio: f64,
    difference: f64,
    fitting: f64,
}

impl Misfit {
    fn of(design: &StationDesign) -> Option<Self> {
        let drive = design.drive?;
        let ratio = drive.gear_ratio.filter(|ratio| *ratio > 0.0)?;
        let (difference, fitting) = (drive.top_runs_faster_by()?, drive.fitting_ratio()?);
        (difference.abs() > MOST_DIFFERENCE).then_some(Self {
            bottom: drive.bottom?,
            top: drive.top?,
            ratio,
            difference,
            fitting,
        })
    }

    fn said(&self, at: Place) -> Diagnostic {
        let word = if self.difference > 0.0 { "faster" } else { "slower" };
        let message = format!(
            "The drive diameters are {:.3} mm (bottom) and {:.3} mm (top): at the gear ratio {} the top roll's surface runs \
             {:.1} % {word} than the bottom roll's and slips; at most {:.0} % is usual (guide value).",
            self.bottom,
            self.top,
            self.ratio,
            self.difference.abs() * 100.0,
            MOST_DIFFERENCE * 100.0
        );
        let hint = format!("Enter the gear ratio {:.3}, or change pass height and distance of the axes.", self.fitting);
        Diagnostic::warning("roll-drive-ratio", at, message).with_hint(hint)
    }
}
