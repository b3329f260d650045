//! Speed of the roller by the code of the proportional valve, from the published calibration.
//!
//! Source: Mohamad 1988, Fig. 4.13: times over 148 mm, speeds computed anew from them. Which voltage the slowest outward
//! speed belongs to is inferred.

/// Code at which the roller stands.
pub const STOP: u8 = 128;
/// Code with which the published listing advances at a cone.
pub const ADVANCE_AS_LISTED: u8 = 185;
/// Code with which the published text says its second version advances: slower, so that it overshoots less.
pub const ADVANCE: u8 = 177;
/// Code with which the published controller retracts.
pub const RETRACT: u8 = 73;
/// Codes for one volt.
const CODES_PER_VOLT: f64 = 19.6;

/// Volts and speed towards the axis, mm/s.
const INWARD: [(f64, f64); 9] = [
    (2.2, 0.0),
    (2.4, 12.60),
    (2.6, 28.24),
    (2.8, 45.26),
    (3.0, 57.59),
    (3.2, 72.20),
    (3.4, 76.68),
    (3.6, 80.00),
    (4.0, 79.14),
];

/// Volts and speed away from the axis, mm/s.
const OUTWARD: [(f64, f64); 6] = [(2.4, 0.0), (2.6, 27.06), (2.8, 46.23), (3.0, 60.9), (3.2, 67.3), (3.4, 66.97)];

/// Speed of the roller at a code, mm/s, positive towards the axis; 0 within the dead band.
#[must_use]
pub fn speed_mm_per_s(code: u8) -> f64 {
    let volts = (f64::from(code) - f64::from(STOP)) / CODES_PER_VOLT;
    if volts >= 0.0 { by_table(&INWARD, volts) } else { -by_table(&OUTWARD, -volts) }
}

/// Between two rows in proportion; outside, the nearest row.
fn by_table(rows: &[(f64, f64)], volts: f64) -> f64 {
    let next = rows.iter().position(|(v, _)| *v >= volts).unwrap_or(rows.len());
    let before = next.checked_sub(1).and_then(|i| rows.get(i));
    match (before, rows.get(next)) {
        (Some((v1, s1)), Some((v2, s2))) => s1 + (s2 - s1) * (volts - v1) / (v2 - v1),
        (None, Some((_, speed))) | (Some((_, speed)), None) => *speed,
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_codes_give_the_published_speeds() {
        assert_eq!(speed_mm_per_s(STOP), 0.0);
        // −2.8 V and +2.9 V.
        assert!((speed_mm_per_s(RETRACT) + 46.6).abs() < 0.5, "{}", speed_mm_per_s(RETRACT));
        let listed = speed_mm_per_s(ADVANCE_AS_LISTED);
        assert!((listed - 52.0).abs() < 0.5, "{listed}");
        assert!((speed_mm_per_s(ADVANCE) - 20.4).abs() < 0.5, "{}", speed_mm_per_s(ADVANCE));
        assert!((speed_mm_per_s(255) - 79.14).abs() < 1e-9 && (speed_mm_per_s(0) + 66.97).abs() < 1e-9);
    }

    #[test]
    fn nothing_moves_within_the_dead_band_and_nothing_crawls() {
        for code in 85..=171 {
            assert_eq!(speed_mm_per_s(code), 0.0, "{code}");
        }
        assert!((0..=255).all(|code| speed_mm_per_s(code).is_finite()));
        assert!(speed_mm_per_s(175) > 12.0 && speed_mm_per_s(77) < -27.0);
    }
}
