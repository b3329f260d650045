//! Receives a program text.

use crate::machine::{FlowControl, Parity, SerialProfile};
use crate::transfer::line::{DC1, DC3};
use crate::transfer::log::visible;
use std::time::Duration;

/// What to do next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReceiveStep {
    /// Hand in what comes.
    Wait,
    /// The end mark came; [`Receiver::into_text`] has the text.
    Done,
    /// The transfer cannot go on, and why.
    Failed(String),
}

/// Gathers one program up to its end mark. What comes after the end mark is not looked at.
#[derive(Debug, Clone)]
pub struct Receiver {
    profile: SerialProfile,
    wait_for_first: Duration,
    idle: Duration,
    text: String,
    seen: usize,
    pages: usize,
    started: Option<Duration>,
    last_byte: Option<Duration>,
    end: Option<Result<(), String>>,
}

impl Receiver {
    /// Most bytes of a program that are taken: over twenty times what 99 pages of nine lines hold.
    pub const LARGEST: usize = 256 * 1024;

    /// Nothing received yet. `wait_for_first` bounds the wait for the first character, `idle` each later gap.
    #[must_use]
    pub fn new(profile: &SerialProfile, wait_for_first: Duration, idle: Duration) -> Self {
        Self {
            profile: profile.clone(),
            wait_for_first,
            idle,
            text: String::new(),
            seen: 0,
            pages: 0,
            started: None,
            last_byte: None,
            end: None,
        }
    }

    /// Hands in what came.
    pub fn received(&mut self, bytes: &[u8], now: Duration) {
        for &byte in bytes {
            if self.end.is_some() {
                return;
            }
            self.seen += 1;
            self.take(byte, now);
        }
    }

    fn take(&mut self, byte: u8, now: Duration) {
        if self.profile.flow == FlowControl::Software && [DC1, DC3].contains(&byte) {
            return;
        }
        if self.text.is_empty() && is_leader(byte) {
            return;
        }
        self.last_byte = Some(now);
        if byte == self.profile.end {
            self.end = Some(self.ended());
        } else if let Some(reason) = self.unusable(byte) {
            self.end = Some(Err(reason));
        } else {
            self.pages += usize::from(byte == self.profile.page_start);
            self.text.push(char::from(byte));
        }
    }

    fn ended(&self) -> Result<(), String> {
        if self.text.is_empty() {
            return Err("The control sent an end mark and nothing else: it holds no program.".to_owned());
        }
        if self.pages == 0 {
            return Err(format!(
                "{} characters came, but no page mark {}: this is no program.",
                self.text.len(),
                visible(self.profile.page_start)
            ));
        }
        Ok(())
    }

    fn unusable(&self, byte: u8) -> Option<String> {
        let place = self.seen;
        if byte > 127 || byte == 0 {
            let parity = match self.profile.parity {
                Parity::None => "no parity",
                Parity::Odd => "odd parity",
                Parity::Even => "even parity",
            };
            return Some(format!(
                "Byte {place} arrived as character {byte}, which no program holds. The line is set to {} baud, {} data \
                 bits, {parity}: check that the control sends the same.",
                self.profile.baud, self.profile.data_bits
            ));
        }
        (self.text.len() >= Self::LARGEST)
            .then(|| format!("No end mark came within {} bytes, more than any program holds.", Self::LARGEST))
    }

    /// What to do at the time `now`.
    pub fn poll(&mut self, now: Duration) -> ReceiveStep {
        let started = *self.started.get_or_insert(now);
        match (&self.end, self.last_byte) {
            (Some(Ok(())), _) => ReceiveStep::Done,
            (Some(Err(reason)), _) => ReceiveStep::Failed(reason.clone()),
            (None, Some(last)) if now.saturating_sub(last) >= self.idle => ReceiveStep::Failed(format!(
                "The control stopped after {} bytes: no end mark and nothing more for {} s.",
                self.text.len(),
                self.idle.as_secs_f64()
            )),
            (None, None) if now.saturating_sub(started) >= self.wait_for_first => ReceiveStep::Failed(format!(
                "Nothing came from the control within {} s.",
                self.wait_for_first.as_secs_f64()
            )),
            (None, _) => ReceiveStep::Wait,
        }
    }

    /// Bytes of text so far.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.text.len()
    }

    /// Pages begun so far.
    #[must_use]
    pub fn pages(&self) -> usize {
        self.pages
    }

    /// The text without its end mark.
    #[must_use]
    pub fn into_text(self) -> String {
        self.text
    }
}

/// What may come before a program without meaning: filling, line ends, tape and flow characters.
fn is_leader(byte: u8) -> bool {
    matches!(byte, 0 | b'\r' | b'\n' | b' ' | 0x11..=0x14 | 0x7f)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transfer::line::tests::orac_profile;
    use proptest::prelude::*;

    const FIRST: Duration = Duration::from_mins(1);
    const IDLE: Duration = Duration::from_secs(5);

    fn receiver() -> Receiver {
        Receiver::new(&orac_profile(), FIRST, IDLE)
    }

    fn after(bytes: &[u8]) -> (ReceiveStep, String) {
        let mut receiver = receiver();
        receiver.received(bytes, Duration::ZERO);
        (receiver.poll(Duration::ZERO), receiver.into_text())
    }

    fn failure(bytes: &[u8]) -> String {
        let ReceiveStep::Failed(reason) = after(bytes).0 else { panic!("{bytes:?} was taken") };
        reason
    }

    #[test]
    fn takes_a_program_up_to_its_end_mark() {
        let (step, text) = after(b"\0\0\r\n\x02PAGE 01 A\r\n\x04rest");
        assert_eq!((step, text.as_str()), (ReceiveStep::Done, "\x02PAGE 01 A\r\n"));
    }

    #[test]
    fn unusable_answers_say_why() {
        assert!(failure(b"\x04").contains("holds no program"));
        assert!(failure(b"HELLO\x04").contains("no page mark ␂"));
        assert!(failure(b"\x02PA\xc7").contains("Byte 4 arrived as character 199"));
        assert!(failure(b"\x02PA\0").contains("character 0"));
        let endless = [&[2][..], &vec![b'X'; Receiver::LARGEST]].concat();
        assert!(failure(&endless).contains("No end mark came within 262144 bytes"));
    }

    #[test]
    fn silence_fails_in_simulated_time() {
        let mut receiver = receiver();
        assert_eq!(receiver.poll(Duration::from_secs(3)), ReceiveStep::Wait);
        assert_eq!(receiver.poll(Duration::from_secs(62)), ReceiveStep::Wait);
        receiver.received(b"\x02PAGE", Duration::from_secs(62));
        assert_eq!(receiver.poll(Duration::from_secs(66)), ReceiveStep::Wait);
        let ReceiveStep::Failed(reason) = receiver.poll(Duration::from_secs(67)) else { panic!("waits for ever") };
        assert_eq!(reason, "The control stopped after 5 bytes: no end mark and nothing more for 5 s.");

        let mut nothing = Receiver::new(&orac_profile(), FIRST, IDLE);
        nothing.poll(Duration::ZERO);
        assert!(matches!(nothing.poll(FIRST), ReceiveStep::Failed(reason) if reason.contains("within 60 s")));
    }

    #[test]
    fn flow_characters_are_text_only_without_software_flow() {
        let soft = SerialProfile { flow: FlowControl::Software, ..orac_profile() };
        let mut receiver = Receiver::new(&soft, FIRST, IDLE);
        receiver.received(b"\x02PA\x13\x11GE\x04", Duration::ZERO);
        assert_eq!(receiver.into_text(), "\x02PAGE");
        assert_eq!(after(b"\x02PA\x13GE\x04").1, "\x02PA\x13GE");
    }

    proptest! {
        #[test]
        fn noise_never_breaks_it(chunks in prop::collection::vec((prop::collection::vec(any::<u8>(), 0..300), 0u64..9), 0..20)) {
            let (mut receiver, mut now, mut fed) = (receiver(), Duration::ZERO, 0);
            receiver.poll(now);
            for (bytes, seconds) in chunks {
                now += Duration::from_secs(seconds);
                receiver.received(&bytes, now);
                fed += bytes.len();
                prop_assert!(receiver.bytes() <= fed.min(Receiver::LARGEST));
                prop_assert!(receiver.pages() <= receiver.bytes());
                receiver.poll(now);
            }
            prop_assert_ne!(receiver.poll(now + FIRST), ReceiveStep::Wait);
            prop_assert!(receiver.into_text().is_ascii());
        }
    }
}
