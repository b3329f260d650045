//! What was sent against what came back, piece by piece.

use super::log::shortened;
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

/// What a program is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Piece {
    /// What stands before the first page.
    Leader,
    /// A page of several lines.
    Page,
    /// A block: one line.
    Block,
}

/// One piece that is not the same on both sides.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// What the piece is.
    pub piece: Piece,
    /// Its number, from 1 in the order of the text (of the received text for an extra piece).
    pub number: usize,
    /// What is different.
    pub kind: DifferenceKind,
}

/// How a piece differs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DifferenceKind {
    /// The piece came back changed; the first place is given.
    Changed {
        /// Line within the piece, from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// The line as sent, control characters made visible, shortened.
        sent: String,
        /// The line as received.
        received: String,
        /// True if the piece differs in blanks only.
        blanks_only: bool,
    },
    /// The piece did not come back.
    Missing {
        /// Its first line as sent.
        sent: String,
    },
    /// A piece came back that was not sent.
    Extra {
        /// Its first line as received.
        received: String,
    },
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.number;
        let piece = match self.piece {
            Piece::Leader => "Before the first page".to_owned(),
            Piece::Page => format!("Page {number}"),
            Piece::Block => format!("Block {number}"),
        };
        match &self.kind {
            DifferenceKind::Changed { line, column, sent, received, blanks_only } => {
                let line = if self.piece == Piece::Block { String::new() } else { format!(" line {line},") };
                let only = if *blanks_only { " (only blanks differ)" } else { "" };
                write!(f, "{piece},{line} character {column}: sent `{sent}`, came back `{received}`{only}")
            }
            DifferenceKind::Missing { sent } => write!(f, "{piece} did not come back: `{sent}`"),
            DifferenceKind::Extra { received } => write!(f, "{piece} of what came back was not sent: `{received}`"),
        }
    }
}

/// Compares the pieces of two programs; no differences means that they are the same.
///
/// Pieces are matched from the front and from the back, so that one lost piece does not make all later ones differ.
#[must_use]
pub fn compare_pieces(piece: Piece, sent: &[&str], received: &[&str], blanks: Blanks) -> Vec<Difference> {
    let is_same = |(x, y): &(&&str, &&str)| same(x, y, blanks);
    let front = sent.iter().zip(received).take_while(is_same).count();
    let most = sent.len().min(received.len()) - front;
    let back = sent.iter().rev().zip(received.iter().rev()).take(most).take_while(is_same).count();
    let (mut sent, mut received) =
        (sent[front..sent.len() - back].iter(), received[front..received.len() - back].iter());
    let mut differences = Vec::new();
    for number in front + 1.. {
        let kind = match (sent.next(), received.next()) {
            (Some(x), Some(y)) if same(x, y, blanks) => continue,
            (Some(x), Some(y)) => changed(x, y),
            (Some(x), None) => DifferenceKind::Missing { sent: first_line(x) },
            (None, Some(y)) => DifferenceKind::Extra { received: first_line(y) },
            (None, None) => break,
        };
        differences.push(Difference { piece, number, kind });
    }
    differences
}

fn same(a: &str, b: &str, blanks: Blanks) -> bool {
    match blanks {
        Blanks::Exact => a == b,
        Blanks::Ignored => a.bytes().filter(|&c| c != b' ').eq(b.bytes().filter(|&c| c != b' ')),
    }
}

fn changed(sent: &str, received: &str) -> DifferenceKind {
    let (a, b) = (sent.as_bytes(), received.as_bytes());
    let place = a.iter().zip(b).take_while(|(x, y)| x == y).count();
    let before = &a[..place];
    let line = before.split(|&c| c == b'\n').count() - 1;
    let column = before.iter().rev().take_while(|&&c| c != b'\n').count() + 1;
    let line_of = |text: &str| shortened(text.split_inclusive('\n').nth(line).unwrap_or_default());
    DifferenceKind::Changed {
        line: line + 1,
        column,
        sent: line_of(sent),
        received: line_of(received),
        blanks_only: same(sent, received, Blanks::Ignored),
    }
}

fn first_line(piece: &str) -> String {
    shortened(piece.lines().next().unwrap_or_default())
}
