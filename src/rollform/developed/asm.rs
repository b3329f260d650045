//! The rule of the American Society for Metals as printed in Wong 1983 (eqs. 2.3 to 2.6).

/// How well the metal can be formed; it matters for bends without a radius.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Metal {
    Normal,
    LessFormable,
}

/// Distance of the neutral line from the inside as a part of the thickness: a third below a radius of one thickness
/// (a half for less formable metal without a radius), a half from two thicknesses on. The rule is silent between one and
/// two thicknesses; the share grows evenly there, so that a radius that is dragged makes no jump.
pub(super) fn factor(radius: f64, thickness: f64, metal: Metal) -> f64 {
    if radius == 0.0 && metal == Metal::LessFormable {
        return 0.5;
    }
    let thicknesses = (radius / thickness).clamp(1.0, 2.0);
    1.0 / 3.0 + (thicknesses - 1.0) / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_third_at_sharp_bends_and_a_half_at_wide_ones() {
        let normal = |radius| factor(radius, 2.0, Metal::Normal);
        for (radius, share) in [(0.0, 1.0 / 3.0), (1.9, 1.0 / 3.0), (4.0, 0.5), (9.0, 0.5), (3.0, 5.0 / 12.0)] {
            assert!((normal(radius) - share).abs() < 1e-12, "{radius}");
        }
        assert_eq!(factor(0.0, 2.0, Metal::LessFormable), 0.5);
        assert_eq!(factor(1.0, 2.0, Metal::LessFormable), normal(1.0));
    }
}
