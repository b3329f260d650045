//! The proof measures the gap against a tolerance: with none nothing could be proved, and one as thick as the wall would prove
//! a roller that touches the former.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;

/// Tolerances that are none, or as large as the thinnest wall.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let own = checked.shell.gap_tolerance;
    let thinnest = checked.shape.and_then(|shape| shape.thinnest()).map_or(f64::INFINITY, |station| station.wall);
    // A wall that comes to nothing has its own rule.
    let most = if thinnest > 0.0 { thinnest } else { f64::INFINITY };
    if own > 0.0 && own < most {
        return Vec::new();
    }
    let limit = if most.is_finite() {
        format!(" and less than the thinnest wall, {}", checked.length(most))
    } else {
        String::new()
    };
    let message = format!("The tolerance of the gap is {}; it must be more than 0{limit}.", checked.length(own));
    vec![Diagnostic::error("gap-tolerance", setting("gap_tolerance"), message)]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_for_none_and_for_one_as_thick_as_the_wall() {
        let mut shell = cone(30.0);
        assert!(codes(check, &shell).is_empty());
        for wrong in [0.0, -0.02, f64::NAN, 0.8] {
            shell.gap_tolerance = wrong;
            assert_eq!(codes(check, &shell), ["gap-tolerance"], "{wrong}");
        }
    }
}
