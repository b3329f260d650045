//! Every figure must be a number that can be calculated with: a NaN would spread through everything derived, and must never
//! reach a rig.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::spinning::limits::LARGEST_FIGURE;

/// Figures that are not numbers, infinite, or beyond what any spinning lathe holds.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let wrong = checked.shell.figures().into_iter().filter(|(_, v)| !(v.is_finite() && v.abs() <= LARGEST_FIGURE));
    wrong
        .map(|(path, value)| {
            let message =
                format!("The figure is {value:e}; it must be a number between −{LARGEST_FIGURE} and {LARGEST_FIGURE}.");
            Diagnostic::error("shell-figure", setting(&path), message).with_hint("Enter the figure again.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_for_what_is_no_number_and_for_the_absurd() {
        for wrong in [f64::NAN, f64::INFINITY, -1e9] {
            let mut shell = cone(30.0);
            shell.rig.rpm = wrong;
            assert_eq!(codes(check, &shell), ["shell-figure"]);
        }
        assert!(codes(check, &cone(30.0)).is_empty());
    }
}
