//! A station bends bends of the section: an angle of a line, or of an element that is gone, does nothing.

use super::subject::Subject;
use crate::diagnostic::Diagnostic;

/// Angles of lines and of unknown elements, and two angles of one bend at a station.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (place, station) in subject.stations() {
        let mut named = Vec::new();
        for bend in &station.bends {
            let name = subject.name(bend.element);
            let message = if !subject.has_element(bend.element) {
                format!("The station bends {name}; the section has no such element.")
            } else if subject.finished_deg(bend.element).is_none() {
                format!("The station bends {name}, which is a line; only bends have an angle.")
            } else if named.contains(&bend.element) {
                format!("The station has 2 angles for {name}; it must have 1, and the last one is used.")
            } else {
                named.push(bend.element);
                continue;
            };
            found.push(
                Diagnostic::error("unknown-bend", place.clone(), message)
                    .with_hint("Delete the angle at this station."),
            );
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::{station, vee};

    #[test]
    fn fires_for_lines_unknown_elements_and_second_angles() {
        let mut set = vee(&[90.0]);
        assert!(found(check, &set).is_empty());
        set.stations = vec![station(1, &[(1, 5.0), (9, 5.0), (2, 30.0), (2, 40.0)])];
        let messages: Vec<String> = found(check, &set).into_iter().map(|d| d.message).collect();
        assert_eq!(messages.len(), 3);
        assert!(
            messages[0].contains("is a line") && messages[1].contains("no such") && messages[2].contains("2 angles")
        );
    }
}
