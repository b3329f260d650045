//! What can be told from the text of a program of words without running it. One file a rule; every rule says why, and speaks
//! only where the control demands it.

mod characters;
mod clamp;
mod comments;
mod compensation;
mod decimal_point;
mod end;
mod home;
mod length;
mod m_words;
mod numbers;
mod offset;
mod tape_marks;
mod units;

use super::findings::{Breach, Findings, Place};
use super::reader::words::{Tape, WordBlock};
use super::report::FindingKind;
use crate::diagnostic::Severity;
use crate::machine::{Machine, Words};

/// A program and the control that is to read it.
struct Program<'a> {
    tape: &'a Tape,
    text: &'a str,
    machine: &'a Machine,
    words: &'a Words,
}

/// What a rule has to say about a block.
#[derive(Debug, Clone, PartialEq)]
struct Remark {
    /// Block from 1.
    block: usize,
    severity: Severity,
    /// Measured value.
    value: f64,
    /// What is allowed.
    limit: f64,
    /// A sentence with the reason.
    message: String,
}

type Rule = fn(&Program<'_>) -> Vec<Remark>;

/// Every rule under its name.
const RULES: [(&str, Rule); 13] = [
    ("lint characters", characters::check),
    ("lint clamp", clamp::check),
    ("lint comments", comments::check),
    ("lint compensation", compensation::check),
    ("lint decimal point", decimal_point::check),
    ("lint end", end::check),
    ("lint home", home::check),
    ("lint length", length::check),
    ("lint m words", m_words::check),
    ("lint numbers", numbers::check),
    ("lint offset", offset::check),
    ("lint tape marks", tape_marks::check),
    ("lint units", units::check),
];

/// Adds what the rules find in a program.
pub(super) fn check(tape: &Tape, text: &str, program: usize, machine: &Machine, findings: &mut Findings) {
    let Some(words) = &machine.words else { return };
    let subject = Program { tape, text, machine, words };
    for (name, rule) in RULES {
        for remark in rule(&subject) {
            let Remark { block, severity, value, limit, message } = remark;
            let breach = Breach { rule: name, severity, kind: FindingKind::Lint, at: None, value, limit, message };
            findings.add_each(Place { program, block: block.max(1) }, breach);
        }
    }
}

impl Remark {
    fn error(block: usize, value: f64, limit: f64, message: String) -> Self {
        Self { block, severity: Severity::Error, value, limit, message }
    }

    fn warning(block: usize, value: f64, limit: f64, message: String) -> Self {
        Self { severity: Severity::Warning, ..Self::error(block, value, limit, message) }
    }

    fn info(block: usize, value: f64, limit: f64, message: String) -> Self {
        Self { severity: Severity::Info, ..Self::error(block, value, limit, message) }
    }
}

impl Program<'_> {
    /// Blocks with words, with their numbers from 1.
    fn blocks(&self) -> impl DoubleEndedIterator<Item = (usize, &WordBlock)> {
        self.tape.with_words()
    }

    /// The block that a line of the text belongs to, from 1: the last one that begins at or above it.
    fn block_at(&self, line: usize) -> usize {
        self.tape.blocks.partition_point(|block| block.line <= line).max(1)
    }

    /// Lines of the text with their numbers from 1, as the reader parts them.
    fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        let parted_by = if self.text.contains('\n') { '\n' } else { '\r' };
        (1..).zip(self.text.split(parted_by)).map(|(line, text)| (line, text.trim_end_matches('\r')))
    }
}

/// True if a block has this code, such as G 96.
fn has(block: &WordBlock, letter: char, value: f64) -> bool {
    block.all(letter).any(|number| number.plain() == value)
}

#[cfg(test)]
mod fixture {
    use super::{Program, Remark, Rule};
    use crate::machine::{Catalog, Machine};
    use crate::proof::reader::words::read;

    pub(super) fn machine(id: &str) -> Machine {
        Catalog::shipped().machine(id).unwrap().clone()
    }

    /// What a rule says about a text on a shipped machine.
    pub(super) fn remarks(rule: Rule, id: &str, text: &str) -> Vec<Remark> {
        let machine = machine(id);
        let tape = read(text, machine.dialect);
        rule(&Program { tape: &tape, text, machine: &machine, words: machine.words.as_ref().unwrap() })
    }

    /// Blocks that a rule speaks about.
    pub(super) fn blocks(rule: Rule, id: &str, text: &str) -> Vec<usize> {
        remarks(rule, id, text).iter().map(|r| r.block).collect()
    }
}
