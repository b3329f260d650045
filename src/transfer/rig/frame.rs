//! One line with its checksum.

use std::fmt;

/// Longest line that is taken, bytes.
pub(super) const LONGEST: usize = 80;

/// A line without its end: a letter and its words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Frame {
    /// What the line is.
    pub letter: char,
    /// Its words.
    pub words: Vec<String>,
}

/// Why a line is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameError {
    /// Its checksum is missing or wrong.
    Sum,
    /// It has no letter, or words that are none.
    Line,
}

impl FrameError {
    /// The word for it on the line.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::Sum => "sum",
            Self::Line => "line",
        }
    }
}

impl Frame {
    /// A line of figures.
    #[must_use]
    pub fn of(letter: char, figures: &[i64]) -> Self {
        Self { letter, words: figures.iter().map(ToString::to_string).collect() }
    }

    /// A line with one word.
    #[must_use]
    pub fn word(letter: char, word: &str) -> Self {
        Self { letter, words: vec![word.to_owned()] }
    }

    /// Reads a line without its line feed.
    ///
    /// # Errors
    /// The checksum or the line is wrong.
    pub fn read(line: &str) -> Result<Self, FrameError> {
        let (body, sum) = line.trim_end_matches('\r').rsplit_once('*').ok_or(FrameError::Sum)?;
        let given = u8::from_str_radix(sum, 16).map_err(|_| FrameError::Sum)?;
        if sum.len() != 2 || given != checksum(body) {
            return Err(FrameError::Sum);
        }
        let mut words = body.split(' ');
        let mut letters = words.next().unwrap_or_default().chars();
        match (letters.next(), letters.next()) {
            (Some(letter), None) if letter.is_ascii_uppercase() => {
                Ok(Self { letter, words: words.map(str::to_owned).collect() })
            }
            _ => Err(FrameError::Line),
        }
    }

    /// All words as whole figures, if there are exactly `N`.
    #[must_use]
    pub fn figures<const N: usize>(&self) -> Option<[i64; N]> {
        let figures: Option<Vec<i64>> = self.words.iter().map(|w| w.parse().ok()).collect();
        figures?.try_into().ok()
    }
}

/// With checksum and line feed.
impl fmt::Display for Frame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut body = self.letter.to_string();
        for word in &self.words {
            body.push(' ');
            body.push_str(word);
        }
        let sum = checksum(&body);
        writeln!(f, "{body}*{sum:02X}")
    }
}

fn checksum(body: &str) -> u8 {
    body.bytes().fold(0, |sum, byte| sum ^ byte)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_back_as_they_were_written() {
        for frame in [Frame::of('S', &[3, 128, -5]), Frame::word('E', "sum"), Frame::of('G', &[])] {
            let line = frame.to_string();
            assert_eq!(Frame::read(line.trim_end_matches('\n')), Ok(frame));
        }
        assert_eq!(Frame::of('Q', &[]).to_string(), "Q*51\n");
    }

    #[test]
    fn every_changed_byte_is_noticed() {
        let line = Frame::of('S', &[12, 345, 67]).to_string();
        let line = line.trim_end();
        for at in 0..line.len() {
            let mut bytes = line.as_bytes().to_vec();
            bytes[at] ^= 1;
            let changed = String::from_utf8(bytes).unwrap();
            assert!(Frame::read(&changed).is_err(), "{changed}");
        }
    }
}
