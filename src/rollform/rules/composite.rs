//! The parts of a composite bend are all of it: they sum to 100 percent, none is negative and the arc has some.

use super::subject::Subject;
use crate::diagnostic::Diagnostic;
use crate::document::Composite;

/// Sums that differ from 100 percent by less are rounding, percent.
const ROUNDING_PERCENT: f64 = 1e-6;

/// Composites of what is no bend, with impossible parts or at stations that are unknown or the wrong way round.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    subject.set.composites.iter().flat_map(|c| faults(subject, c)).collect()
}

fn faults(subject: &Subject<'_>, composite: &Composite) -> Vec<Diagnostic> {
    let (name, [leading, arc, trailing]) = (subject.name(composite.element), composite.percent);
    let mut messages = Vec::new();
    if subject.finished_deg(composite.element).is_none() {
        messages.push(format!("The composite bend {name} is no bend of the section."));
    }
    let sum = leading + arc + trailing;
    if (sum - 100.0).abs() > ROUNDING_PERCENT {
        messages.push(format!("The parts of {name} sum to {sum} %; they must sum to 100 %."));
    }
    if leading < 0.0 || trailing < 0.0 || arc <= 0.0 {
        messages.push(format!(
            "The parts of {name} are {leading} %, {arc} % and {trailing} %; the lines must have at least 0 % and the arc more."
        ));
    }
    if let Some(fixed) = composite.fixed {
        let at = |id: u32| subject.set.stations.iter().position(|s| s.id == id);
        match (at(fixed.first), at(fixed.last)) {
            (Some(first), Some(last)) if first <= last => {}
            (Some(first), Some(last)) => messages.push(format!(
                "The parts of {name} hold from station {} to station {}; the first must not come after the last.",
                first + 1,
                last + 1
            )),
            _ => messages.push(format!("The parts of {name} hold at stations that the line does not have.")),
        }
    }
    messages
        .into_iter()
        .map(|message| Diagnostic::error("composite-bend", subject.element(composite.element), message))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::document::FixedComposite;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_for_parts_and_stations_that_cannot_be() {
        let fixed = |first, last| Some(FixedComposite { first, last });
        for (element, percent, fixed, count) in [
            (2, [20.0, 60.0, 20.0], None, 0),
            (2, [0.0, 100.0, 0.0], fixed(1, 2), 0),
            (2, [20.0, 60.0, 21.0], None, 1),
            (2, [-20.0, 100.0, 20.0], None, 1),
            (2, [50.0, 0.0, 50.0], None, 1),
            (1, [20.0, 60.0, 20.0], None, 1),
            (9, [20.0, 60.0, 20.0], None, 1),
            (2, [20.0, 60.0, 20.0], fixed(2, 1), 1),
            (2, [20.0, 60.0, 20.0], fixed(1, 7), 1),
        ] {
            let mut set = vee(&[45.0, 90.0]);
            set.composites = vec![Composite { element, percent, fixed }];
            assert_eq!(found(check, &set).len(), count, "{element} {percent:?} {fixed:?}");
        }
    }
}
