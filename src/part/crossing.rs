//! Positions where two curves of a part cross.

use super::Curve;
use super::shape::SAME_PLACE_MM;
use crate::geometry::Segment;

/// A range is divided no further than this many times; two crossings within 1/4096 of an overlap go unseen, which
/// changes the outside by less than the curves differ between them.
const DEEPEST: u32 = 12;

/// A difference of radii below this has no sign, mm: curves that coincide differ by rounding only.
const NO_DIFFERENCE_MM: f64 = 1e-9;

/// Positions inside the common range of both curves where their radii cross, mm, in order.
///
/// Both curves are single-valued in z. The range is divided until the bounds of both curves exclude a crossing or
/// the range is small; every change of sign is then bisected down to the last bit.
pub(super) fn crossings(a: &Curve, b: &Curve) -> Vec<f64> {
    let from = a.start().z.max(b.start().z);
    let to = a.end().z.min(b.end().z);
    // Between the turning points both curves are monotone, so that their ends bound them.
    let mut stops = vec![from, to];
    stops.extend([a, b].iter().filter_map(|c| c.turning_point_z()).filter(|&z| from < z && z < to));
    stops.sort_by(f64::total_cmp);
    // A row that was pasted twice would be divided all the way; two straight lines differ by a straight line.
    let depth = match (a, b) {
        _ if a == b => return Vec::new(),
        (Curve::Segment(Segment::Line { .. }), Curve::Segment(Segment::Line { .. })) => 0,
        _ => DEEPEST,
    };
    let mut samples = Vec::new();
    for (&z1, &z2) in stops.iter().zip(stops.iter().skip(1)) {
        sample(a, b, z1, z2, depth, &mut samples);
    }
    let difference = |z: f64| a.radius_at(z) - b.radius_at(z);
    samples.retain(|&z| difference(z).abs() > NO_DIFFERENCE_MM);
    let pairs = samples.iter().zip(samples.iter().skip(1));
    pairs
        .filter(|&(&low, &high)| (difference(low) < 0.0) != (difference(high) < 0.0))
        .map(|(&low, &high)| bisect(difference, low, high))
        .collect()
}

/// Adds positions between `z1` and `z2`, where both curves are monotone, that lie on both sides of every crossing.
fn sample(a: &Curve, b: &Curve, z1: f64, z2: f64, depth: u32, samples: &mut Vec<f64>) {
    let (a1, a2, b1, b2) = (a.radius_at(z1), a.radius_at(z2), b.radius_at(z1), b.radius_at(z2));
    let apart = a1.min(a2) > b1.max(b2) || b1.min(b2) > a1.max(a2);
    if apart || depth == 0 || z2 - z1 <= SAME_PLACE_MM {
        samples.extend([z1, z2]);
        return;
    }
    let middle = f64::midpoint(z1, z2);
    sample(a, b, z1, middle, depth - 1, samples);
    sample(a, b, middle, z2, depth - 1, samples);
}

/// A position between `low` and `high`, at which `difference` has opposite signs, where it changes its sign.
fn bisect(difference: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let below = difference(low) < 0.0;
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            return middle;
        }
        if (difference(middle) < 0.0) == below {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::part::{Parabola, ParabolaAxis};

    fn cylinder(r: f64) -> Curve {
        Curve::line(Point::new(0.0, r), Point::new(10.0, r))
    }

    #[test]
    fn a_cylinder_crosses_an_arc_twice() {
        let arc = Curve::Segment(Segment::Arc {
            start: Point::new(1.0, 3.0),
            end: Point::new(9.0, 3.0),
            center: Point::new(5.0, 0.0),
            ccw: false,
        });
        let found = crossings(&arc, &cylinder(4.0));
        assert_eq!(found.len(), 2);
        assert!((found[0] - 2.0).abs() < 1e-12 && (found[1] - 8.0).abs() < 1e-12);
        assert!(crossings(&arc, &cylinder(5.1)).is_empty());
    }

    #[test]
    fn a_parabola_crosses_a_line_where_both_equations_say() {
        let (start, end) = (Point::new(0.0, 0.0), Point::new(10.0, 10.0));
        let parabola = Curve::Parabola(Parabola::through(start, end, ParabolaAxis::AlongX, 0.1, 10));
        let found = crossings(&parabola, &cylinder(2.5));
        assert_eq!(found.len(), 1);
        assert!((found[0] - 5.0).abs() < 1e-12);
    }

    #[test]
    fn two_tapers_cross_once_at_most() {
        let taper = |r1, r2| Curve::line(Point::new(0.0, r1), Point::new(10.0, r2));
        let found = crossings(&taper(1.0, 5.0), &taper(4.0, 3.0));
        assert_eq!(found.len(), 1);
        assert!((found[0] - 6.0).abs() < 1e-12, "{found:?}");
        assert!(crossings(&taper(1.0, 2.0), &taper(2.5, 3.0)).is_empty());
    }

    #[test]
    fn coinciding_curves_do_not_cross() {
        assert!(crossings(&cylinder(3.0), &cylinder(3.0)).is_empty());
    }
}
