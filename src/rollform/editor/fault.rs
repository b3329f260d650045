//! Why an edit does not fit.

use crate::document::{ElementName, PieceKind};

/// An edit that was left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EditFault {
    /// Id of the edit.
    pub edit: u32,
    /// Stable short name of the reason.
    pub code: &'static str,
    /// A sentence with value and limit.
    pub message: String,
    /// What to do about it.
    pub hint: &'static str,
}

/// Code, message and hint.
pub(super) type Reason = (&'static str, String, &'static str);

/// The element is gone.
pub(super) fn lost(name: ElementName) -> Reason {
    let message = format!("The roll has no element from {} any more.", described(name));
    ("edit-lost", message, "Delete the edit, or let it refer to another element.")
}

/// Two elements have no common point.
pub(super) fn no_meeting(what: &str) -> Reason {
    let message = format!("{what} do not meet, however far they are prolonged.");
    ("edit-no-meeting", message, "Choose another line or circle.")
}

/// A neighbour would run backwards.
pub(super) fn turns_back(by_mm: f64) -> Reason {
    let message =
        format!("A neighbouring line would have to be shortened by {by_mm:.3} mm more than its whole length.");
    ("edit-turns-back", message, "Move the new element nearer to the corner.")
}

/// A figure that cannot be used.
pub(super) fn figure(name: &str, value: f64) -> Reason {
    ("edit-figure", format!("The {name} is {value}; it must be a number above 0 mm."), "Enter another figure.")
}

/// What made an element, for people.
#[must_use]
pub fn described(name: ElementName) -> String {
    match name {
        ElementName::Strip { element, side, kind: PieceKind::Line | PieceKind::Arc } => {
            format!("element {element} {}", side.name())
        }
        ElementName::Strip { element, side, .. } => format!("the straight part of element {element} {}", side.name()),
        ElementName::Edge { side } => format!("the {} edge of the strip", side.name()),
        ElementName::Extension { side, part } => format!("part {part} of the {} extension", side.name()),
        ElementName::Unreached { element: 0, side } => format!("the overhang of the {} edge of the strip", side.name()),
        ElementName::Unreached { element, side } => format!("the overhang of element {element} {}", side.name()),
        ElementName::Flank { side } => format!("the {} side face", side.name()),
        ElementName::Edit { edit } => format!("edit {edit}"),
    }
}
