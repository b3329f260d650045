//! Posts: from cutter location data to the text that a control reads.

mod header;
pub mod orac;
pub mod words;

use crate::diagnostic::Diagnostic;
use crate::machine::{Dialect, Machine};
use crate::turning::{CutterPath, OperationKind};
use crate::units::Unit;
pub use header::Header;

/// How programs are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(clippy::struct_excessive_bools, reason = "each is a choice of its own")]
pub struct Options {
    /// Shorten an ORAC's files with [`orac::optimize`] before they are assembled.
    pub optimize: bool,
    /// Put signals for turret and part handling in front of tool changes and of the end.
    pub automatic: bool,
    /// A program of its own for every operation.
    pub separate_programs: bool,
    /// Unit of the programs on controls that read words.
    pub unit: Unit,
    /// Number of the first program; the machine's usual one without.
    pub program_number: Option<u32>,
    /// Write the control's own cycles where it has them and the operation describes one.
    pub canned_cycles: bool,
    /// Let the control compensate the nose radius where the operation tells its contour.
    pub compensated_by_control: bool,
}

/// The programs of one set-up in the language of its machine. `name` is the item's name; numbers are appended to it.
#[must_use]
pub fn post(name: &str, path: &CutterPath, options: &Options, header: &Header, machine: &Machine) -> PostOutput {
    match machine.dialect {
        Dialect::Orac => orac::post(name, path, options, machine),
        Dialect::Fanuc | Dialect::Linuxcnc => words::post(name, path, options, header, machine),
    }
}

/// A program for a control, ready to be sent or saved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Program {
    /// Name without extension: `QUEEN1`.
    pub name: String,
    /// File extension without the dot: `cnc`.
    pub extension: String,
    /// The text with the control's own characters.
    pub text: String,
    /// Every block of the text in order.
    pub blocks: Vec<BlockInfo>,
}

/// What a block of a program is for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BlockInfo {
    /// One line for people: `PTP X -0.800 Z 0.000 F 80 T1 S1262`.
    pub summary: String,
    /// Operation that the block belongs to; `None` for start and end.
    pub operation: Option<OperationKind>,
    /// Its index in the path's operations; tells operations of one kind apart.
    pub operation_index: Option<usize>,
    /// First line of the block in the text, from 1.
    pub line: usize,
    /// Number of lines.
    pub lines: usize,
}

/// A file that a post writes beside the programs, such as the instructions before assembly.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SideFile {
    /// File name with extension: `QUEEN1.anc`.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Instructions in it.
    pub instructions: usize,
}

/// What a post makes of one set-up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PostOutput {
    /// Programs in the order of cutting.
    pub programs: Vec<Program>,
    /// Files for people and other programs.
    pub side_files: Vec<SideFile>,
    /// What the post has to say.
    pub diagnostics: Vec<Diagnostic>,
}
