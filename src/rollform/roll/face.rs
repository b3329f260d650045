//! A face of a roll while it is built, outwards from the drive surface.

use super::RollElement;
use crate::document::ElementName;
use crate::geometry::{Point, Segment, Vector};
use crate::rollform::strip::Piece;

/// Shorter lines and smaller radii are nothing, mm.
pub(super) const NOTHING_MM: f64 = 1e-9;

/// The faces of the strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum StripFace {
    Bottom,
    Top,
}

impl StripFace {
    /// The outer face of an arc: the one with the larger radius.
    pub(super) fn outer(piece: &Piece) -> Self {
        if piece.angle_rad > 0.0 { Self::Bottom } else { Self::Top }
    }

    pub(super) const fn other(self) -> Self {
        match self {
            Self::Bottom => Self::Top,
            Self::Top => Self::Bottom,
        }
    }

    /// The face of a piece.
    pub(super) const fn of(self, piece: &Piece) -> Segment {
        match self {
            Self::Bottom => piece.bottom,
            Self::Top => piece.top,
        }
    }

    /// Away from the strip at the start of a piece.
    pub(super) fn start_normal(self, piece: &Piece) -> Vector {
        piece.start_normal() * self.sign()
    }

    /// Away from the strip at the end of a piece.
    pub(super) fn end_normal(self, piece: &Piece) -> Vector {
        piece.end_normal() * self.sign()
    }

    const fn sign(self) -> f64 {
        match self {
            Self::Bottom => -1.0,
            Self::Top => 1.0,
        }
    }
}

/// The name of what a piece makes.
pub(super) const fn name_of(piece: &Piece) -> ElementName {
    ElementName::Strip { element: piece.element, side: piece.side, kind: piece.kind }
}

/// A chain of elements that starts at a point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Face {
    /// Where it starts.
    pub start: Point,
    /// Its elements; each starts where the one before ends.
    pub elements: Vec<RollElement>,
}

impl Face {
    /// A face that starts here.
    pub(super) const fn at(start: Point) -> Self {
        Self { start, elements: Vec::new() }
    }

    /// Where it ends so far.
    pub(super) fn end(&self) -> Point {
        self.elements.last().map_or(self.start, |e| e.segment.end())
    }

    /// Goes on straight.
    pub(super) fn line_to(&mut self, to: Point, name: ElementName) {
        if self.end().distance(to) > NOTHING_MM {
            self.elements.push(RollElement::new(Segment::line(self.end(), to), name));
        }
    }

    /// Goes on along an arc; straight to its start if that is elsewhere.
    pub(super) fn arc(&mut self, start: Point, end: Point, center: Point, ccw: bool, name: ElementName) {
        self.line_to(start, name);
        let start = self.end();
        self.elements.push(RollElement::new(Segment::Arc { start, end, center, ccw }, name));
    }

    /// Moves its end: the last line runs to `to` instead; behind an arc a line is added.
    pub(super) fn move_end(&mut self, to: Point, name: ElementName) {
        match self.elements.last_mut() {
            Some(RollElement { segment: Segment::Line { end, .. }, .. }) => *end = to,
            _ => self.line_to(to, name),
        }
    }

    /// The mirror image at z = 0, from its end to its start.
    pub(super) fn mirrored(&self) -> Vec<RollElement> {
        self.elements.iter().rev().map(|e| e.mapped(|s| s.mirrored_at_z(0.0).reversed())).collect()
    }
}
