//! A bend that goes the other way first is bent back later: the metal hardens, and the rolls would have its mirror image.

use super::subject::{Subject, degrees};
use crate::diagnostic::Diagnostic;

/// Angles with the other sign than the finished bend has.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (place, station) in subject.stations() {
        for bend in &station.bends {
            let Some(finished) = subject.finished_deg(bend.element) else { continue };
            if bend.angle_deg * finished < 0.0 {
                let (name, angle) = (subject.name(bend.element), degrees(bend.angle_deg));
                let message = format!(
                    "The angle of {name} is {angle}; the finished bend goes the other way, to {}.",
                    degrees(finished)
                );
                found.push(
                    Diagnostic::error("opposite-bend", place.clone(), message)
                        .with_hint("Change the sign of the angle.")
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
    fn fires_for_the_other_sign_only() {
        assert_eq!(found(check, &vee(&[-10.0, 0.0, 90.0])).len(), 1);
        assert!(found(check, &vee(&[0.0, 45.0, 120.0])).is_empty());
    }
}
