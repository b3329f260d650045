//! One stretch of a surface of revolution: the radius as a line or an arc over z, exact.

use crate::geometry::{Point, Segment};
use std::f64::consts::FRAC_1_SQRT_2;

/// Coordinates nearer than this are the same place, mm: far below the control's 0.001 and far above rounding noise.
pub(super) const SAME_MM: f64 = 1e-9;

/// A radius over the z range `z0..=z1`, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub(super) z0: f64,
    pub(super) z1: f64,
    form: Form,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    /// Through `anchor` with `slope` = dr/dz.
    Line { anchor: Point, slope: f64 },
    /// The upper or lower half of a circle.
    Arc { center: Point, radius: f64, upper: bool },
}

impl Span {
    /// A line from `a` to `b`, `a.z < b.z`.
    pub(super) fn line(a: Point, b: Point) -> Self {
        Self { z0: a.z, z1: b.z, form: Form::Line { anchor: a, slope: (b.r - a.r) / (b.z - a.z) } }
    }

    /// The 45-degree line `r = z + k` over `z0..=z1`.
    pub(super) fn diagonal(z0: f64, z1: f64, k: f64) -> Self {
        Self { z0, z1, form: Form::Line { anchor: Point::new(z0, z0 + k), slope: 1.0 } }
    }

    /// The span of a segment; `None` for a face, which has no width.
    pub(super) fn of(segment: &Segment) -> Option<Self> {
        let segment = if segment.start().z <= segment.end().z { *segment } else { segment.reversed() };
        let (a, b) = (segment.start(), segment.end());
        if b.z - a.z <= SAME_MM {
            return None;
        }
        Some(match segment {
            Segment::Line { .. } => Self::line(a, b),
            Segment::Arc { center, .. } => {
                let upper = segment.point_at(0.5).r >= center.r;
                Self { z0: a.z, z1: b.z, form: Form::Arc { center, radius: a.distance(center), upper } }
            }
        })
    }

    /// The segment from smaller to larger z.
    pub(super) fn segment(&self) -> Segment {
        let (start, end) = (self.left(), self.right());
        match self.form {
            Form::Line { .. } => Segment::Line { start, end },
            Form::Arc { center, upper, .. } => Segment::Arc { start, end, center, ccw: !upper },
        }
    }

    /// Radius at `z`, mm.
    pub(super) fn at(&self, z: f64) -> f64 {
        match self.form {
            Form::Line { anchor, slope } => anchor.r + slope * (z - anchor.z),
            Form::Arc { center, radius, upper } => {
                let height = (radius * radius - (z - center.z).powi(2)).max(0.0).sqrt();
                center.r + if upper { height } else { -height }
            }
        }
    }

    /// Point at the smallest z.
    pub(super) fn left(&self) -> Point {
        Point::new(self.z0, self.at(self.z0))
    }

    /// Point at the largest z.
    pub(super) fn right(&self) -> Point {
        Point::new(self.z1, self.at(self.z1))
    }

    /// The part between `z0` and `z1`; `None` if nothing is left.
    pub(super) fn clipped(&self, z0: f64, z1: f64) -> Option<Self> {
        let (z0, z1) = (self.z0.max(z0), self.z1.min(z1));
        (z1 - z0 > SAME_MM).then_some(Self { z0, z1, form: self.form })
    }

    /// The span `by` mm further out.
    pub(super) fn raised(&self, by: f64) -> Self {
        let up = |p: Point| Point::new(p.z, p.r + by);
        let form = match self.form {
            Form::Line { anchor, slope } => Form::Line { anchor: up(anchor), slope },
            Form::Arc { center, radius, upper } => Form::Arc { center: up(center), radius, upper },
        };
        Self { form, ..*self }
    }

    /// The span with z turned round: z becomes −z.
    pub(super) fn mirrored(&self) -> Self {
        let turn = |p: Point| p.mirrored_at_z(0.0);
        let form = match self.form {
            Form::Line { anchor, slope } => Form::Line { anchor: turn(anchor), slope: -slope },
            Form::Arc { center, radius, upper } => Form::Arc { center: turn(center), radius, upper },
        };
        Self { z0: -self.z1, z1: -self.z0, form }
    }

    /// Where the span meets the line `r = k + m·z`, at most two places, in order of z.
    pub(super) fn meets(&self, m: f64, k: f64) -> Vec<f64> {
        let mut found = match self.form {
            Form::Line { slope, .. } if slope == m => Vec::new(),
            Form::Line { anchor, slope } => vec![(k - anchor.r + slope * anchor.z) / (slope - m)],
            Form::Arc { center, radius, upper } => meet_circle(center, radius, upper, m, k),
        };
        found.retain(|&z| z >= self.z0 - SAME_MM && z <= self.z1 + SAME_MM);
        found.sort_by(f64::total_cmp);
        found.iter().map(|z| z.clamp(self.z0, self.z1)).collect()
    }

    /// Where the span rises towards larger z at exactly 45 degrees: `r − z` has its extreme there. Arcs only.
    pub(super) fn tangent_at_45_degrees(&self) -> Option<f64> {
        let Form::Arc { center, radius, upper } = self.form else { return None };
        let reach = radius * FRAC_1_SQRT_2;
        let z = if upper { center.z - reach } else { center.z + reach };
        (z > self.z0 + SAME_MM && z < self.z1 - SAME_MM).then_some(z)
    }
}

/// Meeting points of `r = k + m·z` with half a circle: (1+m²)d² + 2mqd + q² − R² = 0, d from the centre.
fn meet_circle(center: Point, radius: f64, upper: bool, m: f64, k: f64) -> Vec<f64> {
    let q = k + m * center.z - center.r;
    let a = 1.0 + m * m;
    let root = ((m * q).powi(2) - a * (q * q - radius * radius)).sqrt();
    if root.is_nan() {
        return Vec::new();
    }
    let on_half = |d: f64| if upper { m * d + q >= -SAME_MM } else { m * d + q <= SAME_MM };
    [-root, root].iter().map(|s| (s - m * q) / a).filter(|&d| on_half(d)).map(|d| center.z + d).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bulge() -> Span {
        let arc = Segment::Arc {
            start: Point::new(-3.0, 4.0),
            end: Point::new(4.0, 3.0),
            center: Point::default(),
            ccw: false,
        };
        Span::of(&arc).unwrap()
    }

    #[test]
    fn an_arc_meets_a_level_on_both_sides() {
        let z = bulge().meets(0.0, 4.5);
        let half = (25.0_f64 - 4.5 * 4.5).sqrt();
        assert_eq!(z.len(), 2);
        assert!((z[0] + half).abs() < 1e-12 && (z[1] - half).abs() < 1e-12);
    }

    #[test]
    fn a_diagonal_meets_an_arc_on_the_arc() {
        for z in bulge().meets(1.0, 1.0) {
            assert!((bulge().at(z) - (z + 1.0)).abs() < 1e-9);
        }
        assert_eq!(bulge().meets(1.0, 1.0).len(), 1);
    }

    #[test]
    fn mirroring_twice_and_the_way_through_a_segment_change_nothing() {
        assert_eq!(bulge().mirrored().mirrored(), bulge());
        assert_eq!(Span::of(&bulge().segment()), Some(bulge()));
        assert_eq!(Span::of(&bulge().segment().reversed()), Some(bulge()));
    }

    #[test]
    fn a_face_has_no_span() {
        assert_eq!(Span::of(&Segment::line(Point::new(1.0, 2.0), Point::new(1.0, 5.0))), None);
    }
}
