//! Builds the moves of an operation; knows where the tool is, what it cut, and what is in its way.

use super::chain::{Chain, Run};
use super::conditions::Conditions;
use super::link::{CLEARANCE_MM, LEAN, go};
use super::piece::Piece;
use super::shape::Shape;
use super::surface::Surface;
use super::tool::{Cutter, HOLDER_CLEARANCE_MM};
use super::trace::one_direction;
use super::work::{AIR_MM, Work, covered_along, left_along};
use crate::geometry::{Bounds, Point, Segment};
use crate::turning::{Cut, CutMove};

/// Moves shorter than this are left out, mm: half of a control's smallest step.
const NO_MOVE_MM: f64 = 0.0005;

/// Overlap below which nothing is in the way, mm: rounding, for tools go along cut surfaces.
const TOUCH_MM: f64 = 1e-5;

/// A vertical move counts with this width, mm: a function of z needs one.
const UPRIGHT_MM: f64 = 1e-6;

/// Parts of an arc in which its chip is measured: for controls that cannot take it the post makes chords of it.
const CHIP_PARTS: u32 = 4;

/// The moves of one operation so far. Places are as the tool sees them; the moves are the machine's.
#[derive(Debug, Clone)]
pub(super) struct Path<'a> {
    conditions: &'a Conditions,
    cutter: &'a Cutter,
    /// The work as it is now.
    pub(super) work: Work,
    /// A height at which tools pass the work, mm.
    pub(super) ceiling: f64,
    /// Largest ratio of the two parts of a slanting move.
    pub(super) taper: f64,
    /// Where the programmed point is.
    pub(super) at: Point,
    moves: Vec<CutMove>,
    /// The last cut.
    last: Option<Segment>,
    /// Where the tool is changed.
    home: Point,
    /// How many moves had been made whenever it was back there.
    homes: Vec<usize>,
}

/// Where holder or a side that cannot cut would run into stock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Blocked {
    /// Which segment of the way.
    pub(super) index: usize,
    /// Positions of the programmed point.
    pub(super) zone: Run,
}

impl<'a> Path<'a> {
    /// No moves yet; the tool is at `home`, where it is changed.
    pub(super) fn new(
        conditions: &'a Conditions,
        cutter: &'a Cutter,
        work: &Work,
        home: Point,
        ceiling: f64,
        taper: f64,
    ) -> Self {
        let home = if cutter.turned { home.mirrored_at_z(0.0) } else { home };
        let work = work.seen_by(cutter);
        let (moves, homes) = (Vec::new(), Vec::new());
        Self { conditions, cutter, work, ceiling, taper, at: home, moves, last: None, home, homes }
    }

    /// The same tool as seen from the other end.
    pub(super) fn turn(&mut self, twin: &'a Cutter) {
        if twin.turned != self.cutter.turned {
            self.work = self.work.turned_round();
            self.at = self.at.mirrored_at_z(0.0);
            self.home = self.home.mirrored_at_z(0.0);
            self.last = None;
        }
        self.cutter = twin;
    }

    /// Through air to `to`, whatever is there: [`go`] looks first.
    pub(super) fn rapid(&mut self, to: Point) {
        if self.at.distance(to) >= NO_MOVE_MM {
            self.push(CutMove::Rapid { to });
            self.at = to;
        }
    }

    /// Cutting, straight to `to`.
    pub(super) fn line(&mut self, to: Point) {
        let segment = Segment::line(self.at, to);
        let low = self.swept(&segment);
        let cut = self.conditions.cut(self.at.r, to.r, self.chip_width(&segment, low.as_ref()));
        self.cut_line(to, cut, low);
    }

    /// Cutting, straight to `to`, with a feed and speed of its own.
    pub(super) fn line_at(&mut self, to: Point, cut: Cut) {
        self.cut_line(to, cut, self.swept(&Segment::line(self.at, to)));
    }

    /// Lengthens the line that the last move makes, or makes a new one; `low` is what is [`Path::swept`].
    fn cut_line(&mut self, to: Point, cut: Cut, low: Option<Chain>) {
        if self.at.distance(to) < NO_MOVE_MM {
            return;
        }
        let end = self.seen(to);
        match (self.moves.last_mut(), self.last.as_mut()) {
            (Some(CutMove::Line { to: before, cut: same }), Some(Segment::Line { start, end: last }))
                if *same == cut && one_direction(*start, *last, to) =>
            {
                (*before, *last) = (end, to);
            }
            _ => {
                self.push(CutMove::Line { to, cut });
                self.last = Some(Segment::line(self.at, to));
            }
        }
        self.take(&Segment::line(self.at, to), low);
        self.at = to;
    }

    /// Cutting, along a segment that begins where the tool is.
    pub(super) fn along(&mut self, segment: &Segment) {
        match *segment {
            Segment::Line { end, .. } => self.line(end),
            Segment::Arc { start, end, center, ccw } => {
                if start.distance(end) >= NO_MOVE_MM {
                    let low = self.swept(segment);
                    let cut = self.conditions.cut(start.r, end.r, self.chip_width(segment, low.as_ref()));
                    self.push(CutMove::Arc { to: end, center, ccw, cut });
                    self.last = Some(*segment);
                    self.take(segment, low);
                    self.at = end;
                }
            }
        }
    }

    /// Back to where the tool is changed.
    pub(super) fn home(&mut self) {
        go(self, self.home);
        self.homes.push(self.moves.len());
    }

    /// Moves so far.
    pub(super) const fn len(&self) -> usize {
        self.moves.len()
    }

    /// Moves since the tool was where it is changed.
    pub(super) fn since_home(&self) -> usize {
        self.moves.len() - self.homes.last().copied().unwrap_or(0)
    }

    /// The moves from home to home, and the work after them as the machine sees it.
    pub(super) fn done(mut self) -> (Vec<Vec<CutMove>>, Work) {
        let mut rounds = Vec::new();
        for &from in self.homes.iter().rev() {
            rounds.push(self.moves.split_off(from.min(self.moves.len())));
        }
        rounds.push(self.moves);
        rounds.retain(|moves| moves.iter().any(|m| !matches!(m, CutMove::Rapid { .. })));
        rounds.reverse();
        (rounds, if self.cutter.turned { self.work.turned_round() } else { self.work })
    }

    /// A threading pass to `to`; what it cuts is not taken from the stock, for the crest stays.
    pub(super) fn thread(&mut self, pass: CutMove, to: Point) {
        self.push(pass);
        self.at = to;
    }

    /// A move, or one that ends where it began such as a thread.
    pub(super) fn push(&mut self, m: CutMove) {
        self.moves.push(if self.cutter.turned { turned_round(m) } else { m });
        self.last = None;
    }

    fn seen(&self, p: Point) -> Point {
        if self.cutter.turned { p.mirrored_at_z(0.0) } else { p }
    }

    /// What the insert leaves below it along a segment, if there may be stock on the way.
    fn swept(&self, segment: &Segment) -> Option<Chain> {
        self.meets(segment).then(|| left_along(&self.cutter.edge, segment))
    }

    /// Takes away what the insert covers along a segment, and leaves what is [`Path::swept`].
    fn take(&mut self, segment: &Segment, swept: Option<Chain>) {
        if let Some(low) = swept {
            self.work.take(self.cutter, segment, &low);
        }
    }

    /// Width of the chip along a segment, mm, where the spindle's power asks for it: the mean of a line, the largest mean of an
    /// arc's parts.
    fn chip_width(&self, segment: &Segment, swept: Option<&Chain>) -> f64 {
        let Some(low) = swept.filter(|_| self.conditions.knows_power()) else { return 0.0 };
        let mut stock = self.work.stock.above(low);
        let Segment::Arc { center, ccw, .. } = *segment else {
            return self.taken(&stock, segment, low) / segment.length().max(NO_MOVE_MM);
        };
        let at = |k: u32| segment.point_at(f64::from(k) / f64::from(CHIP_PARTS));
        let mut width = |k: u32| {
            let part = Segment::Arc { start: at(k), end: at(k + 1), center, ccw };
            let low = left_along(&self.cutter.edge, &part);
            let area = self.taken(&stock, &part, &low);
            stock.cut(&low);
            area / part.length().max(NO_MOVE_MM)
        };
        (0..CHIP_PARTS).map(&mut width).fold(0.0, f64::max)
    }

    /// Area that the insert takes of `stock` and of what hangs over it along a segment, mm²; `low` is what is [`Path::swept`].
    fn taken(&self, stock: &Chain, segment: &Segment, low: &Chain) -> f64 {
        let Some((z0, z1)) = low.ends() else { return 0.0 };
        let hanging = &self.work.hanging;
        let is_over = hanging.is_over(z0, z1);
        let over = is_over.then(|| hanging.area_within(low, &covered_along(&self.cutter.top, segment)));
        stock.area_over(low) + over.unwrap_or(0.0)
    }

    /// True if there may be stock on the way along a segment.
    fn meets(&self, segment: &Segment) -> bool {
        let bounds = segment.bounds();
        let (z0, z1) = self.window(bounds.min.z, bounds.max.z);
        self.work.cover.rises_above(z0, z1, bounds.min.r + self.cutter.low)
    }

    /// What lies within reach of the tool while its programmed point is between two positions.
    fn window(&self, z0: f64, z1: f64) -> (f64, f64) {
        (z0 + self.cutter.extent.0, z1 + self.cutter.extent.1)
    }

    /// How low the insert may go between two positions without touching stock; only what is above `above` counts.
    pub(super) fn touch(&self, z0: f64, z1: f64, above: f64) -> Chain {
        let (from, to) = self.window(z0, z1);
        let stock = self.work.stock.higher(from, to, above + self.cutter.low);
        self.cutter.insert.over_within(&stock, z0, z1, above).clipped(z0, z1)
    }

    /// How low the tool may go between two positions without touching stock or what holds it; only what is above `above`
    /// counts, and where that is nothing there is no value.
    pub(super) fn air(&self, z0: f64, z1: f64, above: f64) -> Chain {
        self.air_over(&self.work.cover, (z0, z1), above)
    }

    /// How far a tool that leans away from a wall on its way out, by `furthest` mm at most, does so before it is above all that is in
    /// the machine, mm.
    pub(super) fn lean(&self, furthest: f64) -> f64 {
        let (z0, z1) = self.window(self.at.z, self.at.z + furthest);
        let over = self.work.highest.max(self.work.passed.highest(z0, z1)) - self.cutter.low + HOLDER_CLEARANCE_MM;
        furthest.min(LEAN * (over + CLEARANCE_MM - self.at.r).max(0.0))
    }

    /// True if something hangs over within reach of the tool between two positions.
    pub(super) fn has_hanging(&self, z0: f64, z1: f64) -> bool {
        let (from, to) = self.window(z0, z1);
        self.work.hanging.is_over(from, to)
    }

    /// The same as [`Path::air`] from where the tool is: without what hangs over it, which [`Path::hangs_over`] knows.
    pub(super) fn air_here(&self, z0: f64, z1: f64, above: f64) -> Chain {
        self.air_over(&self.work.stock, (z0, z1), above)
    }

    /// How low the tool may go over `stock` and what holds it; what is a clearance below `above` is nobody's concern.
    fn air_over(&self, stock: &Surface, (z0, z1): (f64, f64), above: f64) -> Chain {
        let ((from, to), low) = (self.window(z0, z1), above + self.cutter.low);
        let solid = stock.higher(from, to, low).max(&self.work.passed.higher(from, to, low));
        self.cutter.body.over_within(&solid, z0 - AIR_MM, z1 + AIR_MM, above - 2.0 * CLEARANCE_MM)
    }

    /// True if the tool would run into something that hangs over it on its straight way to `to`.
    pub(super) fn hangs_over(&self, to: Point) -> bool {
        let (from, end) = self.window(self.at.z.min(to.z), self.at.z.max(to.z));
        if !self.work.hanging.is_over(from, end) {
            return false;
        }
        let way = Segment::line(self.at, to);
        let (high, low) = (covered_along(&self.cutter.whole, &way), left_along(&self.cutter.below, &way));
        self.work.hanging.meets(&low, &high, TOUCH_MM)
    }

    /// The first place of a way where holder or a side that cannot cut runs into stock.
    pub(super) fn blocked(&self, way: &[Segment]) -> Option<Blocked> {
        let bounds = way.iter().map(Segment::bounds).reduce(Bounds::union)?;
        let (from, to) = self.window(bounds.min.z, bounds.max.z);
        let (guarded, reach) = (self.cutter.guard_low, self.cutter.ahead_low);
        let floor = bounds.min.r + guarded.min(reach);
        if !self.work.cover.rises_above(from, to, floor) {
            return None;
        }
        let mut stock = self.work.cover.clone();
        for (index, segment) in way.iter().enumerate() {
            let low = segment.bounds().min.r;
            let piece = Piece::of(segment);
            let ahead = piece.and_then(|p| run_into(&self.cutter.ahead, &stock, &p, low + reach));
            stock.uncover(&left_along(&self.cutter.cutting, segment), &covered_along(&self.cutter.top, segment));
            let at = segment.bounds();
            let piece = piece.unwrap_or_else(|| Piece::level(at.min.z - UPRIGHT_MM, at.min.z + UPRIGHT_MM, at.min.r));
            let beside = run_into(&self.cutter.guard, &stock, &piece, low + guarded);
            let zone = [ahead, beside].into_iter().flatten().max_by(|a, b| a.z1.total_cmp(&b.z1));
            if let Some(zone) = zone {
                return Some(Blocked { index, zone });
            }
        }
        None
    }
}

/// The rightmost stretch of `way` where `shape` on it runs into what of `stock` is above `above`.
fn run_into(shape: &Shape, stock: &Surface, way: &Piece, above: f64) -> Option<Run> {
    let near = stock.reached(shape, way, above);
    if near.pieces.is_empty() {
        return None;
    }
    let floor = Chain { pieces: vec![*way] };
    let needed = shape.over_floor(&near, way.z0, way.z1, &floor);
    needed.runs_over(&floor, TOUCH_MM).pop()
}

/// A move seen from the other end of the machine.
fn turned_round(m: CutMove) -> CutMove {
    let turn = |p: Point| p.mirrored_at_z(0.0);
    match m {
        CutMove::Rapid { to } => CutMove::Rapid { to: turn(to) },
        CutMove::Line { to, cut } => CutMove::Line { to: turn(to), cut },
        CutMove::Arc { to, center, ccw, cut } => CutMove::Arc { to: turn(to), center: turn(center), ccw: !ccw, cut },
        // Tools seen from the other end make no other moves.
        other => other,
    }
}
