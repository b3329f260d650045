//! Exact interpolation: for any contour the roller's place at every increment of the carriage, to the micrometre.

use super::published::{LARGEST_STEP, MM_PER_PULSE, MM_PER_STEP};
use crate::geometry::{Contour, Segment};

/// More points than any table for a small controller holds; keeps a wrong length from filling the memory.
const MOST_POINTS: u32 = 100_000;

/// A place that the roller must have reached when the carriage has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SetPoint {
    /// Carriage travel from the start of the contour, encoder pulses.
    pub pulses: u32,
    /// Distance of the roller away from its start, µm; absolute, never a sum of increments.
    pub retreat_um: i64,
    /// The same in steps of the transducer, 1/8 mm.
    pub steps: i32,
}

/// Set points along a contour of the roller's centre, which runs from tip to base: one at the start, one every `increment`
/// pulses, and one at the last pulse within the contour. Without segments there is none.
#[must_use]
pub fn set_points(centre: &Contour, increment: u32) -> Vec<SetPoint> {
    let (Some(start), Some(end)) = (centre.segments.first().map(Segment::start), centre.segments.last()) else {
        return Vec::new();
    };
    let length = start.z - end.end().z;
    let last = to_count(length / MM_PER_PULSE);
    let increment = increment.max(1);
    let mut points: Vec<SetPoint> = Vec::new();
    let mut from = 0;
    let mut at = 0_u32;
    while at <= last && at / increment <= MOST_POINTS {
        points.push(point(centre, start, at, &mut from));
        if at == last {
            break;
        }
        at = at.saturating_add(increment).min(last);
    }
    points
}

fn point(centre: &Contour, start: crate::geometry::Point, pulses: u32, from: &mut usize) -> SetPoint {
    let z = start.z - f64::from(pulses) * MM_PER_PULSE;
    let retreat = radius_at(centre, z, from) - start.r;
    SetPoint { pulses, retreat_um: to_whole(retreat * 1000.0), steps: steps_of(retreat) }
}

/// Radius of the path at `z`; `from` is the segment that the search begins with, for z falls from call to call.
fn radius_at(centre: &Contour, z: f64, from: &mut usize) -> f64 {
    while centre.segments.get(*from).is_some_and(|s| s.end().z > z) && *from + 1 < centre.segments.len() {
        *from += 1;
    }
    let Some(segment) = centre.segments.get(*from) else { return 0.0 };
    crate::part::Curve::Segment(segment.reversed()).radius_at(z)
}

/// A distance in steps of the transducer, to the nearest.
#[must_use]
pub fn steps_of(mm: f64) -> i32 {
    let steps = (mm / MM_PER_STEP).round().clamp(-f64::from(LARGEST_STEP), f64::from(LARGEST_STEP));
    #[allow(clippy::cast_possible_truncation, reason = "clamped to the transducer's range")]
    {
        steps as i32
    }
}

/// Whole pulses within a length; 0 for what is none.
fn to_count(pulses: f64) -> u32 {
    /// Rounding of a length that is a whole number of pulses.
    const ROUNDING: f64 = 1e-9;
    let whole = (pulses + ROUNDING).floor().clamp(0.0, 1e8);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=1e8")]
    if whole.is_finite() { whole as u32 } else { 0 }
}

fn to_whole(um: f64) -> i64 {
    let whole = um.round().clamp(-1e9, 1e9);
    #[allow(clippy::cast_possible_truncation, reason = "clamped to ±1e9")]
    if whole.is_finite() { whole as i64 } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::spinning::{FormerShape, Shell, path, shape};

    fn cone_path(angle: f64, length: f64) -> Contour {
        let end = Point::new(0.0, 20.0 + length * angle.to_radians().tan());
        Contour::new(vec![Segment::line(Point::new(length, 20.0), end)])
    }

    #[test]
    fn one_pulse_at_a_time_is_right_to_the_micrometre() {
        for angle in [12.0, 30.0, 33.3, 45.0] {
            let points = set_points(&cone_path(angle, 50.0), 1);
            assert_eq!(points.len(), 788);
            for p in &points {
                let exact = f64::from(p.pulses) * 63.5 * angle.to_radians().tan();
                assert!((p.retreat_um as f64 - exact).abs() <= 0.5 + 1e-6, "{angle} {p:?}");
            }
        }
    }

    #[test]
    fn rounding_does_not_add_up() {
        let fine = set_points(&cone_path(31.7, 60.0), 1);
        let coarse = set_points(&cone_path(31.7, 60.0), 16);
        for p in &coarse {
            assert!(fine.contains(p), "{p:?}");
        }
        assert_eq!(fine.last(), coarse.last());
    }

    #[test]
    fn curves_with_roller_and_wall_are_followed() {
        let mut shell = Shell { forming: crate::spinning::Forming::Spinning, ..Shell::default() };
        shell.former.shape = FormerShape::Parabola { constant: 273.8, tip_diameter: 40.0, length: 70.0 };
        let shape = shape(&shell).unwrap();
        let path = path::path(&shell, &shape);
        let centre = &path.last().unwrap().contour;
        let start = centre.segments[0].start();
        for p in set_points(centre, 4) {
            let at = Point::new(start.z - f64::from(p.pulses) * MM_PER_PULSE, start.r + p.retreat_um as f64 / 1000.0);
            assert!((shape.former.distance_to(at) - 10.6).abs() < 0.0015, "{p:?}");
        }
    }

    #[test]
    fn nothing_comes_of_nothing() {
        assert!(set_points(&Contour::default(), 1).is_empty());
    }
}
