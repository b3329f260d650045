//! A contour that grows narrower towards its base keeps the shell on the former.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;

/// Walls that turn back towards the axis.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    /// Less than this is rounding, radians.
    const ROUNDING: f64 = 1e-9;
    let Some(shape) = checked.shape else { return Vec::new() };
    let worst = shape.stations.iter().min_by(|a, b| a.half_angle.total_cmp(&b.half_angle));
    let Some(worst) = worst.filter(|s| s.half_angle < -ROUNDING) else { return Vec::new() };
    let message = format!(
        "The former grows narrower towards its base at {} from the tip, by {:.1}°; the limit is 0°, or the shell cannot be \
         taken off.",
        checked.length(shape.tip().z - worst.at.z),
        -worst.half_angle.to_degrees()
    );
    vec![Diagnostic::error("former-turns-back", setting("former.shape"), message)]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::document::FormerShape;
    use crate::part::Section;

    #[test]
    fn fires_where_the_shell_would_stay_on() {
        let rows = vec![Section::line(1, 0.0, 60.0, 20.0, 80.0), Section::line(2, 20.0, 80.0, 40.0, 30.0)];
        assert_eq!(codes(check, &with_shape(FormerShape::Sections { sections: rows })), ["former-turns-back"]);
        assert!(codes(check, &cone(30.0)).is_empty());
    }
}
