//! The numbered instruction files of a set-up, as published.

use super::instruction::Instruction;
use super::words;
use crate::turning::{CutterPath, OperationKind};

/// One instruction file: `NAME1.anc` is number 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InstructionFile {
    /// Number in the file name, from 1.
    pub number: usize,
    /// What it cuts; `None` for file 3.
    pub operation: Option<OperationKind>,
    /// Its instructions.
    pub instructions: Vec<Instruction>,
}

/// The files of `path` in order of cutting; air is crossed at `rapid_mm_per_min`.
///
/// File 1 is right-hand roughing and begins with the format, the unit and the datum; file 2 is right-hand finishing; file 3
/// is empty, as in both published parts; the other operations follow. The last file ends with the end instruction. Without
/// operations there are no files.
#[must_use]
pub fn files(path: &CutterPath, rapid_mm_per_min: f64) -> Vec<InstructionFile> {
    let is_right = |kind| matches!(kind, OperationKind::RoughRight | OperationKind::FinishRight);
    let after_right = path.operations.iter().take_while(|o| is_right(o.kind)).count();
    let mut contents: Vec<(Option<OperationKind>, Vec<Instruction>)> =
        path.operations.iter().map(|o| (Some(o.kind), words::operation(path, o, rapid_mm_per_min))).collect();
    if let Some((_, first)) = contents.first_mut() {
        first.splice(0..0, words::start(path));
    }
    if let Some((_, last)) = contents.last_mut() {
        last.push(Instruction::End);
    }
    if after_right < contents.len() {
        contents.insert(after_right, (None, Vec::new()));
    }
    contents
        .into_iter()
        .enumerate()
        .map(|(k, (operation, instructions))| InstructionFile { number: k + 1, operation, instructions })
        .collect()
}
