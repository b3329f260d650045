//! Changes of single words, in the order of the text. Nothing here is random.

/// How a program was changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    Sign,
    Digit,
    LostPoint,
    RapidOrFeed,
    ArcSense,
    CentreSign,
    DroppedBlock,
    SwappedTool,
}

impl Kind {
    pub(crate) const ALL: [Self; 8] = [
        Self::Sign,
        Self::Digit,
        Self::LostPoint,
        Self::RapidOrFeed,
        Self::ArcSense,
        Self::CentreSign,
        Self::DroppedBlock,
        Self::SwappedTool,
    ];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::Digit => "digit",
            Self::LostPoint => "lost decimal point",
            Self::RapidOrFeed => "rapid for feed and back",
            Self::ArcSense => "G2 for G3 and back",
            Self::CentreSign => "sign of I or K",
            Self::DroppedBlock => "dropped block",
            Self::SwappedTool => "swapped tool",
        }
    }
}

/// A changed program and what was changed.
pub(crate) struct Mutant {
    pub(crate) what: String,
    pub(crate) text: String,
}

/// A word of a text: letters, then a number, with the place of the number.
struct Token<'t> {
    letters: &'t str,
    number: &'t str,
    at: usize,
}

/// Letters followed by a number, as in `G1X-155.000`, or by blanks and a number, as in `X   15.100`.
fn tokens(line: &str) -> Vec<Token<'_>> {
    let bytes = line.as_bytes();
    let (mut tokens, mut i) = (Vec::new(), 0);
    while i < bytes.len() {
        if !bytes[i].is_ascii_alphabetic() {
            i += 1;
            continue;
        }
        let from = i;
        while i < bytes.len()
            && (bytes[i].is_ascii_alphabetic()
                || bytes[i] == b'-' && bytes.get(i + 1).is_some_and(u8::is_ascii_alphabetic))
        {
            i += 1;
        }
        let letters = &line[from..i];
        while i < bytes.len() && bytes[i] == b' ' {
            i += 1;
        }
        let at = i;
        while i < bytes.len() && (bytes[i].is_ascii_digit() || matches!(bytes[i], b'.' | b'-' | b'+')) {
            i += 1;
        }
        if i > at {
            tokens.push(Token { letters, number: &line[at..i], at });
        }
    }
    tokens
}

/// Every mutant of a kind; of digits one for each word, the place of the digit going round.
pub(crate) fn mutants(text: &str, kind: Kind) -> Vec<Mutant> {
    let pages = text.contains("PAGE ");
    let lines: Vec<&str> = text.split('\n').collect();
    if kind == Kind::DroppedBlock {
        return if pages { dropped_pages(text) } else { dropped_lines(&lines) };
    }
    let mut made = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        for token in tokens(line) {
            let changed =
                if pages { page_word(&token, line, kind, made.len()) } else { word(&token, kind, made.len()) };
            for number in changed {
                let new = format!("{}{number}{}", &line[..token.at], &line[token.at + token.number.len()..]);
                let mut all = lines.clone();
                all[index] = &new;
                let what = format!("line {}: {} instead of {}", index + 1, new.trim(), line.trim());
                made.push(Mutant { what, text: all.join("\n") });
            }
        }
    }
    made
}

const LENGTHS: [&str; 4] = ["X", "Z", "RADIUS", "F"];

fn word(token: &Token<'_>, kind: Kind, count: usize) -> Vec<String> {
    let number = token.number;
    match (kind, token.letters) {
        (Kind::Sign, "X" | "Z") | (Kind::CentreSign, "I" | "K") => negated(number),
        (Kind::Digit, "X" | "Z" | "I" | "K" | "F" | "S" | "G" | "M") => digit(number, count),
        (Kind::LostPoint, "X" | "Z" | "I" | "K" | "F") => without_point(number),
        (Kind::RapidOrFeed, "G") => swapped(number, [("0", "1"), ("1", "0")]),
        (Kind::ArcSense, "G") => swapped(number, [("2", "3"), ("3", "2")]),
        (Kind::SwappedTool, "T") if !number.ends_with("00") => {
            ["0202", "0303", "0606", "1111"].iter().filter(|t| **t != number).map(|t| (*t).to_owned()).collect()
        }
        _ => Vec::new(),
    }
}

fn page_word(token: &Token<'_>, line: &str, kind: Kind, count: usize) -> Vec<String> {
    let number = token.number;
    match (kind, token.letters) {
        (Kind::Sign, "X" | "Z") => negated(number),
        (Kind::Digit, "X" | "Z" | "RADIUS" | "FEEDRATE" | "SPINDLE-SPEED" | "COUNT") => digit(number, count),
        (Kind::LostPoint, name) if LENGTHS.contains(&name) => without_point(number),
        (Kind::RapidOrFeed, "FEEDRATE") => {
            let rapid = number.parse::<f64>().is_ok_and(|f| f >= 1000.0);
            vec![if rapid { "80" } else { "1000" }.to_owned()]
        }
        (Kind::ArcSense, _) if line.contains("CIRCULAR") && token.number.starts_with("02") => vec!["03".to_owned()],
        (Kind::ArcSense, _) if line.contains("CIRCULAR") && token.number.starts_with("03") => vec!["02".to_owned()],
        (Kind::SwappedTool, "TOOL-NO") => (1..=4).map(|t| t.to_string()).filter(|t| t != number).collect(),
        _ => Vec::new(),
    }
}

fn negated(number: &str) -> Vec<String> {
    if number.parse::<f64>().is_ok_and(|v| v == 0.0) {
        return Vec::new();
    }
    vec![number.strip_prefix('-').map_or_else(|| format!("-{number}"), str::to_owned)]
}

/// One digit three higher, nine going back to two; which one goes round with the count.
fn digit(number: &str, count: usize) -> Vec<String> {
    let places: Vec<usize> = number.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(i, _)| i).collect();
    let Some(&at) = places.get(count % places.len().max(1)) else { return Vec::new() };
    let old = number.as_bytes()[at] - b'0';
    vec![format!("{}{}{}", &number[..at], (old + 3) % 10, &number[at + 1..])]
}

fn without_point(number: &str) -> Vec<String> {
    if number.contains('.') { vec![number.replace('.', "")] } else { Vec::new() }
}

fn swapped(number: &str, pairs: [(&str, &str); 2]) -> Vec<String> {
    pairs.iter().filter(|(from, _)| *from == number).map(|(_, to)| (*to).to_owned()).collect()
}

fn dropped_lines(lines: &[&str]) -> Vec<Mutant> {
    let drop = |index: usize| {
        let mut all = lines.to_vec();
        let line = all.remove(index);
        Mutant { what: format!("line {} dropped: {line}", index + 1), text: all.join("\n") }
    };
    (0..lines.len()).filter(|&i| !lines[i].trim().is_empty()).map(drop).collect()
}

/// Pages are numbered anew, so that the lost number does not tell.
fn dropped_pages(text: &str) -> Vec<Mutant> {
    let pages: Vec<&str> = text.split_inclusive('\u{2}').collect();
    // The first piece is what stands before the first page, its mark included.
    let drop = |index: usize| {
        let mut number = 0;
        let mut all = pages[0].to_owned();
        for (_, page) in pages.iter().enumerate().skip(1).filter(|(i, _)| *i != index) {
            number += 1;
            let rest = page.strip_prefix("PAGE ").map_or(*page, |r| r.trim_start_matches(|c: char| c.is_ascii_digit()));
            all += &["PAGE ", &format!("{number:02}"), rest].concat();
        }
        let what = format!("page {index} dropped: {}", pages[index].lines().collect::<Vec<_>>().join(" "));
        let text = all.trim_end_matches('\u{2}').to_owned();
        Mutant { what, text }
    };
    (1..pages.len()).map(drop).collect()
}
