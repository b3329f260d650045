//! Best results come at 1000 to 2000 ft/min, 305 to 610 m/min (Mohamad 1988, section 1.6).

use super::{Checked, setting};
use crate::diagnostic::{Diagnostic, Severity};

/// The recommended range, m/min: 1000 and 2000 ft/min.
const RANGE_M_PER_MIN: [f64; 2] = [304.8, 609.6];

/// Surface speeds that are none, or outside the range.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let speeds = &checked.shell.speeds;
    let none = [
        ("speeds.surface_m_per_min", "surface speed", speeds.surface_m_per_min, "m/min"),
        ("speeds.max_rpm", "highest spindle speed", speeds.max_rpm, "rev/min"),
    ]
    .into_iter()
    .filter(|(_, _, value, _)| value.is_nan() || *value <= 0.0)
    .map(|(path, name, value, unit)| {
        let message = format!("The {name} is {value} {unit}; it must be more than 0.");
        Diagnostic::error("shell-speed", setting(path), message)
    })
    .collect::<Vec<_>>();
    if !none.is_empty() {
        return none;
    }
    let Some(shape) = checked.shape else { return Vec::new() };
    // The clamp may keep the speed below what is asked for: what counts is reached at the base.
    let reached = speeds.surface_m_per_min.min(std::f64::consts::TAU * shape.base().r / 1000.0 * speeds.max_rpm);
    let [least, most] = RANGE_M_PER_MIN;
    if (least..=most).contains(&reached) {
        return Vec::new();
    }
    let message = format!(
        "The surface speed at the base is {reached:.0} m/min; best results come between {least:.0} and {most:.0} m/min."
    );
    vec![Diagnostic::new(Severity::Info, "surface-speed", setting("speeds.surface_m_per_min"), message)]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_outside_the_range_and_for_none() {
        let mut shell = cone(30.0);
        assert!(codes(check, &shell).is_empty());
        shell.speeds.surface_m_per_min = 700.0;
        shell.speeds.max_rpm = 5000.0;
        assert_eq!(codes(check, &shell), ["surface-speed"]);
        shell.speeds.max_rpm = 200.0;
        assert_eq!(codes(check, &shell), ["surface-speed"]);
        shell.speeds.max_rpm = 0.0;
        assert_eq!(codes(check, &shell), ["shell-speed"]);
        shell.speeds.surface_m_per_min = f64::NAN;
        assert_eq!(codes(check, &shell), ["shell-speed", "shell-speed"]);
    }
}
