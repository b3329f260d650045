//! Reads programs of letters and numbers into blocks of words: `N590G3X-128.592Z29.278I-0.458K0.148`.
//!
//! Only the text is looked at here: what the words mean is the business of the interpreter.

mod number;
mod scan;

pub use number::Number;
pub use scan::read;

use super::Trouble;

/// A program text, read.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tape {
    /// Its blocks in the order of the text, one a line and more where `;` parts them. Tape marks and lines with nothing but a
    /// comment are blocks without words; empty lines are none.
    pub blocks: Vec<WordBlock>,
    /// What could not be read.
    pub troubles: Vec<Trouble>,
    /// A `%` stands in front of the first word.
    pub opened: bool,
    /// A `%` stands behind the last word.
    pub closed: bool,
}

/// One block of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct WordBlock {
    /// Its N word.
    pub printed: Option<u32>,
    /// Line of the text, from 1.
    pub line: usize,
    /// It begins with `/`: the operator's switch leaves it out.
    pub optional: bool,
    /// Its words in the order of the text, without N.
    pub words: Vec<Word>,
    /// The LinuxCNC flow word that it is.
    pub flow: Option<Flow>,
}

/// A letter with its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Word {
    /// Address, a capital.
    pub letter: char,
    /// Number.
    pub number: Number,
}

/// A subroutine word of LinuxCNC with the subroutine's name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Flow {
    /// `O100 sub`.
    Sub(String),
    /// `O100 endsub`.
    EndSub(String),
    /// `O100 return`.
    Return(String),
    /// `O100 call`.
    Call(String),
}

impl Tape {
    /// Blocks with words, with their numbers from 1.
    #[must_use]
    pub fn with_words(&self) -> impl DoubleEndedIterator<Item = (usize, &WordBlock)> {
        self.blocks.iter().enumerate().map(|(index, block)| (index + 1, block)).filter(|(_, block)| !block.is_empty())
    }
}

impl WordBlock {
    /// True if it has no words: a tape mark or a comment.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.words.is_empty() && self.flow.is_none() && self.printed.is_none()
    }

    /// The number of the word with this letter; of several the last, which the controls take.
    #[must_use]
    pub fn number(&self, letter: char) -> Option<Number> {
        self.words.iter().rev().find(|word| word.letter == letter).map(|word| word.number)
    }

    /// True if it has a word with this letter.
    #[must_use]
    pub fn has(&self, letter: char) -> bool {
        self.words.iter().any(|word| word.letter == letter)
    }

    /// The numbers of all words with this letter.
    pub fn all(&self, letter: char) -> impl Iterator<Item = Number> + '_ {
        self.words.iter().filter(move |word| word.letter == letter).map(|word| word.number)
    }
}

#[cfg(test)]
mod tests;
