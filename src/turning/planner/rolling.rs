//! A concave stretch of a body rolled along one piece of a surface: the sum of the two.
//!
//! Sums of concave functions follow the directions that they face: what of the body faces further to the left than the piece
//! does is put on the piece's left end, what faces further to the right on its right end, and between them edges are moved
//! along the piece, the piece is moved to corners of the body, and radii of roundings are added.

use super::chain::Chain;
use super::piece::{Form, Piece, SAME_MM};
use super::shape::{Concave, Edge, Facing};
use crate::geometry::Point;

/// A piece of a surface, ready to be rolled along.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    piece: Piece,
    left: Point,
    right: Point,
    /// Where it faces at its left and at its right end.
    first: Facing,
    last: Facing,
    /// Its largest value, mm.
    pub(super) top: f64,
}

/// What of a sum is wanted, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    pub(super) z0: f64,
    pub(super) z1: f64,
}

/// A sum as it is made, from left to right.
struct Sum<'a> {
    way: &'a Way,
    window: Window,
    /// True when the line has been passed; an arc is passed bit by bit.
    walked: bool,
    out: &'a mut Vec<Piece>,
}

impl Way {
    pub(super) fn of(piece: &Piece) -> Self {
        let (first, last) = piece.facings();
        Self { piece: *piece, left: piece.left(), right: piece.right(), first, last, top: piece.highest() }
    }

    /// Where it begins.
    pub(super) const fn z0(&self) -> f64 {
        self.piece.z0
    }

    /// Where it ends.
    pub(super) const fn z1(&self) -> f64 {
        self.piece.z1
    }

    /// True if the next piece begins where this one ends.
    pub(super) fn leads_to(&self, next: &Self) -> bool {
        self.right.distance(next.left) <= SAME_MM
    }

    /// Where the body's reference point is while it touches an arc at the place that faces so; of a line it is not asked.
    fn touching(&self, facing: Facing) -> Point {
        match self.piece.form {
            Form::Arc { center, radius, .. } => {
                Point::new(center.z + radius * facing.cos, center.r + radius * facing.sin)
            }
            Form::Line { .. } => self.left,
        }
    }
}

impl Window {
    /// Everywhere.
    pub(super) const ALL: Self = Self { z0: f64::NEG_INFINITY, z1: f64::INFINITY };
}

impl Concave {
    /// Writes the sum of this stretch with a piece of a surface, as far as it is wanted; of a hollow that `goes_on` from a piece
    /// before it without what that gives: the stretch on the place where the two meet.
    pub(super) fn roll(&self, way: &Way, goes_on: bool, window: Window, out: &mut Vec<Piece>) {
        out.clear();
        if let Form::Arc { center, radius, upper: false } = way.piece.form {
            self.roll_in_hollow(way, goes_on, window, (center, radius), out);
            return;
        }
        let mut sum = Sum { way, window, walked: false, out };
        let mut before = Facing::LEFT;
        for (edge, part) in self.edges.iter().zip(&self.chain.pieces) {
            sum.corner(edge.start, before, edge);
            match edge.rounding {
                None => sum.edge(part, edge.first),
                Some((center, radius)) => sum.rounding(part, edge, center, radius),
            }
            before = edge.last;
        }
        sum.end(self.end, before);
    }

    /// In a hollow the ends hold the body off; between them only roundings of a smaller radius and sharp corners touch.
    fn roll_in_hollow(
        &self,
        way: &Way,
        goes_on: bool,
        window: Window,
        (center, radius): (Point, f64),
        out: &mut Vec<Piece>,
    ) {
        let mut over = self.put_on(way.right, window);
        if !goes_on {
            over = self.put_on(way.left, window).max(&over);
        }
        let mut before = Facing::LEFT;
        let mut touch = |from: Facing, to: Facing, rounding: f64, middle: Point| {
            let (low, high) = (way.first.further_left(to), way.last.further_right(from));
            let left = radius - rounding;
            if left <= 0.0 || low.slope >= high.slope {
                return;
            }
            let middle = Point::new(center.z + middle.z, center.r + middle.r);
            let form = Form::Arc { center: middle, radius: left, upper: false };
            let touching = Piece { z0: middle.z - left * low.cos, z1: middle.z - left * high.cos, form };
            if let Some(touching) = touching.clipped(window.z0, window.z1) {
                over = over.max(&Chain { pieces: vec![touching] });
            }
        };
        for edge in &self.edges {
            touch(before, edge.first, 0.0, edge.start);
            if let Some((center, radius)) = edge.rounding {
                touch(edge.first, edge.last, radius, center);
            }
            before = edge.last;
        }
        touch(before, Facing::RIGHT, 0.0, self.end);
        out.append(&mut over.pieces);
    }

    /// The stretch put on one point.
    pub(super) fn put_on(&self, p: Point, window: Window) -> Chain {
        let pieces = self.chain.pieces.iter().map(|piece| piece.shifted(p.z, p.r));
        Chain { pieces: pieces.filter_map(|piece| piece.clipped(window.z0, window.z1)).collect() }
    }
}

impl Sum<'_> {
    fn push(&mut self, piece: &Piece) {
        self.out.extend(piece.clipped(self.window.z0, self.window.z1));
    }

    /// Part of the body between two positions on it, put on a point.
    fn put(&mut self, part: &Piece, z0: f64, z1: f64, on: Point) {
        if let Some(part) = part.clipped(z0, z1) {
            self.push(&part.shifted(on.z, on.r));
        }
    }

    /// What of the piece faces between two directions, with a corner of the body on it.
    fn corner(&mut self, corner: Point, before: Facing, next: &Edge) {
        if let Form::Line { .. } = self.way.piece.form {
            let slope = self.way.first.slope;
            let turned = next.first.slope < slope || (next.rounding.is_some() && next.first.slope <= slope);
            if !self.walked && turned {
                self.line(corner);
            }
        } else {
            self.arc(corner, 0.0, before, next.first);
        }
    }

    /// The line with a point of the body on it.
    fn line(&mut self, corner: Point) {
        let at = |end: Point| Point::new(end.z + corner.z, end.r + corner.r);
        let piece = Piece::line(at(self.way.left), at(self.way.right));
        self.push(&piece);
        self.walked = true;
    }

    /// What of an arc faces between two directions, about a centre that is moved, and with a rounding's radius added.
    fn arc(&mut self, by: Point, more: f64, from: Facing, to: Facing) {
        let Form::Arc { center, radius, .. } = self.way.piece.form else { return };
        let (from, to) = (self.way.first.further_right(from), self.way.last.further_left(to));
        if from.slope > to.slope {
            let (center, radius) = (Point::new(center.z + by.z, center.r + by.r), radius + more);
            let (z0, z1) = (center.z + radius * from.cos, center.z + radius * to.cos);
            if z1 - z0 > SAME_MM {
                self.push(&Piece { z0, z1, form: Form::Arc { center, radius, upper: true } });
            }
        }
    }

    /// A straight edge of the body. Behind a line that has been passed it is on the right, even if it faces further to the left
    /// by a rounding.
    fn edge(&mut self, part: &Piece, facing: Facing) {
        let on = if self.walked {
            self.way.right
        } else if facing.slope >= self.way.first.slope {
            self.way.left
        } else if facing.slope <= self.way.last.slope {
            self.way.right
        } else {
            self.way.touching(facing)
        };
        self.push(&part.shifted(on.z, on.r));
    }

    /// A rounding of the body.
    fn rounding(&mut self, part: &Piece, edge: &Edge, center: Point, radius: f64) {
        let (first, last) = (self.way.first, self.way.last);
        let place = |facing: Facing| center.z + radius * facing.cos;
        let on_left = if edge.last.slope >= first.slope { part.z1 } else { place(first) };
        if edge.first.slope > first.slope && !self.walked {
            self.put(part, part.z0, on_left, self.way.left);
        }
        if let Form::Line { .. } = self.way.piece.form {
            if !self.walked && edge.first.slope > first.slope && edge.last.slope < first.slope {
                self.line(Point::new(on_left, part.at(on_left)));
            }
        } else {
            self.arc(center, radius, edge.first, edge.last);
        }
        if edge.last.slope < last.slope {
            let on_right = if edge.first.slope <= last.slope { part.z0 } else { place(last) };
            self.put(part, on_right, part.z1, self.way.right);
        }
    }

    /// What of the piece is left when the body has no more edges.
    fn end(&mut self, corner: Point, before: Facing) {
        if let Form::Line { .. } = self.way.piece.form {
            if !self.walked {
                self.line(corner);
            }
        } else {
            self.arc(corner, 0.0, before, Facing::RIGHT);
        }
    }
}
