//! The layout of pages: a header with number and name, then one value a line.

use super::{Layout, Listing, Op, Reading, STX, Word, shown};

/// Reads a text of pages.
pub(super) fn read(lines: &[&str]) -> Listing {
    let mut reading = Reading::new(Layout::Pages);
    let mut troubles_before = 0;
    for (index, text) in lines.iter().enumerate() {
        let line = index + 1;
        if let Some(rest) = header(text) {
            reading.finish(troubles_before);
            troubles_before = reading.listing.troubles.len();
            begin_page(&mut reading, line, rest);
        } else if !bare(text).is_empty() {
            value_line(&mut reading, line, text);
        }
    }
    reading.finish(troubles_before);
    reading.listing
}

/// What follows `PAGE` if the line is a page header.
pub(super) fn header(line: &str) -> Option<&str> {
    let line = bare(line);
    let (head, rest) = line.split_at_checked(4)?;
    head.eq_ignore_ascii_case("PAGE").then_some(rest)
}

/// A line without its page mark and outer blanks.
fn bare(line: &str) -> &str {
    line.trim().trim_start_matches(STX).trim()
}

fn begin_page(reading: &mut Reading, line: usize, rest: &str) {
    let rest = rest.trim_start();
    let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let (number, name) = rest.split_at(digits);
    let printed = number.parse().ok();
    let name = joined(name);
    let found = Op::from_header(&name);
    reading.begin(printed, line, found.map(|(op, _)| op));
    if printed.is_none() {
        reading.trouble(line, format!("The page has no number: \"{}\".", shown(rest)));
    }
    match found {
        None => reading.trouble(line, format!("\"{}\" is not an instruction of the control.", shown(&name))),
        Some((_, Some(sense))) => reading.word(line, Word::Sense, &sense.to_string()),
        Some((_, None)) => {}
    }
}

fn value_line(reading: &mut Reading, line: usize, text: &str) {
    let Some(block) = reading.listing.blocks.last() else {
        return reading.trouble(line, format!("\"{}\" stands before the first page.", shown(text)));
    };
    let Some(op) = block.op else {
        return reading.trouble(line, format!("\"{}\" belongs to a page that cannot be read.", shown(text)));
    };
    let text = text.trim();
    let named = |word: &&Word| {
        text.get(..word.name().len()).is_some_and(|head| head.eq_ignore_ascii_case(word.name()))
            && **word != Word::Sense
    };
    match op.words().iter().filter(named).max_by_key(|word| word.name().len()) {
        Some(&word) => reading.word(line, word, &text[word.name().len()..]),
        None => reading.trouble(line, format!("\"{}\" is not a value of {}.", shown(text), op.mnemonic())),
    }
}

/// In capitals without blanks.
fn joined(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).map(|c| c.to_ascii_uppercase()).collect()
}
