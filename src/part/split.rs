//! The position that divides a part machined at both ends.

use super::shape::{SAME_PLACE_MM, is_usable};
use crate::diagnostic::{Column, Diagnostic, Place, SectionTable};
use crate::document::{Ends, TurnedPart};
use crate::machine::Machine;

/// The split point of a part of `length` mm, entered or found, and what is to be said about it.
///
/// Found as published: the start of the first section far enough from the clamped end for the chuck's grip and the gap
/// in front of it, or, with automatic handling, for the chuck and the handling. Lengths in mm.
pub(super) fn split(part_mm: &TurnedPart, length: f64, machine: &Machine) -> (f64, Vec<Diagnostic>) {
    let held = held_length(part_mm, machine);
    let entered = match part_mm.ends {
        Ends::Two { split } => split,
        Ends::One => None,
    };
    let (split, mut diagnostics) = match entered {
        Some(split) if is_usable(split) && split > SAME_PLACE_MM && split < length - SAME_PLACE_MM => {
            (split, Vec::new())
        }
        Some(split) => {
            let (found, mut diagnostics) = find(part_mm, length, held);
            diagnostics.insert(0, outside_part(split, length, found));
            (found, diagnostics)
        }
        None => find(part_mm, length, held),
    };
    diagnostics.extend(too_short("first", split, held));
    diagnostics.extend(too_short("second", length - split, held));
    diagnostics.extend(cut_threads(part_mm, split));
    (split, diagnostics)
}

/// Length that must stay unmachined in one clamping, mm.
fn held_length(part_mm: &TurnedPart, machine: &Machine) -> f64 {
    let chuck = &machine.chuck;
    if part_mm.automatic { chuck.automatic_grip_mm } else { chuck.grip_mm + chuck.gap_mm }
}

/// The start of the first section at least `held` from the clamped end, or the middle.
fn find(part_mm: &TurnedPart, length: f64, held: f64) -> (f64, Vec<Diagnostic>) {
    let far_enough = part_mm.sections.iter().map(|s| s.z1).filter(|&z| z >= held - SAME_PLACE_MM);
    let first = far_enough.filter(|&z| z < length - SAME_PLACE_MM).fold(f64::INFINITY, f64::min);
    if first.is_finite() {
        return (first, Vec::new());
    }
    let middle = length / 2.0;
    let message = format!(
        "No section begins {held:.3} mm or more from the clamped end of the {length:.3} mm long part; it is divided in \
         its middle, at {middle:.3} mm."
    );
    (middle, vec![Diagnostic::warning("split-not-found", Place::Document, message).with_hint("Enter the split point.")])
}

fn outside_part(split: f64, length: f64, found: f64) -> Diagnostic {
    let message = format!(
        "The split point at {split:.3} mm is not inside the part, 0 to {length:.3} mm; {found:.3} mm is used instead."
    );
    Diagnostic::error("split-outside-part", Place::Document, message).with_hint("Enter a position inside the part.")
}

fn too_short(which: &str, length: f64, held: f64) -> Option<Diagnostic> {
    let message = format!(
        "The {which} clamping has {length:.3} mm of the part to hold; the chuck and the gap in front of it need \
         {held:.3} mm."
    );
    (length < held - SAME_PLACE_MM).then(|| {
        Diagnostic::warning("split-short-grip", Place::Document, message)
            .with_hint("Move the split point, or check by hand that the chuck is clear of the tool.")
    })
}

/// Threads that run over the split point; a thread cannot be cut in two clampings.
fn cut_threads(part_mm: &TurnedPart, split: f64) -> Vec<Diagnostic> {
    let rows = part_mm.sections.iter().enumerate();
    rows.filter(|(_, s)| matches!(s.kind, crate::part::SectionKind::Thread { .. }))
        .filter(|(_, s)| s.z1 < split - SAME_PLACE_MM && s.z2 > split + SAME_PLACE_MM)
        .map(|(index, s)| {
            let at =
                Place::Section { id: s.id, table: SectionTable::Outside, row: index + 1, column: Some(Column::Z1) };
            let message = format!(
                "The thread from {:.3} mm to {:.3} mm runs over the split point at {split:.3} mm; it cannot be cut in \
                 two clampings.",
                s.z1, s.z2
            );
            Diagnostic::error("split-through-thread", at, message).with_hint("Move the split point off the thread.")
        })
        .collect()
}
