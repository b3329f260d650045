//! The layout of instruction lists: number, mnemonic and values on one line.

use super::words::COUNTER_CLOCKWISE;
use super::{CLOCKWISE, Layout, Listing, Op, Reading, Word, number, shown};

/// Reads a text of instructions.
pub(super) fn read(lines: &[&str]) -> Listing {
    let mut reading = Reading::new(Layout::Instructions);
    for (index, text) in lines.iter().enumerate() {
        let text = text.trim();
        if !text.is_empty() {
            let troubles_before = reading.listing.troubles.len();
            instruction(&mut reading, index + 1, text);
            reading.finish(troubles_before);
        }
    }
    reading.listing
}

fn instruction(reading: &mut Reading, line: usize, text: &str) {
    let after_number = text.trim_start_matches(|c: char| c.is_ascii_digit());
    let printed = text[..text.len() - after_number.len()].parse().ok();
    let text = after_number.trim_start();
    let values = text.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let name = text[..text.len() - values.len()].to_ascii_uppercase();
    let op = Op::from_mnemonic(&name);
    reading.begin(printed, line, op);
    match op {
        Some(op) => read_values(reading, line, op, &number::fields(values)),
        None => reading.trouble(line, format!("\"{}\" is not an instruction of the control.", shown(text))),
    }
}

fn read_values(reading: &mut Reading, line: usize, op: Op, fields: &[String]) {
    for (&word, field) in op.words().iter().zip(fields) {
        match (word, field.to_ascii_uppercase().as_str()) {
            (Word::Sense, "CW") => reading.word(line, word, &CLOCKWISE.to_string()),
            (Word::Sense, "CCW") => reading.word(line, word, &COUNTER_CLOCKWISE.to_string()),
            (Word::Sense, other) => reading.trouble(line, format!("\"{}\" is neither CW nor CCW.", shown(other))),
            _ => reading.word(line, word, field),
        }
    }
    if let Some(extra) = fields.get(op.words().len()) {
        reading.trouble(line, format!("{} has a value too many: \"{}\".", op.mnemonic(), shown(extra)));
    }
}
