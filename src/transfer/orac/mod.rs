//! The protocol of the Denford ORAC: pages of ASCII text, each begun by a page mark (STX), the whole ended by an end
//! mark (EOT). There are no check sums and no answers, so only a program that came back can be called verified.

pub(super) mod pages;

use super::compare::{Blanks, Difference, Piece, compare_pieces};
use super::log::visible;
use super::protocol::{Outgoing, Refused};
use super::receiver::{Frame, Taken, is_filling};
use crate::machine::PageMarks;

/// The pages as they are, then the end mark.
pub(super) fn outgoing(text: &str, marks: PageMarks) -> Result<Outgoing, Refused> {
    let PageMarks { page_start, end } = marks;
    check(text, page_start)?;
    let mut bytes = text.as_bytes().to_vec();
    let is_mark = |&(_, &byte): &(usize, &u8)| byte == page_start;
    let block_starts = bytes.iter().enumerate().filter(is_mark).map(|(place, _)| place).collect();
    bytes.push(end);
    Ok(Outgoing { bytes, block_starts })
}

fn check(text: &str, page_start: u8) -> Result<(), Refused> {
    let (mut line, mut column) = (1, 1);
    for character in text.chars() {
        let Ok(value @ 0..=127) = u8::try_from(character) else {
            return Err(Refused::NotSevenBit { line, column, character });
        };
        if value.is_ascii_control() && ![page_start, b'\r', b'\n'].contains(&value) {
            let allowed = "page marks, carriage returns and line feeds";
            return Err(Refused::ControlCharacter { line, column, value, allowed });
        }
        column += 1;
        if value == b'\n' {
            (line, column) = (line + 1, 1);
        }
    }
    if text.as_bytes().first() == Some(&page_start) { Ok(()) } else { Err(Refused::NoPages { page_start }) }
}

/// Everything up to the end mark; it must hold a page.
#[derive(Debug)]
pub(super) struct PageFrame {
    marks: PageMarks,
    has_pages: bool,
}

impl PageFrame {
    pub(super) const fn new(marks: PageMarks) -> Self {
        Self { marks, has_pages: false }
    }

    fn ended(&self, text: &str) -> Taken {
        if text.is_empty() {
            return Taken::Wrong("The control sent an end mark and nothing else: it holds no program.".to_owned());
        }
        if !self.has_pages {
            return Taken::Wrong(format!(
                "{} characters came, but no page mark {}: this is no program.",
                text.len(),
                visible(self.marks.page_start)
            ));
        }
        Taken::Ended
    }
}

impl Frame for PageFrame {
    fn take(&mut self, byte: u8, text: &str) -> Taken {
        if text.is_empty() && is_filling(byte) {
            Taken::Skipped
        } else if byte == self.marks.end {
            self.ended(text)
        } else if byte == self.marks.page_start {
            self.has_pages = true;
            Taken::KeptMark
        } else {
            Taken::Kept
        }
    }
}

/// Compares page by page.
pub(super) fn compare(sent: &str, received: &str, marks: PageMarks, blanks: Blanks) -> Vec<Difference> {
    let (sent, received) = (pages::split(sent, marks.page_start), pages::split(received, marks.page_start));
    let mut differences = compare_pieces(Piece::Leader, &[sent.leader], &[received.leader], blanks);
    differences.extend(compare_pieces(Piece::Page, &sent.pages, &received.pages, blanks));
    differences
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const MARKS: PageMarks = PageMarks { page_start: 2, end: 4 };
    const SENT: &str = "\x02PAGE 01 A\r\nX    1.000\r\n\x02PAGE 02 B\r\nX    2.000\r\n\x02PAGE 03 END\r\n";

    fn sentences(received: &str, blanks: Blanks) -> Vec<String> {
        compare(SENT, received, MARKS, blanks).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn equal_texts_have_no_differences() {
        assert_eq!(compare(SENT, SENT, MARKS, Blanks::Exact), []);
        assert_eq!(compare("", "", MARKS, Blanks::Exact), []);
    }

    #[test]
    fn a_changed_character_is_placed() {
        assert_eq!(
            sentences(&SENT.replace("2.000", "2.010"), Blanks::Ignored),
            ["Page 2, line 2, character 9: sent `X    2.000␍␊`, came back `X    2.010␍␊`"]
        );
    }

    #[test]
    fn a_lost_page_is_one_difference() {
        let received = SENT.replace("\x02PAGE 02 B\r\nX    2.000\r\n", "");
        assert_eq!(sentences(&received, Blanks::Exact), ["Page 2 did not come back: `PAGE 02 B`"]);
        let twice = SENT.replace("\x02PAGE 03", "\x02PAGE 02 B\r\n\x02PAGE 03");
        assert_eq!(sentences(&twice, Blanks::Exact), ["Page 3 of what came back was not sent: `PAGE 02 B`"]);
    }

    #[test]
    fn blanks_count_unless_ignored() {
        let received = SENT.replace("X    2", "X 2");
        let exact = sentences(&received, Blanks::Exact);
        assert!(exact.len() == 1 && exact[0].ends_with("(only blanks differ)"), "{exact:?}");
        assert_eq!(sentences(&received, Blanks::Ignored), Vec::<String>::new());
    }

    #[test]
    fn a_lost_line_end_and_noise_in_front_are_differences() {
        assert_eq!(sentences(&SENT.replacen('\r', "", 1), Blanks::Ignored).len(), 1);
        assert!(sentences(&format!("Q{SENT}"), Blanks::Ignored)[0].starts_with("Before the first page, line 1"));
    }

    proptest! {
        #[test]
        fn texts_are_equal_exactly_if_nothing_differs(a in "[\x02\r\nX1 ]{0,12}", b in "[\x02\r\nX1 ]{0,12}") {
            prop_assert_eq!(compare(&a, &b, MARKS, Blanks::Exact).is_empty(), a == b);
            let strip = |text: &str| text.replace(' ', "");
            prop_assert_eq!(compare(&a, &b, MARKS, Blanks::Ignored).is_empty(), strip(&a) == strip(&b));
        }
    }
}
