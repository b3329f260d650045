//! The unbounded line or circle behind an element.

use crate::geometry::{Point, Segment, Vector};

/// A line or circle without ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Carrier {
    /// A point and a direction of unit length.
    Line(Point, Vector),
    /// Centre and radius, mm.
    Circle(Point, f64),
}

impl Carrier {
    /// The carrier of a segment; `None` for a line without length.
    pub(super) fn of(segment: &Segment) -> Option<Self> {
        match *segment {
            Segment::Line { start, end } => Some(Self::Line(start, (end - start).try_normalize(0.0)?)),
            Segment::Arc { start, center, .. } => Some(Self::Circle(center, start.distance(center))),
        }
    }

    /// Where two carriers meet nearest to `near`.
    pub(super) fn meeting(self, other: Self, near: Point) -> Option<Point> {
        self.sample().prolonged_meeting(&other.sample(), near)
    }

    /// The point of the carrier nearest to `p`.
    pub(super) fn nearest(self, p: Point) -> Option<Point> {
        match self {
            Self::Line(on, along) => Some(on + along * (p - on).dot(&along)),
            Self::Circle(center, radius) => Some(center + (p - center).try_normalize(0.0)? * radius),
        }
    }

    /// Some segment of the carrier.
    fn sample(self) -> Segment {
        match self {
            Self::Line(on, along) => Segment::line(on, on + along),
            Self::Circle(center, radius) => {
                let start = center + Vector::new(radius, 0.0);
                Segment::Arc { start, end: center - Vector::new(radius, 0.0), center, ccw: true }
            }
        }
    }
}
