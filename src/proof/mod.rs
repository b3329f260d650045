//! The second opinion: reads emitted programs with its own readers, cuts the stock and reports what it finds.
//!
//! Shares nothing with the generators and posts but geometry, machine data and the shape of the data.
//!
//! The way of a program: [`reader`] (text to blocks) → `structure` (numbering, pairs) → `control` (runs the blocks as the
//! control would) → `limits` (what the machine can do), `judge` (cuts the stock by `cut`, measures against `form`, and at the
//! end the `leftover`) and `record` (times, playback) → [`ProofReport`].

mod compare;
mod control;
mod cut;
mod cut_by;
mod findings;
mod form;
mod input;
mod json;
mod judge;
mod leftover;
mod limits;
mod prove;
pub mod reader;
mod record;
mod report;
mod step;
mod structure;

pub use compare::{Change, compare};
pub use cut_by::CutBy;
pub use input::{MayCut, ProofInput, Work};
pub use json::{path_json, proof_json};
pub use prove::prove;
pub use report::{
    BlockRef, BlockReport, BoreTarget, Finding, FindingKind, Leftover, Motion, Move, ProgramText, ProofReport,
    StockState, Target, Times,
};

#[cfg(test)]
mod tests;
