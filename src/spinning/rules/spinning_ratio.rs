//! Conventional spinning draws the blank in; a blank too large for its finished diameter wrinkles (guide value).

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::document::Forming;
use crate::spinning::limits::MOST_PASSES;
use crate::spinning::material::SPINNING_RATIO_PER_PASS;

/// Blanks too large for the number of passes.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let Some(shape) = checked.shape.filter(|_| checked.shell.forming == Forming::Spinning) else { return Vec::new() };
    let passes = checked.shell.passes.clamp(1, MOST_PASSES);
    let limit = SPINNING_RATIO_PER_PASS.powf(f64::from(passes));
    let ratio = shape.blank_radius / shape.base().r;
    if ratio <= limit {
        return Vec::new();
    }
    let message = format!(
        "The blank of {} is {ratio:.2} times the finished diameter; {passes} passes spin up to {limit:.2} times.",
        checked.length(2.0 * shape.blank_radius)
    );
    vec![Diagnostic::warning("spinning-ratio", setting("passes"), message).with_hint("Take more passes.")]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::document::FormerShape;
    use crate::spinning::Shell;

    #[test]
    fn fires_for_a_deep_shell_in_one_pass() {
        let deep = FormerShape::Parabola { constant: 273.8, tip_diameter: 40.0, length: 70.0 };
        let one = Shell { forming: Forming::Spinning, ..with_shape(deep) };
        assert_eq!(codes(check, &one), ["spinning-ratio"]);
        assert!(codes(check, &Shell { passes: 2, ..one.clone() }).is_empty());
        assert!(codes(check, &Shell { forming: Forming::Shear, ..one }).is_empty());
    }
}
