//! The ORAC's program language: instruction files, pages, and the way between them.

mod files;
mod instruction;
mod number;
mod text;
mod words;

pub use files::{InstructionFile, files};
pub use instruction::{Field, Instruction, Kind, Sense};
pub use text::{instructions_text, parse_instructions};
