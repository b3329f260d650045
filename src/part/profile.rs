//! The exact profile of a part: one curve after another along the spindle.

use crate::geometry::{Bounds, Contour, Point, Segment};

/// A curve of a profile, exact. Parabolas keep their form until a program needs lines or arcs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Curve {
    /// A line or an arc.
    Segment(Segment),
    /// A parabola through two ends.
    Parabola(Parabola),
}

/// A parabola `v = a·u² + b·u + c` between two points, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parabola {
    /// First point.
    pub start: Point,
    /// Last point.
    pub end: Point,
    /// Which coordinate is the quadratic one.
    pub axis: ParabolaAxis,
    /// Coefficients a, b, c.
    pub coefficients: [f64; 3],
    /// Chords that the published generator cuts it with, over its whole row.
    pub chords: u32,
}

/// Direction of a parabola's axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ParabolaAxis {
    /// Axis parallel to the spindle: z is a quadratic of r.
    AlongZ,
    /// Axis square to the spindle: r is a quadratic of z.
    AlongX,
}

/// One piece of the profile, with the row it comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The curve, from smaller to larger z (a face: in the order of travel along the profile).
    pub curve: Curve,
    /// Row that the piece belongs to; a face belongs to its own row if
    /// the table has one, else to the row on its far side from the clamped end.
    pub section: u32,
    /// What the piece is.
    pub role: PieceRole,
}

/// What a piece of the profile is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PieceRole {
    /// The surface of a section.
    Surface,
    /// The cylinder of a thread before it is cut: outside its major, in a bore its minor diameter.
    Thread,
    /// A face between sections of different diameter.
    Face,
    /// Stands in for a row that is missing or impossible.
    Filler,
}

/// The outside or the bore of one set-up's part, from the clamped end (smallest z) to the free end, in part space, mm.
///
/// The pieces are connected: each starts where the one before ends. Nowhere does z decrease along the profile.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Profile {
    /// The pieces in order of z.
    pub pieces: Vec<Piece>,
}

impl Piece {
    /// First point.
    #[must_use]
    pub const fn start(&self) -> Point {
        self.curve.start()
    }

    /// Last point.
    #[must_use]
    pub const fn end(&self) -> Point {
        self.curve.end()
    }

    /// The piece in the space of the other end of a part of `length` mm: mirrored, and run backwards.
    #[must_use]
    pub fn turned_round(&self, length: f64) -> Self {
        Self { curve: self.curve.turned_round(length / 2.0), ..*self }
    }
}

impl Profile {
    /// Largest radius at position `z`, mm; `None` beyond both ends.
    #[must_use]
    pub fn radius_at(&self, z: f64) -> Option<f64> {
        let first = self.pieces.partition_point(|piece| piece.end().z < z);
        let here = self.pieces.iter().skip(first).take_while(|piece| piece.start().z <= z);
        here.map(|piece| piece.curve.radius_at(z)).reduce(f64::max)
    }

    /// The smallest rectangle around the profile; `None` without pieces.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        self.pieces.iter().map(|piece| piece.curve.bounds()).reduce(Bounds::union)
    }

    /// Points along the profile, start included, no chord further than `tolerance` mm from its curve.
    #[must_use]
    pub fn polyline(&self, tolerance: f64) -> Vec<Point> {
        let first = self.pieces.first().map(Piece::start);
        first.into_iter().chain(self.pieces.iter().flat_map(|piece| piece.curve.polyline_points(tolerance))).collect()
    }
}

/// A contour with the row behind every segment.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PartContour {
    /// Lines and arcs from the clamped end to the free end.
    pub contour: Contour,
    /// Row id of each segment, as many as segments.
    pub sections: Vec<u32>,
}
