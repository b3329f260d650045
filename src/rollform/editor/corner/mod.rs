//! Chamfers and blending arcs at the corner of two lines (chapter 6.9), under three conditions, one file each.

mod angle;
mod lines;
mod size;

use super::fault::{self, Reason};
use crate::document::ElementName;
use crate::geometry::{Point, Segment, Vector};
use crate::rollform::roll::RollElement;

/// A corner that may be modified.
pub(super) struct Corner {
    index: usize,
    point: Point,
    /// Directions of the lines in the direction of the contour.
    before: Vector,
    after: Vector,
    /// Lengths of the lines, mm.
    lengths: [f64; 2],
}

impl Corner {
    /// The corner behind the element with this index, if a modification of this size may be made there.
    pub(super) fn at(elements: &[RollElement], index: usize, size: f64, name: &str) -> Result<Self, Reason> {
        if !(size.is_finite() && size > 0.0) {
            return Err(fault::figure(name, size));
        }
        let (before, after) = lines::both_lines(elements, index)?;
        angle::below_135(&before, &after)?;
        let lengths = [before.length(), after.length()];
        size::at_most_60_percent(lengths, size, name)?;
        let (point, before, after) = (before.end(), before.direction_at(1.0), after.direction_at(0.0));
        Ok(Self { index, point, before, after, lengths })
    }

    /// Angle between the lines, radians.
    fn included(&self) -> f64 {
        std::f64::consts::PI - self.before.perp(&self.after).abs().atan2(self.before.dot(&self.after))
    }

    /// A line whose ends have the distance `depth` from the other line each: it takes depth / sin(angle) off both.
    pub(super) fn chamfer(&self, elements: &mut Vec<RollElement>, depth: f64, name: ElementName) -> Result<(), Reason> {
        let (from, to) = self.cut(depth / self.included().sin())?;
        self.put(elements, Segment::line(from, to), name);
        Ok(())
    }

    /// An arc that touches both lines: it takes radius / tan(angle / 2) off both.
    pub(super) fn blend(&self, elements: &mut Vec<RollElement>, radius: f64, name: ElementName) -> Result<(), Reason> {
        let (start, end) = self.cut(radius / (self.included() / 2.0).tan())?;
        let ccw = self.before.perp(&self.after) > 0.0;
        let left = Vector::new(-self.before.y, self.before.x);
        let center = start + left * if ccw { radius } else { -radius };
        self.put(elements, Segment::Arc { start, end, center, ccw }, name);
        Ok(())
    }

    /// The points at a distance from the corner on both lines.
    fn cut(&self, distance: f64) -> Result<(Point, Point), Reason> {
        let shorter = self.lengths[0].min(self.lengths[1]);
        if distance >= shorter {
            return Err(fault::turns_back(distance - shorter));
        }
        Ok((self.point - self.before * distance, self.point + self.after * distance))
    }

    fn put(&self, elements: &mut Vec<RollElement>, segment: Segment, name: ElementName) {
        if let Some(RollElement { segment: Segment::Line { end, .. }, .. }) = elements.get_mut(self.index) {
            *end = segment.start();
        }
        if let Some(RollElement { segment: Segment::Line { start, .. }, .. }) = elements.get_mut(self.index + 1) {
            *start = segment.end();
        }
        elements.insert(self.index + 1, RollElement::new(segment, name));
    }
}
