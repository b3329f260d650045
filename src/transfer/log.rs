//! The transfer log: what went over the wire, with control characters made visible.

use std::fmt;
use std::time::Duration;

/// A log line is closed after this many bytes even if no line end came.
const LONGEST_LINE: usize = 80;

/// Which way a log line went.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// To the control.
    Sent,
    /// From the control.
    Received,
    /// A remark of this program.
    Note,
}

/// One line of the log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogLine {
    /// Time since the transfer began.
    pub at: Duration,
    /// Which way it went.
    pub direction: Direction,
    /// The characters, control characters shown as their pictures, or the remark.
    pub text: String,
}

impl fmt::Display for LogLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = match self.direction {
            Direction::Sent => '>',
            Direction::Received => '<',
            Direction::Note => '·',
        };
        write!(f, "{:>8.3} {sign} {}", self.at.as_secs_f64(), self.text)
    }
}

/// One byte as text: control characters as their pictures (␂ ␍ ␊ ␄), bytes above 127 as `<A3>`.
#[must_use]
pub fn visible(byte: u8) -> String {
    match byte {
        0..=31 => char::from_u32(0x2400 + u32::from(byte)).map(String::from).unwrap_or_default(),
        127 => '␡'.to_string(),
        128.. => format!("<{byte:02X}>"),
        _ => char::from(byte).to_string(),
    }
}

/// At most 30 characters of a line, control characters made visible.
pub(super) fn shortened(line: &str) -> String {
    const MOST: usize = 30;
    let start: String = line.bytes().take(MOST).map(visible).collect();
    if line.len() > MOST { start + "…" } else { start }
}

/// Gathers the bytes of one direction into log lines, one for each line of text.
#[derive(Debug)]
pub struct Gatherer {
    direction: Direction,
    bytes: Vec<u8>,
}

impl Gatherer {
    /// Nothing gathered yet.
    #[must_use]
    pub fn new(direction: Direction) -> Self {
        Self { direction, bytes: Vec::new() }
    }

    /// Adds bytes; returns the lines that they completed. A line ends after a line feed or the end mark.
    pub fn add(&mut self, bytes: &[u8], end: u8, at: Duration) -> Vec<LogLine> {
        let mut lines = Vec::new();
        for &byte in bytes {
            self.bytes.push(byte);
            if byte == b'\n' || byte == end || self.bytes.len() >= LONGEST_LINE {
                lines.extend(self.finish(at));
            }
        }
        lines
    }

    /// The line begun, if any.
    pub fn finish(&mut self, at: Duration) -> Option<LogLine> {
        if self.bytes.is_empty() {
            return None;
        }
        let text = self.bytes.drain(..).map(visible).collect();
        Some(LogLine { at, direction: self.direction, text })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_visible() {
        let mut gatherer = Gatherer::new(Direction::Sent);
        let lines = gatherer.add(b"\x02PAGE 01 MM-UNITS\r\nEND\x04\xa3", 4, Duration::ZERO);
        let texts: Vec<_> = lines.iter().map(|line| line.text.as_str()).collect();
        assert_eq!(texts, ["␂PAGE 01 MM-UNITS␍␊", "END␄"]);
        assert_eq!(gatherer.finish(Duration::ZERO).unwrap().text, "<A3>");
        assert_eq!(gatherer.finish(Duration::ZERO), None);
    }

    #[test]
    fn endless_lines_are_cut() {
        let lines = Gatherer::new(Direction::Received).add(&[b'x'; 200], 4, Duration::ZERO);
        assert_eq!(lines.len(), 2);
    }
}
