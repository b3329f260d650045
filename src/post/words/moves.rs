//! Moves of an operation to blocks.

use super::arc::{Piece, pieces};
use super::block::Line;
use super::grid::Counts;
use super::writer::Writer;
use crate::geometry::{Point, Segment, Vector};
use crate::machine::{ArcCenter, DwellWord};
use crate::turning::{Cut, CutMove};

/// Rapid.
pub(super) const G0: u32 = 0;
/// Straight at feed.
pub(super) const G1: u32 = 1;

impl Writer<'_> {
    /// Writes `moves`, each displaced by `by`, until the program is longer than anything could hold.
    pub(super) fn moves(&mut self, moves: &[CutMove], by: Vector) {
        for cut_move in moves {
            if self.blocks.len() > self.control.machine.limits.blocks_per_program {
                return;
            }
            self.cut_move(cut_move, by);
        }
    }

    fn cut_move(&mut self, cut_move: &CutMove, by: Vector) {
        match *cut_move {
            CutMove::Rapid { to } => self.rapid(to + by),
            CutMove::Line { to, cut } => self.straight(to + by, &cut),
            CutMove::Arc { to, center, ccw, cut } => {
                let arc = Segment::Arc { start: self.state.exact, end: to + by, center: center + by, ccw };
                self.arc(&arc, &cut);
            }
            CutMove::Thread { to_z, outside_radius, base_radius, pitch, depth_per_cut, rpm } => {
                let depths = (outside_radius + by.y, base_radius + by.y, depth_per_cut);
                self.whole_thread(to_z + by.x, depths, pitch, rpm);
            }
            CutMove::ThreadPass { to, lead, start_deg, rpm } => self.thread_pass(to + by, lead, start_deg, rpm),
            CutMove::Dwell { seconds } => self.dwell(seconds),
            CutMove::Repeat { count, step, ref body } => {
                for k in 0..count {
                    if self.blocks.len() > self.control.machine.limits.blocks_per_program {
                        return;
                    }
                    self.moves(body, by + step * f64::from(k));
                }
            }
        }
    }

    /// A rapid move; none where the tool is there already.
    pub(super) fn rapid(&mut self, to: Point) {
        let counts = self.control.grid.counts(to);
        if self.state.at != Some(counts) {
            let mut line = self.line();
            self.motion(&mut line, G0);
            self.position(&mut line, counts);
            self.push(line);
        }
        self.arrived(to, counts);
    }

    fn straight(&mut self, to: Point, cut: &Cut) {
        let radius = self.state.exact.r.abs().max(to.r.abs());
        self.spindle_for(cut, radius);
        let counts = self.control.grid.counts(to);
        if self.state.at != Some(counts) {
            self.line_block(counts, cut, radius);
        }
        self.arrived(to, counts);
    }

    fn line_block(&mut self, to: Counts, cut: &Cut, radius: f64) {
        let mut line = self.line();
        self.motion(&mut line, G1);
        self.position(&mut line, to);
        self.feed_word(&mut line, cut, radius);
        self.push(line);
        self.state.at = Some(to);
    }

    fn arc(&mut self, arc: &Segment, cut: &Cut) {
        let bounds = arc.bounds();
        let radius = bounds.min.r.abs().max(bounds.max.r.abs());
        self.spindle_for(cut, radius);
        let from = self.state.at.unwrap_or_else(|| self.control.grid.counts(arc.start()));
        for piece in pieces(arc, from, &self.control.grid, &self.control.arcs) {
            match piece {
                Piece::Line(to) => self.line_block(to, cut, radius),
                Piece::Arc { .. } => self.arc_block(&piece, cut, radius),
            }
        }
        self.arrived(arc.end(), self.control.grid.counts(arc.end()));
    }

    fn arc_block(&mut self, piece: &Piece, cut: &Cut, largest_radius: f64) {
        let Piece::Arc { to, center, radius, ccw } = *piece else { return };
        let control = self.control;
        let at = self.state.at.unwrap_or(to);
        let mut line = self.line();
        self.motion(&mut line, if ccw == control.words.g2_is_ccw { 2 } else { 3 });
        self.position(&mut line, to);
        let signed = |v: i64| if control.words.arc_center_signed { v } else { v.abs() };
        let (i, k) = match control.words.arc_center {
            ArcCenter::Radius => {
                line.length('R', radius);
                (None, None)
            }
            ArcCenter::Incremental => (Some(center.0), Some(center.1)),
            ArcCenter::Absolute => {
                let point = control.grid.displaced(control.grid.point(at), center.0, center.1);
                let (i, k) = control.grid.absolute(point);
                (Some(i), Some(k))
            }
        };
        if let (Some(i), Some(k)) = (i, k) {
            line.length('I', signed(i)).length('K', signed(k));
        }
        self.feed_word(&mut line, cut, largest_radius);
        self.push(line);
        self.state.at = Some(to);
    }

    /// Adds a motion word; G1 only where the control does not know it yet.
    pub(super) fn motion(&mut self, line: &mut Line<'_>, motion: u32) {
        if let Some(words) = self.pending.take() {
            line.code(&words).whole('G', motion);
        } else if motion == G1 && self.state.motion == Some(G1) {
            line.implied = "G1";
        } else {
            line.whole('G', motion);
        }
        self.state.motion = Some(motion);
    }

    /// Adds the position words that say something new.
    pub(super) fn position(&mut self, line: &mut Line<'_>, to: Counts) {
        match (self.state.at, self.control.words.incremental) {
            (Some(at), true) => {
                if at.x != to.x {
                    line.length('U', to.x - at.x);
                }
                if at.z != to.z {
                    line.length('W', to.z - at.z);
                }
            }
            (at, _) => {
                if at.is_none_or(|at| at.x != to.x) {
                    line.length('X', to.x);
                }
                if at.is_none_or(|at| at.z != to.z) {
                    line.length('Z', to.z);
                }
            }
        }
    }

    fn feed_word(&mut self, line: &mut Line<'_>, cut: &Cut, radius: f64) {
        let control = self.control;
        let counts = control.feed_counts(cut, radius);
        if counts <= 0 {
            let (text, unit) = (control.feed.text(1), control.feed_unit());
            let message = format!("The feed rounds to 0 {unit}; the smallest that can be written is {text} {unit}.");
            line.fault("feed-too-small", message, "Raise the feed or the spindle speed.");
        }
        if self.state.feed != Some(counts) {
            line.number('F', control.feed, counts);
            self.state.feed = Some(counts);
        }
    }

    fn dwell(&mut self, seconds: f64) {
        let control = self.control;
        let mut line = self.line();
        line.whole('G', 4);
        match control.words.dwell {
            DwellWord::PMilliseconds => {
                line.word(&format!("P{:.0}", seconds * 1000.0));
            }
            DwellWord::PSeconds => {
                line.word(&format!("P{seconds:.3}"));
            }
            DwellWord::XSeconds => {
                let format = control.grid.format;
                line.number('X', format, format.counts(seconds));
            }
        }
        self.push(line);
    }

    pub(super) fn arrived(&mut self, exact: Point, counts: Counts) {
        self.state.exact = exact;
        self.state.at = Some(counts);
    }
}
