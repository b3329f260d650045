//! What the rig is asked for must be possible: it never starts on figures that are none.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;

/// Highest spindle speed of the published lathe, rev/min (Mohamad 1988, section 6.4).
const MOST_RPM: f64 = 750.0;
/// Most encoder pulses between two set points: a turn of the published leadscrew.
const MOST_PULSES: u32 = 100;

/// Settings of the rig outside its range.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let rig = &checked.shell.rig;
    let positive = |mm: f64| format!("{}; it must be more than 0", checked.length(mm));
    let wrong = [
        (
            "rpm",
            rig.rpm > 0.0 && rig.rpm <= MOST_RPM,
            format!("The rig's spindle speed is {} rev/min; it must be more than 0 and at most {MOST_RPM}", rig.rpm),
        ),
        ("feed_per_rev", rig.feed_per_rev > 0.0, format!("The carriage feed is {}", positive(rig.feed_per_rev))),
        (
            "increment_pulses",
            (1..=MOST_PULSES).contains(&rig.increment_pulses),
            format!("The increment is {} pulses; it must be 1 to {MOST_PULSES}", rig.increment_pulses),
        ),
        ("path_limit", rig.path_limit > 0.0, format!("The limit off the path is {}", positive(rig.path_limit))),
    ];
    let wrong = wrong.into_iter().filter(|(_, good, _)| !good);
    wrong
        .map(|(name, _, message)| Diagnostic::error("rig", setting(&format!("rig.{name}")), format!("{message}.")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::document::RigChoices;

    #[test]
    fn fires_for_every_setting_out_of_range() {
        let mut shell = cone(30.0);
        assert!(codes(check, &shell).is_empty());
        shell.rig = RigChoices { rpm: 800.0, feed_per_rev: 0.0, increment_pulses: 0, path_limit: -1.0 };
        assert_eq!(codes(check, &shell), ["rig", "rig", "rig", "rig"]);
        shell.rig.rpm = f64::NAN;
        assert_eq!(codes(check, &shell).len(), 4);
    }
}
