//! A body that is pushed against a function of z: its upper boundary in concave stretches, ready to be rolled along it.

use super::chain::Chain;
use super::outline::{Turn, upper_pieces};
use super::piece::{Form, Piece, SAME_MM};
use crate::geometry::{Contour, Point};

/// Normals closer than this are parallel, radians: rounding of angles.
const SAME_ANGLE: f64 = 1e-12;

/// Where a place of a boundary faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Facing {
    /// Rise over way; it falls along a stretch that turns to the right. Infinite where the boundary is upright.
    pub(super) slope: f64,
    /// Direction of its normal: along z.
    pub(super) cos: f64,
    /// Direction of its normal: upwards.
    pub(super) sin: f64,
}

/// One side of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edge {
    /// Where it begins.
    pub(super) start: Point,
    /// Where it faces at its beginning and at its end.
    pub(super) first: Facing,
    pub(super) last: Facing,
    /// Centre and radius of a rounding, mm.
    pub(super) rounding: Option<(Point, f64)>,
}

/// A stretch of a boundary along which the normal only turns to the right.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Concave {
    pub(super) start: Point,
    /// Where it ends.
    pub(super) end: Point,
    /// Its sides.
    pub(super) edges: Vec<Edge>,
    /// The same as a function.
    pub(super) chain: Chain,
    /// Its largest value, mm.
    pub(super) top: f64,
}

/// The upper boundary of a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Shape {
    pub(super) parts: Vec<Concave>,
}

impl Facing {
    /// To the left, as what stands upright on a stretch's left end does.
    pub(super) const LEFT: Self = Self { slope: f64::INFINITY, cos: -1.0, sin: 0.0 };

    /// To the right.
    pub(super) const RIGHT: Self = Self { slope: f64::NEG_INFINITY, cos: 1.0, sin: 0.0 };

    /// The one of two that faces further to the left.
    pub(super) fn further_left(self, other: Self) -> Self {
        if other.slope > self.slope { other } else { self }
    }

    /// The one of two that faces further to the right.
    pub(super) fn further_right(self, other: Self) -> Self {
        if other.slope < self.slope { other } else { self }
    }

    /// True if the boundary turns to the right from here to `next`, or goes straight on.
    fn turns_right(self, next: Self) -> bool {
        next.slope.atan() <= self.slope.atan() + SAME_ANGLE.sqrt()
    }
}

impl Piece {
    /// Where the piece faces at its left and at its right end.
    pub(super) fn facings(&self) -> (Facing, Facing) {
        match self.form {
            Form::Line { p, q } => {
                let (dz, dr) = (q.z - p.z, q.r - p.r);
                let length = (dz * dz + dr * dr).sqrt();
                let facing = Facing { slope: dr / dz, cos: -dr / length, sin: dz / length };
                (facing, facing)
            }
            Form::Arc { center, radius, upper } => {
                let at = |z: f64| {
                    let along = (if upper { z - center.z } else { center.z - z }).clamp(-radius, radius);
                    let up = ((radius - along) * (radius + along)).sqrt();
                    Facing { slope: -along / up, cos: along / radius, sin: up / radius }
                };
                (at(self.z0), at(self.z1))
            }
        }
    }
}

impl Shape {
    /// The upper boundary of contours turned over.
    pub(super) fn of<'a>(contours: impl IntoIterator<Item = &'a Contour>, turn: Turn) -> Self {
        let mut parts = Vec::new();
        for contour in contours {
            add_parts(&upper_pieces(contour, turn), &mut parts);
        }
        Self { parts }
    }

    /// The upper boundary of a contour turned over, and everything within `by` mm of it.
    pub(super) fn grown(contour: &Contour, turn: Turn, by: f64) -> Self {
        // Sides that overhang lie over one another.
        let sides = upper_pieces(contour, turn).into_iter().map(|side| Chain { pieces: vec![side] });
        let sharp = Chain::largest_of(sides.collect());
        let mut parts = Vec::new();
        add_parts(&Self::disc(by).over(&sharp).pieces, &mut parts);
        Self { parts }
    }

    /// This boundary together with another one.
    pub(super) fn and(mut self, other: Self) -> Self {
        self.parts.extend(other.parts);
        self
    }

    /// A disc about the origin.
    pub(super) fn disc(radius: f64) -> Self {
        let form = Form::Arc { center: Point::default(), radius, upper: true };
        let mut parts = Vec::new();
        add_parts(&[Piece { z0: -radius, z1: radius, form }], &mut parts);
        Self { parts }
    }

    /// The boundary given as a function.
    pub(super) fn of_chain(chain: &Chain) -> Self {
        let mut parts = Vec::new();
        add_parts(&chain.pieces, &mut parts);
        Self { parts }
    }

    /// Largest value of the boundary from a position on, mm; −∞ without any.
    pub(super) fn top(&self, from_z: f64) -> f64 {
        let pieces = self.parts.iter().flat_map(|p| &p.chain.pieces).filter(|p| p.z1 > from_z);
        pieces.map(Piece::highest).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Largest value of the boundary between two positions, mm; −∞ without any.
    pub(super) fn highest(&self, z0: f64, z1: f64) -> f64 {
        self.parts.iter().map(|part| part.chain.highest(z0, z1)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Where the boundary begins and where it ends.
    pub(super) fn extent(&self) -> (f64, f64) {
        let ends = self.parts.iter().map(|part| (part.z0(), part.z1()));
        ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(z0, z1), (a, b)| (z0.min(a), z1.max(b)))
    }

    /// The boundary as a function.
    #[cfg(test)]
    pub(super) fn chain(&self) -> Chain {
        Chain::largest(&self.parts.iter().map(|p| p.chain.clone()).collect::<Vec<_>>())
    }
}

/// Groups pieces into stretches whose normals turn to the right.
fn add_parts(pieces: &[Piece], parts: &mut Vec<Concave>) {
    let mut current: Vec<Piece> = Vec::new();
    for piece in pieces {
        if let Some(last) = current.last() {
            let joined = last.right().distance(piece.left()) <= SAME_MM.sqrt() && piece.z0 >= last.z1 - SAME_MM;
            let turns_right = last.facings().1.turns_right(piece.facings().0);
            if !(joined && turns_right) {
                parts.extend(Concave::new(std::mem::take(&mut current)));
            }
        }
        current.push(*piece);
    }
    parts.extend(Concave::new(current));
}

impl Concave {
    fn new(pieces: Vec<Piece>) -> Option<Self> {
        let (start, end) = (pieces.first()?.left(), pieces.last()?.right());
        let top = pieces.iter().map(Piece::highest).fold(f64::NEG_INFINITY, f64::max);
        Some(Self { start, end, edges: pieces.iter().map(Edge::of).collect(), chain: Chain { pieces }, top })
    }

    /// Where the stretch begins.
    pub(super) const fn z0(&self) -> f64 {
        self.start.z
    }

    /// Where it ends.
    pub(super) const fn z1(&self) -> f64 {
        self.end.z
    }
}

impl Edge {
    /// The side that a line or the upper half of a circle is.
    fn of(piece: &Piece) -> Self {
        let (first, last) = piece.facings();
        let rounding = match piece.form {
            Form::Arc { center, radius, .. } => Some((center, radius)),
            Form::Line { .. } => None,
        };
        Self { start: piece.left(), first, last, rounding }
    }
}
