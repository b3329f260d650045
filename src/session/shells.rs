//! What the proof of a shell says.

use super::Verdict;
use crate::regen::ShellDerived;

/// What the proof says of the shell's programs.
pub(super) fn verdict(made: &ShellDerived) -> Verdict {
    let blocks = made.post.programs.iter().map(|p| p.blocks.len()).sum();
    match (blocks, made.proof.passed) {
        (0, _) => Verdict::NoProgram,
        (_, false) => Verdict::Failed { errors: 1 },
        (blocks, true) => Verdict::Proved { time_s: made.proof.times.total_s, blocks },
    }
}
