//! Pages (`.cnc`): the form in which the control keeps and sends instructions.

use super::instruction::{Field, Instruction};
use super::number;
use std::fmt::Write;

/// Character in front of every page (start of text).
pub const PAGE_START: char = '\u{2}';

/// End of a line on a page.
const LINE_END: &str = "\r\n";

/// Characters of a page with room to spare.
const TYPICAL_PAGE: usize = 112;

/// The pages of a program, numbered from 1. Nothing follows the last one.
#[must_use]
pub fn pages_text(instructions: &[Instruction]) -> String {
    let mut text = String::with_capacity(instructions.len() * TYPICAL_PAGE);
    for (number, instruction) in (1..).zip(instructions) {
        push_page(&mut text, number, instruction);
    }
    text
}

/// Adds one page.
fn push_page(text: &mut String, number: usize, instruction: &Instruction) {
    // Writing to a String cannot fail.
    let _ = write!(text, "{PAGE_START}PAGE {number:02} ");
    text.push_str(instruction.kind().heading());
    text.push_str(LINE_END);
    for (field, value) in instruction.fields() {
        text.push_str(field.label());
        match field {
            Field::Feed => number::push(text, field, value, 5),
            _ if field.is_decimal() => number::push(text, field, value, 9),
            _ => {
                text.push(' ');
                number::push(text, field, value, 0);
            }
        }
        text.push_str(LINE_END);
    }
}

/// Lines of the page of `instruction`.
pub(super) fn lines(instruction: &Instruction) -> usize {
    1 + instruction.kind().fields().len()
}
