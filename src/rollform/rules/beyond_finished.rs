//! Beyond its finished angle a bend is overbent. That may be meant, for springback; but the metal of the bend must reach.

use super::subject::{Subject, degrees};
use crate::diagnostic::Diagnostic;
use crate::rollform::bends::mean_length;

/// Angles beyond the finished one: a warning, or an error where no inside radius is left.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (place, station) in subject.stations() {
        for bend in &station.bends {
            let finished = subject.bends().find(|&(id, ..)| id == bend.element);
            let Some((id, radius, finished)) = finished.filter(|&(.., f)| bend.angle_deg.abs() > f.abs()) else {
                continue;
            };
            let thickness = subject.set.section.thickness;
            let sharpest = (2.0 * mean_length(radius, finished, thickness) / thickness).to_degrees();
            let (name, angle) = (subject.name(id), degrees(bend.angle_deg));
            let report = if bend.angle_deg.abs() > sharpest {
                let message = format!(
                    "The angle of {name} is {angle}; at {} its inside radius is 0.",
                    degrees(sharpest.copysign(finished))
                );
                Diagnostic::error("beyond-finished", place.clone(), message).with_hint("Use a smaller angle.")
            } else {
                let message = format!("The angle of {name} is {angle}, beyond the finished {}.", degrees(finished));
                Diagnostic::warning("beyond-finished", place.clone(), message)
                    .with_hint("Keep it if it is meant as overbend against springback.")
            };
            found.push(report.with_related(subject.element(id)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::diagnostic::Severity;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_beyond_the_finished_angle() {
        assert!(found(check, &vee(&[45.0, 90.0])).is_empty());
        assert_eq!(found(check, &vee(&[92.0]))[0].severity, Severity::Warning);
        // Mean length 2.5 mm times a right angle; half a thickness of 0.5 mm would do for 450 degrees.
        let impossible = found(check, &vee(&[451.0]));
        assert_eq!(impossible[0].severity, Severity::Error);
        assert!(impossible[0].message.contains("450°"), "{impossible:?}");
    }
}
