//! Flow-turning forms walls between 12° and 80° to the axis: below, the thinning is excessive; above, the metal is worked too
//! little to be sound (Mohamad 1988, section 1.1).

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::document::Forming;

/// Smallest half angle in one go, degrees.
const LEAST_DEG: f64 = 12.0;
/// Smallest half angle that two passes reach (Mohamad 1988, section 1.1), degrees.
const LEAST_IN_TWO_DEG: f64 = 8.0;
/// Largest half angle, degrees.
const MOST_DEG: f64 = 80.0;
/// Rounding of angles, degrees.
const ROUNDING_DEG: f64 = 1e-6;

/// Walls outside the range of the process.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let Some(shape) = checked.shape.filter(|_| checked.shell.forming == Forming::Shear) else { return Vec::new() };
    let least = if checked.shell.passes > 1 { LEAST_IN_TWO_DEG } else { LEAST_DEG };
    let angles = || shape.stations.iter().map(|s| s.half_angle.to_degrees());
    let low = angles().reduce(f64::min).filter(|a| *a >= 0.0 && *a < least - ROUNDING_DEG);
    let high = angles().reduce(f64::max).filter(|a| *a > MOST_DEG + ROUNDING_DEG);
    let place = || setting("former.shape");
    let low = low.map(|angle| {
        let message = format!(
            "The wall stands at {angle:.1}° to the axis; flow-turning in {} needs at least {least}°.",
            if checked.shell.passes > 1 { "several passes" } else { "one pass" }
        );
        Diagnostic::error("half-angle-small", place(), message)
            .with_hint("Make the shell wider, or form it by conventional spinning, which keeps the wall.")
    });
    let high = high.map(|angle| {
        let message = format!(
            "The wall stands at {angle:.1}° to the axis; above {MOST_DEG}° the metal is worked too little to be sound."
        );
        Diagnostic::warning("half-angle-large", place(), message)
    });
    low.into_iter().chain(high).collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_outside_the_range() {
        assert_eq!(codes(check, &cone(11.9)), ["half-angle-small"]);
        assert_eq!(codes(check, &cone(80.5)), ["half-angle-large"]);
        assert!(codes(check, &cone(12.0)).is_empty() && codes(check, &cone(80.0)).is_empty());
    }

    #[test]
    fn two_passes_reach_eight_degrees_and_spinning_any() {
        let two = Shell { passes: 2, ..cone(8.0) };
        assert!(codes(check, &two).is_empty());
        assert_eq!(codes(check, &Shell { passes: 2, ..cone(7.9) }), ["half-angle-small"]);
        assert!(codes(check, &Shell { forming: Forming::Spinning, ..cone(5.0) }).is_empty());
    }

    use crate::spinning::Shell;
}
