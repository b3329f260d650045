//! The work in the machine: the contour to be kept, the jaws, and the stock that is left.

use super::chain::{Chain, PIT_MM, Run};
use super::hanging::Hanging;
use super::outline::{Turn, one_way, upper_pieces};
use super::piece::Piece;
use super::shape::Shape;
use super::surface::Surface;
use super::tool::{Cutter, Use};
use crate::geometry::{Point, Segment};
use crate::machine::Machine;
use crate::part::{PartContour, Setup};

/// Distance that a tool keeps from what holds the work while it cuts, mm.
const JAW_CLEARANCE_MM: f64 = 1.0;

/// The same on its ways through air, mm: less, so that it can get to where it may cut.
pub(super) const PASSING_MM: f64 = 0.5;

/// The bar that stays begins this far beyond the last place that a nose cuts, mm: rounding must not make it a wall.
const BESIDE_MM: f64 = 1e-6;

/// A leaning edge leaves slivers up to this width on the bar that stays, mm; other tools keep clear of them.
const SLIVER_MM: f64 = 0.1;

/// How far tools go into the air beyond the stock's end, mm.
pub(super) const AIR_MM: f64 = 1.0;

/// How far the programmed point may pass the axis, mm: a face is cut to its middle by the side of the nose.
pub(super) const AXIS_OVERSHOOT_MM: f64 = 1.0;

/// The work, mm.
#[derive(Debug, Clone)]
pub(super) struct Work {
    /// The finished contour as a function.
    pub(super) part: Chain,
    /// What is in the machine now, below the ways of the tools.
    pub(super) stock: Surface,
    /// The top of all that is in the machine: a leaning edge leaves slivers that hang over what it cut.
    pub(super) cover: Surface,
    /// What hangs over.
    pub(super) hanging: Hanging,
    /// Jaws, mandrel and tailstock with the distance kept from them.
    pub(super) jaws: Chain,
    /// The same with the distance kept on ways through air.
    pub(super) passed: Surface,
    /// No stock is above this, mm.
    pub(super) highest: f64,
    /// Machined from here.
    pub(super) from_z: f64,
    /// Free end of the finished part.
    pub(super) face_z: f64,
    /// No tool needs to go lower, mm.
    pub(super) floor: f64,
    /// True if z is turned round.
    turned: bool,
}

/// Where a tool's programmed point may be: on or above a function over the range that is worked in.
#[derive(Debug, Clone)]
pub(super) struct Limit {
    pub(super) chain: Chain,
    pub(super) z0: f64,
    pub(super) z1: f64,
}

impl Work {
    /// The work of a set-up before the first cut.
    pub(super) fn new(setup: &Setup, contour: &PartContour, machine: &Machine) -> Self {
        let part = Chain { pieces: contour.contour.segments.iter().filter_map(Piece::of).collect() };
        let (face, chuck) = (setup.chuck_face_z, &machine.chuck);
        let mut held = vec![Piece::level(face - chuck.depth_mm, face, chuck.radius_mm)];
        for outline in setup.mandrel.iter().chain(&setup.tailstock) {
            held.extend(upper_pieces(outline, Turn::None));
        }
        let held = Chain::largest(&held.into_iter().map(|p| Chain { pieces: vec![p] }).collect::<Vec<_>>());
        let stock = upper_pieces(&setup.stock, Turn::None).into_iter().map(|p| Chain { pieces: vec![p] });
        let stock = Chain::largest(&stock.collect::<Vec<_>>());
        Self::of(part, stock, &held, (setup.machined_from_z, setup.length), -AXIS_OVERSHOOT_MM)
    }

    /// The work of what is to be made, what it is made from and what holds it; `range`: machined from, free end.
    pub(super) fn of(part: Chain, stock: Chain, held: &Chain, range: (f64, f64), floor: f64) -> Self {
        let highest = stock.top();
        let stock = Surface::from(stock);
        Self {
            part,
            cover: stock.clone(),
            highest,
            hanging: Hanging::default(),
            stock,
            jaws: Shape::disc(JAW_CLEARANCE_MM).over(held),
            passed: Shape::disc(PASSING_MM).over(held).into(),
            from_z: range.0,
            face_z: range.1,
            floor,
            turned: false,
        }
    }

    /// The work seen from the other end of the machine.
    pub(super) fn turned_round(&self) -> Self {
        Self {
            part: self.part.mirrored(),
            stock: self.stock.mirrored(),
            cover: self.cover.mirrored(),
            hanging: self.hanging.mirrored(),
            jaws: self.jaws.mirrored(),
            passed: self.passed.mirrored(),
            highest: self.highest,
            from_z: -self.face_z,
            face_z: -self.from_z,
            floor: self.floor,
            turned: !self.turned,
        }
    }

    /// The work as a tool sees it.
    pub(super) fn seen_by(&self, cutter: &Cutter) -> Self {
        if cutter.turned == self.turned { self.clone() } else { self.turned_round() }
    }

    /// Where stock is machined: from, to.
    pub(super) fn range(&self) -> (f64, f64) {
        if self.turned { (f64::NEG_INFINITY, self.face_z) } else { (self.from_z, f64::INFINITY) }
    }

    /// Largest radius of the stock within the range that is machined, mm.
    pub(super) fn top(&self) -> f64 {
        let (z0, z1) = self.range();
        self.stock.highest(z0, z1)
    }

    /// True if there is stock more than `by` mm above what is kept; what is beside it counts.
    pub(super) fn has_above(&self, kept: &Chain, by: f64) -> bool {
        self.stock.chain().runs_over(kept, by).iter().any(|run| run.width() > PIT_MM)
    }

    /// Position of the stock's free end.
    pub(super) fn end_z(&self) -> f64 {
        self.stock.ends().map_or(self.face_z, |(_, end)| end)
    }

    /// How low a tool may go if `allowance` mm are left on the contour.
    pub(super) fn limit(&self, cutter: &Cutter, allowance: f64) -> Limit {
        self.limit_over(cutter, &self.kept(allowance))
    }

    /// The contour with what is left on it, mm.
    pub(super) fn kept(&self, allowance: f64) -> Chain {
        if allowance > 0.0 { Shape::disc(allowance).over(&self.part) } else { self.part.clone() }
    }

    /// How low a tool may go over what is kept of the part.
    pub(super) fn limit_over(&self, cutter: &Cutter, kept: &Chain) -> Limit {
        self.limited(cutter, &kept.max(&self.jaws).max(&self.bar(cutter)))
    }

    /// The bar that stays beside what is machined, for other tools than right-hand ones with the slivers on its face.
    fn bar(&self, cutter: &Cutter) -> Chain {
        if self.turned {
            let edge = self.face_z + cutter.nose + BESIDE_MM;
            let bar = self.stock.between(edge, f64::INFINITY);
            return match bar.at(edge) {
                Some(r) => bar.max(&Chain::level(edge - SLIVER_MM, edge, r)),
                None => bar,
            };
        }
        let edge = self.from_z - cutter.nose - BESIDE_MM;
        let bar = self.stock.between(f64::NEG_INFINITY, edge);
        match bar.at(edge) {
            Some(r) if cutter.r#use != Use::Right => bar.max(&Chain::level(edge, edge + SLIVER_MM, r)),
            _ => bar,
        }
    }

    /// How low a tool may go without touching the stock or what holds it.
    pub(super) fn air(&self, cutter: &Cutter) -> Chain {
        cutter.body.over(&self.cover.chain().max(&self.passed.chain()))
    }

    /// Where the programmed point may be over what is kept: up to the bar that stays, and beyond an end that is free.
    fn limited(&self, cutter: &Cutter, kept: &Chain) -> Limit {
        let starts = self.stock.ends().map_or(self.from_z, |(start, _)| start).min(self.from_z);
        let ends = self.end_z().max(self.face_z);
        let beside = SLIVER_MM;
        let z0 = if !self.turned && starts < self.from_z - beside {
            self.from_z - cutter.bottom.0
        } else {
            starts - cutter.contact().1 - AIR_MM
        };
        let z1 = if self.turned && ends > self.face_z + beside {
            self.face_z - cutter.bottom.1
        } else {
            ends - cutter.extent.0 + 2.0 * AIR_MM
        };
        let floor = self.floor.max(-cutter.nose);
        let chain = cutter.body.over_within(kept, z0, z1, floor).clipped(z0, z1);
        Limit { chain: chain.max(&Chain::level(z0, z1, floor)), z0, z1 }
    }

    /// Takes away what the insert of a tool covers along a segment; `low` is what it leaves below it, as [`left_along`] gives it.
    pub(super) fn take(&mut self, cutter: &Cutter, segment: &Segment, low: &Chain) {
        let high = covered_along(&cutter.top, segment);
        let changed = [self.hanging.cut(low, &high, &self.stock), self.stock.cut(low)];
        if let Some(Run { z0, z1 }) = changed.into_iter().flatten().reduce(Run::and) {
            self.cover.replace(z0, z1, &self.hanging.top_over(self.stock.between(z0, z1), z0, z1));
        }
    }

    /// What is left below a shape with its radius turned over whose reference point goes all along a function.
    pub(super) fn left_by(edge: &Shape, way: &Chain) -> Chain {
        // Pits of this side are thin walls of stock: they stay.
        edge.over_all(&way.clone().negated()).negated()
    }
}

/// What is left below a shape with its radius turned over that goes along a segment.
pub(super) fn left_along(edge: &Shape, segment: &Segment) -> Chain {
    swept(edge, segment).negated()
}

/// The upper side of what a shape covers along a segment.
pub(super) fn covered_along(top: &Shape, segment: &Segment) -> Chain {
    let (a, b) = (segment.start(), segment.end());
    over_all(top, segment, |p| p).unwrap_or_else(|| top.at(if a.r <= b.r { b } else { a }))
}

/// The lower boundary of a swept tool, negated.
fn swept(edge: &Shape, segment: &Segment) -> Chain {
    let (a, b) = (segment.start(), segment.end());
    let lower = if a.r <= b.r { a } else { b };
    over_all(edge, segment, |p| p.negated()).unwrap_or_else(|| edge.at(Point::new(lower.z, -lower.r)))
}

/// The largest of a shape put on every point of a segment, seen as `seen`; `None` if it is upright. An arc may turn back along z.
fn over_all(shape: &Shape, segment: &Segment, seen: impl Fn(Piece) -> Piece) -> Option<Chain> {
    let over = |part: &Segment| Piece::of(part).map(|p| shape.over_piece(&seen(p)));
    match segment {
        Segment::Line { .. } => over(segment),
        Segment::Arc { .. } => one_way(segment).iter().filter_map(over).reduce(|a, b| a.max(&b)),
    }
}
