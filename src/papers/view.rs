//! How part space lies on a page.

use super::page::{Page, Pen};
use crate::geometry::{Point, Segment, Vector};

/// How part space lies on a page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Where the axis crosses part position 0, mm from the lower left corner of the page.
    pub origin: Point,
    /// mm on paper for one mm of the part.
    pub scale: f64,
}

impl View {
    /// A point of the part on paper.
    #[must_use]
    pub fn place(&self, p: Point) -> Point {
        Point::new(self.origin.z + p.z * self.scale, self.origin.r + p.r * self.scale)
    }

    /// A point on paper in part space, mm.
    #[must_use]
    pub fn part_point(&self, p: Point) -> Point {
        Point::new((p.z - self.origin.z) / self.scale, (p.r - self.origin.r) / self.scale)
    }

    /// A segment of the part on paper.
    pub(super) fn segment(&self, segment: &Segment) -> Segment {
        match *segment {
            Segment::Line { start, end } => Segment::line(self.place(start), self.place(end)),
            Segment::Arc { start, end, center, ccw } => {
                Segment::Arc { start: self.place(start), end: self.place(end), center: self.place(center), ccw }
            }
        }
    }

    /// Segments of the part on paper.
    pub(super) fn segments(&self, segments: &[Segment]) -> Vec<Segment> {
        segments.iter().map(|s| self.segment(s)).collect()
    }

    /// The axis, sticking out at both ends.
    pub(super) fn axis(&self, page: &mut Page, from_z: f64, to_z: f64) {
        /// Length beyond the part, mm on paper.
        const BEYOND_MM: f64 = 5.0;
        let beyond = Vector::new(BEYOND_MM, 0.0);
        let (from, to) = (self.place(Point::new(from_z, 0.0)), self.place(Point::new(to_z, 0.0)));
        page.line(from - beyond, to + beyond, Pen::CENTRE);
    }
}

/// The point on the other side of the axis.
pub(super) fn below(p: Point) -> Point {
    Point::new(p.z, -p.r)
}

/// A segment mirrored at the axis.
pub(super) fn mirrored(segment: &Segment) -> Segment {
    match *segment {
        Segment::Line { start, end } => Segment::line(below(start), below(end)),
        Segment::Arc { start, end, center, ccw } => {
            Segment::Arc { start: below(start), end: below(end), center: below(center), ccw: !ccw }
        }
    }
}
