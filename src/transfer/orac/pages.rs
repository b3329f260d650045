//! Pages of a program text: each begins with the page mark; what stands before the first is the leader.

use crate::transfer::log::{shortened, visible};

/// Text before the first page mark, and the pages without their marks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::transfer) struct Pages<'a> {
    /// What stands before the first page mark; empty in a good program.
    pub(in crate::transfer) leader: &'a str,
    /// The pages in the order of the text, without their marks.
    pub(in crate::transfer) pages: Vec<&'a str>,
}

/// Takes a text apart at its page marks.
pub(in crate::transfer) fn split(text: &str, page_start: u8) -> Pages<'_> {
    let mut pieces = text.split(char::from(page_start));
    let leader = pieces.next().unwrap_or_default();
    Pages { leader, pages: pieces.collect() }
}

/// What is wrong with the form of a program text, in sentences; empty if it is well-formed.
///
/// Well-formed: it begins with a page mark, every page begins with `PAGE` and its number counted from 1 without gaps,
/// and it holds no control characters but page marks, carriage returns and line feeds.
pub(in crate::transfer) fn problems(text: &str, page_start: u8) -> Vec<String> {
    let Pages { leader, pages } = split(text, page_start);
    let mut problems = Vec::new();
    if !leader.is_empty() {
        problems.push(format!("{} characters stand before the first page mark.", leader.len()));
    }
    if pages.is_empty() {
        problems.push("There is no page mark at all.".to_owned());
    }
    problems.extend(pages.iter().enumerate().filter_map(|(index, page)| wrong_number(index + 1, page)));
    problems.extend(wrong_character(text, page_start));
    problems
}

fn wrong_number(expected: usize, page: &str) -> Option<String> {
    let head = page.lines().next().unwrap_or_default();
    let number: Option<usize> =
        head.strip_prefix("PAGE").and_then(|rest| rest.split_whitespace().next()).and_then(|n| n.parse().ok());
    match number {
        Some(number) if number == expected => None,
        Some(number) => Some(format!("Page {expected} in the order of the text is numbered {number}.")),
        None => Some(format!("Page {expected} begins with `{}`, not with PAGE and its number.", shortened(head))),
    }
}

fn wrong_character(text: &str, page_start: u8) -> Option<String> {
    let allowed = [page_start, b'\r', b'\n'];
    let (place, byte) = text.bytes().enumerate().find(|(_, b)| b.is_ascii_control() && !allowed.contains(b))?;
    Some(format!("Byte {} is the control character {} ({byte}).", place + 1, visible(byte)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_good_program_has_no_problems() {
        let text = "\x02PAGE 01 MM-UNITS\r\n\x02PAGE 02 END-PROGRAM..M02\r\n";
        assert_eq!(split(text, 2).pages.len(), 2);
        assert_eq!(problems(text, 2), Vec::<String>::new());
    }

    #[test]
    fn each_fault_of_form_is_named() {
        for (text, words) in [
            ("", "no page mark"),
            ("XY\x02PAGE 01 A\r\n", "2 characters stand before"),
            ("\x02PAGE 01 A\r\n\x02PAGE 03 B\r\n", "Page 2 in the order of the text is numbered 3"),
            ("\x02PAG 01 A\r\n", "begins with `PAG 01 A`"),
            ("\x02PAGE 01 A\x07\r\n", "␇ (7)"),
        ] {
            assert!(problems(text, 2).iter().any(|p| p.contains(words)), "{text:?}: {:?}", problems(text, 2));
        }
    }
}
