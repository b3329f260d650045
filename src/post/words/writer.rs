//! The blocks of one program as they are written, and what the control remembers from block to block.

use super::block::{Block, Line};
use super::control::{Control, Spindle};
use super::grid::Counts;
use super::recipes::Profile;
use crate::geometry::Point;

/// What the control remembers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct State {
    /// Number of the last motion word, G0 to G3.
    pub(super) motion: Option<u32>,
    /// Where the tool is; unknown after a move to a place of the machine.
    pub(super) at: Option<Counts>,
    /// The same point before it was rounded.
    pub(super) exact: Point,
    /// Counts of the last feed word.
    pub(super) feed: Option<i64>,
    /// Speed of the spindle.
    pub(super) spindle: Option<Spindle>,
    /// The last clamp, rev/min.
    pub(super) clamp: Option<u32>,
}

/// A program while it is written.
#[derive(Debug, Clone)]
pub(super) struct Writer<'a> {
    pub(super) control: &'a Control<'a>,
    pub(super) state: State,
    pub(super) blocks: Vec<Block>,
    /// Index of the operation that is written.
    pub(super) operation: Option<usize>,
    /// Words that the next motion block begins with.
    pub(super) pending: Option<String>,
    /// The contour that a finishing cycle may follow.
    pub(super) profile: Option<Profile>,
    next_number: u32,
    /// Characters of all blocks with their ends.
    pub(super) chars: usize,
}

/// A place in a program to go back to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    state: State,
    blocks: usize,
    next_number: u32,
    chars: usize,
}

impl<'a> Writer<'a> {
    pub(super) fn new(control: &'a Control<'a>) -> Self {
        let next_number = control.words.sequence_numbers.map_or(0, |n| n.first);
        Self {
            control,
            state: State::default(),
            blocks: Vec::new(),
            operation: None,
            pending: None,
            profile: None,
            next_number,
            chars: 0,
        }
    }

    pub(super) const fn line(&self) -> Line<'a> {
        Line::new(self.control)
    }

    pub(super) fn mark(&self) -> Mark {
        Mark { state: self.state, blocks: self.blocks.len(), next_number: self.next_number, chars: self.chars }
    }

    pub(super) fn back_to(&mut self, mark: Mark) {
        self.state = mark.state;
        self.blocks.truncate(mark.blocks);
        self.next_number = mark.next_number;
        self.chars = mark.chars;
        self.operation = None;
    }

    /// Adds a block with its sequence number.
    pub(super) fn push(&mut self, line: Line<'_>) {
        if line.text.is_empty() {
            return;
        }
        let mut numbered = self.line();
        if let Some(number) = self.sequence_number() {
            numbered.word(&number);
        }
        let space = usize::from(self.control.words.word_space && !numbered.text.is_empty());
        let words_at = numbered.text.len() + space;
        numbered.word(&line.text);
        numbered.faults = line.faults;
        self.finish(numbered, words_at, line.implied);
    }

    /// Adds one block of words that stand in the machine's data.
    pub(super) fn push_code(&mut self, code: &str) {
        let mut line = self.line();
        line.code(code);
        self.push(line);
    }

    /// Adds a line that has no sequence number: tape marks, program numbers, comments.
    pub(super) fn push_bare(&mut self, text: &str) {
        let mut line = self.line();
        line.text.push_str(text);
        self.finish(line, 0, "");
    }

    fn finish(&mut self, mut line: Line<'_>, words_at: usize, implied: &'static str) {
        let length = line.text.chars().count();
        if let Some(most) = self.control.words.max_line_chars.filter(|&most| length > most) {
            let message = format!("The block has {length} characters; the control reads {most}.");
            line.fault("line-too-long", message, "Leave out sequence numbers or blanks in the machine's words.");
        }
        self.chars += length + self.control.words.block_end.chars().count();
        let Line { text, faults, .. } = line;
        self.blocks.push(Block { text, words_at, implied, operation: self.operation, faults });
    }

    /// The number of the block after `blocks` more, if it has one.
    pub(super) fn number_ahead(&self, blocks: u32) -> Option<u32> {
        let numbers = self.control.words.sequence_numbers?;
        let number = self.next_number.saturating_add(numbers.step.saturating_mul(blocks));
        let most = self.control.words.digits.get(&'N').map_or(usize::MAX, |digits| usize::from(digits.most));
        (number.to_string().len() <= most).then_some(number)
    }

    /// The next N word; blocks beyond the highest number have none, so that no number is there twice.
    fn sequence_number(&mut self) -> Option<String> {
        let numbers = self.control.words.sequence_numbers?;
        let text = format!("{:0>width$}", self.next_number, width = usize::from(numbers.digits));
        let most = self.control.words.digits.get(&'N').map_or(usize::MAX, |digits| usize::from(digits.most));
        if text.len() > most {
            return None;
        }
        self.next_number = self.next_number.saturating_add(numbers.step);
        Some(format!("N{text}"))
    }
}
