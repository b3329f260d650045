//! The proof of a shell's program: the emitted text is run by the proof's own reader, and the roller, the former and what
//! holds the blank are compared along every move.
//!
//! Nothing of the path's own making is used: the moves come from the text, the wall from the former's own contour.

mod contact;
mod gap;
mod obstacles;
mod reach;
mod route;

use super::shape::ShellShape;
use crate::cancel::{Cancel, Cancelled};
use crate::diagnostic::Severity;
use crate::document::Shell;
use crate::geometry::{Segment, Vector};
use crate::machine::{Machine, ToolOutline};
use crate::proof::{self, Finding, FindingKind, Motion, Move, ProgramText, ProofInput, Times};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a shell's program is proved against.
#[derive(Debug, Clone, PartialEq)]
pub struct ShellProofInput {
    /// The machine that will run it.
    pub machine: Arc<Machine>,
    /// Outline of every tool of the machine, for its control.
    pub tools: Arc<BTreeMap<u32, ToolOutline>>,
    /// The programs.
    pub programs: Arc<Vec<ProgramText>>,
    /// Part-space position of the control's zero along the spindle.
    pub program_zero_z: f64,
    /// The design in mm.
    pub shell: Shell,
    /// Former and wall.
    pub shape: Arc<ShellShape>,
}

/// What the proof found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ShellProof {
    /// True if there is no finding of severity error.
    pub passed: bool,
    /// Findings in order of program and block.
    pub findings: Vec<Finding>,
    /// Times of the programs.
    pub times: Times,
    /// Every move in part space, from the text.
    pub moves: Vec<Move>,
    /// Smallest gap between roller and former less the wall there, mm; negative is thinner than the wall.
    pub tightest_mm: f64,
    /// Largest gap less the wall along the former after the last pass, mm; hollows that the nose does not reach left out.
    pub widest_mm: f64,
    /// Largest distance of the shell from the former in hollows that the nose does not reach into, mm.
    pub spanned_mm: f64,
    /// Smallest distance of the roller from former, chuck, follower and tailstock, mm.
    pub clearance_mm: f64,
}

/// Proves the programs of a shell.
///
/// # Errors
/// [`Cancelled`] if `cancel` was asked to stop.
pub fn prove(input: &ShellProofInput, cancel: &Cancel) -> Result<ShellProof, Cancelled> {
    let run = proof::prove(
        &ProofInput {
            machine: Arc::clone(&input.machine),
            tools: Arc::clone(&input.tools),
            programs: Arc::clone(&input.programs),
            work: None,
        },
        cancel,
    )?;
    let by = Vector::new(input.program_zero_z, 0.0);
    let moves: Vec<Move> = run.moves.iter().map(|m| Move { path: m.path.translated(by), ..m.clone() }).collect();
    let mut found = ShellProof { findings: run.findings, times: run.times, moves, ..ShellProof::default() };
    cancel.check()?;
    gap::check(input, &mut found);
    contact::check(input, &mut found);
    found.findings.sort_by_key(|f| (program_index(input, &f.program), f.block));
    found.passed = found.findings.iter().all(|f| f.severity != Severity::Error);
    Ok(found)
}

fn program_index(input: &ShellProofInput, name: &str) -> usize {
    input.programs.iter().position(|p| p.name == name).unwrap_or(usize::MAX)
}

/// Moves that go somewhere.
fn travelled(found: &ShellProof) -> impl Iterator<Item = (usize, &Move)> {
    found.moves.iter().enumerate().filter(|(_, m)| m.motion != Motion::Pause && m.path.length() > 0.0)
}

/// Shares along a path, ends included, no two places further apart than `apart` mm.
fn shares(path: &Segment, apart: f64) -> impl Iterator<Item = f64> + use<> {
    /// More places than any move needs.
    const MOST: f64 = 20_000.0;
    let count = (path.length() / apart).ceil().clamp(1.0, MOST);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST")]
    let count = if count.is_finite() { count as u32 } else { 1 };
    (0..=count).map(move |k| f64::from(k) / f64::from(count))
}

/// A finding at a move.
fn finding(
    input: &ShellProofInput,
    at_move: &Move,
    share: f64,
    kind: FindingKind,
    value_and_limit: (f64, f64),
    message: String,
) -> Finding {
    let program = input.programs.get(at_move.program).map_or_else(String::new, |p| p.name.clone());
    Finding {
        severity: Severity::Error,
        kind,
        program,
        block: at_move.block,
        at: Some(at_move.path.point_at(share)),
        value: value_and_limit.0,
        limit: value_and_limit.1,
        message,
    }
}

#[cfg(test)]
mod tests;
