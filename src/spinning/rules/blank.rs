//! No metal is lost or won: a blank of less volume than the shell gives a shorter one.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;

/// Blanks with too little metal, or much too much.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    /// Share of the radius by which a blank may be larger and still be trimmed without a word.
    const TRIMMED: f64 = 0.15;
    /// Rounding, mm.
    const ROUNDING_MM: f64 = 1e-6;
    if let Some(given) = checked.shell.blank.diameter.filter(|d| !d.is_nan() && *d <= 0.0) {
        let message = format!("The blank is {} in diameter; it must be more than 0.", checked.length(given));
        return vec![
            Diagnostic::error("blank-diameter", setting("blank.diameter"), message)
                .with_hint("Leave the diameter to the program to have it by constant volume."),
        ];
    }
    let Some(shape) = checked.shape else { return Vec::new() };
    let (own, needed) = (shape.blank_radius, shape.volume_radius);
    let figures = format!(
        "The blank is {} in diameter; the shell has the volume of one of {}",
        checked.length(2.0 * own),
        checked.length(2.0 * needed)
    );
    let place = setting("blank.diameter");
    if own < needed - ROUNDING_MM {
        return vec![
            Diagnostic::warning("blank-small", place, format!("{figures}, so the shell comes out shorter."))
                .with_hint("Leave the diameter to the program, or give at least the second figure."),
        ];
    }
    if own > needed * (1.0 + TRIMMED) {
        return vec![Diagnostic::warning("blank-large", place, format!("{figures}; a flange is left."))];
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::spinning::Shell;

    fn with_blank(diameter: f64) -> Shell {
        let mut shell = cone(30.0);
        shell.blank.diameter = Some(diameter);
        shell
    }

    #[test]
    fn fires_for_too_little_and_too_much_metal() {
        assert_eq!(codes(check, &with_blank(70.0)), ["blank-small"]);
        assert_eq!(codes(check, &with_blank(120.0)), ["blank-large"]);
        assert_eq!(codes(check, &with_blank(0.0)), ["blank-diameter"]);
        assert_eq!(codes(check, &with_blank(-70.0)), ["blank-diameter"]);
        assert!(codes(check, &with_blank(78.0)).is_empty() && codes(check, &cone(30.0)).is_empty());
    }
}
