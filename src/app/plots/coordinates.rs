//! Between the part space of a set-up (mm, radius) and what a person reads (document's unit, diameter).

use crate::geometry::Point;
use crate::part::Setup;
use crate::units::Unit;

/// How positions of one set-up are written in the document.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coordinates {
    /// Unit of the document.
    pub unit: Unit,
    /// Length of the part, mm.
    pub length_mm: f64,
    /// True if the document's z runs from the free end.
    pub turned_round: bool,
}

impl Coordinates {
    /// Coordinates of `setup` in a document in `unit`.
    #[must_use]
    pub fn of(setup: &Setup, unit: Unit) -> Self {
        Self { unit, length_mm: setup.length, turned_round: setup.turned_round }
    }

    /// The document's z of a part-space z in mm.
    #[must_use]
    pub fn document_z(self, z_mm: f64) -> f64 {
        self.swap_ends(z_mm) / self.unit.in_mm()
    }

    /// The document's diameter at a part-space radius in mm; below the centre line it counts as above.
    #[must_use]
    pub fn diameter(self, r_mm: f64) -> f64 {
        2.0 * r_mm.abs() / self.unit.in_mm()
    }

    /// The part-space point at a z and diameter of the document.
    #[must_use]
    pub fn point(self, z: f64, diameter: f64) -> Point {
        Point::new(self.swap_ends(z * self.unit.in_mm()), diameter * self.unit.in_mm() / 2.0)
    }

    /// A length or position as text with the decimals of the unit, without the unit's name.
    #[must_use]
    pub fn text(self, value: f64) -> String {
        fixed(value, self.unit.decimals())
    }

    /// The readout of a pointer at `z` and `diameter`, both as the document writes them, with the unit.
    #[must_use]
    pub fn readout(self, z: f64, diameter: f64) -> String {
        format!("z {}  ⌀ {} {}", self.text(z), self.text(diameter), self.unit.symbol())
    }

    fn swap_ends(self, z_mm: f64) -> f64 {
        if self.turned_round { self.length_mm - z_mm } else { z_mm }
    }
}

/// `value` with `decimals` decimals; never `-0.000`.
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| matches!(b, b'0' | b'.')) => rest.to_owned(),
        _ => text,
    }
}

/// The smallest of …, 0.1, 0.2, 0.5, 1, 2, 5, 10, … that is at least `least`; 1 for anything but a positive number.
pub(super) fn round_step(least: f64) -> f64 {
    if !(least.is_finite() && least > 0.0) {
        return 1.0;
    }
    let decade = 10.0_f64.powf(least.log10().floor());
    // A hair of slack, so that a step is not skipped for the last bit of a logarithm.
    let fits = |factor: &f64| factor * decade >= least * (1.0 - 1e-9);
    decade * [1.0, 2.0, 5.0, 10.0].into_iter().find(fits).unwrap_or(10.0)
}

/// `value` moved to the nearest multiple of `step`; unchanged without a step.
pub(super) fn snapped(value: f64, step: Option<f64>) -> f64 {
    match step {
        // Dividing by the inverse keeps 0.1-steps at their nearest decimal: 17.3, not 17.300000000000001.
        Some(step) if step > 0.0 && step < 1.0 => (value / step).round() / (1.0 / step).round(),
        Some(step) if step >= 1.0 => (value / step).round() * step,
        _ => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn turned_round_positions_count_from_the_other_end() {
        let c = Coordinates { unit: Unit::Inch, length_mm: 50.8, turned_round: true };
        assert!((c.document_z(0.0) - 2.0).abs() < 1e-12);
        assert!((c.diameter(12.7) - 1.0).abs() < 1e-12);
        assert_eq!(c.point(2.0, 1.0), Point::new(0.0, 12.7));
    }

    #[test]
    fn texts_never_show_a_negative_zero() {
        assert_eq!(fixed(-0.0001, 3), "0.000");
        assert_eq!(fixed(-0.2, 1), "-0.2");
    }

    #[test]
    fn steps_are_one_two_five() {
        for (least, step) in [(0.03, 0.05), (0.1, 0.1), (1.2, 2.0), (5.0, 5.0), (7.0, 10.0)] {
            assert!((round_step(least) - step).abs() < 1e-12 * step, "{least}");
        }
        assert_eq!(round_step(f64::NAN), 1.0);
    }

    #[test]
    fn snapping_gives_clean_decimals() {
        assert_eq!(snapped(17.283, Some(0.1)), 17.3);
        assert_eq!(snapped(17.283, Some(0.05)), 17.3);
        assert_eq!(snapped(17.283, Some(0.5)), 17.5);
        assert_eq!(snapped(17.283, Some(5.0)), 15.0);
        assert_eq!(snapped(17.283, None), 17.283);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn document_and_part_positions_round_trip(z in -500.0..500.0_f64, r in 0.0..100.0_f64, turned_round: bool) {
            let c = Coordinates { unit: Unit::Inch, length_mm: 80.0, turned_round };
            let p = c.point(c.document_z(z), c.diameter(r));
            prop_assert!(p.distance(Point::new(z, r)) < 1e-9);
        }

        #[test]
        fn a_snapped_value_is_within_half_a_step(value in -300.0..300.0_f64, power in -3..3_i32) {
            let step = 2.0 * 10.0_f64.powi(power);
            prop_assert!((snapped(value, Some(step)) - value).abs() <= step * 0.500_001);
        }
    }
}
