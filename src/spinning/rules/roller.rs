//! A roller is a wheel: wider than its nose, larger than it is wide, and standing so that its flanks clear the wall.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::spinning::limits::STATIONS;

/// Rollers that are none.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let roller = &checked.shell.roller;
    let nose = roller.nose_radius;
    let length = |mm: f64| checked.length(mm);
    let degrees = |value: f64| format!("{value}°");
    [
        ("nose_radius", nose > 0.0, length(nose), "more than 0".to_owned()),
        ("width", roller.width >= 2.0 * nose, length(roller.width), format!("at least {}", length(2.0 * nose))),
        (
            "diameter",
            roller.diameter >= 2.0 * nose,
            length(roller.diameter),
            format!("at least {}", length(2.0 * nose)),
        ),
        ("swivel_deg", roller.swivel_deg.abs() <= 90.0, degrees(roller.swivel_deg), "within −90° and 90°".to_owned()),
        (
            "flank_deg",
            roller.flank_deg > 0.0 && roller.flank_deg < 90.0,
            degrees(roller.flank_deg),
            "between 0° and 90°".to_owned(),
        ),
        (
            "station",
            STATIONS.contains(&roller.station),
            roller.station.to_string(),
            format!("{} to {}", STATIONS.start(), STATIONS.end()),
        ),
    ]
    .into_iter()
    .filter(|(_, good, _, _)| !good)
    .map(|(name, _, value, limit)| {
        let words = name.trim_end_matches("_deg").replace('_', " ");
        let message = format!("The {words} of the roller is {value}; it must be {limit}.");
        Diagnostic::error("roller", setting(&format!("roller.{name}")), message)
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_for_every_figure_that_no_roller_has() {
        let mut shell = cone(30.0);
        assert!(codes(check, &shell).is_empty());
        shell.roller.width = 10.0;
        shell.roller.flank_deg = 0.0;
        assert_eq!(codes(check, &shell), ["roller", "roller"]);
        shell.roller.nose_radius = -1.0;
        shell.roller.swivel_deg = 100.0;
        assert_eq!(codes(check, &shell).len(), 3);
        shell.roller.station = 0;
        assert_eq!(codes(check, &shell).len(), 4);
    }
}
