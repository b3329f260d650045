//! One block: its words, and what cannot be written in it.

use super::control::Control;
use super::number::{NumberFormat, whole};
use crate::diagnostic::Severity;

/// Something about a block that has to be said.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) severity: Severity,
    pub(super) code: &'static str,
    pub(super) message: String,
    pub(super) hint: &'static str,
}

/// A block of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Block {
    /// The whole line.
    pub(super) text: String,
    /// Where its words begin behind the sequence number.
    pub(super) words_at: usize,
    /// The modal motion that it leaves out, for people.
    pub(super) implied: &'static str,
    /// Index of the operation it belongs to.
    pub(super) operation: Option<usize>,
    pub(super) faults: Vec<Fault>,
}

impl Block {
    /// The words with blanks between them, the motion included that is not repeated.
    pub(super) fn summary(&self) -> String {
        let words = self.text.get(self.words_at..).unwrap_or_default();
        if words.starts_with('(') {
            return words.to_owned();
        }
        let mut text = self.implied.to_owned();
        for c in words.chars().filter(|c| !c.is_whitespace()) {
            if c.is_ascii_alphabetic() && !text.is_empty() {
                text.push(' ');
            }
            text.push(c);
        }
        text
    }
}

/// The words of a block while it is put together.
#[derive(Debug)]
pub(super) struct Line<'a> {
    control: &'a Control<'a>,
    pub(super) text: String,
    pub(super) implied: &'static str,
    pub(super) faults: Vec<Fault>,
}

impl<'a> Line<'a> {
    pub(super) const fn new(control: &'a Control<'a>) -> Self {
        Self { control, text: String::new(), implied: "", faults: Vec::new() }
    }

    /// Adds words as they stand in the machine's data; nothing for none.
    pub(super) fn code(&mut self, code: &str) -> &mut Self {
        for word in code.split_whitespace() {
            self.word(word);
        }
        self
    }

    pub(super) fn word(&mut self, word: &str) -> &mut Self {
        if self.control.words.word_space && !self.text.is_empty() {
            self.text.push(' ');
        }
        self.text.push_str(word);
        self
    }

    /// A whole-number word.
    pub(super) fn whole(&mut self, address: char, number: u32) -> &mut Self {
        match whole(self.control.words, address, number) {
            Ok(word) => self.word(&word),
            Err(most) => {
                let message = format!("The word {address}{number} has more digits than the {most} that fit.");
                self.fault("word-too-long", message, "Choose a value that the control can read.");
                self.word(&format!("{address}{number}"))
            }
        }
    }

    /// A decimal word.
    pub(super) fn number(&mut self, address: char, format: NumberFormat, counts: i64) -> &mut Self {
        let text = format.text(counts);
        if counts.unsigned_abs() > format.most().unsigned_abs() {
            let most = format.text(format.most());
            let message = format!("{address} is {text}; the largest number that its word can hold is {most}.");
            self.fault("word-too-long", message, "Move the program zero, or choose a machine that is large enough.");
        }
        self.word(&format!("{address}{text}"))
    }

    /// A length.
    pub(super) fn length(&mut self, address: char, counts: i64) -> &mut Self {
        self.number(address, self.control.grid.format, counts)
    }

    pub(super) fn fault(&mut self, code: &'static str, message: String, hint: &'static str) {
        self.faults.push(Fault { severity: Severity::Error, code, message, hint });
    }

    pub(super) fn warn(&mut self, code: &'static str, message: String, hint: &'static str) {
        self.faults.push(Fault { severity: Severity::Warning, code, message, hint });
    }
}
