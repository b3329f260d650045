//! The reader/punch interface of Fanuc controls, which plays a tape reader and a tape punch over RS-232.
//!
//! To the control: it sends DC1 when its operator starts reading; then `%`, the blocks, `%` go out. DC3 stops the sender,
//! DC1 lets it go on; DC3 also says that the closing `%` was read. From the control: DC2, the same, DC4. The control skips
//! everything up to the first end of block, so the first line holds nothing but `%`. Code: the ISO characters, upper case.

mod punch;

use super::compare::{Blanks, Difference, Piece, compare_pieces};
use super::log::visible;
use super::protocol::{Outgoing, Refused};
use crate::machine::{EndOfBlock, ReaderPunch};
pub(super) use punch::PunchFrame;

/// `%` begins and ends a tape.
pub(super) const TAPE_MARK: char = '%';

/// Characters of the control's ISO code beside letters, digits and `%`. Others it ignores or takes for an alarm.
const SIGNS: &str = " ()+-:/.#&'*,;<=>?@\"[]";

/// Most problems of one program that are listed.
const MOST_PROBLEMS: usize = 10;

/// The blocks between two lines with `%`, each with its end of block and, for the TV check, an even number of characters.
///
/// The lines with `%` may be in the text or not.
pub(super) fn outgoing(text: &str, habits: ReaderPunch) -> Result<Outgoing, Refused> {
    let end = habits.end_of_block.text();
    let mut bytes = format!("{TAPE_MARK}{end}").into_bytes();
    let mut block_starts = Vec::new();
    for (line, block) in numbered_blocks(text) {
        check(line, block)?;
        let block = if habits.tv_check { block.trim_end_matches(' ') } else { block };
        block_starts.push(bytes.len());
        bytes.extend(block.bytes());
        if habits.tv_check && is_odd(block) {
            bytes.push(b' ');
        }
        bytes.extend(end.bytes());
    }
    if numbered_blocks(text).all(|(_, block)| block.trim().is_empty()) {
        return Err(Refused::Empty);
    }
    bytes.push(TAPE_MARK as u8);
    Ok(Outgoing { bytes, block_starts })
}

/// True if a block has an odd number of characters with its line feed. Carriage returns after it come in pairs.
fn is_odd(block: &str) -> bool {
    block.chars().filter(|&c| c != '\r').count() % 2 == 0
}

/// The blocks of a text with their line numbers from 1, without the lines that hold a lone `%` at either end.
fn numbered_blocks(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_filling = |line: &str| line.trim().is_empty();
    let is_mark = |line: &str| line.trim() == "%";
    let lines: Vec<_> = text.lines().collect();
    let first = lines.iter().take_while(|line| is_filling(line)).count();
    let first = first + usize::from(lines.get(first).is_some_and(|line| is_mark(line)));
    let filling_after = lines.iter().skip(first).rev().take_while(|line| is_filling(line)).count();
    let end = lines.len() - filling_after;
    let end = end - usize::from(end > first && lines.get(end - 1).is_some_and(|line| is_mark(line)));
    let numbered = lines.into_iter().enumerate().map(|(index, line)| (index + 1, line));
    numbered.take(end).skip(first)
}

fn check(line: usize, block: &str) -> Result<(), Refused> {
    for (index, character) in block.chars().enumerate() {
        let column = index + 1;
        if let Some(why) = not_in_code(character) {
            return Err(Refused::NotInCode { line, column, character, why });
        }
        if let Some(value) = u8::try_from(character).ok().filter(u8::is_ascii_control) {
            let allowed = "line ends";
            return Err(Refused::ControlCharacter { line, column, value, allowed });
        }
    }
    Ok(())
}

/// Why a character cannot be sent; none for control characters.
fn not_in_code(character: char) -> Option<&'static str> {
    match character {
        TAPE_MARK => Some("ends a program; only its first and its last line may hold it, and nothing else. Remove it"),
        'a'..='z' => Some("is lower case; this control takes upper case only. Change it"),
        'A'..='Z' | '0'..='9' => None,
        _ if character.is_ascii_control() || SIGNS.contains(character) => None,
        _ => Some("is not in the ISO code of this control. Replace it"),
    }
}

/// The blocks of a tape that came in: after the first end of block, up to the closing `%`.
///
/// Only the profile's end of block ends one; a carriage return that does not belong to it stays visible.
fn received_blocks(received: &str, end_of_block: EndOfBlock) -> Vec<&str> {
    let tape = received.strip_suffix(TAPE_MARK).unwrap_or(received);
    let mut blocks: Vec<_> = tape.split(end_of_block.text()).skip(1).collect();
    if blocks.last().is_some_and(|rest| rest.is_empty()) {
        blocks.pop();
    }
    blocks
}

fn without_padding(block: &str, habits: ReaderPunch) -> &str {
    if habits.tv_check { block.trim_end_matches(' ') } else { block }
}

/// A program as a file: line feeds, no padding, `%` in the first and last line.
pub(super) fn text_of(received: &str, habits: ReaderPunch) -> String {
    let blocks = received_blocks(received, habits.end_of_block);
    let lines: String = blocks.into_iter().map(|block| without_padding(block, habits).to_owned() + "\n").collect();
    format!("%\n{lines}%\n")
}

/// What is wrong with a tape that came in.
pub(super) fn problems(received: &str, habits: ReaderPunch) -> Vec<String> {
    let blocks = received_blocks(received, habits.end_of_block);
    let wrong =
        |(index, block): (usize, &&str)| problem(block, habits).map(|why| format!("Block {}: {why}", index + 1));
    let mut problems: Vec<_> = blocks.iter().enumerate().filter_map(wrong).take(MOST_PROBLEMS).collect();
    if blocks.is_empty() {
        problems.push("There is no block in it.".to_owned());
    }
    problems
}

fn problem(block: &str, habits: ReaderPunch) -> Option<String> {
    let stray = |c: char| c.is_ascii_control() || not_in_code(c).is_some();
    if let Some((index, character)) = block.chars().enumerate().find(|(_, c)| stray(*c)) {
        let shown = u8::try_from(character).map_or_else(|_| character.to_string(), visible);
        let why = match not_in_code(character) {
            Some(_) => "which no program of this control holds",
            None => "but its end is not as end_of_block of the machine's file says, or it was damaged",
        };
        return Some(format!("character {} is `{shown}`, {why}.", index + 1));
    }
    (habits.tv_check && is_odd(block)).then(|| {
        let count = block.len() + 1;
        format!("it has {count} characters; the TV check wants an even number, so something was lost or added.")
    })
}

/// Compares block by block what is left without leader, ends of blocks and padding as the profile describes them.
pub(super) fn compare(sent: &str, received: &str, habits: ReaderPunch, blanks: Blanks) -> Vec<Difference> {
    let sent: Vec<_> = numbered_blocks(sent).map(|(_, block)| without_padding(block, habits)).collect();
    let received: Vec<_> = received_blocks(received, habits.end_of_block)
        .into_iter()
        .map(|block| without_padding(block, habits))
        .collect();
    compare_pieces(Piece::Block, &sent, &received, blanks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const LF: ReaderPunch = ReaderPunch { end_of_block: EndOfBlock::Lf, tv_check: false, confirms_end: true };
    const CR_TV: ReaderPunch = ReaderPunch { end_of_block: EndOfBlock::LfCrCr, tv_check: true, confirms_end: true };

    fn sent(text: &str, habits: ReaderPunch) -> String {
        String::from_utf8(outgoing(text, habits).unwrap().bytes).unwrap()
    }

    #[test]
    fn leader_ends_of_blocks_and_padding_are_as_the_profile_says() {
        for text in ["O1\nG21\nM30\n", "%\nO1\nG21\nM30\n%\n", "\r\n%\r\nO1\r\nG21\r\nM30\r\n%\r\n\r\n"] {
            assert_eq!(sent(text, LF), "%\nO1\nG21\nM30\n%");
            assert_eq!(sent(text, CR_TV), "%\n\r\rO1 \n\r\rG21\n\r\rM30\n\r\r%");
        }
        assert_eq!(outgoing("O1\nG21\n", LF).unwrap().block_starts, [2, 5]);
    }

    #[test]
    fn what_the_control_cannot_read_is_refused_with_its_place() {
        for (text, words) in [
            ("O1\nN10 g21\n", "Line 2, character 5: `g` is lower case"),
            ("%\nO1\n(TOOL 5°)\n%\n", "Line 3, character 8: `°` is not in the ISO code"),
            ("O1\n(10$)\n", "Line 2, character 4: `$` is not in the ISO code"),
            ("O1\n%\nM30\n", "Line 2, character 1: `%` ends a program"),
            ("O1\nX1\tZ2\n", "Line 2, character 3: ␉ is the control character 9"),
            ("O1\nX1\rZ2\n", "Line 2, character 3: ␍ is the control character 13"),
            ("%\n\n%\n", "no block"),
            ("", "no block"),
        ] {
            let refused = outgoing(text, LF).unwrap_err().to_string();
            assert!(refused.contains(words), "{text:?}: {refused}");
        }
    }

    #[test]
    fn only_what_the_profile_says_is_no_difference() {
        let program = "O1\nG21\nM30\n";
        for habits in [LF, CR_TV] {
            let tape = sent(program, habits);
            assert_eq!(compare(program, &tape, habits, Blanks::Exact), []);
            assert_eq!(problems(&tape, habits), Vec::<String>::new());
            assert_eq!(text_of(&tape, habits), format!("%\n{program}%\n"));
        }
        for (tape, words) in [
            ("%\nO1\nG20\nM30\n%", "Block 2, character 3: sent `G21`, came back `G20`"),
            ("%\nO1\nM30\n%", "Block 2 did not come back: `G21`"),
            ("%\nO1\nG21\nG21\nM30\n%", "Block 3 of what came back was not sent: `G21`"),
            ("%\nO1 \nG21\nM30\n%", "came back `O1 ` (only blanks differ)"),
            ("%\nO1\n\r\rG21\n\r\rM30\n\r\r%", "Block 2, character 1: sent `G21`, came back `␍␍G21`"),
        ] {
            let differences = compare(program, tape, LF, Blanks::Exact);
            assert!(differences.iter().any(|d| d.to_string().contains(words)), "{tape:?}: {differences:?}");
        }
        assert!(!compare(program, "%\n\r\rO1 \nG21\n\r\rM30\n\r\r%", CR_TV, Blanks::Exact).is_empty());
    }

    #[test]
    fn a_damaged_tape_is_told() {
        for (tape, habits, words) in [
            ("%\nO1\nG2q\n%", LF, "Block 2: character 3 is `q`"),
            ("%\nO1\n\r\rG21\n%", LF, "Block 2: character 1 is `␍`, but its end is not as end_of_block"),
            ("%\n\r\rO1\n\r\r%", CR_TV, "Block 1: it has 3 characters; the TV check wants an even number"),
            ("%", LF, "no block"),
        ] {
            let problems = problems(tape, habits);
            assert!(problems.iter().any(|p| p.contains(words)), "{tape:?}: {problems:?}");
        }
    }

    proptest! {
        #[test]
        fn every_program_comes_back_as_it_was_sent(
            blocks in prop::collection::vec("[A-Z0-9.() -]{0,12}[A-Z0-9]", 1..20),
            lf_cr_cr in any::<bool>(),
            tv_check in any::<bool>(),
        ) {
            let end_of_block = if lf_cr_cr { EndOfBlock::LfCrCr } else { EndOfBlock::Lf };
            let habits = ReaderPunch { end_of_block, tv_check, confirms_end: true };
            let program = blocks.join("\n") + "\n";
            let tape = sent(&program, habits);
            prop_assert_eq!(compare(&program, &tape, habits, Blanks::Exact), []);
            prop_assert_eq!(problems(&tape, habits), Vec::<String>::new());
            prop_assert_eq!(text_of(&tape, habits), format!("%\n{program}%\n"));
            if tv_check {
                prop_assert!(tape[..tape.len() - 1].split_inclusive('\n').all(|block| block.len() % 2 == 0));
            }
        }

        #[test]
        fn noise_never_breaks_it(received in "[%\n\rA1 q]{0,30}", tv_check in any::<bool>()) {
            let habits = ReaderPunch { tv_check, ..LF };
            let text = text_of(&received, habits);
            if problems(&received, habits).is_empty() {
                prop_assert_eq!(compare(&text, &received, habits, Blanks::Exact), []);
            }
            let _ = outgoing(&received, habits);
        }
    }
}
