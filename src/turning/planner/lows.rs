//! The smallest values of a function over stretches that move on along it.

use super::chain::Chain;
use std::collections::VecDeque;

/// A function by the smallest values of its pieces; stretches are asked for from left to right. Every piece is taken up once, and
/// dropped when a lower one follows or when it lies behind: a stretch costs what is new in it.
#[derive(Debug, Default)]
pub(super) struct Lows {
    /// Pieces that no stretch has reached yet, the next one last.
    ahead: Vec<Low>,
    /// Those of the last stretch that may be its lowest, from left to right, which is from low to high.
    near: VecDeque<Low>,
}

/// Where a piece or a gap lies, and the smallest value there.
#[derive(Debug, Clone, Copy)]
struct Low {
    z0: f64,
    z1: f64,
    r: f64,
}

impl Low {
    const fn gap(z0: f64, z1: f64) -> Self {
        Self { z0, z1, r: f64::NEG_INFINITY }
    }
}

impl Lows {
    /// The function's; a gap is below everything.
    pub(super) fn of(chain: &Chain) -> Self {
        let mut ahead = Vec::with_capacity(chain.pieces.len() + 2);
        let mut to = f64::INFINITY;
        for piece in chain.pieces.iter().rev() {
            if piece.z1 < to {
                ahead.push(Low::gap(piece.z1, to));
            }
            ahead.push(Low { z0: piece.z0, z1: piece.z1, r: piece.lowest() });
            to = piece.z0;
        }
        ahead.push(Low::gap(f64::NEG_INFINITY, to));
        Self { ahead, near: VecDeque::new() }
    }

    /// The smallest value between two positions, neither of which lies before those asked for last.
    pub(super) fn least(&mut self, z0: f64, z1: f64) -> f64 {
        while let Some(low) = self.ahead.pop_if(|low| low.z0 < z1) {
            while self.near.back().is_some_and(|last| last.r >= low.r) {
                self.near.pop_back();
            }
            self.near.push_back(low);
        }
        while self.near.front().is_some_and(|low| low.z1 <= z0) {
            self.near.pop_front();
        }
        self.near.front().map_or(f64::INFINITY, |low| low.r)
    }
}

#[cfg(test)]
mod tests {
    use super::super::piece::Piece;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_least_of_a_stretch_is_that_of_its_pieces(
            levels in proptest::collection::vec((0.5..3.0_f64, 0.0..1.0_f64, -5.0..5.0_f64), 1..12),
            steps in proptest::collection::vec((0.0..2.0_f64, 0.1..4.0_f64), 1..20),
        ) {
            let mut z = 0.0;
            let mut chain = Chain::default();
            for (width, gap, r) in levels {
                z += if gap < 0.3 { gap } else { 0.0 };
                chain.pieces.push(Piece::level(z, z + width, r));
                z += width;
            }
            let mut lows = Lows::of(&chain);
            let (mut from, mut to) = (-2.0, -1.0_f64);
            for (on, width) in steps {
                from += on;
                to = to.max(from + width);
                let covered: f64 = chain.over(from, to).iter().filter_map(|p| p.clipped(from, to)).map(|p| p.z1 - p.z0).sum();
                let least = chain.over(from, to).iter().map(Piece::lowest).fold(f64::INFINITY, f64::min);
                let expected = if covered < to - from - 1e-6 { f64::NEG_INFINITY } else { least };
                prop_assert_eq!(lows.least(from, to), expected);
            }
        }
    }
}
