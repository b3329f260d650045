//! The cylinder behind the contour keeps the shell off the chuck; it has a length or is not there.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;

/// Lengths that are none.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let length = checked.shell.former.base_length;
    if length >= 0.0 || length.is_nan() {
        return Vec::new();
    }
    let message = format!("The base behind the contour is {} long; it must be 0 or more.", checked.length(length));
    vec![Diagnostic::error("base-length", setting("former.base_length"), message)]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_for_less_than_nothing() {
        let mut shell = cone(30.0);
        shell.former.base_length = 0.0;
        assert!(codes(check, &shell).is_empty());
        shell.former.base_length = -0.1;
        assert_eq!(codes(check, &shell), ["base-length"]);
    }
}
