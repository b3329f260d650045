//! The strip at a stage of the line: its mean line and both its faces, piece by piece, from left to right.
//!
//! Strip space: `z` across the line, to the right, 0 at the origin of the section; `r` the height, 0 at the bottom face of
//! the base. How the strip lies there:
//!
//! * With its origin in the middle, the origin stays where it is and the elements there keep their slope.
//! * With its origin at an edge, nothing would hold the strip: the edge moves most of all. It is held by its base, the longest
//!   line that is horizontal in the finished section; the middle of the base keeps its place and its slope. Without any
//!   such line the origin holds it.

mod chain;
mod place;

#[cfg(test)]
mod tests;

use super::bends::{BendState, Stage, bend_states};
use crate::document::RollSet;
pub use crate::document::{PieceKind, Side};
use crate::geometry::{Contour, Point, Segment, Vector};
use std::collections::BTreeMap;

/// A piece of the strip: a line, or a line or the arc of a bend. All its segments run from left to right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Id of its element.
    pub element: u32,
    /// Side of the origin.
    pub side: Side,
    /// What it is of its element.
    pub kind: PieceKind,
    /// Inside radius of an arc, mm; 0 of a line.
    pub inside_radius: f64,
    /// Angle of an arc, radians, positive if it turns upwards; 0 of a line.
    pub angle_rad: f64,
    /// Direction at its left end, radians, counter-clockwise from z. It may exceed half a turn.
    pub heading_rad: f64,
    /// On the mean line.
    pub mean: Segment,
    /// On the bottom face.
    pub bottom: Segment,
    /// On the top face.
    pub top: Segment,
}

impl Piece {
    /// Direction at its right end, radians.
    #[must_use]
    pub fn end_heading_rad(&self) -> f64 {
        self.heading_rad + self.angle_rad
    }

    /// Direction square to the strip at its left end, from the bottom to the top face.
    #[must_use]
    pub fn start_normal(&self) -> Vector {
        normal(self.heading_rad)
    }

    /// Direction square to the strip at its right end, from the bottom to the top face.
    #[must_use]
    pub fn end_normal(&self) -> Vector {
        normal(self.end_heading_rad())
    }

    /// True for the bent arc of a bend.
    #[must_use]
    pub fn is_bent(&self) -> bool {
        self.kind == PieceKind::Arc
    }
}

/// The strip at a stage.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Its thickness, mm.
    pub thickness: f64,
    /// Its pieces from left to right; each starts where the one before ends.
    pub pieces: Vec<Piece>,
    /// Pieces left of the origin.
    pub left_of_origin: usize,
}

impl Strip {
    /// The strip at a stage. The set is in mm.
    #[must_use]
    pub fn at(set: &RollSet, stage: Stage) -> Self {
        Self::with_bends(set, &bend_states(set, stage))
    }

    /// The strip with these bends, as after springback. A bend without a state is left out.
    #[must_use]
    pub fn with_bends(set: &RollSet, bends: &BTreeMap<u32, BendState>) -> Self {
        place::placed(set, bends)
    }

    /// The mean line from left to right.
    #[must_use]
    pub fn mean(&self) -> Contour {
        self.line(|piece| piece.mean)
    }

    /// The bottom face from left to right.
    #[must_use]
    pub fn bottom(&self) -> Contour {
        self.line(|piece| piece.bottom)
    }

    /// The top face from left to right.
    #[must_use]
    pub fn top(&self) -> Contour {
        self.line(|piece| piece.top)
    }

    /// The closed outline: the bottom face, the right edge, the top face back, the left edge. Pieces without length on a face
    /// are left out. Empty without pieces.
    #[must_use]
    pub fn outline(&self) -> Contour {
        let (Some(first), Some(last)) = (self.pieces.first(), self.pieces.last()) else { return Contour::default() };
        let there = self.pieces.iter().map(|piece| piece.bottom);
        let back = self.pieces.iter().rev().map(|piece| piece.top.reversed());
        let right = Segment::line(last.bottom.end(), last.top.end());
        let left = Segment::line(first.top.start(), first.bottom.start());
        let all = there.chain([right]).chain(back).chain([left]);
        Contour::new(all.filter(|segment| segment.length() > 0.0).collect())
    }

    /// Length of the mean line, mm.
    #[must_use]
    pub fn mean_length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.mean.length()).sum()
    }

    /// The point of the mean line at the origin of the section.
    #[must_use]
    pub fn origin(&self) -> Point {
        let right = self.pieces.get(self.left_of_origin).map(|piece| piece.mean.start());
        right.or_else(|| self.pieces.last().map(|piece| piece.mean.end())).unwrap_or_default()
    }

    fn line(&self, of: impl Fn(&Piece) -> Segment) -> Contour {
        Contour::new(self.pieces.iter().map(of).collect())
    }
}

/// Direction at right angles to a heading, on its left.
pub(super) fn normal(heading_rad: f64) -> Vector {
    Vector::new(-heading_rad.sin(), heading_rad.cos())
}

/// Direction of a heading.
pub(super) fn along(heading_rad: f64) -> Vector {
    Vector::new(heading_rad.cos(), heading_rad.sin())
}
