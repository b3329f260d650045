//! Keeps the moves, times and block reports of a proof while the programs run.

use super::findings::Place;
use super::report::{BlockReport, Motion, Move, Times};
use crate::geometry::Segment;

/// What has happened so far.
#[derive(Debug, Default)]
pub(super) struct Record {
    /// Times of all programs.
    pub times: Times,
    /// One entry a block, of all programs one after another.
    pub blocks: Vec<BlockReport>,
    /// Every move.
    pub moves: Vec<Move>,
    /// Index of the stock state after the next move that is played.
    pub stock_after: usize,
    first_block: usize,
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
            stock_after: self.stock_after,
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
}
