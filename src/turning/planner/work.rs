//! The work in the machine: the contour to be kept, the jaws, and the stock that is left.

use super::chain::Chain;
use super::outline::{Turn, upper_pieces};
use super::piece::Piece;
use super::shape::Shape;
use super::tool::{Cutter, Use};
use crate::geometry::{Point, Segment};
use crate::machine::Machine;
use crate::part::{PartContour, Setup};

/// Distance that a tool keeps from the jaws, mm.
pub(super) const JAW_CLEARANCE_MM: f64 = 1.0;

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
    /// What is in the machine now.
    pub(super) stock: Chain,
    /// Jaws with the distance kept from them.
    pub(super) jaws: Chain,
    /// Machined from here.
    pub(super) from_z: f64,
    /// Free end of the finished part.
    pub(super) face_z: f64,
    /// No tool needs to go lower, mm.
    pub(super) floor: f64,
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
        let face = setup.chuck_face_z + JAW_CLEARANCE_MM;
        let jaws = Chain::level(face - machine.chuck.depth_mm, face, machine.chuck.radius_mm + JAW_CLEARANCE_MM);
        let stock = upper_pieces(&setup.stock, Turn::None).into_iter().map(|p| Chain { pieces: vec![p] });
        Self {
            part,
            stock: Chain::largest(&stock.collect::<Vec<_>>()),
            jaws,
            from_z: setup.machined_from_z,
            face_z: setup.length,
            floor: -AXIS_OVERSHOOT_MM,
        }
    }

    /// Largest radius of the stock within the range that is machined, mm.
    pub(super) fn top(&self) -> f64 {
        self.stock.highest(self.from_z, f64::INFINITY)
    }

    /// Position of the stock's free end.
    pub(super) fn end_z(&self) -> f64 {
        self.stock.pieces.last().map_or(self.face_z, |p| p.z1)
    }

    /// How low a tool may go if `allowance` mm are left on the contour.
    pub(super) fn limit(&self, cutter: &Cutter, allowance: f64) -> Limit {
        let kept = if allowance > 0.0 { Shape::disc(allowance).over(&self.part) } else { self.part.clone() };
        self.limited(cutter, &cutter.body.over(&kept.max(&self.jaws).max(&self.bar(cutter))))
    }

    /// The bar that stays beside what is machined, for other tools than right-hand ones with the slivers on its face.
    fn bar(&self, cutter: &Cutter) -> Chain {
        let edge = self.from_z - cutter.nose - BESIDE_MM;
        let bar = self.stock.clipped(f64::NEG_INFINITY, edge);
        match bar.at(edge) {
            Some(r) if cutter.r#use != Use::Right => bar.max(&Chain::level(edge, edge + SLIVER_MM, r)),
            _ => bar,
        }
    }

    /// How low a tool may go without touching the stock or the jaws.
    pub(super) fn air(&self, cutter: &Cutter) -> Chain {
        cutter.body.over(&self.stock.max(&self.jaws))
    }

    fn limited(&self, cutter: &Cutter, chain: &Chain) -> Limit {
        let z0 = self.from_z - cutter.bottom.0;
        let z1 = self.end_z().max(self.face_z) - cutter.extent.0 + 2.0 * AIR_MM;
        let floor = Chain::level(z0, z1, self.floor.max(-cutter.nose));
        Limit { chain: chain.clipped(z0, z1).max(&floor), z0, z1 }
    }

    /// What is left below a tool that goes along `path`.
    pub(super) fn left_by(cutter: &Cutter, path: &[Segment]) -> Chain {
        let leaves: Vec<Chain> = path.iter().map(|s| swept(cutter, s)).collect();
        Chain::largest(&leaves).negated()
    }

    /// Takes away what a tool cuts along `path`.
    pub(super) fn cut(&mut self, cutter: &Cutter, path: &[Segment]) {
        let left = Self::left_by(cutter, path);
        let (Some(first), Some(last)) = (self.stock.pieces.first(), self.stock.pieces.last()) else { return };
        let (z0, z1) = (first.z0, last.z1);
        self.stock = self.stock.min(&left).clipped(z0, z1);
        self.stock.pieces.retain(|p| p.highest() > 0.0);
    }
}

/// The lower boundary of a swept tool, negated.
fn swept(cutter: &Cutter, segment: &Segment) -> Chain {
    let mut parts = super::outline::one_way(segment).into_iter().filter_map(|s| Piece::of(&s)).peekable();
    if parts.peek().is_none() {
        let (a, b) = (segment.start(), segment.end());
        let lower = if a.r <= b.r { a } else { b };
        return cutter.edge.at(Point::new(lower.z, -lower.r));
    }
    let pieces: Vec<Piece> = parts.map(|p| p.negated()).collect();
    // One after the other: a segment may turn back along z.
    Chain::largest(&pieces.into_iter().map(|p| cutter.edge.over(&Chain { pieces: vec![p] })).collect::<Vec<_>>())
}
