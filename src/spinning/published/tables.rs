//! The tables of the published controller: tangents, form lengths and the parabola as ratios of integers.

use super::MM_PER_PULSE;

/// Tangents of the half angles from 30° to 45° as numerator and denominator.
const TANGENTS: [(u16, u16); 16] = [
    (26, 45),
    (3, 5),
    (78, 125),
    (37, 57),
    (56, 83),
    (7, 10),
    (53, 73),
    (49, 65),
    (25, 32),
    (17, 21),
    (47, 56),
    (73, 84),
    (9, 10),
    (69, 74),
    (28, 29),
    (1, 1),
];

/// Constant 4a of the published parabola `travel² = 4a · rise`, mm.
pub const PARABOLA_CONSTANT_MM: f64 = 273.8;

/// Points of the parabola table, 16 pulses apart.
pub const PARABOLA_POINTS: usize = 72;

/// Rise of the parabola in mm at every 16 pulses as numerator and denominator.
const PARABOLA: [(u16, u16); PARABOLA_POINTS] = [
    (131, 34747),
    (524, 34747),
    (651, 19186),
    (45, 746),
    (961, 10196),
    (704, 5187),
    (806, 4363),
    (90, 373),
    (528, 1729),
    (961, 2549),
    (937, 2054),
    (405, 746),
    (295, 463),
    (852, 1153),
    (123, 145),
    (360, 373),
    (961, 882),
    (193, 158),
    (377, 277),
    (656, 435),
    (685, 412),
    (177, 97),
    (355, 178),
    (810, 373),
    (205, 87),
    (813, 319),
    (863, 314),
    (869, 294),
    (929, 293),
    (492, 145),
    (471, 130),
    (637, 165),
    (583, 142),
    (292, 67),
    (956, 207),
    (386, 79),
    (160, 31),
    (969, 178),
    (367, 64),
    (187, 31),
    (995, 157),
    (685, 103),
    (718, 103),
    (708, 97),
    (710, 93),
    (710, 89),
    (533, 64),
    (443, 51),
    (869, 96),
    (820, 87),
    (961, 98),
    (367, 36),
    (646, 61),
    (1000, 91),
    (479, 42),
    (934, 79),
    (49, 4),
    (799, 63),
    (958, 73),
    (95, 7),
    (491, 35),
    (942, 65),
    (823, 55),
    (803, 52),
    (223, 14),
    (739, 45),
    (897, 53),
    (523, 30),
    (359, 20),
    (351, 19),
    (19, 1),
    (899, 46),
];

/// Form lengths, mm, whose pulses the published table gives rounded down instead of to the nearest.
const ROUNDED_DOWN_MM: [u32; 5] = [33, 37, 41, 45, 49];

/// Tangent of a half angle in degrees as numerator and denominator; `None` outside 30° to 45°.
#[must_use]
pub fn tangent_ratio(angle_deg: u32) -> Option<(u16, u16)> {
    TANGENTS.get(usize::try_from(angle_deg.checked_sub(30)?).ok()?).copied()
}

/// Rise of the parabola at point `k`, from 1, as numerator and denominator of mm; `None` outside the table.
#[must_use]
pub fn parabola_ratio(k: usize) -> Option<(u16, u16)> {
    PARABOLA.get(k.checked_sub(1)?).copied()
}

/// A form length in encoder pulses as in the published table.
#[must_use]
pub fn form_length_pulses(form_length_mm: u32) -> u32 {
    let exact = f64::from(form_length_mm) / MM_PER_PULSE;
    let pulses = if ROUNDED_DOWN_MM.contains(&form_length_mm) { exact.floor() } else { exact.round() };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number that is not negative")]
    {
        pulses as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_near_what_they_stand_for() {
        for angle in 30..=45 {
            let (num, den) = tangent_ratio(angle).unwrap();
            let exact = f64::from(angle).to_radians().tan();
            assert!((f64::from(num) / f64::from(den) - exact).abs() < 0.001, "{angle}");
        }
        assert_eq!((tangent_ratio(29), tangent_ratio(46)), (None, None));
        for k in 1..=PARABOLA_POINTS {
            let (num, den) = parabola_ratio(k).unwrap();
            let travel = k as f64 * 16.0 * MM_PER_PULSE;
            let error = f64::from(num) / f64::from(den) - travel * travel / PARABOLA_CONSTANT_MM;
            assert!(error.abs() < 0.0052, "{k}: {error}");
        }
        assert_eq!((parabola_ratio(0), parabola_ratio(73)), (None, None));
    }
}
