//! A line or an arc between two points.

use super::{Bounds, Point, Vector};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A line or a circular arc, exact, in part space.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Segment {
    /// A straight line.
    Line {
        /// First point.
        start: Point,
        /// Last point.
        end: Point,
    },
    /// A circular arc of less than a full turn.
    Arc {
        /// First point.
        start: Point,
        /// Last point.
        end: Point,
        /// Centre of the circle.
        center: Point,
        /// Counter-clockwise from start to end.
        ccw: bool,
    },
}

impl Segment {
    /// A line from `start` to `end`.
    #[must_use]
    pub const fn line(start: Point, end: Point) -> Self {
        Self::Line { start, end }
    }

    /// First point.
    #[must_use]
    pub const fn start(&self) -> Point {
        match *self {
            Self::Line { start, .. } | Self::Arc { start, .. } => start,
        }
    }

    /// Last point.
    #[must_use]
    pub const fn end(&self) -> Point {
        match *self {
            Self::Line { end, .. } | Self::Arc { end, .. } => end,
        }
    }

    /// Radius of an arc, mm; `None` for a line.
    #[must_use]
    pub fn radius(&self) -> Option<f64> {
        match *self {
            Self::Line { .. } => None,
            Self::Arc { start, center, .. } => Some(start.distance(center)),
        }
    }

    /// Angle swept by an arc, radians, positive counter-clockwise; 0 for a line.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        match *self {
            Self::Line { .. } => 0.0,
            Self::Arc { start, end, center, ccw } => {
                let turn = angle_of(end - center) - angle_of(start - center);
                if ccw { turn.rem_euclid(TAU) } else { -(-turn).rem_euclid(TAU) }
            }
        }
    }

    /// Length along the segment, mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        match *self {
            Self::Line { start, end } => start.distance(end),
            Self::Arc { start, center, .. } => start.distance(center) * self.sweep().abs(),
        }
    }

    /// The point at `t` of the length, `t` from 0 to 1. The ends are returned exactly.
    #[must_use]
    pub fn point_at(&self, t: f64) -> Point {
        if t <= 0.0 {
            return self.start();
        }
        if t >= 1.0 {
            return self.end();
        }
        match *self {
            Self::Line { start, end } => start + (end - start) * t,
            Self::Arc { start, center, .. } => {
                let angle = angle_of(start - center) + self.sweep() * t;
                on_circle(center, start.distance(center), angle)
            }
        }
    }

    /// Direction of travel at `t`, unit length. A line without length points nowhere and returns zero.
    #[must_use]
    pub fn direction_at(&self, t: f64) -> Vector {
        match *self {
            Self::Line { start, end } => (end - start).try_normalize(0.0).unwrap_or_default(),
            Self::Arc { start, center, ccw, .. } => {
                let angle = angle_of(start - center) + self.sweep() * t.clamp(0.0, 1.0);
                let forward = Vector::new(-angle.sin(), angle.cos());
                if ccw { forward } else { -forward }
            }
        }
    }

    /// The same segment from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match *self {
            Self::Line { start, end } => Self::Line { start: end, end: start },
            Self::Arc { start, end, center, ccw } => Self::Arc { start: end, end: start, center, ccw: !ccw },
        }
    }

    /// The segment moved by `v`.
    #[must_use]
    pub fn translated(&self, v: Vector) -> Self {
        self.mapped(|p| p + v, false)
    }

    /// The segment mirrored at the plane across the spindle at `z`.
    #[must_use]
    pub fn mirrored_at_z(&self, z: f64) -> Self {
        self.mapped(|p| p.mirrored_at_z(z), true)
    }

    /// True if the direction from the centre of an arc to `p` lies within its sweep, ends included. True for a line.
    pub(super) fn faces(&self, p: Point) -> bool {
        let Self::Arc { start, center, ccw, .. } = *self else { return true };
        let turn = angle_of(p - center) - angle_of(start - center);
        (if ccw { turn } else { -turn }).rem_euclid(TAU) <= self.sweep().abs()
    }

    fn mapped(&self, map: impl Fn(Point) -> Point, turns_over: bool) -> Self {
        match *self {
            Self::Line { start, end } => Self::Line { start: map(start), end: map(end) },
            Self::Arc { start, end, center, ccw } => {
                Self::Arc { start: map(start), end: map(end), center: map(center), ccw: ccw != turns_over }
            }
        }
    }

    /// The smallest rectangle around the segment.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let ends = Bounds { min: self.start(), max: self.start() }.including(self.end());
        let Self::Arc { start, center, ccw, .. } = *self else { return ends };
        let radius = start.distance(center);
        let sweep = self.sweep().abs();
        let from = angle_of(start - center);
        (0..4)
            .map(|quarter| f64::from(quarter) * FRAC_PI_2)
            .filter(|&angle| (if ccw { angle - from } else { from - angle }).rem_euclid(TAU) < sweep)
            .fold(ends, |bounds, angle| bounds.including(on_circle(center, radius, angle)))
    }

    /// An arc in parts that end where it passes beside, above or below its centre, so that its chords reach as far out as it
    /// does itself; a line as it is.
    #[must_use]
    pub fn quarters(&self) -> Vec<Self> {
        let Self::Arc { start, end, center, ccw } = *self else { return vec![*self] };
        let (radius, from, sweep) = (start.distance(center), angle_of(start - center), self.sweep());
        let share = |quarter: i32| (f64::from(quarter) * FRAC_PI_2 - from) / sweep;
        let mut inside: Vec<i32> = (-6..=6).filter(|&k| share(k) > 0.0 && share(k) < 1.0).collect();
        inside.sort_by(|a, b| share(*a).total_cmp(&share(*b)));
        let sides = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        let at = |quarter: &i32| {
            let (z, r) =
                sides.into_iter().cycle().nth(quarter.rem_euclid(4).unsigned_abs() as usize).unwrap_or_default();
            Point::new(center.z + radius * z, center.r + radius * r)
        };
        let ends: Vec<Point> = std::iter::once(start).chain(inside.iter().map(at)).chain([end]).collect();
        ends.windows(2).map(|w| Self::Arc { start: w[0], end: w[1], center, ccw }).collect()
    }

    /// Points along the segment without its start, no chord further than `tolerance` mm from the arc.
    #[must_use]
    pub fn polyline_points(&self, tolerance: f64) -> Vec<Point> {
        let Some(radius) = self.radius() else { return vec![self.end()] };
        let count = chord_count(radius, self.sweep().abs(), tolerance);
        (1..=count).map(|k| self.point_at(f64::from(k) / f64::from(count))).collect()
    }
}

/// Angle of `v` from the z direction, radians, counter-clockwise.
fn angle_of(v: Vector) -> f64 {
    v.y.atan2(v.x)
}

fn on_circle(center: Point, radius: f64, angle: f64) -> Point {
    Point::new(center.z + radius * angle.cos(), center.r + radius * angle.sin())
}

/// Chords needed so that none is further than `tolerance` from its arc (sagitta r(1 - cos(a/2))); at least one.
fn chord_count(radius: f64, sweep: f64, tolerance: f64) -> u32 {
    /// More chords than any arc on a lathe needs; keeps a wrong tolerance from filling the memory.
    const MOST: f64 = 100_000.0;
    let step = 2.0 * (1.0 - tolerance / radius).clamp(-1.0, 1.0).acos();
    let count = (sweep / step).ceil();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST")]
    if count.is_finite() { count.clamp(1.0, MOST) as u32 } else { MOST as u32 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quarter() -> Segment {
        Segment::Arc { start: Point::new(2.0, 0.0), end: Point::new(0.0, 2.0), center: Point::default(), ccw: true }
    }

    #[test]
    fn quarter_arc_has_its_length_and_middle() {
        let arc = quarter();
        assert!((arc.length() - std::f64::consts::PI).abs() < 1e-12);
        assert!(arc.point_at(0.5).distance(Point::new(2.0_f64.sqrt(), 2.0_f64.sqrt())) < 1e-12);
    }

    #[test]
    fn reversing_and_mirroring_keep_length_and_bounds() {
        let arc = quarter();
        assert!((arc.reversed().length() - arc.length()).abs() < 1e-12);
        assert_eq!(arc.reversed().bounds(), arc.bounds());
        assert!((arc.mirrored_at_z(3.0).length() - arc.length()).abs() < 1e-12);
    }

    #[test]
    fn clockwise_long_way_round_reaches_the_far_side() {
        let Segment::Arc { start, end, center, .. } = quarter() else { unreachable!() };
        let long = Segment::Arc { start, end, center, ccw: false };
        assert!((long.bounds().min.z + 2.0).abs() < 1e-12);
        assert!((long.sweep() + 1.5 * std::f64::consts::PI).abs() < 1e-12);
    }

    #[test]
    fn chords_stay_within_tolerance() {
        let points = quarter().polyline_points(0.001);
        let mut last = quarter().start();
        for p in points {
            let middle = Point::new(f64::midpoint(last.z, p.z), f64::midpoint(last.r, p.r));
            assert!(2.0 - middle.distance(Point::default()) <= 0.001 + 1e-12);
            last = p;
        }
    }
}
