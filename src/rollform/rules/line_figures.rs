//! Strain is reckoned over the distance from station to station; rolls turn on shafts that have a diameter.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};

/// Figures of the line that are not greater than 0.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let line = &subject.set.line;
    let report = |what: &str, value: String| {
        let message = format!("The {what} is {value}; it must be greater than 0.");
        Diagnostic::error("forming-line", Place::Document, message)
    };
    let lengths = [
        ("distance from station to station", line.station_pitch),
        ("diameter of the shafts", line.shaft_diameter),
        ("diameter of the side rolls' axles", line.side_shaft_diameter),
    ];
    let bad = lengths.into_iter().filter(|&(_, value)| value <= 0.0);
    let mut found: Vec<Diagnostic> = bad.map(|(what, value)| report(what, subject.length(value))).collect();
    let figures = [("ratio of the shafts' speeds", line.gear_ratio), ("speed of the bottom shafts", line.bottom_rpm)];
    let bad = figures.into_iter().filter_map(|(what, value)| Some((what, value.filter(|v| *v <= 0.0)?)));
    found.extend(bad.map(|(what, value)| report(what, value.to_string())));
    found.extend(subject.set.die_clearance.filter(|clearance| *clearance < 0.0).map(|clearance| {
        let message = format!(
            "The clearance of the die block's aperture is {}; it must be 0 or more.",
            subject.length(clearance)
        );
        Diagnostic::error("die-clearance", Place::Document, message)
    }));
    found
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_for_every_figure() {
        let mut set = vee(&[90.0]);
        assert!(found(check, &set).is_empty());
        set.line.station_pitch = 0.0;
        set.line.shaft_diameter = -1.0;
        set.line.side_shaft_diameter = 0.0;
        set.line.gear_ratio = Some(0.0);
        set.line.bottom_rpm = Some(-3.0);
        set.die_clearance = Some(-0.1);
        assert_eq!(found(check, &set).len(), 6);
    }
}
