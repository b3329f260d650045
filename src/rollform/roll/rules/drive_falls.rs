//! Along the line the strip is kept taut: on shafts that turn alike the bottom rolls' drive diameters do not fall.

use crate::diagnostic::{Diagnostic, Place};
use crate::rollform::StationDesign;

/// Diameters that differ by less are the same, mm.
const SAME_MM: f64 = 0.001;

/// Stations whose bottom roll runs slower than the one before.
pub(super) fn check(stations: &[StationDesign]) -> Vec<Diagnostic> {
    let driven: Vec<(&StationDesign, f64)> =
        stations.iter().filter_map(|station| Some((station, station.drive?.bottom?))).collect();
    driven.windows(2).filter_map(|pair| if let [a, b] = pair { slower(*a, *b) } else { None }).collect()
}

fn slower((before, larger): (&StationDesign, f64), (station, smaller): (&StationDesign, f64)) -> Option<Diagnostic> {
    if smaller >= larger - SAME_MM {
        return None;
    }
    let message = format!(
        "The bottom roll's drive diameter is {smaller:.3} mm, that of station {} {larger:.3} mm; it must not be less, for on shafts \
         that turn alike the strip slackens between them.",
        before.number
    );
    let hint = format!("Increase the pass height by {:.3} mm.", (larger - smaller) / 2.0);
    let at = |s: &StationDesign| Place::Station { id: s.station, number: s.number };
    Some(Diagnostic::warning("roll-drive-falls", at(station), message).with_related(at(before)).with_hint(hint))
}
