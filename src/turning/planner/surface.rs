//! The top of the stock: a function of z that is cut again and again. Its pieces lie in chunks with the largest value of each, so
//! that a cut touches only the chunks that it meets, and who looks for what is high passes over those that are low.

use super::chain::{Chain, Run};
use super::piece::{EQUAL_MM, Piece, SAME_MM};
use super::shape::Shape;
use std::ops::Range;
use std::sync::Arc;

/// Pieces of one chunk at most: fewer are copied at every cut, more are passed over at every look.
const MOST_PIECES: usize = 48;

/// Neighbours with fewer pieces than this together become one.
const FEW_PIECES: usize = 12;

/// A function of z in chunks. A copy shares those with the original that are not changed afterwards.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Surface {
    /// In order of z; none is empty.
    chunks: Vec<Arc<Chunk>>,
}

/// A few pieces that follow one another.
#[derive(Debug, Clone, PartialEq)]
struct Chunk {
    chain: Chain,
    z0: f64,
    z1: f64,
    /// Largest value, mm.
    top: f64,
}

impl Chunk {
    fn of(chain: Chain) -> Option<Self> {
        let (z0, z1) = chain.ends()?;
        let top = chain.top();
        Some(Self { chain, z0, z1, top })
    }

    /// What of it lies between two positions.
    fn between(&self, z0: f64, z1: f64) -> impl Iterator<Item = Piece> + '_ {
        self.chain.over(z0, z1).iter().filter_map(move |p| p.clipped(z0, z1))
    }
}

impl From<Chain> for Surface {
    fn from(chain: Chain) -> Self {
        Self { chunks: chunks_of(&chain.pieces).collect() }
    }
}

/// Pieces in chunks that can still grow.
fn chunks_of(pieces: &[Piece]) -> impl Iterator<Item = Arc<Chunk>> + '_ {
    let most = if pieces.len() <= MOST_PIECES { MOST_PIECES } else { MOST_PIECES / 2 };
    pieces.chunks(most).filter_map(|part| Chunk::of(Chain { pieces: part.to_vec() })).map(Arc::new)
}

impl Surface {
    /// All of it.
    pub(super) fn chain(&self) -> Chain {
        self.between(f64::NEG_INFINITY, f64::INFINITY)
    }

    /// The part between two positions.
    pub(super) fn between(&self, z0: f64, z1: f64) -> Chain {
        let chunks = self.over(z0, z1);
        let mut pieces = Vec::with_capacity(chunks.iter().map(|chunk| chunk.chain.pieces.len()).sum());
        for chunk in chunks {
            pieces.extend(chunk.between(z0, z1));
        }
        Chain { pieces }
    }

    /// The pieces between two positions that are anywhere above a height.
    pub(super) fn higher(&self, z0: f64, z1: f64, above: f64) -> Chain {
        let above = above + SAME_MM;
        let high = self.over(z0, z1).iter().filter(|chunk| chunk.top > above);
        Chain { pieces: high.flat_map(|chunk| chunk.between(z0, z1)).filter(|p| p.highest() > above).collect() }
    }

    /// The pieces between the ends of another function that may be above it.
    pub(super) fn above(&self, lower: &Chain) -> Chain {
        let Some((z0, z1)) = lower.ends() else { return Chain::default() };
        let high = self.over(z0, z1).iter().filter(|chunk| chunk.top > lower.lowest(chunk.z0, chunk.z1));
        Chain { pieces: high.flat_map(|chunk| chunk.between(z0, z1)).collect() }
    }

    /// The pieces that are anywhere above a height, and that a shape may touch on its way along a piece.
    pub(super) fn reached(&self, shape: &Shape, way: &Piece, above: f64) -> Chain {
        let (extent, lowest) = (shape.extent(), way.lowest());
        let (z0, z1) = (way.z0 - extent.1, way.z1 - extent.0);
        let meets = |chunk: &&Arc<Chunk>| {
            chunk.top > above + SAME_MM && chunk.top + shape.highest(way.z0 - chunk.z1, way.z1 - chunk.z0) > lowest
        };
        let near = self.over(z0, z1).iter().filter(meets).flat_map(|chunk| chunk.between(z0, z1));
        Chain { pieces: near.filter(|p| p.highest() > above + SAME_MM).collect() }
    }

    /// True if a piece that reaches into a stretch is anywhere above a height.
    pub(super) fn rises_above(&self, z0: f64, z1: f64, height: f64) -> bool {
        let mut high = self.over(z0, z1).iter().filter(|chunk| chunk.top > height);
        high.any(|chunk| chunk.chain.over(z0, z1).iter().any(|p| p.highest() > height))
    }

    /// Largest value in a stretch; −∞ in a gap.
    pub(super) fn highest(&self, z0: f64, z1: f64) -> f64 {
        self.over(z0, z1).iter().map(|chunk| chunk.chain.highest(z0, z1)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Where it begins and where it ends.
    pub(super) fn ends(&self) -> Option<(f64, f64)> {
        Some((self.chunks.first()?.z0, self.chunks.last()?.z1))
    }

    /// The function with z turned round.
    pub(super) fn mirrored(&self) -> Self {
        let turned = self.chunks.iter().rev().filter_map(|chunk| Chunk::of(chunk.chain.mirrored()));
        Self { chunks: turned.map(Arc::new).collect() }
    }

    /// Takes away what lies above `lower`, which has no gaps; gives a stretch outside which nothing was taken.
    pub(super) fn cut(&mut self, lower: &Chain) -> Option<Run> {
        let (z0, z1) = lower.ends()?;
        let mut taken: Option<Run> = None;
        for k in self.range(z0, z1).rev() {
            let Some(chunk) = self.chunks.get_mut(k) else { continue };
            if chunk.top <= lower.lowest(chunk.z0, chunk.z1) {
                continue;
            }
            let here = Run { z0: chunk.z0.max(z0), z1: chunk.z1.min(z1) };
            taken = Some(taken.map_or(here, |run| run.and(here)));
            let chunk = Arc::make_mut(chunk);
            chunk.chain.cut(lower);
            chunk.top = chunk.chain.top();
            self.settle(k);
        }
        self.end_where_nothing_is_left();
        taken
    }

    /// Takes away what lies between `low` and `high` where that reaches the top; where it does not, something hangs over what was
    /// taken, and the function stays.
    pub(super) fn uncover(&mut self, low: &Chain, high: &Chain) {
        let Some((mut from, end)) = low.ends() else { return };
        let hidden = self.above(high).runs_over(high, EQUAL_MM);
        for run in hidden.iter().chain([&Run { z0: end, z1: end }]) {
            if run.z0 - from > SAME_MM {
                self.cut(&low.clipped(from, run.z0));
            }
            from = run.z1;
        }
    }

    /// Puts another function in the place of a stretch.
    pub(super) fn replace(&mut self, z0: f64, z1: f64, by: &Chain) {
        let range = self.range(z0, z1);
        let over = self.chunks.get(range.clone()).unwrap_or_default();
        let mut whole = Chain::default();
        over.iter().flat_map(|chunk| &chunk.chain.pieces).for_each(|p| whole.push(*p));
        whole.replace(z0, z1, by);
        let first = range.start;
        self.chunks.splice(range, chunks_of(&whole.pieces));
        self.settle(first);
    }

    /// What ends at or before a position.
    pub(super) fn ended_at(&self, z1: f64) -> Self {
        Self::from(self.between(f64::NEG_INFINITY, z1))
    }

    /// Numbers of the chunks that reach into a stretch.
    fn range(&self, z0: f64, z1: f64) -> Range<usize> {
        let first = self.chunks.partition_point(|chunk| chunk.z1 <= z0);
        first..self.chunks.partition_point(|chunk| chunk.z0 < z1).max(first)
    }

    fn over(&self, z0: f64, z1: f64) -> &[Arc<Chunk>] {
        self.chunks.get(self.range(z0, z1)).unwrap_or_default()
    }

    /// Brings a chunk that was changed to a fair size.
    fn settle(&mut self, k: usize) {
        let Some(chunk) = self.chunks.get(k) else { return };
        let pieces = &chunk.chain.pieces;
        if pieces.is_empty() || pieces.len() > MOST_PIECES {
            let parts: Vec<_> = chunks_of(pieces).collect();
            self.chunks.splice(k..=k, parts);
        }
        self.join(k);
        if let Some(before) = k.checked_sub(1) {
            self.join(before);
        }
    }

    /// Makes one of a chunk and its neighbour if both are small.
    fn join(&mut self, k: usize) {
        let (Some(chunk), Some(next)) = (self.chunks.get(k), self.chunks.get(k + 1)) else { return };
        if chunk.chain.pieces.len() + next.chain.pieces.len() < FEW_PIECES {
            let mut both = chunk.chain.clone();
            next.chain.pieces.iter().for_each(|p| both.push(*p));
            let both: Vec<_> = chunks_of(&both.pieces).collect();
            self.chunks.splice(k..k + 2, both);
        }
    }

    /// What is cut off at the end is gone.
    fn end_where_nothing_is_left(&mut self) {
        while let Some(last) = self.chunks.last_mut() {
            let gone = last.chain.pieces.last().is_none_or(|p| p.highest() <= 0.0);
            if !gone {
                return;
            }
            let mut chain = last.chain.clone();
            chain.pieces.pop();
            match Chunk::of(chain) {
                Some(chunk) => *last = Arc::new(chunk),
                None => _ = self.chunks.pop(),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::machine::Catalog;
    use crate::turning::planner::tool::Cutter;
    use proptest::prelude::*;

    /// A bar with a groove at every 0.1 mm, deeper and less deep, in many chunks.
    fn grooved() -> Chain {
        let r = |k: u32| 20.0 + f64::from(k * 7 % 11) / 10.0 + (f64::from(k) / 40.0).sin();
        let at = |k: u32| Point::new(f64::from(k) / 10.0, r(k));
        Chain { pieces: (0..400).map(|k| Piece::line(at(k), at(k + 1))).collect() }
    }

    /// What a tool might leave: down, level, up.
    fn cut(z: f64, r: f64, width: f64) -> Chain {
        let corners = [(z, r + 4.0), (z + 0.4 * width, r), (z + 0.7 * width, r), (z + width, r + 3.0)];
        let points = corners.map(|(z, r)| Point::new(z, r));
        Chain { pieces: points.windows(2).map(|w| Piece::line(w[0], w[1])).collect() }
    }

    fn cuts() -> impl Strategy<Value = Vec<Chain>> {
        let one = (-2.0..40.0_f64, 17.0..22.0_f64, 0.05..15.0_f64).prop_map(|(z, r, width)| cut(z, r, width));
        proptest::collection::vec(one, 1..30)
    }

    fn is_sound(surface: &Surface) -> bool {
        let chunks = &surface.chunks;
        chunks.windows(2).all(|w| w[0].z1 <= w[1].z0 + SAME_MM)
            && chunks.iter().all(|c| {
                (1..=MOST_PIECES).contains(&c.chain.pieces.len())
                    && c.chain.ends() == Some((c.z0, c.z1))
                    && c.top == c.chain.top()
            })
    }

    /// Largest difference between two functions, mm; ∞ where only one of them has a value.
    fn apart(a: &Chain, b: &Chain) -> f64 {
        let places = (0..4000).map(|k| f64::from(k) * 0.010_007 + 1e-4);
        let difference = |z: f64| match (a.at(z), b.at(z)) {
            (Some(a), Some(b)) => (a - b).abs(),
            (None, None) => 0.0,
            _ => f64::INFINITY,
        };
        places.map(difference).fold(0.0, f64::max)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn what_is_cut_in_chunks_is_cut_as_a_whole(cuts in cuts()) {
            let (mut whole, mut surface) = (grooved(), Surface::from(grooved()));
            for low in &cuts {
                let before = surface.chain();
                let taken = surface.cut(low);
                whole.cut(low);
                prop_assert!(is_sound(&surface));
                prop_assert!(apart(&whole, &surface.chain()) < 1e-9);
                let Run { z0, z1 } = taken.unwrap_or(Run { z0: f64::INFINITY, z1: f64::INFINITY });
                for (from, to) in [(f64::NEG_INFINITY, z0), (z1, f64::INFINITY)] {
                    prop_assert_eq!(apart(&before.clipped(from, to), &surface.between(from, to)), 0.0);
                }
            }
            prop_assert_eq!(surface.mirrored().mirrored().chain(), surface.chain());
        }

        #[test]
        fn what_a_look_passes_over_does_not_matter(cuts in cuts(), z in 0.0..35.0_f64, r in 17.0..24.0_f64) {
            let mut surface = Surface::from(grooved());
            for low in &cuts {
                surface.cut(low);
            }
            let (whole, low) = (surface.chain(), cut(z, r, 5.0));
            prop_assert!((surface.above(&low).area_over(&low) - whole.clipped(z, z + 5.0).area_over(&low)).abs() < 1e-9);
            prop_assert_eq!(surface.rises_above(z, z + 5.0, r), whole.over(z, z + 5.0).iter().any(|p| p.highest() > r));
            let higher = surface.higher(z, z + 5.0, r);
            prop_assert_eq!(higher.runs_above(r + SAME_MM), whole.clipped(z, z + 5.0).runs_above(r + SAME_MM));
            prop_assert_eq!(surface.highest(z, z + 5.0), whole.highest(z, z + 5.0));
            let cutter = Cutter::new(1, &Catalog::shipped().tool("orac-right").unwrap().outline()).unwrap();
            let way = Piece::line(Point::new(z, r), Point::new(z + 0.7, r + 0.3));
            let floor = Chain { pieces: vec![way] };
            let runs = |near: &Chain| cutter.guard.over_floor(near, way.z0, way.z1, &floor).runs_over(&floor, 1e-6);
            let (found, expected) = (runs(&surface.reached(&cutter.guard, &way, r + cutter.guard_low)), runs(&whole));
            prop_assert!(found.len() == expected.len(), "{found:?} {expected:?}");
            for (a, b) in found.iter().zip(&expected) {
                prop_assert!((a.z0 - b.z0).abs().max((a.z1 - b.z1).abs()) < 1e-6);
            }
        }

        #[test]
        fn a_stretch_is_replaced(z in -1.0..35.0_f64, width in 0.01..20.0_f64) {
            let (mut whole, mut surface) = (grooved(), Surface::from(grooved()));
            let by = Chain::level(z, z + width, 25.0);
            whole.replace(z, z + width, &by);
            surface.replace(z, z + width, &by);
            prop_assert!(is_sound(&surface) && apart(&whole, &surface.chain()) < 1e-9);
        }
    }

    #[test]
    fn what_is_covered_stays_and_an_end_cut_to_the_axis_is_gone() {
        let mut surface = Surface::from(grooved());
        // Under a roof at 21 mm from 10 to 15 mm nothing comes off.
        let (low, mut high) = (Chain::level(10.0, 20.0, 15.0), Chain::level(10.0, 15.0, 18.0));
        high.push(Piece::level(15.0, 20.0, 30.0));
        surface.uncover(&low, &high);
        assert_eq!((surface.chain().at(12.55), surface.chain().at(17.55)), (grooved().at(12.55), Some(15.0)));
        surface.cut(&Chain::level(30.0, 41.0, -0.5));
        assert!(is_sound(&surface) && surface.ends().is_some_and(|(_, end)| (end - 30.0).abs() < 1e-9));
    }
}
