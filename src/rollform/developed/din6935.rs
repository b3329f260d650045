//! DIN 6935: the neutral line by the ratio of radius and thickness, and the difference for legs measured outside.

use std::f64::consts::PI;

/// Factor of half the thickness: k = 0.65 + 0.5·lg(r/s), from 0 to 1.
pub(super) fn factor(radius: f64, thickness: f64) -> f64 {
    let factor = 0.65 + 0.5 * (radius / thickness).log10();
    if factor.is_nan() { 0.0 } else { factor.clamp(0.0, 1.0) }
}

/// What is added to two legs measured outside to give the flat length, mm (usually negative). `opening_deg` is the angle
/// between the legs, 180° minus the bend angle; from 165° on the difference is left out.
#[must_use]
pub fn length_difference_mm(opening_deg: f64, radius: f64, thickness: f64) -> f64 {
    let bend = PI - opening_deg.to_radians();
    let arc = bend * (radius + factor(radius, thickness) * thickness / 2.0);
    let outside = radius + thickness;
    match opening_deg {
        o if o <= 90.0 => arc - 2.0 * outside,
        o if o <= 165.0 => arc - 2.0 * outside * (bend / 2.0).tan(),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(value: f64, wanted: f64) {
        assert!((value - wanted).abs() < 0.0005, "{value} is not {wanted}");
    }

    #[test]
    fn radius_4_in_2_mm() {
        assert!((factor(4.0, 2.0) - 0.8005).abs() < 0.00005);
        assert!((PI / 2.0 * (4.0 + factor(4.0, 2.0)) - 7.5406).abs() < 0.00005);
        for (opening, difference) in [(60.0, -1.946), (90.0, -4.459), (120.0, -1.901), (165.0, -0.323), (166.0, 0.0)] {
            near(length_difference_mm(opening, 4.0, 2.0), difference);
        }
    }

    #[test]
    fn factor_stays_between_0_and_1() {
        assert_eq!(factor(0.0, 2.0), 0.0);
        assert_eq!(factor(0.05, 2.0), 0.0);
        assert_eq!(factor(20.0, 2.0), 1.0);
    }
}
