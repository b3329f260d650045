//! Sends a program text.

use crate::machine::{FlowControl, SerialProfile};
use crate::transfer::line::{self, DC1, DC3, Pace};
use crate::transfer::log::visible;
use std::time::Duration;

/// Why a text is not sent at all.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Refused {
    /// The settings of the line are impossible.
    #[error("{0}")]
    Line(String),
    /// A character that seven bits cannot carry.
    #[error(
        "Line {line}, character {column}: `{character}` is character {}; only characters up to 127 can be sent. \
         Replace it.", u32::from(*character)
    )]
    NotSevenBit {
        /// Line from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// The character.
        character: char,
    },
    /// A control character that would end the transfer or confuse the control.
    #[error(
        "Line {line}, character {column}: {} is the control character {value}; a program may hold page marks, \
         carriage returns and line feeds only. Remove it.", visible(*value)
    )]
    ControlCharacter {
        /// Line from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// Its value.
        value: u8,
    },
    /// The text is not a page file.
    #[error(
        "The text does not begin with a page mark (character {page_start}): it is no page file. Assemble the program \
         to pages first."
    )]
    NoPages {
        /// The page mark.
        page_start: u8,
    },
}

/// What to do next.
#[derive(Debug, PartialEq, Eq)]
pub enum SendStep<'a> {
    /// Write these bytes and report with [`Sender::written`] how many were taken.
    Write(&'a [u8]),
    /// Nothing to write for this long, unless something is received.
    Wait(Duration),
    /// All bytes are out.
    Done,
    /// The transfer cannot go on, and why.
    Failed(String),
}

/// Sends one program: the pages as they are, then the end mark.
#[derive(Debug, Clone)]
pub struct Sender {
    bytes: Vec<u8>,
    sent: usize,
    page_starts: Vec<usize>,
    pace: Pace,
    heeds_dc3: bool,
    held: bool,
    patience: Duration,
    last_progress: Option<Duration>,
}

impl Sender {
    /// Checks `text` as a whole before the first byte goes out.
    ///
    /// `patience` is the time without progress after which the transfer fails.
    ///
    /// # Errors
    /// [`Refused`] with place and value.
    pub fn new(text: &str, profile: &SerialProfile, unpaced: bool, patience: Duration) -> Result<Self, Refused> {
        line::check(profile).map_err(Refused::Line)?;
        check_text(text, profile.page_start)?;
        let mut bytes = text.as_bytes().to_vec();
        let is_mark = |&(_, &byte): &(usize, &u8)| byte == profile.page_start;
        let page_starts = bytes.iter().enumerate().filter(is_mark).map(|(place, _)| place).collect();
        bytes.push(profile.end);
        Ok(Self {
            bytes,
            sent: 0,
            page_starts,
            pace: Pace::new(profile, unpaced),
            heeds_dc3: profile.flow == FlowControl::Software,
            held: false,
            patience,
            last_progress: None,
        })
    }

    /// What to do at the time `now`.
    pub fn poll(&mut self, now: Duration) -> SendStep<'_> {
        let last_progress = *self.last_progress.get_or_insert(now);
        let rest = self.bytes.get(self.sent..).unwrap_or_default();
        if rest.is_empty() {
            let backlog = self.pace.backlog(now);
            return if backlog.is_zero() { SendStep::Done } else { SendStep::Wait(backlog) };
        }
        if now.saturating_sub(last_progress) >= self.patience {
            return SendStep::Failed(self.stuck());
        }
        if self.held {
            return SendStep::Wait(self.patience);
        }
        match rest.get(..self.pace.allowance(now).min(rest.len())) {
            Some(chunk) if !chunk.is_empty() => SendStep::Write(chunk),
            _ => SendStep::Wait(self.pace.wait(now)),
        }
    }

    fn stuck(&self) -> String {
        let (sent, total, waited) = (self.sent, self.bytes.len(), self.patience.as_secs_f64());
        if self.held {
            format!(
                "The control asked to wait (DC3) after {sent} of {total} bytes and did not go on within {waited} s."
            )
        } else {
            format!(
                "The port took no byte for {waited} s, after {sent} of {total} bytes. Check the cable, the flow control \
                 and that the control is ready to receive."
            )
        }
    }

    /// Notes that `count` bytes of the last chunk were taken.
    pub fn written(&mut self, count: usize, now: Duration) {
        if count > 0 {
            self.sent = self.bytes.len().min(self.sent + count);
            self.pace.took(count, now);
            self.last_progress = Some(now);
        }
    }

    /// Notes what the control sent meanwhile: DC3 holds and DC1 resumes if software flow control is chosen.
    pub fn received(&mut self, bytes: &[u8], now: Duration) {
        if !self.heeds_dc3 {
            return;
        }
        for byte in bytes {
            match *byte {
                DC3 => self.held = true,
                DC1 if self.held => {
                    self.held = false;
                    self.last_progress = Some(now);
                }
                _ => {}
            }
        }
    }

    /// Bytes taken so far, and in all, the end mark included.
    #[must_use]
    pub fn bytes(&self) -> (usize, usize) {
        (self.sent, self.bytes.len())
    }

    /// Pages begun so far, and in all.
    #[must_use]
    pub fn pages(&self) -> (usize, usize) {
        (self.page_starts.partition_point(|&start| start < self.sent), self.page_starts.len())
    }

    /// Time that the rest takes at the speed of the line; none if unpaced.
    #[must_use]
    pub fn time_left(&self, now: Duration) -> Option<Duration> {
        let rest = self.pace.time_for(self.bytes.len().saturating_sub(self.sent))?;
        Some(rest + self.pace.backlog(now))
    }
}

fn check_text(text: &str, page_start: u8) -> Result<(), Refused> {
    let (mut line, mut column) = (1, 1);
    for character in text.chars() {
        let Ok(value @ 0..=127) = u8::try_from(character) else {
            return Err(Refused::NotSevenBit { line, column, character });
        };
        if value.is_ascii_control() && ![page_start, b'\r', b'\n'].contains(&value) {
            return Err(Refused::ControlCharacter { line, column, value });
        }
        column += 1;
        if value == b'\n' {
            (line, column) = (line + 1, 1);
        }
    }
    if text.as_bytes().first() == Some(&page_start) { Ok(()) } else { Err(Refused::NoPages { page_start }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transfer::line::tests::orac_profile;

    const TEXT: &str = "\x02PAGE 01 MM-UNITS\r\n\x02PAGE 02 END-PROGRAM..M02\r\n";
    const PATIENCE: Duration = Duration::from_secs(10);

    /// Runs to the end in simulated time; the port takes at most `port_takes` bytes a call.
    fn run(sender: &mut Sender, port_takes: usize) -> (Vec<u8>, Duration, Result<(), String>) {
        let (mut out, mut now) = (Vec::new(), Duration::ZERO);
        loop {
            let chunk = match sender.poll(now) {
                SendStep::Write(bytes) => bytes[..bytes.len().min(port_takes)].to_vec(),
                SendStep::Wait(time) => {
                    now += time.max(Duration::from_micros(10));
                    continue;
                }
                SendStep::Done => return (out, now, Ok(())),
                SendStep::Failed(reason) => return (out, now, Err(reason)),
            };
            sender.written(chunk.len(), now);
            out.extend(&chunk);
            now += Duration::from_millis(if chunk.is_empty() { 20 } else { 1 });
        }
    }

    #[test]
    fn sends_text_and_end_mark_at_the_speed_of_the_line() {
        let mut sender = Sender::new(TEXT, &orac_profile(), false, PATIENCE).unwrap();
        let (out, took, end) = run(&mut sender, 64);
        assert_eq!(end, Ok(()));
        assert_eq!(out, [TEXT.as_bytes(), &[4]].concat());
        let on_the_wire = line::character_time(&orac_profile()) * u32::try_from(out.len()).unwrap();
        assert!(took >= on_the_wire && took < on_the_wire + Duration::from_millis(5), "{took:?}");
        assert_eq!((sender.bytes(), sender.pages()), ((out.len(), out.len()), (2, 2)));
    }

    #[test]
    fn unpaced_takes_no_time_of_its_own() {
        let mut sender = Sender::new(TEXT, &orac_profile(), true, PATIENCE).unwrap();
        assert_eq!(sender.time_left(Duration::ZERO), None);
        let (out, took, end) = run(&mut sender, 7);
        assert_eq!((out.len(), end), (TEXT.len() + 1, Ok(())));
        assert!(took < Duration::from_millis(20));
    }

    #[test]
    fn a_port_that_takes_nothing_fails() {
        let mut sender = Sender::new(TEXT, &orac_profile(), false, PATIENCE).unwrap();
        let (out, took, end) = run(&mut sender, 0);
        assert!(out.is_empty() && took >= PATIENCE);
        assert!(end.unwrap_err().contains("no byte for 10 s, after 0 of 47 bytes"));
    }

    #[test]
    fn dc3_holds_and_dc1_resumes_if_chosen() {
        let soft = SerialProfile { flow: FlowControl::Software, ..orac_profile() };
        let mut sender = Sender::new(TEXT, &soft, true, PATIENCE).unwrap();
        sender.received(&[DC3], Duration::ZERO);
        assert!(matches!(sender.poll(Duration::ZERO), SendStep::Wait(_)));
        sender.received(b"noise", Duration::from_secs(1));
        assert!(matches!(sender.poll(Duration::from_secs(1)), SendStep::Wait(_)));
        sender.received(&[DC1], Duration::from_secs(9));
        assert!(matches!(sender.poll(Duration::from_secs(12)), SendStep::Write(_)));
        sender.received(&[DC3], Duration::from_secs(12));
        let SendStep::Failed(reason) = sender.poll(Duration::from_secs(19)) else { panic!("held for ever") };
        assert!(reason.contains("DC3"), "{reason}");

        let mut without = Sender::new(TEXT, &orac_profile(), true, PATIENCE).unwrap();
        without.received(&[DC3], Duration::ZERO);
        assert!(matches!(without.poll(Duration::ZERO), SendStep::Write(_)));
    }

    #[test]
    fn bad_texts_are_refused_with_place_and_value() {
        for (text, words) in [
            ("\x02PAGE 01\r\nX ½\r\n", "Line 2, character 3: `½` is character 189"),
            ("\x02PAGE 01\r\n\x04", "Line 2, character 1: ␄ is the control character 4"),
            ("\x02A\x11", "character 3: ␑ is the control character 17"),
            ("  1  INC\n", "no page file"),
            ("", "no page file"),
        ] {
            let refused = Sender::new(text, &orac_profile(), false, PATIENCE).unwrap_err();
            assert!(refused.to_string().contains(words), "{refused}");
        }
    }
}
