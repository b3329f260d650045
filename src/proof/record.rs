//! Keeps the moves, stock states, times and block reports of a proof while the programs run.

use super::findings::Place;
use super::report::{BlockReport, Motion, Move, StockState, Times};
use crate::geometry::Segment;

/// Points that all stock states together may hold; beyond, every second state is dropped. 2 million points are 32 MB.
const STOCK_POINTS: usize = 2_000_000;

/// What has happened so far.
#[derive(Debug, Default)]
pub(super) struct Record {
    /// Times of all programs.
    pub times: Times,
    /// One entry a block, of all programs one after another.
    pub blocks: Vec<BlockReport>,
    /// Every move.
    pub moves: Vec<Move>,
    /// Stock states.
    pub stock: Vec<StockState>,
    first_block: usize,
    points: usize,
    changes: usize,
    stride: usize,
}

/// A move that is to be recorded.
#[derive(Debug, Clone, Copy)]
pub(super) struct Played {
    /// Path of the programmed point.
    pub path: Segment,
    /// Kind of motion.
    pub motion: Motion,
    /// Turret station.
    pub tool: u32,
    /// Feed, mm/min.
    pub feed: f64,
    /// Spindle speed, rev/min.
    pub rpm: f64,
    /// Duration, s.
    pub lasts_s: f64,
}

impl Record {
    /// A record that begins with the stock before the first move.
    pub(super) fn new(stock: StockState) -> Self {
        Self { stock: vec![stock], stride: 1, ..Self::default() }
    }

    /// Starts the next program, whose blocks are all listed even if they never run.
    pub(super) fn begin_program(&mut self, name: &str, printed: &[Option<u32>]) {
        self.first_block = self.blocks.len();
        self.blocks.extend((1..).zip(printed).map(|(block, &printed)| BlockReport {
            program: name.to_owned(),
            block,
            printed,
            runs: 0,
            time_s: 0.0,
            removed_mm2: 0.0,
            chip_mm2: 0.0,
        }));
    }

    /// The report of a block of the present program.
    pub(super) fn block(&mut self, block: usize) -> Option<&mut BlockReport> {
        self.blocks.get_mut(self.first_block + block.checked_sub(1)?)
    }

    /// Adds a move and its time.
    pub(super) fn play(&mut self, place: Place, played: Played) {
        self.moves.push(Move {
            program: place.program,
            block: place.block,
            path: played.path,
            motion: played.motion,
            tool: played.tool,
            feed_mm_per_min: played.feed,
            rpm: played.rpm,
            starts_s: self.times.total_s,
            lasts_s: played.lasts_s,
            stock_after: self.stock.len().saturating_sub(1),
        });
        self.times.total_s += played.lasts_s;
        match played.motion {
            Motion::Rapid => self.times.rapid_s += played.lasts_s,
            Motion::Feed | Motion::Thread => self.times.feed_s += played.lasts_s,
            Motion::Pause => {}
        }
        if let Some(block) = self.block(place.block) {
            block.time_s += played.lasts_s;
        }
    }

    /// Adds the stock as it is after the next move that is played.
    pub(super) fn stock_changed(&mut self, state: impl FnOnce() -> StockState) {
        self.changes += 1;
        if self.changes.is_multiple_of(self.stride) {
            self.push_stock(state());
        }
    }

    fn push_stock(&mut self, state: StockState) {
        self.points += points(&state);
        self.stock.push(state);
        if self.points > STOCK_POINTS {
            self.thin_out();
        }
    }

    /// Drops every second state but the first; moves then show the state before their own.
    fn thin_out(&mut self) {
        let mut index = 0;
        self.stock.retain(|_| {
            index += 1;
            index % 2 == 1
        });
        for played in &mut self.moves {
            played.stock_after /= 2;
        }
        self.points = self.stock.iter().map(points).sum();
        self.stride *= 2;
    }

    /// Makes sure that the last move shows the stock as it is at the end.
    pub(super) fn finish(&mut self, state: StockState) {
        if self.stock.last() != Some(&state) {
            self.stock.push(state);
            if let Some(last) = self.moves.last_mut() {
                last.stock_after = self.stock.len() - 1;
            }
        }
    }
}

fn points(state: &StockState) -> usize {
    state.rings.iter().map(Vec::len).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use std::sync::Arc;

    #[test]
    fn states_are_thinned_out_and_moves_keep_pointing_at_them() {
        let ring: Arc<Vec<Vec<Point>>> = Arc::new(vec![vec![Point::default(); 50_000]]);
        let mut record = Record::new(StockState::default());
        let line = Segment::line(Point::default(), Point::default());
        let played = Played { path: line, motion: Motion::Feed, tool: 1, feed: 1.0, rpm: 1.0, lasts_s: 1.0 };
        for _ in 0..1000 {
            record.stock_changed(|| StockState { rings: Arc::clone(&ring) });
            record.play(Place { program: 0, block: 1 }, played);
        }
        assert!(record.stock.len() <= STOCK_POINTS / 50_000);
        assert!(record.moves.iter().all(|m| m.stock_after < record.stock.len()));
        assert!(record.moves.is_sorted_by_key(|m| m.stock_after));
    }
}
