//! A bend that has a smaller angle than at the station before is bent back, which work-hardens it.

use super::subject::{Subject, degrees};
use crate::diagnostic::Diagnostic;
use crate::rollform::bends::{Stage, angles_deg};

/// Bends whose angle shrinks from one station to the next.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut before = angles_deg(subject.set, Stage::Flat);
    for (place, station) in subject.stations() {
        for bend in &station.bends {
            let Some(last) = before.insert(bend.element, bend.angle_deg) else { continue };
            if bend.angle_deg.abs() < last.abs() && bend.angle_deg * last >= 0.0 {
                let (name, angle) = (subject.name(bend.element), degrees(bend.angle_deg));
                let message = format!(
                    "The angle of {name} goes back to {angle}; it was {} at the station before.",
                    degrees(last)
                );
                found.push(
                    Diagnostic::warning("unbending", place.clone(), message)
                        .with_related(subject.element(bend.element)),
                );
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_where_an_angle_shrinks() {
        assert_eq!(found(check, &vee(&[45.0, 30.0, 90.0])).len(), 1);
        assert!(found(check, &vee(&[45.0, 45.0, 90.0])).is_empty());
    }
}
