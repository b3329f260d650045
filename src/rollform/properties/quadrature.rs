//! Integrals along lines and arcs: Gauss-Legendre points, exact for the cubes of lines and to rounding for arcs of at most
//! a quarter turn, into which longer ones are divided.

use crate::geometry::{Point, Segment, Vector};
use std::f64::consts::FRAC_PI_2;

/// Places and weights on (-1, 1), positive half; eight points integrate polynomials up to degree 15.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_3),
];

/// A place on a segment with its share of the length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// The place.
    pub(super) point: Point,
    /// Unit normal to the left of the direction.
    pub(super) normal: Vector,
    /// Length from the start of the segment, mm.
    pub(super) along: f64,
    /// Its share of the length, mm.
    pub(super) ds: f64,
}

/// The places of a segment.
pub(super) fn samples(segment: &Segment) -> impl Iterator<Item = Sample> + use<> {
    let segment = *segment;
    let length = segment.length();
    let pieces = (segment.sweep().abs() / FRAC_PI_2).ceil().max(1.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a full turn has four quarters")]
    let starts = (0..pieces as u32).map(move |k| f64::from(k) / pieces);
    let places = starts.flat_map(move |from| {
        let on_both_sides = GAUSS.iter().flat_map(|&(x, w)| [(-x, w), (x, w)]);
        on_both_sides.map(move |(x, w)| (from + f64::midpoint(1.0, x) / pieces, w / 2.0 / pieces))
    });
    places.map(move |(t, share)| {
        let direction = segment.direction_at(t);
        Sample {
            point: segment.point_at(t),
            normal: Vector::new(-direction.y, direction.x),
            along: t * length,
            ds: share * length,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_and_moments_of_an_arc_are_those_of_the_formulas() {
        let at = |angle: f64| Point::new(2.0 * angle.cos(), 2.0 * angle.sin());
        let arc = Segment::Arc { start: at(0.0), end: at(3.0), center: Point::default(), ccw: true };
        let sum = |f: fn(&Sample) -> f64| samples(&arc).map(|s| f(&s) * s.ds).sum::<f64>();
        assert!((sum(|_| 1.0) - 6.0).abs() < 1e-12);
        assert!((sum(|s| s.point.r) - 4.0 * (1.0 - 3.0_f64.cos())).abs() < 1e-12);
        assert!((sum(|s| s.point.z * s.point.z) - 8.0 * (1.5 + 6.0_f64.sin() / 4.0)).abs() < 1e-12);
    }
}
