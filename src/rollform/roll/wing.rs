//! Both roll faces along the strip, from the drive surface outwards to the right.

use super::RollElement;
use super::face::{Face, StripFace};
use super::opening::Openings;
use super::relief::reliefs;
use super::transition::{inner, outer, plain};
use crate::document::{ElementName, Side};
use crate::geometry::{Point, Segment};
use crate::rollform::strip::{Piece, normal};

/// Where a wing starts: both faces of the strip there, and its direction outwards.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Start {
    pub bottom: Point,
    pub top: Point,
    pub heading_rad: f64,
}

impl Start {
    /// The same in the mirror.
    pub(super) fn mirrored(self) -> Self {
        let mirror = |p: Point| p.mirrored_at_z(0.0);
        Self { bottom: mirror(self.bottom), top: mirror(self.top), heading_rad: -self.heading_rad }
    }

    /// A face that stands off by a relief.
    fn face(self, of: StripFace, relief: f64) -> Point {
        let up = normal(self.heading_rad) * relief;
        match of {
            StripFace::Bottom => self.bottom - up,
            StripFace::Top => self.top + up,
        }
    }
}

/// Both faces on one side, seen as if it were the right one.
pub(super) struct Wing {
    /// Which side it is.
    pub side: Side,
    /// Where it starts.
    start: Start,
    /// The pieces from the inside outwards.
    pub pieces: Vec<Piece>,
    /// Face of the bottom roll.
    pub bottom: Face,
    /// Face of the top roll.
    pub top: Face,
}

impl Wing {
    /// The faces along these pieces, of which the first `driven` drive.
    pub(super) fn new(side: Side, pieces: Vec<Piece>, driven: usize, start: Start, openings: Openings) -> Self {
        let reliefs = reliefs(&pieces, driven, openings);
        let mut relief = reliefs.start;
        let mut bottom = Face::at(start.face(StripFace::Bottom, relief.bottom));
        let mut top = Face::at(start.face(StripFace::Top, relief.top));
        for (piece, change) in pieces.iter().zip(&reliefs.changes) {
            let Some(new) = *change else {
                plain(&mut bottom, piece, StripFace::Bottom, relief.bottom);
                plain(&mut top, piece, StripFace::Top, relief.top);
                continue;
            };
            let outside = StripFace::outer(piece);
            let (outer_face, inner_face) = match outside {
                StripFace::Bottom => (&mut bottom, &mut top),
                StripFace::Top => (&mut top, &mut bottom),
            };
            let fillet = outer(outer_face, piece, relief.of(outside), new.of(outside));
            let inside = outside.other();
            if new.of(inside) == relief.of(inside) {
                plain(inner_face, piece, inside, relief.of(inside));
            } else {
                inner(inner_face, piece, relief.of(inside), openings.clearance, fillet);
            }
            relief = new;
        }
        Self { side, start, pieces, bottom, top }
    }

    /// Direction of the strip at its outer end, radians.
    pub(super) fn end_heading_rad(&self) -> f64 {
        self.pieces.last().map_or(self.start.heading_rad, Piece::end_heading_rad)
    }

    /// Where both wings meet.
    pub(super) const fn start_z(&self) -> f64 {
        self.top.start.z
    }

    /// The outline of the strip as the rolls see it: both faces and the edge.
    pub(super) fn outline(&self) -> Vec<RollElement> {
        let edge = Segment::line(self.bottom.end(), self.top.end());
        let edge = RollElement::new(edge, ElementName::Edge { side: self.side });
        self.bottom.elements.iter().chain(&self.top.elements).cloned().chain([edge]).collect()
    }

    /// True if the strip turns back under or over itself somewhere.
    pub(super) fn overhangs(&self) -> bool {
        /// Directions that turn back by less are upright, as cosine.
        const UPRIGHT: f64 = 1e-9;
        self.pieces.iter().any(|p| p.heading_rad.cos().min(p.end_heading_rad().cos()) < -UPRIGHT)
    }
}
