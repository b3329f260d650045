//! Where a roll is in strip space.

use crate::document::RollKind;
use crate::geometry::{Point, Segment};

/// The place of a roll: strip space to roll space and back. In roll space `z` grows from the left (of a side roll the lower)
/// face of the roll, `r` is the radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Which roll.
    pub kind: RollKind,
    /// Position of the left face along z in strip space; of a side roll the height of the lower face. mm.
    pub face: f64,
    /// Height of the axis in strip space; of a side roll its position along z. mm.
    pub axis: f64,
}

impl Frame {
    /// A point of strip space in roll space.
    #[must_use]
    pub fn point_to_roll(&self, p: Point) -> Point {
        match self.kind {
            RollKind::Top => Point::new(p.z - self.face, self.axis - p.r),
            RollKind::Bottom => Point::new(p.z - self.face, p.r - self.axis),
            RollKind::Left => Point::new(p.r - self.face, p.z - self.axis),
            RollKind::Right => Point::new(p.r - self.face, self.axis - p.z),
        }
    }

    /// A point of roll space in strip space.
    #[must_use]
    pub fn point_to_strip(&self, p: Point) -> Point {
        match self.kind {
            RollKind::Top => Point::new(p.z + self.face, self.axis - p.r),
            RollKind::Bottom => Point::new(p.z + self.face, p.r + self.axis),
            RollKind::Left => Point::new(p.r + self.axis, p.z + self.face),
            RollKind::Right => Point::new(self.axis - p.r, p.z + self.face),
        }
    }

    /// A segment of strip space in roll space, run the same way.
    #[must_use]
    pub fn to_roll(&self, segment: &Segment) -> Segment {
        mapped(segment, |p| self.point_to_roll(p), self.mirrors())
    }

    /// A segment of roll space in strip space, run the same way.
    #[must_use]
    pub fn to_strip(&self, segment: &Segment) -> Segment {
        mapped(segment, |p| self.point_to_strip(p), self.mirrors())
    }

    const fn mirrors(&self) -> bool {
        matches!(self.kind, RollKind::Top | RollKind::Left)
    }
}

/// A segment under a map that keeps lengths; `mirrors` if it turns senses round.
pub(super) fn mapped(segment: &Segment, map: impl Fn(Point) -> Point, mirrors: bool) -> Segment {
    match *segment {
        Segment::Line { start, end } => Segment::Line { start: map(start), end: map(end) },
        Segment::Arc { start, end, center, ccw } => {
            Segment::Arc { start: map(start), end: map(end), center: map(center), ccw: ccw != mirrors }
        }
    }
}
