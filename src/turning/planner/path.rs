//! Builds the moves of an operation; knows where the tool is and what it cut.

use super::chain::Chain;
use super::conditions::Conditions;
use super::link::link;
use super::trace::one_direction;
use crate::geometry::{Point, Segment};
use crate::turning::{Cut, CutMove};

/// Moves shorter than this are left out, mm: half of a control's smallest step.
const NO_MOVE_MM: f64 = 0.0005;

/// The moves of one operation so far.
#[derive(Debug, Clone)]
pub(super) struct Path<'a> {
    conditions: &'a Conditions,
    /// Where the programmed point is.
    pub(super) at: Point,
    pub(super) moves: Vec<CutMove>,
    /// Where it went while cutting.
    pub(super) cuts: Vec<Segment>,
    /// Where the tool is changed.
    home: Point,
    /// How many moves had been made whenever it was back there.
    homes: Vec<usize>,
}

impl<'a> Path<'a> {
    /// No moves yet; the tool is at `at`, where it is changed.
    pub(super) const fn new(conditions: &'a Conditions, at: Point) -> Self {
        Self { conditions, at, moves: Vec::new(), cuts: Vec::new(), home: at, homes: Vec::new() }
    }

    /// Through air to `to`.
    pub(super) fn rapid(&mut self, to: Point) {
        if self.at.distance(to) >= NO_MOVE_MM {
            self.moves.push(CutMove::Rapid { to });
            self.at = to;
        }
    }

    /// Cutting, straight to `to`.
    pub(super) fn line(&mut self, to: Point) {
        self.line_at(to, self.conditions.cut(self.at.r, to.r));
    }

    /// Cutting, straight to `to`, with a feed and speed of its own.
    pub(super) fn line_at(&mut self, to: Point, cut: Cut) {
        if self.at.distance(to) < NO_MOVE_MM {
            return;
        }
        match (self.moves.last_mut(), self.cuts.last_mut()) {
            (Some(CutMove::Line { to: end, cut: same }), Some(Segment::Line { start, end: last }))
                if *same == cut && one_direction(*start, *last, to) =>
            {
                (*end, *last) = (to, to);
            }
            _ => {
                self.cuts.push(Segment::line(self.at, to));
                self.moves.push(CutMove::Line { to, cut });
            }
        }
        self.at = to;
    }

    /// Cutting, along a segment that begins where the tool is.
    pub(super) fn along(&mut self, segment: &Segment) {
        match *segment {
            Segment::Line { end, .. } => self.line(end),
            Segment::Arc { start, end, center, ccw } => {
                if start.distance(end) >= NO_MOVE_MM {
                    self.cuts.push(*segment);
                    self.moves.push(CutMove::Arc { to: end, center, ccw, cut: self.conditions.cut(start.r, end.r) });
                    self.at = end;
                }
            }
        }
    }

    /// Back to where the tool is changed.
    pub(super) fn home(&mut self, air: &Chain, ceiling: f64) {
        link(self, self.home, air, ceiling);
        self.homes.push(self.moves.len());
    }

    /// Moves since the tool was where it is changed.
    pub(super) fn since_home(&self) -> usize {
        self.moves.len() - self.homes.last().copied().unwrap_or(0)
    }

    /// The moves from home to home.
    pub(super) fn rounds(mut self) -> Vec<Vec<CutMove>> {
        let mut rounds = Vec::new();
        for &from in self.homes.iter().rev() {
            rounds.push(self.moves.split_off(from.min(self.moves.len())));
        }
        rounds.push(self.moves);
        rounds.retain(|moves| moves.iter().any(|m| !matches!(m, CutMove::Rapid { .. })));
        rounds.reverse();
        rounds
    }

    /// A threading pass to `to`; what it cuts is not taken from the stock, for the crest stays.
    pub(super) fn thread(&mut self, pass: CutMove, to: Point) {
        self.moves.push(pass);
        self.at = to;
    }

    /// A move that ends where it began, such as a thread.
    pub(super) fn push(&mut self, cycle: CutMove) {
        self.moves.push(cycle);
    }
}
