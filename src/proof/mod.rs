//! The second opinion: reads emitted programs with its own readers, cuts the stock and reports what it finds.
//!
//! Shares nothing with the generators and posts but geometry, machine data and the shape of the data.

mod input;
mod report;

pub use input::{MayCut, ProofInput, Work};
pub use report::{
    BlockReport, Finding, FindingKind, Leftover, Motion, Move, ProgramText, ProofReport, StockState, Target, Times,
};
