//! Curves of a profile: queries, cutting and turning round. Every curve is single-valued in z or a vertical line.

use super::{Curve, Parabola, ParabolaAxis};
use crate::geometry::{Bounds, Point, Segment};

impl Curve {
    /// A straight line from `start` to `end`.
    #[must_use]
    pub const fn line(start: Point, end: Point) -> Self {
        Self::Segment(Segment::line(start, end))
    }

    /// First point.
    #[must_use]
    pub const fn start(&self) -> Point {
        match self {
            Self::Segment(segment) => segment.start(),
            Self::Parabola(parabola) => parabola.start,
        }
    }

    /// Last point.
    #[must_use]
    pub const fn end(&self) -> Point {
        match self {
            Self::Segment(segment) => segment.end(),
            Self::Parabola(parabola) => parabola.end,
        }
    }

    /// Radius at position `z`, mm. Outside the curve the radius of its nearer end; on a vertical line the larger one.
    #[must_use]
    pub fn radius_at(&self, z: f64) -> f64 {
        let (start, end) = (self.start(), self.end());
        if end.z <= start.z {
            return start.r.max(end.r);
        }
        if z <= start.z {
            return start.r;
        }
        if z >= end.z {
            return end.r;
        }
        match *self {
            Self::Segment(Segment::Line { .. }) => start.r + (end.r - start.r) * ((z - start.z) / (end.z - start.z)),
            Self::Segment(Segment::Arc { center, ccw, .. }) => {
                let radius = start.distance(center);
                let height = (radius * radius - (z - center.z).powi(2)).max(0.0).sqrt();
                if ccw { center.r - height } else { center.r + height }
            }
            Self::Parabola(parabola) => parabola.radius_at(z),
        }
    }

    /// The part of the curve from `z1` to `z2`, mm; its ends lie exactly at these positions.
    #[must_use]
    pub fn between(&self, z1: f64, z2: f64) -> Self {
        self.with_ends(Point::new(z1, self.radius_at(z1)), Point::new(z2, self.radius_at(z2)))
    }

    /// The same curve from `start`, which must lie on it.
    #[must_use]
    pub fn starting_at(&self, start: Point) -> Self {
        self.with_ends(start, self.end())
    }

    fn with_ends(&self, start: Point, end: Point) -> Self {
        match *self {
            Self::Segment(Segment::Line { .. }) => Self::line(start, end),
            Self::Segment(Segment::Arc { center, ccw, .. }) => Self::Segment(Segment::Arc { start, end, center, ccw }),
            Self::Parabola(parabola) => Self::Parabola(Parabola { start, end, ..parabola }),
        }
    }

    /// The curve mirrored at the plane across the spindle at `z` and run backwards, so that z still grows along it.
    #[must_use]
    pub fn turned_round(&self, z: f64) -> Self {
        match self {
            Self::Segment(segment) => Self::Segment(segment.mirrored_at_z(z).reversed()),
            Self::Parabola(parabola) => Self::Parabola(parabola.turned_round(z)),
        }
    }

    /// The smallest rectangle around the curve.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::Segment(segment) => segment.bounds(),
            Self::Parabola(parabola) => parabola.bounds(),
        }
    }

    /// Position between the ends where the radius is largest or smallest, mm, if there is one.
    #[must_use]
    pub fn turning_point_z(&self) -> Option<f64> {
        let z = match self {
            Self::Segment(Segment::Line { .. }) => return None,
            Self::Segment(Segment::Arc { center, .. }) => center.z,
            Self::Parabola(parabola) => parabola.vertex_z()?,
        };
        (self.start().z < z && z < self.end().z).then_some(z)
    }

    /// Points along the curve without its start, no chord further than `tolerance` mm from it.
    #[must_use]
    pub fn polyline_points(&self, tolerance: f64) -> Vec<Point> {
        match self {
            Self::Segment(segment) => segment.polyline_points(tolerance),
            Self::Parabola(parabola) => parabola.polyline_points(tolerance),
        }
    }
}

impl Parabola {
    /// The parabola with quadratic coefficient `a` (1/mm) through both ends.
    #[must_use]
    pub fn through(start: Point, end: Point, axis: ParabolaAxis, a: f64, chords: u32) -> Self {
        let (u1, v1) = axis.uv(start);
        let (u2, v2) = axis.uv(end);
        let slope = (v2 - v1) / (u2 - u1);
        let coefficients = [a, slope - a * (u1 + u2), v1 - slope * u1 + a * u1 * u2];
        Self { start, end, axis, coefficients, chords }
    }

    /// The quadratic coefficient, 1/mm.
    #[must_use]
    pub const fn quadratic(&self) -> f64 {
        self.coefficients[0]
    }

    /// The point at `t` of the way between the ends, measured along the coordinate that the parabola is a function of.
    /// The ends are returned exactly.
    ///
    /// Newton's form through both ends; it keeps its accuracy far from the origin, unlike `a·u² + b·u + c`.
    #[must_use]
    pub fn point_at(&self, t: f64) -> Point {
        if t <= 0.0 {
            return self.start;
        }
        if t >= 1.0 {
            return self.end;
        }
        let (u1, v1) = self.axis.uv(self.start);
        let (u2, v2) = self.axis.uv(self.end);
        let width = u2 - u1;
        self.axis.point(u1 + width * t, v1 + (v2 - v1) * t + self.quadratic() * width * width * t * (t - 1.0))
    }

    /// Share of the way, 0 to 1, at which the parabola has position `z`.
    fn share_at(&self, z: f64) -> f64 {
        let dz = self.end.z - self.start.z;
        let w = z - self.start.z;
        match self.axis {
            ParabolaAxis::AlongX => w / dz,
            ParabolaAxis::AlongZ => {
                // k·t² + (dz − k)·t = w, the root between 0 and 1 in the form without cancellation.
                let k = self.bulge();
                let linear = dz - k;
                let root = (linear * linear + 4.0 * k * w).max(0.0).sqrt();
                if linear + root > 0.0 { (2.0 * w / (linear + root)).clamp(0.0, 1.0) } else { 0.0 }
            }
        }
    }

    /// a·(u2 − u1)²: four times the distance of the middle from the chord, along the quadratic coordinate, mm.
    pub(super) fn bulge(&self) -> f64 {
        let width = self.axis.uv(self.end).0 - self.axis.uv(self.start).0;
        self.quadratic() * width * width
    }

    fn radius_at(&self, z: f64) -> f64 {
        self.point_at(self.share_at(z)).r
    }

    /// Position of the vertex of a parabola whose axis is square to the spindle.
    fn vertex_z(&self) -> Option<f64> {
        let share = self.vertex_share()?;
        (self.axis == ParabolaAxis::AlongX).then(|| self.point_at(share).z)
    }

    /// Share of the way at which the vertex lies, if strictly between the ends.
    pub(super) fn vertex_share(&self) -> Option<f64> {
        let rise = self.axis.uv(self.end).1 - self.axis.uv(self.start).1;
        let share = 0.5 - 0.5 * rise / self.bulge();
        (0.0 < share && share < 1.0).then_some(share)
    }

    fn bounds(&self) -> Bounds {
        let ends = Bounds { min: self.start, max: self.start }.including(self.end);
        self.vertex_share().map_or(ends, |share| ends.including(self.point_at(share)))
    }

    fn turned_round(&self, z: f64) -> Self {
        let [a, b, c] = self.coefficients;
        let width = 2.0 * z;
        let coefficients = match self.axis {
            ParabolaAxis::AlongX => [a, -(2.0 * a * width + b), (a * width + b) * width + c],
            ParabolaAxis::AlongZ => [-a, -b, width - c],
        };
        let (start, end) = (self.end.mirrored_at_z(z), self.start.mirrored_at_z(z));
        Self { start, end, coefficients, ..*self }
    }

    fn polyline_points(&self, tolerance: f64) -> Vec<Point> {
        /// More chords than any parabola on a lathe needs; keeps a wrong tolerance from filling the memory.
        const MOST: f64 = 100_000.0;
        // n equal chords leave a quarter of the bulge divided by n².
        let wanted = (0.25 * self.bulge().abs() / tolerance).sqrt().ceil();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST")]
        let count = if wanted.is_finite() { wanted.clamp(1.0, MOST) as u32 } else { MOST as u32 };
        (1..=count).map(|k| self.point_at(f64::from(k) / f64::from(count))).collect()
    }
}

impl ParabolaAxis {
    /// The coordinate that the parabola is a function of, and the quadratic one.
    pub(super) const fn uv(self, p: Point) -> (f64, f64) {
        match self {
            Self::AlongX => (p.z, p.r),
            Self::AlongZ => (p.r, p.z),
        }
    }

    const fn point(self, u: f64, v: f64) -> Point {
        match self {
            Self::AlongX => Point::new(u, v),
            Self::AlongZ => Point::new(v, u),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn along_x() -> Parabola {
        Parabola::through(Point::new(5.0, 8.0), Point::new(14.0, 5.0), ParabolaAxis::AlongX, -0.1, 10)
    }

    fn along_z() -> Parabola {
        // z = 10 − r²/2.5 from r = 5 to the vertex on the axis.
        Parabola::through(Point::new(0.0, 5.0), Point::new(10.0, 0.0), ParabolaAxis::AlongZ, -0.4, 10)
    }

    #[test]
    fn newton_form_and_coefficients_agree() {
        for parabola in [along_x(), along_z()] {
            let [a, b, c] = parabola.coefficients;
            for k in 0..=20 {
                let (u, v) = parabola.axis.uv(parabola.point_at(f64::from(k) / 20.0));
                assert!((v - (a * u * u + b * u + c)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn radius_at_finds_the_points_of_the_curve() {
        for parabola in [along_x(), along_z()] {
            for k in 0..=20 {
                let p = parabola.point_at(f64::from(k) / 20.0);
                // Near a vertical tangent the radius follows the root of a rounding error in z.
                assert!((Curve::Parabola(parabola).radius_at(p.z) - p.r).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn turning_round_twice_changes_nothing() {
        for parabola in [along_x(), along_z()] {
            let turned = parabola.turned_round(20.0);
            assert!(turned.start.z < turned.end.z);
            let (u, v) = turned.axis.uv(turned.point_at(0.3));
            let [a, b, c] = turned.coefficients;
            assert!((v - (a * u * u + b * u + c)).abs() < 1e-9);
            let back = turned.turned_round(20.0);
            assert!(back.start.distance(parabola.start) < 1e-12);
            assert!(back.coefficients.iter().zip(parabola.coefficients).all(|(x, y)| (x - y).abs() < 1e-9));
        }
    }

    #[test]
    fn bounds_include_the_vertex() {
        let hill = Parabola::through(Point::new(0.0, 1.0), Point::new(4.0, 1.0), ParabolaAxis::AlongX, -0.5, 10);
        assert!((hill.bounds().max.r - 3.0).abs() < 1e-12);
        assert_eq!(Curve::Parabola(hill).turning_point_z(), Some(2.0));
    }

    #[test]
    fn chords_stay_within_tolerance() {
        let parabola = along_x();
        let points = parabola.polyline_points(0.01);
        assert!(points.len() > 5);
        let mut last = parabola.start;
        for p in points {
            let middle = f64::midpoint(last.z, p.z);
            assert!((parabola.radius_at(middle) - f64::midpoint(last.r, p.r)).abs() <= 0.01 + 1e-12);
            last = p;
        }
    }
}
