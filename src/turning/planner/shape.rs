//! A body that is pushed against a function of z: its upper boundary in concave stretches, ready for [`dilate`](super::dilate).

use super::chain::Chain;
use super::outline::{Turn, upper_pieces};
use super::piece::{Form, Piece, SAME_MM};
use crate::geometry::{Contour, Point};
use std::f64::consts::{FRAC_PI_2, PI};

/// Normals closer than this are parallel, radians: rounding of angles.
const SAME_ANGLE: f64 = 1e-12;

/// One side of an outline by its normals, which turn from pointing left (π) to pointing right (0) along growing z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Element {
    /// A straight edge.
    Line {
        /// Direction of its normal.
        normal: f64,
        /// Its length, mm.
        length: f64,
    },
    /// A rounding.
    Arc {
        /// Direction of the normal where it begins, the larger one.
        from: f64,
        /// Direction of the normal where it ends.
        to: f64,
        /// Its radius, mm.
        radius: f64,
        /// Its centre.
        center: Point,
    },
}

/// A place of a boundary about which its normal turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rounding {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) radius: f64,
    pub(super) center: Point,
}

/// A stretch of a boundary along which the normal only turns to the right.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Concave {
    pub(super) start: Point,
    pub(super) elements: Vec<Element>,
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

impl Element {
    /// The element of a line or of the upper half of a circle.
    pub(super) fn of(piece: &Piece) -> Self {
        match piece.form {
            Form::Line { p, q } => {
                let (a, b) = (piece.left(), piece.right());
                Self::Line { normal: FRAC_PI_2 + (q.r - p.r).atan2(q.z - p.z), length: a.distance(b) }
            }
            Form::Arc { center, radius, .. } => {
                let normal = |z: f64| ((z - center.z) / radius).clamp(-1.0, 1.0).acos();
                Self::Arc { from: normal(piece.z0), to: normal(piece.z1), radius, center }
            }
        }
    }

    const fn first_normal(&self) -> f64 {
        match *self {
            Self::Line { normal, .. } => normal,
            Self::Arc { from, .. } => from,
        }
    }

    const fn last_normal(&self) -> f64 {
        match *self {
            Self::Line { normal, .. } => normal,
            Self::Arc { to, .. } => to,
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
        let sharp = Chain { pieces: upper_pieces(contour, turn) };
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
            let turns_right = Element::of(piece).first_normal() <= Element::of(last).last_normal() + SAME_ANGLE.sqrt();
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
        let start = pieces.first()?.left();
        let top = pieces.iter().map(Piece::highest).fold(f64::NEG_INFINITY, f64::max);
        Some(Self { start, elements: pieces.iter().map(Element::of).collect(), chain: Chain { pieces }, top })
    }

    /// Where the stretch begins.
    pub(super) const fn z0(&self) -> f64 {
        self.start.z
    }

    /// Where it ends.
    pub(super) fn z1(&self) -> f64 {
        self.chain.pieces.last().map_or(self.start.z, |p| p.z1)
    }

    /// The sum of this stretch with a line: what comes before the line's direction on its left end, the rest on its right end,
    /// and the line between.
    pub(super) fn along_line(&self, piece: &Piece) -> Chain {
        let (a, b, normal) = (piece.left(), piece.right(), Element::of(piece).first_normal());
        let mut pieces = Vec::with_capacity(self.elements.len() + 2);
        let mut walked = false;
        let line = |pieces: &mut Vec<Piece>, corner: Point| {
            let at = |end: Point| Point::new(end.z + corner.z, end.r + corner.r);
            pieces.push(Piece::line(at(a), at(b)));
        };
        for (element, part) in self.elements.iter().zip(&self.chain.pieces) {
            if !walked && element.last_normal() < normal {
                walked = true;
                let place = match *element {
                    Element::Arc { from, radius, center, .. } if from > normal => center.z + radius * normal.cos(),
                    _ => part.z0,
                };
                pieces.extend(part.clipped(f64::NEG_INFINITY, place).map(|p| p.shifted(a.z, a.r)));
                line(&mut pieces, Point::new(place, part.at(place)));
                pieces.extend(part.clipped(place, f64::INFINITY).map(|p| p.shifted(b.z, b.r)));
                continue;
            }
            let end = if walked { b } else { a };
            pieces.push(part.shifted(end.z, end.r));
        }
        if !walked {
            let last = self.chain.pieces.last().map_or(self.start, Piece::right);
            line(&mut pieces, last);
        }
        Chain { pieces }
    }

    /// Every rounding of the stretch; a corner is one of no radius.
    pub(super) fn roundings(&self) -> impl Iterator<Item = Rounding> {
        let mut before = PI;
        let ends = self.chain.pieces.iter().map(|p| (p.left(), p.right()));
        let mut all = Vec::with_capacity(2 * self.elements.len() + 1);
        let mut last = self.start;
        for (element, (left, right)) in self.elements.iter().zip(ends) {
            all.push(Rounding { from: before, to: element.first_normal(), radius: 0.0, center: left });
            if let Element::Arc { from, to, radius, center } = *element {
                all.push(Rounding { from, to, radius, center });
            }
            before = element.last_normal();
            last = right;
        }
        all.push(Rounding { from: before, to: 0.0, radius: 0.0, center: last });
        all.into_iter().filter(|r| r.from - r.to > SAME_ANGLE.sqrt())
    }

    /// The sum of this stretch with a line or the upper half of a circle: the stretch's outline rolled along it.
    ///
    /// Sums of concave functions follow the normals: edges of equal direction are added, roundings add their radii.
    pub(super) fn rolled_along(&self, piece: &Piece) -> Chain {
        let other = Element::of(piece);
        let at = piece.left();
        let mut walk = Walk { at: Point::new(at.z + self.start.z, at.r + self.start.r), pieces: Vec::new() };
        let all = || self.elements.iter().chain([&other]);
        let mut normals: Vec<f64> = all().flat_map(|e| [e.first_normal(), e.last_normal()]).collect();
        normals.sort_by(|a, b| b.total_cmp(a));
        normals.dedup_by(|a, b| (*a - *b).abs() <= SAME_ANGLE);
        for (k, &normal) in normals.iter().enumerate() {
            let edge: f64 = all()
                .filter_map(|e| match *e {
                    Element::Line { normal: n, length } if (n - normal).abs() <= SAME_ANGLE => Some(length),
                    _ => None,
                })
                .sum();
            walk.line(normal, edge);
            if let Some(&next) = normals.get(k + 1) {
                let middle = f64::midpoint(normal, next);
                let radius: f64 = all()
                    .filter_map(|e| match *e {
                        Element::Arc { from, to, radius, .. } if from > middle && middle > to => Some(radius),
                        _ => None,
                    })
                    .sum();
                walk.arc(normal, next, radius);
            }
        }
        Chain { pieces: walk.pieces }
    }
}

/// Draws an outline by its normals.
struct Walk {
    at: Point,
    pieces: Vec<Piece>,
}

impl Walk {
    fn go(&mut self, to: Point, piece: Option<Piece>) {
        self.pieces.extend(piece.filter(|p| p.z1 - p.z0 > SAME_MM));
        self.at = to;
    }

    fn line(&mut self, normal: f64, length: f64) {
        if length > 0.0 {
            let to = Point::new(self.at.z + length * normal.sin(), self.at.r - length * normal.cos());
            self.go(to, Some(Piece::line(self.at, to)));
        }
    }

    fn arc(&mut self, from: f64, to: f64, radius: f64) {
        if radius > 0.0 {
            let on = |angle: f64| Point::new(radius * angle.cos(), radius * angle.sin());
            let (a, b) = (on(from.min(PI)), on(to.max(0.0)));
            let center = Point::new(self.at.z - a.z, self.at.r - a.r);
            let end = Point::new(center.z + b.z, center.r + b.r);
            let form = Form::Arc { center, radius, upper: true };
            self.go(end, Some(Piece { z0: self.at.z, z1: end.z, form }));
        }
    }
}
