//! Reads programs, made here or typed at the lathe, into blocks. Shares nothing with the posts.
//!
//! `orac` reads the pages and instruction lists of the ORAC, `words` the letters and numbers of all other controls.
//! Whatever cannot be read is a [`Trouble`], never skipped silently.

mod orac;
pub mod words;

pub(crate) use orac::CLOCKWISE;
pub use orac::{Block, Layout, Listing, Op, Word, read};

/// Something that could not be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trouble {
    /// Block from 1 in the order of the text; text before the first block counts to block 1.
    pub block: usize,
    /// Line from 1.
    pub line: usize,
    /// What is wrong, with the text that could not be read.
    pub message: String,
}

/// Text as it can be shown in a message: short, control characters visible.
fn shown(text: &str) -> String {
    /// Longest piece of a bad text that a message repeats, characters.
    const LONGEST: usize = 40;
    let visible: String = text.trim().chars().take(LONGEST).collect();
    visible.escape_default().to_string()
}
