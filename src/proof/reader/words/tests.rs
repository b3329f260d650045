use super::*;
use crate::machine::Dialect;

fn fanuc(text: &str) -> Tape {
    read(text, Dialect::Fanuc)
}

fn linuxcnc(text: &str) -> Tape {
    read(text, Dialect::Linuxcnc)
}

fn spelled(tape: &Tape) -> Vec<String> {
    let word = |w: &Word| format!("{}{}", w.letter, w.number.plain());
    tape.with_words().map(|(_, b)| b.words.iter().map(word).collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn blocks_are_read_whatever_ends_them() {
    let blocks = ["O201", "G50 X-455 Z320 M8", "G1 X-155 F0.1"];
    for end in ["\n", "\r\n", "\n\r\r", ";\n", ";", "\r"] {
        let text = ["%", "O0201", "N10G50X-455.000Z320.000M08", "N15 G1 X - 155. F.1", "%", ""].join(end);
        let text = if end == ";" { text.replace("%;", "%\n").replace(";%", ";\n%") } else { text };
        let tape = fanuc(&text);
        assert_eq!((spelled(&tape), &tape.troubles), (blocks.map(str::to_owned).to_vec(), &Vec::new()), "{end:?}");
        assert_eq!((tape.opened, tape.closed), (true, true), "{end:?}");
        assert_eq!(tape.blocks.iter().map(|b| b.printed).collect::<Vec<_>>(), [None, None, Some(10), Some(15), None]);
    }
}

#[test]
fn comments_and_tape_leaders_are_no_words() {
    let tape = fanuc("\u{12}\0\0%\nO1(ROLL G1 X1; 2T)\n(ONLY A REMARK)\n/N5 G0X1.(A)Z2.\nM30\n%\u{14}");
    assert_eq!(spelled(&tape), ["O1", "G0 X1 Z2", "M30"]);
    assert_eq!((tape.troubles, tape.blocks[3].optional, tape.blocks[3].line), (vec![], true, 4));
    let tape = linuxcnc("%\ng0 x+0. 12 34 y7 ; to the start\nm2\n%");
    assert_eq!((spelled(&tape), tape.troubles), (vec!["G0 X0.1234 Y7".to_owned(), "M2".to_owned()], vec![]));
}

#[test]
fn subroutine_words_of_linuxcnc_are_read() {
    let tape = linuxcnc("o100 sub\nG1 X1\no100 endsub\nO<groove> CALL\no100 if [#1 GT 2]\n");
    assert_eq!(tape.blocks[0].flow, Some(Flow::Sub("100".into())));
    assert_eq!(tape.blocks[3].flow, Some(Flow::Call("groove".into())));
    assert_eq!(tape.troubles.iter().map(|t| t.block).collect::<Vec<_>>(), [5]);
}

#[test]
fn whatever_cannot_be_read_is_named() {
    for (text, what) in [
        ("G1X1O", "\"O\""),
        ("G1X1.2.3", "1.2.3"),
        ("G1X--1", "--1"),
        ("G1X#100", "parameters"),
        ("X[1+2]", "expressions"),
        ("?5", "\"?5\""),
        ("G1X1X2", "twice"),
        ("G1N5", "beginning"),
        ("N-5G1", "whole"),
        ("G1(OPEN", "not closed"),
        ("G1)X1", "not opened"),
        ("%\nM30\n%\nG1", "behind the closing"),
        ("%O1\nM30", "behind the tape mark"),
        ("G1XZ5", "\"X\""),
        ("G1Xä", "\"X"),
    ] {
        let tape = fanuc(text);
        assert_eq!(tape.troubles.len(), 1, "{text}: {:?}", tape.troubles);
        assert!(tape.troubles[0].message.contains(what), "{text}: {}", tape.troubles[0].message);
    }
}

proptest::proptest! {
    #[test]
    fn no_text_panics(text in "[ -~\r\n%;/()NGXZIKO<>.#äß∞\u{0}\u{12}]{0,120}") {
        let (a, b) = (fanuc(&text), linuxcnc(&text));
        let words = a.blocks.iter().chain(&b.blocks).flat_map(|block| &block.words);
        proptest::prop_assert!(words.into_iter().all(|word| word.number.plain().is_finite()));
    }
}
