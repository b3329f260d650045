//! What was sent against what came back, page by page.

use super::pages::{Pages, shortened, split};
use std::fmt;

/// How blanks are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Blanks {
    /// Every character counts.
    #[default]
    Exact,
    /// Blanks (character 32) do not count: a control may lay out a page with other blanks than the sender, and reads
    /// numbers with or without them. Nothing else is ignored.
    Ignored,
}

/// One page that is not the same on both sides.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Page, counted from 1 in the order of the text (of the received text for an extra page); 0 is what stands before
    /// the first page mark.
    pub page: usize,
    /// What is different.
    pub kind: DifferenceKind,
}

/// How a page differs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DifferenceKind {
    /// The page came back changed; the first place is given.
    Changed {
        /// Line within the page, from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// The line as sent, control characters made visible, shortened.
        sent: String,
        /// The line as received.
        received: String,
        /// True if the page differs in blanks only.
        blanks_only: bool,
    },
    /// The page did not come back.
    Missing {
        /// Its first line as sent.
        sent: String,
    },
    /// A page came back that was not sent.
    Extra {
        /// Its first line as received.
        received: String,
    },
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let page = self.page;
        match &self.kind {
            DifferenceKind::Changed { line, column, sent, received, blanks_only } => {
                let place = if page == 0 { "Before the first page".to_owned() } else { format!("Page {page}") };
                let only = if *blanks_only { " (only blanks differ)" } else { "" };
                write!(f, "{place}, line {line}, character {column}: sent `{sent}`, came back `{received}`{only}")
            }
            DifferenceKind::Missing { sent } => write!(f, "Page {page} did not come back: `{sent}`"),
            DifferenceKind::Extra { received } => {
                write!(f, "Page {page} of what came back was not sent: `{received}`")
            }
        }
    }
}

/// Compares two program texts; no differences means that they are the same.
///
/// Pages are matched from the front and from the back, so that one lost page does not make all later ones differ.
#[must_use]
pub fn compare(sent: &str, received: &str, page_start: u8, blanks: Blanks) -> Vec<Difference> {
    let (sent, received) = (split(sent, page_start), split(received, page_start));
    let mut differences = Vec::new();
    if !same(sent.leader, received.leader, blanks) {
        differences.push(changed(0, sent.leader, received.leader));
    }
    compare_pages(&sent, &received, blanks, &mut differences);
    differences
}

fn compare_pages(sent: &Pages<'_>, received: &Pages<'_>, blanks: Blanks, differences: &mut Vec<Difference>) {
    let (a, b) = (&sent.pages, &received.pages);
    let is_same = |(x, y): &(&&str, &&str)| same(x, y, blanks);
    let front = a.iter().zip(b).take_while(is_same).count();
    let back = a.iter().rev().zip(b.iter().rev()).take_while(is_same).count().min(a.len().min(b.len()) - front);
    let (mut a, mut b) = (a[front..a.len() - back].iter(), b[front..b.len() - back].iter());
    let mut page = front;
    loop {
        page += 1;
        match (a.next(), b.next()) {
            (Some(x), Some(y)) if same(x, y, blanks) => {}
            (Some(x), Some(y)) => differences.push(changed(page, x, y)),
            (Some(x), None) => differences.push(missing(page, x)),
            (None, Some(y)) => differences.push(extra(page, y)),
            (None, None) => return,
        }
    }
}

fn same(a: &str, b: &str, blanks: Blanks) -> bool {
    match blanks {
        Blanks::Exact => a == b,
        Blanks::Ignored => a.bytes().filter(|&c| c != b' ').eq(b.bytes().filter(|&c| c != b' ')),
    }
}

fn changed(page: usize, sent: &str, received: &str) -> Difference {
    let (a, b) = (sent.as_bytes(), received.as_bytes());
    let place = a.iter().zip(b).take_while(|(x, y)| x == y).count();
    let before = &a[..place];
    let line = before.split(|&c| c == b'\n').count() - 1;
    let column = before.iter().rev().take_while(|&&c| c != b'\n').count() + 1;
    let line_of = |text: &str| shortened(text.split_inclusive('\n').nth(line).unwrap_or_default());
    let blanks_only = same(sent, received, Blanks::Ignored);
    let kind = DifferenceKind::Changed {
        line: line + 1,
        column,
        sent: line_of(sent),
        received: line_of(received),
        blanks_only,
    };
    Difference { page, kind }
}

fn missing(page: usize, sent: &str) -> Difference {
    Difference { page, kind: DifferenceKind::Missing { sent: shortened(sent.lines().next().unwrap_or_default()) } }
}

fn extra(page: usize, received: &str) -> Difference {
    let received = shortened(received.lines().next().unwrap_or_default());
    Difference { page, kind: DifferenceKind::Extra { received } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SENT: &str = "\x02PAGE 01 A\r\nX    1.000\r\n\x02PAGE 02 B\r\nX    2.000\r\n\x02PAGE 03 END\r\n";

    fn sentences(received: &str, blanks: Blanks) -> Vec<String> {
        compare(SENT, received, 2, blanks).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn equal_texts_have_no_differences() {
        assert_eq!(compare(SENT, SENT, 2, Blanks::Exact), []);
        assert_eq!(compare("", "", 2, Blanks::Exact), []);
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
            prop_assert_eq!(compare(&a, &b, 2, Blanks::Exact).is_empty(), a == b);
            let strip = |text: &str| text.replace(' ', "");
            prop_assert_eq!(compare(&a, &b, 2, Blanks::Ignored).is_empty(), strip(&a) == strip(&b));
        }
    }
}
