//! Receives a program text: the same machine for every protocol, with a `Frame` that knows where a program begins and
//! ends.

use super::protocol;
use crate::machine::{DC1, DC3, Parity, SerialProfile};
use std::fmt::Debug;
use std::time::Duration;

/// What to do next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReceiveStep {
    /// Hand in what comes.
    Wait,
    /// The end mark came; [`Receiver::into_received`] has what came.
    Done,
    /// The transfer cannot go on, and why.
    Failed(String),
}

/// What a byte is to a protocol.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Taken {
    /// No part of the program: filling before or after it, or a mark of the transfer.
    Skipped,
    /// A character of the program.
    Kept,
    /// The character that begins a page or ends a block.
    KeptMark,
    /// The end of the transfer.
    Ended,
    /// Something that is no program; a sentence.
    Wrong(String),
}

/// Finds a program in what comes in.
pub(super) trait Frame: Debug + Send {
    /// Takes the next byte; `text` is what was kept so far.
    fn take(&mut self, byte: u8, text: &str) -> Taken;
}

/// Gathers one program up to its end mark. What comes after the end mark is not looked at.
#[derive(Debug)]
pub struct Receiver {
    profile: SerialProfile,
    frame: Box<dyn Frame>,
    wait_for_first: Duration,
    idle: Duration,
    text: String,
    seen: usize,
    blocks: usize,
    started: Option<Duration>,
    last_byte: Option<Duration>,
    end: Option<Result<(), String>>,
}

impl Receiver {
    /// Most bytes of a program that are taken: over twenty times what 99 pages of nine lines hold, and 640 m of tape.
    pub const LARGEST: usize = 256 * 1024;

    /// Nothing received yet. `wait_for_first` bounds the wait for the first character, `idle` each later gap.
    #[must_use]
    pub fn new(profile: &SerialProfile, wait_for_first: Duration, idle: Duration) -> Self {
        Self {
            frame: protocol::frame(profile.protocol),
            profile: profile.clone(),
            wait_for_first,
            idle,
            text: String::new(),
            seen: 0,
            blocks: 0,
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
        if self.profile.heeds_dc3() && [DC1, DC3].contains(&byte) {
            return;
        }
        let taken = self.frame.take(byte, &self.text);
        if taken == Taken::Skipped && self.text.is_empty() {
            return;
        }
        self.last_byte = Some(now);
        match taken {
            Taken::Skipped => {}
            Taken::Ended => self.end = Some(Ok(())),
            Taken::Wrong(reason) => self.end = Some(Err(reason)),
            Taken::Kept | Taken::KeptMark => {
                if let Some(reason) = self.unusable(byte) {
                    self.end = Some(Err(reason));
                } else {
                    self.blocks += usize::from(taken == Taken::KeptMark);
                    self.text.push(char::from(byte));
                }
            }
        }
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

    /// Bytes of the program so far.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.text.len()
    }

    /// Pages begun, or blocks ended, so far.
    #[must_use]
    pub fn blocks(&self) -> usize {
        self.blocks
    }

    /// The program as it came in, without the marks of the transfer.
    #[must_use]
    pub fn into_received(self) -> String {
        self.text
    }
}

/// What may come before a program without meaning: filling, line ends, tape and flow characters.
pub(super) const fn is_filling(byte: u8) -> bool {
    matches!(byte, 0 | b'\r' | b'\n' | b' ' | 0x11..=0x14 | 0x7f)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::FlowControl;
    use crate::transfer::line::tests::{fanuc_profile, orac_profile};
    use proptest::prelude::*;

    const FIRST: Duration = Duration::from_mins(1);
    const IDLE: Duration = Duration::from_secs(5);

    fn after(profile: &SerialProfile, bytes: &[u8]) -> (ReceiveStep, String) {
        let mut receiver = Receiver::new(profile, FIRST, IDLE);
        receiver.received(bytes, Duration::ZERO);
        (receiver.poll(Duration::ZERO), receiver.into_received())
    }

    fn failure(profile: &SerialProfile, bytes: &[u8]) -> String {
        let ReceiveStep::Failed(reason) = after(profile, bytes).0 else { panic!("{bytes:?} was taken") };
        reason
    }

    #[test]
    fn takes_a_program_up_to_its_end_mark() {
        let (step, text) = after(&orac_profile(), b"\0\0\r\n\x02PAGE 01 A\r\n\x04rest");
        assert_eq!((step, text.as_str()), (ReceiveStep::Done, "\x02PAGE 01 A\r\n"));
        let (step, text) = after(&fanuc_profile(), b"\x13\x12\0\0%\nO1\nM30\n%\n\0\0\x14rest");
        assert_eq!((step, text.as_str()), (ReceiveStep::Done, "%\nO1\nM30\n%"));
    }

    #[test]
    fn unusable_answers_say_why() {
        let orac = |bytes: &[u8]| failure(&orac_profile(), bytes);
        assert!(orac(b"\x04").contains("holds no program"));
        assert!(orac(b"HELLO\x04").contains("no page mark ␂"));
        assert!(orac(b"\x02PA\xc7").contains("Byte 4 arrived as character 199"));
        assert!(orac(b"\x02PA\0").contains("character 0"));
        let endless = [&[2][..], &vec![b'X'; Receiver::LARGEST]].concat();
        assert!(orac(&endless).contains("No end mark came within 262144 bytes"));

        let fanuc = |bytes: &[u8]| failure(&fanuc_profile(), bytes);
        assert!(fanuc(b"\x12\x14").contains("holds no program"));
        assert!(fanuc(b"\x12%\n%\x14").contains("holds no program"));
        assert!(fanuc(b"\x12O1\n").contains("begins with `O`"));
        assert!(fanuc(b"\x12%\nO1\n\x14").contains("before the closing %"));
        assert!(fanuc(b"\x12%\nO1\n%\nM30").contains("`M` came after the closing %"));
        assert!(fanuc(b"\x12%\nO1\x07").contains("control character ␇ (7)"));
        assert!(fanuc(b"\x12%\nO1\0").contains("character 0"));
    }

    #[test]
    fn silence_fails_in_simulated_time() {
        let mut receiver = Receiver::new(&orac_profile(), FIRST, IDLE);
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
        assert_eq!(after(&soft, b"\x02PA\x13\x11GE\x04").1, "\x02PAGE");
        assert_eq!(after(&orac_profile(), b"\x02PA\x13GE\x04").1, "\x02PA\x13GE");
    }

    proptest! {
        #[test]
        fn noise_never_breaks_it(
            is_fanuc in any::<bool>(),
            chunks in prop::collection::vec((prop::collection::vec(any::<u8>(), 0..300), 0u64..9), 0..20),
        ) {
            let profile = if is_fanuc { fanuc_profile() } else { orac_profile() };
            let (mut receiver, mut now, mut fed) = (Receiver::new(&profile, FIRST, IDLE), Duration::ZERO, 0);
            receiver.poll(now);
            for (bytes, seconds) in chunks {
                now += Duration::from_secs(seconds);
                receiver.received(&bytes, now);
                fed += bytes.len();
                prop_assert!(receiver.bytes() <= fed.min(Receiver::LARGEST));
                prop_assert!(receiver.blocks() <= receiver.bytes());
                receiver.poll(now);
            }
            prop_assert_ne!(receiver.poll(now + FIRST), ReceiveStep::Wait);
            prop_assert!(receiver.into_received().is_ascii());
        }
    }
}
