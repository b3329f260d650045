//! What the proof of a shell says.

use super::Verdict;
use crate::diagnostic::Severity;
use crate::regen::ShellDerived;

/// What the proof says of the shell's programs.
pub(super) fn verdict(made: &ShellDerived) -> Verdict {
    let blocks = made.post.programs.iter().map(|p| p.blocks.len()).sum();
    let errors = made.proof.findings.iter().filter(|f| f.severity == Severity::Error).count();
    match (blocks, made.proof.passed) {
        (0, _) => Verdict::NoProgram,
        (_, false) => Verdict::Failed { errors: errors.max(1) },
        (blocks, true) => Verdict::Proved { time_s: made.proof.times.total_s, blocks },
    }
}
