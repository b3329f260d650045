//! A line has a length; the inside radius of a bend may be 0 but not less.

use super::subject::Subject;
use crate::diagnostic::Diagnostic;
use crate::document::ElementKind;

/// Lines of length 0 or less and negative radii.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let faults = subject.set.section.all().filter_map(|element| {
        let message = match element.kind {
            ElementKind::Line { length } if length <= 0.0 => {
                format!("The line is {} long; it must be longer than 0.", subject.length(length))
            }
            ElementKind::Bend { inside_radius, .. } if inside_radius < 0.0 => {
                format!("The inside radius is {}; it must be at least 0.", subject.length(inside_radius))
            }
            _ => return None,
        };
        Some(Diagnostic::error("element-length", subject.element(element.id), message))
    });
    faults.collect()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::{bend, line, vee};

    #[test]
    fn fires_for_lines_and_radii() {
        let mut set = vee(&[90.0]);
        set.section.elements[1] = bend(2, 0.0, 90.0);
        assert!(found(check, &set).is_empty());
        set.section.elements = vec![line(1, 0.0), bend(2, -1.0, 90.0), line(3, -5.0)];
        assert_eq!(found(check, &set).len(), 3);
    }
}
