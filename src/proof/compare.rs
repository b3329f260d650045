//! Compares two texts of a program word by word, so that a changed value is named with its block and by how much it changed.

use super::reader::words::WordBlock;
use super::reader::{self, Block, Listing, Op, Trouble, Word};
use crate::machine::Dialect;
use serde::Serialize;

/// One difference between two program texts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Change {
    /// Block from 1 in the new text; of a block that is gone, in the old one.
    pub block: usize,
    /// Name of the word, `INSTRUCTION` for the block as a whole, `PAGE` for its number, `TEXT` for what cannot be read.
    pub word: String,
    /// What it was; `None` if it was not there.
    pub was: Option<String>,
    /// What it is; `None` if it is not there any more.
    pub is: Option<String>,
    /// New value less old value, in the program's unit, if both are numbers.
    pub difference: Option<f64>,
}

/// Every difference in meaning between two texts of either layout. Blanks, line ends and page marks do not count.
///
/// Equal blocks at the beginning and at the end are matched first, so an inserted or lost block does not shift all others.
#[must_use]
pub fn compare(was: &str, is: &str, dialect: Dialect) -> Vec<Change> {
    let mut changes = match dialect {
        Dialect::Orac => compare_pages(was, is),
        Dialect::Fanuc | Dialect::Linuxcnc => compare_words(was, is, dialect),
    };
    changes.sort_by_key(|change| change.block);
    changes
}

fn compare_pages(was: &str, is: &str) -> Vec<Change> {
    let (was, is) = (reader::read(was), reader::read(is));
    let longest = was.blocks.len().min(is.blocks.len());
    let head = was.blocks.iter().zip(&is.blocks).take_while(|(a, b)| same(a, b)).count();
    let ends = was.blocks.iter().rev().zip(is.blocks.iter().rev());
    let tail = ends.take_while(|(a, b)| same(a, b)).count().min(longest - head);
    let (old, new) = (&was.blocks[head..was.blocks.len() - tail], &is.blocks[head..is.blocks.len() - tail]);
    let mut changes = Vec::new();
    for index in 0..old.len().max(new.len()) {
        compare_blocks(head + index + 1, old.get(index), new.get(index), &mut changes);
    }
    if was.blocks.len() == is.blocks.len() {
        compare_numbers(&was, &is, &mut changes);
    }
    compare_troubles(&was.troubles, &is.troubles, &mut changes);
    changes
}

/// Programs of words: blocks are matched as pages are, their N words aside; comments do not count.
fn compare_words(was: &str, is: &str, dialect: Dialect) -> Vec<Change> {
    let (was, is) = (reader::words::read(was, dialect), reader::words::read(is, dialect));
    let same = |(a, b): &(&WordBlock, &WordBlock)| {
        let words = a.words.len() == b.words.len() && a.words.iter().zip(&b.words).all(|(a, b)| same_word(a, b));
        words && a.flow == b.flow && a.optional == b.optional && a.printed == b.printed
    };
    let longest = was.blocks.len().min(is.blocks.len());
    let head = was.blocks.iter().zip(&is.blocks).take_while(same).count();
    let ends = was.blocks.iter().rev().zip(is.blocks.iter().rev());
    let tail = ends.take_while(same).count().min(longest - head);
    let (old, new) = (&was.blocks[head..was.blocks.len() - tail], &is.blocks[head..is.blocks.len() - tail]);
    let mut changes = Vec::new();
    for index in 0..old.len().max(new.len()) {
        compare_word_blocks(head + index + 1, old.get(index), new.get(index), &mut changes);
    }
    compare_troubles(&was.troubles, &is.troubles, &mut changes);
    changes
}

fn compare_word_blocks(block: usize, was: Option<&WordBlock>, is: Option<&WordBlock>, changes: &mut Vec<Change>) {
    let mut change = |word: String, was: Option<String>, is: Option<String>, difference| {
        changes.push(Change { block, word, was, is, difference });
    };
    let spelled = |b: &WordBlock| b.words.iter().map(spelled).collect::<Vec<_>>().join(" ");
    let (Some(a), Some(b)) = (was, is) else {
        return change("INSTRUCTION".to_owned(), was.map(spelled), is.map(spelled), None);
    };
    let letters = |b: &WordBlock| b.words.iter().map(|w| w.letter).collect::<Vec<_>>();
    if letters(a) != letters(b) || a.flow != b.flow || a.optional != b.optional {
        return change("INSTRUCTION".to_owned(), Some(spelled(a)), Some(spelled(b)), None);
    }
    for (old, new) in a.words.iter().zip(&b.words).filter(|(old, new)| !same_word(old, new)) {
        let (was, is) = (old.number.plain(), new.number.plain());
        let difference = (!matches!(old.letter, 'G' | 'M' | 'T')).then(|| rounded(is - was));
        change(old.letter.to_string(), Some(was.to_string()), Some(is.to_string()), difference);
    }
    if a.printed != b.printed {
        let text = |n: Option<u32>| n.map(|n| n.to_string());
        change("N".to_owned(), text(a.printed), text(b.printed), None);
    }
}

/// Zeros behind a decimal point do not count; without a point every digit does.
fn same_word(a: &reader::words::Word, b: &reader::words::Word) -> bool {
    let points = a.number.has_point() && b.number.has_point();
    a == b || a.letter == b.letter && points && a.number.plain() == b.number.plain()
}

fn spelled(word: &reader::words::Word) -> String {
    format!("{}{}", word.letter, word.number.plain())
}

fn same(a: &Block, b: &Block) -> bool {
    a.op == b.op && a.words == b.words
}

fn compare_blocks(block: usize, was: Option<&Block>, is: Option<&Block>, changes: &mut Vec<Change>) {
    let mut change = |word: &str, was: Option<String>, is: Option<String>, difference| {
        changes.push(Change { block, word: word.to_owned(), was, is, difference });
    };
    let (Some(a), Some(b)) = (was, is) else {
        return change("INSTRUCTION", was.map(instruction), is.map(instruction), None);
    };
    if a.op != b.op {
        return change("INSTRUCTION", Some(instruction(a)), Some(instruction(b)), None);
    }
    for &word in b.op.map_or(&[][..], Op::words) {
        let (was, is) = (a.value(word), b.value(word));
        if was != is {
            let difference = was.zip(is).filter(|_| word != Word::Sense).map(|(was, is)| rounded(is - was));
            change(word.name(), was.map(|v| v.to_string()), is.map(|v| v.to_string()), difference);
        }
    }
}

/// A block in one line.
fn instruction(block: &Block) -> String {
    let name = block.op.map_or("(unreadable)", Op::mnemonic).to_owned();
    block.words.iter().fold(name, |text, (word, value)| format!("{text} {} {value}", word.name()))
}

fn compare_numbers(was: &Listing, is: &Listing, changes: &mut Vec<Change>) {
    for (index, (a, b)) in was.blocks.iter().zip(&is.blocks).enumerate() {
        if a.printed != b.printed {
            let text = |n: Option<u32>| n.map(|n| n.to_string());
            let difference = a.printed.zip(b.printed).map(|(was, is)| f64::from(is) - f64::from(was));
            let word = "PAGE".to_owned();
            changes.push(Change { block: index + 1, word, was: text(a.printed), is: text(b.printed), difference });
        }
    }
}

/// What cannot be read in one text only counts as changed, whatever the readable words say.
fn compare_troubles(was: &[Trouble], is: &[Trouble], changes: &mut Vec<Change>) {
    let only_in = |a: &[Trouble], b: &[Trouble]| -> Vec<(usize, String)> {
        let known = |m: &str| b.iter().any(|t| t.message == m);
        a.iter().filter(|t| !known(&t.message)).map(|t| (t.block, t.message.clone())).collect()
    };
    let gone = only_in(was, is).into_iter().map(|(block, message)| (block, Some(message), None));
    let new = only_in(is, was).into_iter().map(|(block, message)| (block, None, Some(message)));
    changes.extend(gone.chain(new).map(|(block, was, is)| Change {
        block,
        word: "TEXT".to_owned(),
        was,
        is,
        difference: None,
    }));
}

/// To a millionth, so that the difference of 0.3 and 0.1 reads 0.2.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::{Change, Dialect};

    fn compare(was: &str, is: &str) -> Vec<Change> {
        super::compare(was, is, Dialect::Orac)
    }

    const OLD: &str = "1 INC\n2 PTP 0.000 -20.100 80 1 1000\n3 PTP 0.000 20.100 80 1 1000\n4 END";

    #[test]
    fn a_changed_z_is_named_with_block_and_difference() {
        let changes = compare(OLD, &OLD.replace("-20.100", "-20.300"));
        assert_eq!(changes.len(), 1);
        let change = &changes[0];
        assert_eq!((change.block, change.word.as_str(), change.difference), (2, "Z", Some(-0.2)));
        assert_eq!((change.was.as_deref(), change.is.as_deref()), (Some("-20.1"), Some("-20.3")));
    }

    #[test]
    fn words_of_other_controls_are_compared_too() {
        let old = "O1\nN10 G1 X-155.000 (CUT)\nN20 G2 X1. Z1. I1.\nM30";
        let compared = |new: &str| super::compare(old, new, Dialect::Fanuc);
        assert_eq!(compared("O1\n\nN10G1X-155.\nN20G2X1.0Z1.I1.\nM30"), []);
        let change = &compared(&old.replace("-155", "-154"))[0];
        assert_eq!((change.block, change.word.as_str(), change.difference), (2, "X", Some(1.0)));
        let change = &compared(&old.replace("G2", "G3"))[0];
        assert_eq!((change.block, change.was.as_deref(), change.difference), (3, Some("2"), None));
        assert_eq!(compared("O1\nN20 G2 X1. Z1. I1.\nM30")[0].is, None);
        assert_eq!(compared(&old.replace("I1.", "I#1"))[1].word, "TEXT");
    }

    #[test]
    fn layout_does_not_count() {
        let pages = "PAGE 1 INCREMENTAL-FORMAT.G91\r\nPAGE 2 POINT-TO-POINT.G00,G01\r\nX 0\r\nZ - 20.1\r\nFEEDRATE 80\r\nTOOL-NO 1\r\n\
            SPINDLE-SPEED 1000\r\nPAGE 3 POINT-TO-POINT.G00,G01\r\nX 0\r\nZ 20.1\r\nFEEDRATE 80\r\nTOOL-NO 1\r\nSPINDLE-SPEED 1000\r\n\
            PAGE 4 END-PROGRAM..M02\r\n";
        assert_eq!(compare(OLD, pages), []);
    }

    #[test]
    fn a_lost_block_is_one_change() {
        let lost = "1 INC\n2 PTP 0.000 20.100 80 1 1000\n3 END";
        let changes = compare(OLD, lost);
        assert_eq!(changes.len(), 1);
        assert_eq!((changes[0].block, changes[0].is.as_ref()), (2, None));
        assert_eq!(compare(lost, OLD)[0].was, None);
    }

    #[test]
    fn what_cannot_be_read_is_a_change() {
        assert_eq!(compare(OLD, &OLD.replace("1 INC", "1 INC 5"))[0].word, "TEXT");
        assert_eq!(compare(OLD, &OLD.replace("4 END", "4 ENE"))[0].word, "INSTRUCTION");
        assert_eq!(compare(OLD, &OLD.replace("4 END", "5 END"))[0].word, "PAGE");
    }
}
