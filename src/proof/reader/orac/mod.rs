//! Reads ORAC programs, made here or typed at the lathe, into blocks. Shares nothing with the post.
//!
//! Two layouts are recognised by their content: pages (`PAGE 04 POINT-TO-POINT.G00,G01` and one value a line, each page
//! begun by STX on the wire) and instruction lists (one instruction a line). Both are read leniently where real files are
//! irregular (blanks, missing STX or CR, small letters); whatever cannot be read is a [`Trouble`], never skipped silently.

mod instructions;
mod number;
mod pages;
mod words;

pub(crate) use words::CLOCKWISE;
pub use words::{Op, Word};

use super::{Trouble, shown};
use number::{BadNumber, LARGEST_NUMBER};

/// Character that begins a page.
const STX: char = '\u{2}';
/// Character that ends a transfer; harmless at the end of a file.
const EOT: char = '\u{4}';

/// Layout of a program text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// Pages as the control stores and sends them.
    Pages,
    /// One instruction a line.
    Instructions,
}

/// A program text, read.
#[derive(Debug, Clone, PartialEq)]
pub struct Listing {
    /// How it was laid out.
    pub layout: Layout,
    /// Its blocks in the order of the text.
    pub blocks: Vec<Block>,
    /// What could not be read.
    pub troubles: Vec<Trouble>,
}

/// One block (page) of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Number written in the text, if any; blocks are otherwise counted from 1 in the order of the text.
    pub printed: Option<u32>,
    /// First line of the block, from 1.
    pub line: usize,
    /// Its instruction; `None` if it cannot be read.
    pub op: Option<Op>,
    /// Values that could be read, in the unit of the program.
    pub words: Vec<(Word, f64)>,
}

impl Block {
    /// The value of a word, if it was given and readable.
    #[must_use]
    pub fn value(&self, word: Word) -> Option<f64> {
        self.words.iter().find(|(w, _)| *w == word).map(|&(_, value)| value)
    }
}

/// Reads a program of either layout.
#[must_use]
pub fn read(text: &str) -> Listing {
    let text = text.trim_end_matches(|c: char| c == EOT || c.is_whitespace());
    let lines: Vec<&str> = if text.contains('\n') { text.lines().collect() } else { text.split('\r').collect() };
    if lines.iter().any(|line| pages::header(line).is_some()) {
        pages::read(&lines)
    } else {
        instructions::read(&lines)
    }
}

/// Collects blocks and troubles while a text is read.
struct Reading {
    listing: Listing,
}

impl Reading {
    fn new(layout: Layout) -> Self {
        Self { listing: Listing { layout, blocks: Vec::new(), troubles: Vec::new() } }
    }

    fn trouble(&mut self, line: usize, message: String) {
        let block = self.listing.blocks.len().max(1);
        self.listing.troubles.push(Trouble { block, line, message });
    }

    /// Starts a block.
    fn begin(&mut self, printed: Option<u32>, line: usize, op: Option<Op>) {
        self.listing.blocks.push(Block { printed, line, op, words: Vec::new() });
    }

    /// Adds a value to the open block, or says why not.
    fn word(&mut self, line: usize, word: Word, text: &str) {
        let name = word.name();
        let value = match number::number(text) {
            Ok(value) if word.is_whole() && (value.fract() != 0.0 || value < 0.0) => {
                return self.trouble(line, format!("{name} {value} must be a whole number from 0 up."));
            }
            Ok(value) => value,
            Err(BadNumber::Form) => {
                return self.trouble(line, format!("\"{}\" is not a number for {name}.", shown(text)));
            }
            Err(BadNumber::TooLarge) => {
                let text = shown(text);
                return self.trouble(line, format!("{name} {text} is larger than the control's {LARGEST_NUMBER}."));
            }
        };
        let Some(block) = self.listing.blocks.last_mut() else { return };
        if block.words.iter().any(|(w, _)| *w == word) {
            return self.trouble(line, format!("{name} is given twice in one block."));
        }
        block.words.push((word, value));
    }

    /// Closes the open block: every value that its instruction needs must be there. A value that was there but could not be
    /// read has its own trouble already.
    fn finish(&mut self, troubles_before: usize) {
        let Some(block) = self.listing.blocks.last_mut() else { return };
        let Some(op) = block.op else { return };
        let line = block.line;
        block.words.sort_by_key(|(word, _)| op.words().iter().position(|w| w == word));
        let missing: Vec<&str> =
            op.words().iter().filter(|&&w| block.value(w).is_none()).map(|word| word.name()).collect();
        if !missing.is_empty() && self.listing.troubles.len() == troubles_before {
            self.trouble(line, format!("{} needs {}, which is missing.", op.mnemonic(), missing.join(" and ")));
        }
    }
}

#[cfg(test)]
mod tests;
