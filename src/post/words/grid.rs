//! From points of a path to the counts of position words and back.

use super::number::NumberFormat;
use crate::geometry::Point;
use crate::machine::Words;
use crate::units::Unit;

/// A position in counts of its X and Z words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Counts {
    pub(super) x: i64,
    pub(super) z: i64,
}

/// What the position words of a control mean.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    pub(super) format: NumberFormat,
    /// What an X word grows by when the radius grows by one: 1 or 2, negative for a tool behind the axis.
    x_per_radius: f64,
    x_sign: f64,
    mm_per_unit: f64,
    /// Part-space position of the program zero, mm.
    zero_z: f64,
}

impl Grid {
    pub(super) fn new(words: &Words, unit: Unit, zero_z: f64) -> Self {
        let decimals = match unit {
            Unit::Mm => words.decimals_mm,
            Unit::Inch => words.decimals_inch,
        };
        Self {
            format: NumberFormat::length(words, decimals),
            x_per_radius: words.x_at(1.0),
            x_sign: f64::from(words.x_sign),
            mm_per_unit: unit.in_mm(),
            zero_z,
        }
    }

    /// The nearest position that the words can name.
    pub(super) fn counts(&self, p: Point) -> Counts {
        Counts {
            x: self.format.counts(p.r * self.x_per_radius / self.mm_per_unit),
            z: self.format.counts((p.z - self.zero_z) / self.mm_per_unit),
        }
    }

    /// The point in part space that `counts` names.
    pub(super) fn point(&self, counts: Counts) -> Point {
        let r = self.format.value(counts.x) * self.mm_per_unit / self.x_per_radius;
        Point::new(self.format.value(counts.z) * self.mm_per_unit + self.zero_z, r)
    }

    /// One count along z, mm; the same on the radius for words that are radii.
    pub(super) fn step_mm(&self) -> f64 {
        self.mm_per_unit / self.format.scale()
    }

    /// A displacement in the words' radius direction and along z, counts of a radius word: the values of I and K.
    pub(super) fn displacement(&self, from: Point, to: Point) -> (f64, f64) {
        let scale = self.format.scale() / self.mm_per_unit;
        ((to.r - from.r) * self.x_sign * scale, (to.z - from.z) * scale)
    }

    /// The point that lies `i` and `k` counts from `from`.
    pub(super) fn displaced(&self, from: Point, i: i64, k: i64) -> Point {
        let mm = |counts| self.format.value(counts) * self.mm_per_unit;
        Point::new(from.z + mm(k), from.r + mm(i) * self.x_sign)
    }

    /// The words of a position that is written as a radius whatever X is: I and K of a centre from the program zero.
    pub(super) fn absolute(&self, p: Point) -> (i64, i64) {
        let i = p.r * self.x_sign / self.mm_per_unit;
        (self.format.counts(i), self.format.counts((p.z - self.zero_z) / self.mm_per_unit))
    }
}
