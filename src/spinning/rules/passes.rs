//! One pass forms cones down to about 13°; between 8° and 13° there must be two (Mohamad 1988, section 1.1).

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::document::Forming;
use crate::spinning::limits::MOST_PASSES;

/// Smallest half angle in one pass, degrees.
const ONE_PASS_DEG: f64 = 13.0;

/// Too few passes for the angle, or a number that is none.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let passes = checked.shell.passes;
    if !(1..=MOST_PASSES).contains(&passes) {
        let message = format!("There are {passes} passes; there must be 1 to {MOST_PASSES}.");
        return vec![Diagnostic::error("passes", setting("passes"), message)];
    }
    let Some(shape) = checked.shape.filter(|_| checked.shell.forming == Forming::Shear && passes == 1) else {
        return Vec::new();
    };
    let least = shape.stations.iter().map(|s| s.half_angle.to_degrees()).reduce(f64::min);
    let Some(angle) = least.filter(|angle| *angle < ONE_PASS_DEG - 1e-6) else { return Vec::new() };
    let message =
        format!("The wall stands at {angle:.1}° to the axis; one pass forms walls from about {ONE_PASS_DEG}°.");
    vec![Diagnostic::warning("passes-few", setting("passes"), message).with_hint("Take two passes.")]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::spinning::Shell;

    #[test]
    fn fires_for_one_pass_below_thirteen_degrees_and_for_no_pass() {
        assert_eq!(codes(check, &cone(12.5)), ["passes-few"]);
        assert_eq!(codes(check, &Shell { passes: 0, ..cone(30.0) }), ["passes"]);
        assert_eq!(codes(check, &Shell { passes: 9, ..cone(30.0) }), ["passes"]);
        assert!(codes(check, &cone(13.0)).is_empty());
        assert!(codes(check, &Shell { passes: 2, ..cone(12.5) }).is_empty());
    }
}
