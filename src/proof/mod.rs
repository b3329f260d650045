//! The second opinion: reads emitted programs with its own readers, cuts the stock and reports what it finds.
//!
//! Shares nothing with the generators and posts but geometry, machine data and the shape of the data.
//!
//! The way of a program: [`reader`] (text to blocks) → `structure` and `lint` (what the text must have) → `control` for the
//! ORAC's pages and `interpreter` for programs of words (run the blocks as the controls would) → `run`: `limits` (what the
//! machine can do), `judge` (cuts the stock by `cut`, measures against `form`, and at the end the `leftover`), `times` and
//! `record` (playback) → [`ProofReport`].

mod compare;
mod control;
mod cost;
mod cut;
mod cut_by;
mod findings;
mod form;
mod input;
mod interpreter;
mod json;
mod judge;
mod leftover;
mod limits;
mod lint;
mod power;
mod prove;
pub mod reader;
mod record;
mod report;
mod run;
mod step;
mod strips;
mod structure;
mod times;
mod tops;

pub use compare::{Change, compare};
pub use cut::StockHistory;
pub use cut_by::CutBy;
pub use input::{MayCut, ProofInput, Work};
pub use json::{path_json, proof_json};
pub use prove::prove;
pub use report::{
    BlockRef, BlockReport, BoreTarget, Finding, FindingKind, Leftover, Motion, Move, PartCost, ProgramText,
    ProofReport, StockState, Target, Times,
};

#[cfg(test)]
mod tests;
