//! COMPRESS: from pages to instructions, reading as leniently as real files need.

use super::instruction::{Field, Instruction, Kind};
use super::number;
use crate::diagnostic::{Diagnostic, Place};

/// Character that ends a transfer; what follows it is no part of the program.
const END_OF_TRANSFER: char = '\u{4}';

/// The word that begins every page.
const PAGE: &str = "PAGE";

/// Reads the pages of `program`. Pages that cannot be read are left out and named in the diagnostics by their place in
/// the text. Control characters, blanks, ends of lines, small letters and page numbers do not matter.
#[must_use]
pub fn compress(text: &str, program: &str) -> (Vec<Instruction>, Vec<Diagnostic>) {
    let sent = text.split(END_OF_TRANSFER).next().unwrap_or_default();
    let solid: String = sent.chars().filter(|c| !c.is_whitespace() && !c.is_control()).collect();
    let solid = solid.to_uppercase();
    let mut instructions = Vec::new();
    let mut diagnostics = Vec::new();
    for (block, page) in solid.split(PAGE).enumerate() {
        let read = match (block, page) {
            (0, "") => continue,
            (0, other) => Err(format!("The text before the first page, '{other}', is no page.")),
            (_, page) => read_page(page),
        };
        match read {
            Ok(instruction) => instructions.push(instruction),
            Err(message) => {
                let at = Place::Block { program: program.to_owned(), block };
                diagnostics.push(Diagnostic::error("orac-page", at, message));
            }
        }
    }
    (instructions, diagnostics)
}

/// Reads one page without its first word and without blanks: number, heading, fields.
fn read_page(page: &str) -> Result<Instruction, String> {
    let body = page.trim_start_matches(|c: char| c.is_ascii_digit());
    let (kind, mut rest) = heading(body).ok_or_else(|| format!("The page '{body}' has no heading of the ORAC."))?;
    let mut values: Vec<Option<i32>> = vec![None; kind.fields().len()];
    while !rest.is_empty() {
        let (at, field, after) =
            label(kind, rest).ok_or_else(|| format!("{} does not have the field '{rest}'.", kind.heading()))?;
        let end = after.find(|c: char| !matches!(c, '0'..='9' | '+' | '-' | '.')).unwrap_or(after.len());
        let (digits, next) = after.split_at(end);
        if let Some(value) = values.get_mut(at) {
            *value = Some(number::parse(field, digits)?);
        }
        rest = next;
    }
    let missing = kind.fields().iter().zip(&values).find(|(_, value)| value.is_none());
    if let Some((field, _)) = missing {
        return Err(format!("{} has no {}.", kind.heading(), field.label()));
    }
    let values: Vec<i32> = values.into_iter().flatten().collect();
    kind.instruction(&values).ok_or_else(|| format!("{} has the wrong number of values.", kind.heading()))
}

/// The kind that a page begins with, and what follows its heading. The code after the heading's point may be missing where
/// the words say enough.
fn heading(body: &str) -> Option<(Kind, &str)> {
    let whole = Kind::ALL.into_iter().find_map(|k| Some((k, body.strip_prefix(k.heading())?)));
    let words = || {
        Kind::ALL.into_iter().filter(|k| k.sense_word().is_none()).find_map(|kind| {
            let words = kind.heading().split('.').next()?;
            let rest = body.strip_prefix(words)?;
            Some((kind, rest.trim_start_matches(|c: char| matches!(c, '.' | ',' | 'G' | 'M' | '0'..='9'))))
        })
    };
    whole.or_else(words)
}

/// The field that `rest` begins with: its place in the instruction, and what follows its label.
fn label(kind: Kind, rest: &str) -> Option<(usize, Field, &str)> {
    let mut fields = kind.fields().iter().enumerate();
    fields.find_map(|(at, &field)| Some((at, field, rest.strip_prefix(field.label())?)))
}

#[cfg(test)]
mod tests {
    use super::super::instruction::tests::any_instruction;
    use super::super::page::pages_text;
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn blanks_small_letters_and_missing_marks_do_not_matter() {
        let typed = "\u{2}PAGE 04 POINT-TO-POINT.G00,G01\r\nX 0.000 z - 20.000FEEDRATE 1000 TOOL-NO 1\nSPINDLE-SPEED 1094\u{4}junk";
        let (read, diagnostics) = compress(typed, "P");
        assert_eq!(diagnostics, []);
        assert_eq!(read, [Instruction::Ptp { x: 0, z: -20_000, feed: 1000, tool: 1, rpm: 1094 }]);
        assert_eq!(compress("PAGE 92 END-PROGRAM", "P").0, [Instruction::End]);
    }

    #[test]
    fn bad_pages_are_named_with_what_is_wrong() {
        let text = "PAGE 01 INCREMENTAL-FORMAT.G91 PAGE 02 POINT-TO-POINT X 1 Z 2 TOOL-NO 1 SPINDLE-SPEED 9 \
                    PAGE 03 HOVER PAGE 04 DWELL.G04 TIME 1.2.3 PAGE 05 START-DO-LOOP COUNT 0 PAGE 06 CIRCULAR X 1";
        let (read, diagnostics) = compress(text, "P");
        assert_eq!(read, [Instruction::Inc]);
        let messages: Vec<&str> = diagnostics.iter().map(|d| d.message.as_str()).collect();
        assert_eq!(
            messages,
            [
                "POINT-TO-POINT.G00,G01 has no FEEDRATE.",
                "The page 'HOVER' has no heading of the ORAC.",
                "TIME is '1.2.3', which is not a number.",
                "COUNT is 0; it must lie between 1 and 999.",
                "The page 'CIRCULARX1' has no heading of the ORAC.",
            ]
        );
        assert_eq!(diagnostics[0].at, Place::Block { program: "P".into(), block: 2 });
    }

    proptest! {
        #[test]
        fn pages_round_trip(list in proptest::collection::vec(any_instruction(), 0..40)) {
            let (read, diagnostics) = compress(&pages_text(&list), "P");
            prop_assert!(diagnostics.is_empty(), "{:?}", diagnostics);
            prop_assert_eq!(read, list);
        }

        #[test]
        fn any_text_is_read_without_harm(text in "(PAGE|[A-Z]{1,3}|[ -~\u{2}]){0,60}") {
            let _ = compress(&text, "P");
        }
    }
}
