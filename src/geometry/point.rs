//! A point and a rectangle in part space.

use serde::{Deserialize, Serialize};
use std::ops::{Add, Sub};

/// A difference of points; `x` is along z, `y` along r, in mm.
pub type Vector = nalgebra::Vector2<f64>;

/// A point in part space, in mm.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Point {
    /// Position along the spindle, mm.
    pub z: f64,
    /// Radius, mm.
    pub r: f64,
}

impl Point {
    /// The point at `z` and `r`, both in mm.
    #[must_use]
    pub const fn new(z: f64, r: f64) -> Self {
        Self { z, r }
    }

    /// Distance to `other`, mm.
    #[must_use]
    pub fn distance(self, other: Self) -> f64 {
        (other - self).norm()
    }

    /// The point mirrored at the plane across the spindle at `z`.
    #[must_use]
    pub fn mirrored_at_z(self, z: f64) -> Self {
        Self::new(2.0 * z - self.z, self.r)
    }

    /// True if neither coordinate is NaN or infinite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.z.is_finite() && self.r.is_finite()
    }
}

impl Sub for Point {
    type Output = Vector;
    fn sub(self, other: Self) -> Vector {
        Vector::new(self.z - other.z, self.r - other.r)
    }
}

impl Add<Vector> for Point {
    type Output = Self;
    fn add(self, v: Vector) -> Self {
        Self::new(self.z + v.x, self.r + v.y)
    }
}

impl Sub<Vector> for Point {
    type Output = Self;
    fn sub(self, v: Vector) -> Self {
        Self::new(self.z - v.x, self.r - v.y)
    }
}

/// An axis-parallel rectangle in part space, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Corner with the smallest z and r.
    pub min: Point,
    /// Corner with the largest z and r.
    pub max: Point,
}

impl Bounds {
    /// The rectangle around `points`, or `None` if there are none.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        points
            .into_iter()
            .fold(None, |bounds: Option<Self>, p| Some(bounds.map_or(Self { min: p, max: p }, |b| b.including(p))))
    }

    /// The smallest rectangle around this one and `p`.
    #[must_use]
    pub fn including(self, p: Point) -> Self {
        Self {
            min: Point::new(self.min.z.min(p.z), self.min.r.min(p.r)),
            max: Point::new(self.max.z.max(p.z), self.max.r.max(p.r)),
        }
    }

    /// The smallest rectangle around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        self.including(other.min).including(other.max)
    }

    /// True if the rectangles share a point, borders included.
    #[must_use]
    pub fn touches(self, other: Self) -> bool {
        self.min.z <= other.max.z && other.min.z <= self.max.z && self.min.r <= other.max.r && other.min.r <= self.max.r
    }
}
