//! Spindle speed.

use super::ROUNDING;
use crate::machine::Machine;
use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::report::FindingKind;

/// Compares a speed in rev/min with the highest one.
pub(super) fn check(rpm: f64, machine: &Machine, place: Place, findings: &mut Findings) {
    let highest = machine.limits.spindle_max_rpm;
    if rpm < 0.0 || rpm > highest + ROUNDING {
        let message = format!("The spindle speed is {rpm:.0} rev/min; 0 to {highest:.0} rev/min is possible.");
        findings.add(place, Breach::error("speed", FindingKind::OutsideLimits, rpm, highest, message));
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::proof::tests::machine;

    /// The test lathe's spindle runs up to 2000 rev/min.
    fn fires_at(rpm: f64) -> bool {
        !found(|place, findings| check(rpm, &machine(), place, findings)).is_empty()
    }

    #[test]
    fn fires() {
        assert!(fires_at(2000.1) && fires_at(-1.0));
    }

    #[test]
    fn does_not_fire() {
        assert!(!fires_at(0.0) && !fires_at(2000.0));
    }
}
