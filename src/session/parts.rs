//! An edit of the part that is shown, in the document that holds it.

use crate::document::{Content, Document, RollRef, RollWork, TurnedPart};

/// Changes the part that is shown: that of the document, or, of a set, the roll `shown` with the part it is turned as.
///
/// A roll's shape follows from its design, so that only what is decided about its turning goes into the document.
pub(super) fn change_part(
    document: &mut Document,
    shown: Option<(RollRef, TurnedPart)>,
    change: impl FnOnce(&mut TurnedPart),
) {
    match (&mut document.content, shown) {
        (Content::TurnedPart(part), _) => change(part),
        (Content::RollSet(set), Some((roll, before))) => {
            let mut after = before.clone();
            change(&mut after);
            if after.machine != before.machine {
                set.machine.clone_from(&after.machine);
            }
            if after.material != before.material {
                set.material.clone_from(&after.material);
            }
            decide(set.roll_mut(roll), &before, after);
        }
        (Content::RollSet(_) | Content::Shell(_), _) => {}
    }
}

/// Notes what differs between a roll's part before and after an edit.
fn decide(work: &mut RollWork, before: &TurnedPart, after: TurnedPart) {
    if (after.bar_diameter - before.bar_diameter).abs() > 0.0 {
        work.blank_diameter = Some(after.bar_diameter);
    }
    if after.generator != before.generator {
        work.generator = Some(after.generator);
    }
    work.plan = after.plan;
    work.program = after.program;
    work.overrides = after.overrides;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::RollKind;

    #[test]
    fn only_what_was_changed_is_decided() {
        let mut work = RollWork::of(RollRef { station: 1, kind: RollKind::Top });
        let before = TurnedPart::default();
        decide(&mut work, &before, before.clone());
        assert_eq!(work, RollWork::of(work.roll));
        decide(&mut work, &before, TurnedPart { bar_diameter: 150.0, ..before.clone() });
        assert_eq!((work.blank_diameter, work.generator), (Some(150.0), None));
    }
}
