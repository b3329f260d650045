//! Instruction files (`.anc`, `.bnc`): one numbered line an instruction.

use super::instruction::{Field, Instruction, Kind};
use super::number;
use crate::diagnostic::{Diagnostic, Place};
use std::fmt::Write;

/// Characters of a line with room to spare.
const TYPICAL_LINE: usize = 48;

/// The text of an instruction file, lines numbered from 1 and ended by LF.
#[must_use]
pub fn instructions_text(instructions: &[Instruction]) -> String {
    let mut text = String::with_capacity(instructions.len() * TYPICAL_LINE);
    for (k, instruction) in instructions.iter().enumerate() {
        // Writing to a String cannot fail.
        let _ = write!(text, "{:>3}  ", k + 1);
        push_line(&mut text, instruction);
        text.push('\n');
    }
    text
}

/// Adds one line without its number.
fn push_line(text: &mut String, instruction: &Instruction) {
    let kind = instruction.kind();
    let fields = kind.fields();
    let of_sort = |decimal: bool| instruction.fields().filter(move |(field, _)| field.is_decimal() == decimal);
    text.push_str(kind.word());
    if let Some(first) = fields.first() {
        let width = if first.is_decimal() { 4_usize } else { 3 };
        text.extend(std::iter::repeat_n(' ', width.saturating_sub(kind.word().len())));
    }
    for (field, value) in of_sort(true) {
        number::push(text, field, value, 9);
    }
    if let Some(sense) = kind.sense_word() {
        // Writing to a String cannot fail.
        let _ = write!(text, " {sense:<3}");
    }
    for (field, value) in of_sort(false) {
        text.push(' ');
        number::push(text, field, value, if field == Field::Feed { 4 } else { 0 });
    }
}

/// Reads an instruction file. Lines that cannot be read are left out and named in the diagnostics with `file` and line.
///
/// Blanks may be missing after a sign or doubled anywhere, and letters may be small; the numbers of the lines are not needed.
#[must_use]
pub fn parse_instructions(text: &str, file: &str) -> (Vec<Instruction>, Vec<Diagnostic>) {
    let mut instructions = Vec::new();
    let mut diagnostics = Vec::new();
    for (k, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        match parse_line(line) {
            Ok(instruction) => instructions.push(instruction),
            Err(message) => {
                let at = Place::Line { file: file.to_owned(), line: k + 1, column: None };
                diagnostics.push(Diagnostic::error("orac-instruction", at, message));
            }
        }
    }
    (instructions, diagnostics)
}

fn parse_line(line: &str) -> Result<Instruction, String> {
    let upper = line.to_uppercase().replace("- ", "-");
    let unnumbered = upper.trim_start().trim_start_matches(|c: char| c.is_ascii_digit());
    let mut words: Vec<&str> = unnumbered.split_whitespace().collect();
    let Some(word) = (!words.is_empty()).then(|| words.remove(0)) else {
        return Err("The line has a number but no instruction.".to_owned());
    };
    let sense = words.iter().position(|w| matches!(*w, "CW" | "CCW")).map(|at| words.remove(at));
    let kind = Kind::ALL
        .into_iter()
        .find(|k| k.word() == word && k.sense_word() == sense)
        .ok_or_else(|| unknown(word, sense))?;
    let fields = kind.fields();
    if words.len() != fields.len() {
        return Err(format!("{word} has {} values; it needs {}.", words.len(), fields.len()));
    }
    let values: Result<Vec<i32>, String> =
        fields.iter().zip(words).map(|(field, word)| number::parse(*field, word)).collect();
    kind.instruction(&values?).ok_or_else(|| format!("{word} has the wrong number of values."))
}

fn unknown(word: &str, sense: Option<&str>) -> String {
    match (word, sense) {
        ("CIRC", _) => "CIRC has no sense; it needs CW or CCW after the radius.".to_owned(),
        (_, Some(sense)) => format!("{word} {sense} is not an ORAC instruction."),
        (_, None) => format!("{word} is not an ORAC instruction."),
    }
}

#[cfg(test)]
mod tests {
    use super::super::instruction::Sense;
    use super::super::instruction::tests::any_instruction;
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn lines_have_the_printed_layout() {
        let text = instructions_text(&[
            Instruction::Inc,
            Instruction::Pdat { x: 15_100, z: 20_000 },
            Instruction::Ptp { x: -10_000, z: 0, feed: 80, tool: 1, rpm: 1742 },
            Instruction::Do { count: 5 },
            Instruction::Edo,
            Instruction::Circ { x: 0, z: -1, radius: 2_000, sense: Sense::Cw, feed: 80, tool: 1, rpm: 999 },
            Instruction::Oxua { channel: 2, state: 1 },
            Instruction::Dwel { time: 1500 },
        ]);
        let expected = "  1  INC\n  2  PDAT   15.100   20.000\n  3  PTP   -10.000    0.000   80 1 1742\n  4  DO  5\n  5  EDO\n  \
                        6  CIRC    0.000   -0.001    2.000 CW    80 1 999\n  7  OXUA 2 1\n  8  DWEL    1.500\n";
        assert_eq!(text, expected);
    }

    #[test]
    fn bad_lines_are_named_with_value_and_limit() {
        let (good, bad) = parse_instructions(
            "  1  INC\n  2  PTP 0.000 - 1.000 1000 1\n 3 JUMP 4\n 4 DO 1000\n 5 CIRC 0 0 1 80 1 9\n",
            "A.anc",
        );
        assert_eq!(good, [Instruction::Inc]);
        let messages: Vec<&str> = bad.iter().map(|d| d.message.as_str()).collect();
        assert_eq!(
            messages,
            [
                "PTP has 4 values; it needs 5.",
                "JUMP is not an ORAC instruction.",
                "COUNT is 1000; it must lie between 1 and 999.",
                "CIRC has no sense; it needs CW or CCW after the radius.",
            ]
        );
    }

    proptest! {
        #[test]
        fn text_round_trips(list in proptest::collection::vec(any_instruction(), 0..40)) {
            let text = instructions_text(&list);
            let (read, diagnostics) = parse_instructions(&text, "A.anc");
            prop_assert!(diagnostics.is_empty(), "{:?}", diagnostics);
            prop_assert_eq!(instructions_text(&read), text);
            prop_assert_eq!(read, list);
        }

        #[test]
        fn any_text_is_read_without_harm(text in "[ -~\n]{0,200}") {
            let _ = parse_instructions(&text, "A.anc");
        }
    }
}
