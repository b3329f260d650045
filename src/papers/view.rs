//! The part on paper: its outline at a scale, and where a point of the part lies.

use super::page::{Ink, Page, Pen};
use crate::geometry::{Contour, Point, Segment, Vector};

/// Smallest change of direction that is drawn as an edge, radians (about 1 degree).
const EDGE_RAD: f64 = 0.018;

/// How part space lies on a page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    /// Where the axis crosses part position 0.
    pub(super) origin: Point,
    /// mm on paper for one mm of the part.
    pub(super) scale: f64,
}

impl View {
    /// A point of the part on paper.
    pub(super) fn place(&self, p: Point) -> Point {
        Point::new(self.origin.z + p.z * self.scale, self.origin.r + p.r * self.scale)
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
    pub(super) fn segments(&self, contour: &Contour) -> Vec<Segment> {
        contour.segments.iter().map(|s| self.segment(s)).collect()
    }

    /// The whole section of the body under `outside`: both halves filled, outline and edges drawn.
    pub(super) fn body(&self, page: &mut Page, outside: &Contour) {
        let (Some(first), Some(last)) = (outside.segments.first(), outside.segments.last()) else { return };
        let (first, last) = (first.start(), last.end());
        let mut ring = outside.segments.clone();
        ring.push(Segment::line(last, below(last)));
        ring.extend(outside.segments.iter().rev().map(|s| mirrored(&s.reversed())));
        ring.push(Segment::line(below(first), first));
        ring.retain(|s| s.start() != s.end());
        page.area(ring.iter().map(|s| self.segment(s)).collect(), Ink::Pale, Some(Pen::EDGE));
        for pair in outside.segments.windows(2) {
            let turn = pair[0].direction_at(1.0).angle(&pair[1].direction_at(0.0));
            let at = pair[1].start();
            if turn > EDGE_RAD && at.r > 0.0 {
                page.line(self.place(at), self.place(below(at)), Pen::THIN);
            }
        }
    }

    /// The axis, sticking out at both ends.
    pub(super) fn axis(&self, page: &mut Page, from_z: f64, to_z: f64) {
        /// Length beyond the part, mm on paper.
        const BEYOND_MM: f64 = 5.0;
        let beyond = Vector::new(BEYOND_MM, 0.0);
        let (from, to) = (self.place(Point::new(from_z, 0.0)), self.place(Point::new(to_z, 0.0)));
        page.line(from + -beyond, to + beyond, Pen::CENTRE);
    }
}

fn below(p: Point) -> Point {
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
