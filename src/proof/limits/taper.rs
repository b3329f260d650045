//! Steepness of a taper.

use crate::geometry::Point;
use crate::machine::Machine;
use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::report::FindingKind;

/// A leg of a taper shorter than this, mm, is none: it is below the resolution of the control.
const NO_LEG_MM: f64 = 0.000_5;

/// Compares the ratio of a line's legs with the largest that the control runs.
pub(super) fn check(start: Point, end: Point, machine: &Machine, place: Place, findings: &mut Findings) {
    let ratio_limit = machine.limits.taper_ratio;
    let (dz, dr) = ((end.z - start.z).abs(), (end.r - start.r).abs());
    let (long, short) = (dz.max(dr), dz.min(dr));
    if short > NO_LEG_MM && long >= ratio_limit * short {
        let ratio = long / short;
        let message = format!(
            "The taper moves {dr:.3} mm in x and {dz:.3} mm in z, {ratio:.1} to 1; the control takes less than {ratio_limit:.0} to 1."
        );
        let breach = Breach::error("taper", FindingKind::OutsideLimits, ratio, ratio_limit, message);
        // A warning only: of the ten chords that the published MASTER part asks for, the one at the crown is 23.7 to 1.
        findings.add(place, breach.into_warning().at(end));
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::proof::tests::machine;

    /// The test lathe runs tapers of less than 20 to 1.
    fn fires_at(z: f64, r: f64) -> bool {
        !found(|place, findings| check(Point::default(), Point::new(z, r), &machine(), place, findings)).is_empty()
    }

    #[test]
    fn fires() {
        assert!(fires_at(-10.0, 0.5) && fires_at(0.25, 10.0));
    }

    #[test]
    fn does_not_fire() {
        assert!(!fires_at(-10.0, 0.51) && !fires_at(-10.0, 0.0) && !fires_at(0.0, 10.0));
    }
}
