//! A list of elements begins and ends with a line: a bend needs straight strip on both sides to be bent by.

use super::subject::Subject;
use crate::diagnostic::Diagnostic;
use crate::document::{Element, ElementKind};

/// Lists that begin or end with a bend.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    subject.lists().into_iter().flat_map(|(list, _)| ends(subject, list)).collect()
}

fn ends(subject: &Subject<'_>, list: &[Element]) -> Vec<Diagnostic> {
    let first = list.first().map(|e| (e, "first"));
    let last = list.last().filter(|_| list.len() > 1).map(|e| (e, "last"));
    let ends = first.into_iter().chain(last).filter(|(e, _)| matches!(e.kind, ElementKind::Bend { .. }));
    ends.map(|(element, which)| {
        let message = format!("The {which} element of the list is a bend; it must be a line.");
        Diagnostic::error("end-element", subject.element(element.id), message).with_hint("Add a line beyond the bend.")
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::{bend, vee};

    #[test]
    fn fires_at_either_end() {
        let mut set = vee(&[90.0]);
        assert!(found(check, &set).is_empty());
        set.section.elements.remove(0);
        set.section.elements.push(bend(4, 1.0, 10.0));
        let places: Vec<String> = found(check, &set).iter().map(|d| d.at.to_string()).collect();
        assert_eq!(places, ["element 1", "element 3"]);
    }
}
