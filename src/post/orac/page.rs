//! Pages (`.cnc`): the form in which the control keeps and sends instructions.

use super::instruction::{Field, Instruction};
use std::fmt::Write;

/// Character in front of every page (start of text).
pub const PAGE_START: char = '\u{2}';

/// End of a line on a page.
const LINE_END: &str = "\r\n";

/// The pages of a program, numbered from 1. Nothing follows the last one.
#[must_use]
pub fn pages_text(instructions: &[Instruction]) -> String {
    (1..).zip(instructions).map(|(number, instruction)| page(number, instruction)).collect()
}

/// One page.
pub(super) fn page(number: usize, instruction: &Instruction) -> String {
    let mut page = format!("{PAGE_START}PAGE {number:02} {}{LINE_END}", instruction.kind().heading());
    for (field, value) in instruction.fields() {
        let (label, value) = (field.label(), field.written(value));
        // Writing to a String cannot fail.
        let _ = match field {
            Field::Feed => write!(page, "{label}{value:>5}{LINE_END}"),
            _ if field.is_decimal() => write!(page, "{label}{value:>9}{LINE_END}"),
            _ => write!(page, "{label} {value}{LINE_END}"),
        };
    }
    page
}

/// Lines of the page of `instruction`.
pub(super) fn lines(instruction: &Instruction) -> usize {
    1 + instruction.kind().fields().len()
}
