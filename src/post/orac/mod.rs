//! The ORAC's program language: instruction files, pages, and the way between them.
//!
//! Cutter location data become numbered instruction files (`.anc`), shortened ones (`.bnc`), and programs of pages (`.cnc`).

mod assemble;
mod compress;
mod divide;
mod files;
mod instruction;
mod number;
mod optimize;
mod page;
mod text;
mod words;
pub mod write;

use super::{BlockInfo, Options, PostOutput, Program, SideFile};
use crate::diagnostic::{Diagnostic, Place};
use crate::machine::{Axis, Machine};
use crate::turning::{CutMove, CutterPath};
use assemble::{Block, assemble};
pub use compress::compress;
pub use files::{InstructionFile, files};
pub use instruction::{Field, Instruction, Kind, Sense};
pub use optimize::optimize;
pub use page::{PAGE_START, pages_text};
pub use text::{instructions_text, parse_instructions};

/// The programs and instruction files of one set-up. `name` is the item's name; numbers are appended to it.
#[must_use]
pub fn post(name: &str, path: &CutterPath, options: &Options, machine: &Machine) -> PostOutput {
    let plain = files(path, machine.rapid_mm_per_min(Axis::Z));
    let mut side_files: Vec<SideFile> = plain.iter().map(|f| side_file(name, "anc", f)).collect();
    let used = if options.optimize { plain.iter().map(shortened).collect() } else { plain };
    if options.optimize {
        side_files.extend(used.iter().map(|f| side_file(name, "bnc", f)));
    }
    let limit = machine.limits.blocks_per_program;
    let assembled = assemble(&used, limit, options.automatic);
    let programs: Vec<Program> =
        (1..).zip(&assembled).map(|(k, blocks)| program(format!("{name}{k}"), blocks)).collect();
    let checked = programs.iter().zip(&assembled).flat_map(|(program, blocks)| check(program, blocks, machine));
    let diagnostics = passes_refused(path, machine).into_iter().chain(checked).collect();
    PostOutput { programs, side_files, diagnostics }
}

/// Single threading passes, for which the control has no instruction.
fn passes_refused(path: &CutterPath, machine: &Machine) -> Option<Diagnostic> {
    let operation = path.operations.iter().find(|o| o.moves.iter().any(|m| matches!(m, CutMove::ThreadPass { .. })))?;
    let message =
        format!("\"{}\" cuts a thread pass by pass; {} knows whole threads only.", operation.name, machine.name);
    let at = Place::Tool { station: operation.tool };
    Some(Diagnostic::error("orac-thread-pass", at, message).with_hint("Cut the thread by the control's own cycle."))
}

fn shortened(file: &InstructionFile) -> InstructionFile {
    InstructionFile { instructions: optimize(&file.instructions), ..*file }
}

fn side_file(name: &str, extension: &str, file: &InstructionFile) -> SideFile {
    SideFile {
        name: format!("{name}{}.{extension}", file.number),
        text: instructions_text(&file.instructions),
        instructions: file.instructions.len(),
    }
}

fn program(name: String, blocks: &[Block]) -> Program {
    let instructions: Vec<Instruction> = blocks.iter().map(|b| b.instruction).collect();
    let mut line = 1;
    let infos = blocks.iter().map(|block| {
        let lines = page::lines(&block.instruction);
        let Block { operation, operation_index, .. } = *block;
        let info = BlockInfo { summary: block.instruction.summary(), operation, operation_index, line, lines };
        line += lines;
        info
    });
    Program { name, extension: "cnc".to_owned(), blocks: infos.collect(), text: pages_text(&instructions) }
}

/// Values that the number layout cannot hold, and programs that the memory cannot.
fn check(program: &Program, blocks: &[Block], machine: &Machine) -> Vec<Diagnostic> {
    let (count, limit) = (blocks.len(), machine.limits.blocks_per_program);
    let at = |block: usize| Place::Block { program: program.name.clone(), block };
    let too_long = (count > limit).then(|| {
        let message = format!("{} has {count} pages; {} holds {limit}.", program.name, machine.name);
        Diagnostic::error("program-too-long", at(count), message)
    });
    let values =
        (1..).zip(blocks).flat_map(|(k, b)| b.instruction.fields().map(move |(field, value)| (k, field, value)));
    let wrong = values.filter_map(|(k, field, value)| {
        let message = number::checked(field, value).err()?;
        Some(Diagnostic::error("orac-value", at(k), message).with_hint("The control has no room for such a number."))
    });
    wrong.chain(too_long).collect()
}
