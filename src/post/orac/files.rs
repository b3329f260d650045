//! The numbered instruction files of a set-up, as published.

use super::instruction::Instruction;
use super::words;
use crate::turning::{CutterPath, Operation, OperationKind};

/// One instruction file: `NAME1.anc` is number 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InstructionFile {
    /// Number in the file name, from 1.
    pub number: usize,
    /// What it cuts; `None` for file 3.
    pub operation: Option<OperationKind>,
    /// Index of that in the path's operations.
    pub operation_index: Option<usize>,
    /// Its instructions.
    pub instructions: Vec<Instruction>,
}

/// The files of `path` in order of cutting; air is crossed at `rapid_mm_per_min`.
///
/// File 1 is right-hand roughing and begins with the format, the unit and the datum; file 2 is right-hand finishing; file 3
/// is empty, as in both published parts; the other operations follow. A path that begins with another operation has no empty
/// file, for the first one begins every program. The last file ends with the end instruction. Without
/// operations there are no files.
#[must_use]
pub fn files(path: &CutterPath, rapid_mm_per_min: f64) -> Vec<InstructionFile> {
    let is_right = |kind| matches!(kind, OperationKind::RoughRight | OperationKind::FinishRight);
    let after_right = path.operations.iter().take_while(|o| is_right(o.kind)).count();
    let instructions = |o: &Operation| words::operation(path, o, rapid_mm_per_min);
    let mut files: Vec<InstructionFile> = path
        .operations
        .iter()
        .enumerate()
        .map(|(index, o)| InstructionFile {
            number: 0,
            operation: Some(o.kind),
            operation_index: Some(index),
            instructions: instructions(o),
        })
        .collect();
    if let Some(first) = files.first_mut() {
        first.instructions.splice(0..0, words::start(path));
    }
    if let Some(last) = files.last_mut() {
        last.instructions.push(Instruction::End);
    }
    if (1..files.len()).contains(&after_right) {
        let unused = InstructionFile { number: 0, operation: None, operation_index: None, instructions: Vec::new() };
        files.insert(after_right, unused);
    }
    files.iter_mut().zip(1..).for_each(|(file, number)| file.number = number);
    files
}
