//! Sends a program text: the same machine for every protocol, since they differ only in the bytes, in who starts, and in
//! who says that the end was read.

use super::line::{self, Pace};
use super::protocol::{Outgoing, Refused, outgoing};
use crate::machine::{DC1, DC3, Protocol, SerialProfile};
use std::time::Duration;

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

/// A DC3 after the last byte may also mean that the buffer is full, and then DC1 follows. It counts as "the end was read"
/// after so long without DC1.
const CONFIRMED_AFTER: Duration = Duration::from_millis(500);

/// How long a sender waits for what.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Patience {
    /// For the control to start the transfer (DC1), where it does so.
    pub start: Duration,
    /// For any progress after that.
    pub stuck: Duration,
}

/// Sends one program. A reader/punch control starts it with DC1 and ends it with DC3; an ORAC says nothing.
#[derive(Debug, Clone)]
pub struct Sender {
    outgoing: Outgoing,
    sent: usize,
    pace: Pace,
    heeds_dc3: bool,
    /// The control has to say that it read the end.
    wants_confirmation: bool,
    started: bool,
    /// When DC3 came, while no DC1 has come after it.
    held: Option<Duration>,
    patience: Patience,
    last_progress: Option<Duration>,
}

impl Sender {
    /// Checks `text` as a whole before the first byte goes out.
    ///
    /// # Errors
    /// [`Refused`] with place and value.
    pub fn new(text: &str, profile: &SerialProfile, unpaced: bool, patience: Patience) -> Result<Self, Refused> {
        line::check(profile).map_err(Refused::Line)?;
        let (control_starts, wants_confirmation) = match profile.protocol {
            Protocol::OracPages(_) => (false, false),
            Protocol::FanucReaderPunch(habits) => (true, habits.confirms_end),
        };
        Ok(Self {
            outgoing: outgoing(text, profile.protocol)?,
            sent: 0,
            pace: Pace::new(profile, unpaced),
            heeds_dc3: profile.heeds_dc3(),
            wants_confirmation,
            started: !control_starts,
            held: None,
            patience,
            last_progress: None,
        })
    }

    /// What to do at the time `now`.
    pub fn poll(&mut self, now: Duration) -> SendStep<'_> {
        let waited = now.saturating_sub(*self.last_progress.get_or_insert(now));
        if !self.started {
            return patient(waited, self.patience.start, || self.not_started());
        }
        let rest = self.outgoing.bytes.get(self.sent..).unwrap_or_default();
        if rest.is_empty() {
            return self.at_the_end(waited, now);
        }
        if self.held.is_some() || waited >= self.patience.stuck {
            return patient(waited, self.patience.stuck, || self.stuck());
        }
        match rest.get(..self.pace.allowance(now).min(rest.len())) {
            Some(chunk) if !chunk.is_empty() => SendStep::Write(chunk),
            _ => SendStep::Wait(self.pace.wait(now)),
        }
    }

    fn at_the_end(&self, waited: Duration, now: Duration) -> SendStep<'static> {
        let confirmed_at = self.held.map(|since| since + CONFIRMED_AFTER);
        let left = match confirmed_at {
            Some(confirmed_at) if self.wants_confirmation => confirmed_at.saturating_sub(now),
            None if self.wants_confirmation => {
                return patient(waited, self.patience.stuck, || self.not_confirmed());
            }
            _ => self.pace.backlog(now),
        };
        if left.is_zero() { SendStep::Done } else { SendStep::Wait(left) }
    }

    fn not_started(&self) -> String {
        format!(
            "The control did not start the transfer (DC1) within {} s. Start reading at the control after pressing Send; \
             if that was done, check the cable and the settings of the line.",
            self.patience.start.as_secs_f64()
        )
    }

    fn not_confirmed(&self) -> String {
        format!(
            "All {} bytes went out, but the control did not say (DC3) within {} s that it read the end of the program. \
             Look at its screen for an alarm, and compare.",
            self.sent,
            self.patience.stuck.as_secs_f64()
        )
    }

    fn stuck(&self) -> String {
        let (sent, total, waited) = (self.sent, self.outgoing.bytes.len(), self.patience.stuck.as_secs_f64());
        if self.held.is_some() {
            format!(
                "The control asked to wait (DC3) after {sent} of {total} bytes and did not go on within {waited} s. Look \
                 at its screen for an alarm."
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
            self.sent = self.outgoing.bytes.len().min(self.sent + count);
            self.pace.took(count, now);
            self.last_progress = Some(now);
        }
    }

    /// Notes what the control sent meanwhile: DC1 starts and resumes, DC3 holds, where the protocol or the flow control
    /// knows them.
    pub fn received(&mut self, bytes: &[u8], now: Duration) {
        if !self.heeds_dc3 {
            return;
        }
        for byte in bytes {
            match *byte {
                DC3 if self.started => self.held = Some(now),
                DC1 if self.held.is_some() || !self.started => {
                    (self.started, self.held) = (true, None);
                    self.last_progress = Some(now);
                }
                _ => {}
            }
        }
    }

    /// False while the control has not yet started the transfer.
    #[must_use]
    pub const fn has_started(&self) -> bool {
        self.started
    }

    /// Bytes taken so far, and in all, marks included.
    #[must_use]
    pub fn bytes(&self) -> (usize, usize) {
        (self.sent, self.outgoing.bytes.len())
    }

    /// Blocks or pages begun so far, and in all.
    #[must_use]
    pub fn blocks(&self) -> (usize, usize) {
        let starts = &self.outgoing.block_starts;
        (starts.partition_point(|&start| start < self.sent), starts.len())
    }

    /// Time that the rest takes at the speed of the line; none if unpaced.
    #[must_use]
    pub fn time_left(&self, now: Duration) -> Option<Duration> {
        let rest = self.pace.time_for(self.outgoing.bytes.len().saturating_sub(self.sent))?;
        Some(rest + self.pace.backlog(now))
    }
}

fn patient<'a>(waited: Duration, patience: Duration, reason: impl FnOnce() -> String) -> SendStep<'a> {
    let left = patience.saturating_sub(waited);
    if left.is_zero() { SendStep::Failed(reason()) } else { SendStep::Wait(left) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::FlowControl;
    use crate::transfer::line::tests::{fanuc_profile, orac_profile};

    const TEXT: &str = "\x02PAGE 01 MM-UNITS\r\n\x02PAGE 02 END-PROGRAM..M02\r\n";
    const NC: &str = "O0201\nN10G21\nM30\n";
    const PATIENCE: Patience = Patience { start: Duration::from_mins(1), stuck: Duration::from_secs(10) };

    fn orac(unpaced: bool) -> Sender {
        Sender::new(TEXT, &orac_profile(), unpaced, PATIENCE).unwrap()
    }

    fn fanuc(unpaced: bool) -> Sender {
        Sender::new(NC, &fanuc_profile(), unpaced, PATIENCE).unwrap()
    }

    fn failure(step: SendStep<'_>) -> String {
        let SendStep::Failed(reason) = step else { panic!("{step:?}") };
        reason
    }

    /// Runs to the end in simulated time from `now`; the port takes at most `port_takes` bytes a call.
    fn run(sender: &mut Sender, mut now: Duration, port_takes: usize) -> (Vec<u8>, Duration, Result<(), String>) {
        let mut out = Vec::new();
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
        let mut sender = orac(false);
        let (out, took, end) = run(&mut sender, Duration::ZERO, 64);
        assert_eq!(end, Ok(()));
        assert_eq!(out, [TEXT.as_bytes(), &[4]].concat());
        let on_the_wire = line::character_time(&orac_profile()) * u32::try_from(out.len()).unwrap();
        assert!(took >= on_the_wire && took < on_the_wire + Duration::from_millis(5), "{took:?}");
        assert_eq!((sender.bytes(), sender.blocks()), ((out.len(), out.len()), (2, 2)));
    }

    #[test]
    fn unpaced_takes_no_time_of_its_own() {
        let mut sender = orac(true);
        assert_eq!(sender.time_left(Duration::ZERO), None);
        let (out, took, end) = run(&mut sender, Duration::ZERO, 7);
        assert_eq!((out.len(), end), (TEXT.len() + 1, Ok(())));
        assert!(took < Duration::from_millis(20));
    }

    #[test]
    fn a_port_that_takes_nothing_fails() {
        let (out, took, end) = run(&mut orac(false), Duration::ZERO, 0);
        assert!(out.is_empty() && took >= PATIENCE.stuck);
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
        assert!(failure(sender.poll(Duration::from_secs(19))).contains("DC3"));

        let mut without = orac(true);
        without.received(&[DC3], Duration::ZERO);
        assert!(matches!(without.poll(Duration::ZERO), SendStep::Write(_)));
    }

    #[test]
    fn a_reader_starts_the_sender_and_says_that_it_read_the_end() {
        let mut sender = fanuc(true);
        assert!(matches!(sender.poll(Duration::ZERO), SendStep::Wait(_)));
        sender.received(&[DC3, b'x'], Duration::ZERO);
        assert!(!sender.has_started());
        let begin = Duration::from_secs(50);
        sender.received(&[DC1], begin);
        assert!(sender.has_started());
        let (out, took, end) = run(&mut sender.clone(), begin, 64);
        assert_eq!(out, b"%\nO0201\nN10G21\nM30\n%");
        assert!(took >= begin + PATIENCE.stuck);
        assert!(end.unwrap_err().contains("All 20 bytes went out, but the control did not say (DC3)"));
        while let SendStep::Write(bytes) = sender.poll(begin) {
            let count = bytes.len();
            sender.written(count, begin);
        }
        sender.received(&[DC3, DC1, DC3], begin);
        assert!(matches!(sender.poll(begin), SendStep::Wait(_)), "DC1 may follow");
        assert_eq!(sender.poll(begin + CONFIRMED_AFTER), SendStep::Done);
        sender.received(&[DC1], begin);
        assert!(failure(sender.poll(begin + PATIENCE.stuck)).contains("did not say (DC3)"), "the buffer was full");
    }

    #[test]
    fn a_reader_that_never_starts_fails_in_simulated_time() {
        let mut sender = fanuc(false);
        assert!(matches!(sender.poll(Duration::ZERO), SendStep::Wait(time) if time == PATIENCE.start));
        assert!(failure(sender.poll(PATIENCE.start)).contains("(DC1) within 60 s"));
    }

    #[test]
    fn little_is_on_its_way_when_a_reader_says_stop() {
        let mut sender = fanuc(false);
        sender.received(&[DC1], Duration::ZERO);
        let SendStep::Write(chunk) = sender.poll(Duration::ZERO) else { panic!("nothing to write") };
        assert!(chunk.len() <= 4, "{} characters ahead at 436 a second", chunk.len());
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
