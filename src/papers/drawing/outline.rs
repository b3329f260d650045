//! The finished outside and bore of a part as a drawing shows them.

use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::papers::body::finished;
use crate::part::{Curve, PartContour, Piece, PieceRole, Profile};

/// Two places closer than this are one, mm of the part.
pub(super) const SAME_MM: f64 = 0.0005;

/// One side of the finished part from the clamped to the free end, mm.
#[derive(Debug, Clone, Default)]
pub(super) struct Outline {
    /// Exact pieces, without what is cut away behind the part when it is parted off; cylinders that continue each other
    /// are one.
    pub(super) pieces: Vec<Piece>,
    /// The same as lines and arcs.
    pub(super) segments: Vec<Segment>,
}

impl Outline {
    /// What of a profile and its contour belongs to the finished part.
    pub(super) fn new(profile: &Profile, contour: &PartContour) -> Self {
        let of_part = profile.pieces.iter().filter(|p| p.start().z.min(p.end().z) >= -SAME_MM);
        let mut pieces: Vec<Piece> = Vec::new();
        for piece in of_part {
            match pieces.last_mut() {
                Some(last)
                    if is_cylinder(last) && is_cylinder(piece) && last.end().distance(piece.start()) < SAME_MM =>
                {
                    last.curve = Curve::line(last.start(), piece.end());
                }
                _ => pieces.push(*piece),
            }
        }
        Self { pieces, segments: finished(&contour.contour.segments) }
    }

    /// The smallest rectangle around the outline.
    pub(super) fn bounds(&self) -> Option<Bounds> {
        Contour::new(self.segments.clone()).bounds()
    }

    /// The first place with the largest radius.
    pub(super) fn largest(&self) -> Option<Point> {
        let top = |segment: &Segment| {
            let (start, end, top) = (segment.start(), segment.end(), segment.bounds().max.r);
            match *segment {
                Segment::Arc { center, .. } if top > start.r.max(end.r) => Point::new(center.z, top),
                _ if end.r > start.r => end,
                _ => start,
            }
        };
        self.segments.iter().map(top).reduce(|first, other| if other.r > first.r + SAME_MM { other } else { first })
    }

    /// Largest radius between two positions, mm.
    pub(super) fn largest_radius(&self, from: f64, to: f64) -> f64 {
        self.within(from, to).map(|b| b.max.r).fold(0.0, f64::max)
    }

    /// Smallest radius between two positions, mm.
    pub(super) fn smallest_radius(&self, from: f64, to: f64) -> f64 {
        self.within(from, to).map(|b| b.min.r).fold(f64::INFINITY, f64::min)
    }

    /// The segments between two positions, cut off there.
    pub(super) fn clipped(&self, from: f64, to: f64) -> Vec<Segment> {
        let inside = self.segments.iter().filter(|s| s.start().z < to - SAME_MM && s.end().z > from + SAME_MM);
        let cut = inside.map(|segment| {
            let (start, end) = (segment.start().z.max(from), segment.end().z.min(to));
            match Curve::Segment(*segment).between(start, end) {
                Curve::Segment(cut) if start < end => cut,
                _ => *segment,
            }
        });
        cut.collect()
    }

    fn within(&self, from: f64, to: f64) -> impl Iterator<Item = Bounds> {
        self.clipped(from, to).into_iter().map(|s| s.bounds())
    }
}

/// True for a smooth cylinder off the axis.
pub(super) fn is_cylinder(piece: &Piece) -> bool {
    let (start, end) = (piece.start(), piece.end());
    let straight = matches!(piece.curve, Curve::Segment(Segment::Line { .. })) && piece.role != PieceRole::Thread;
    straight && (start.r - end.r).abs() < SAME_MM && start.r > SAME_MM && !is_face(piece)
}

/// True for a face square to the axis.
pub(super) fn is_face(piece: &Piece) -> bool {
    (piece.start().z - piece.end().z).abs() < SAME_MM
}
