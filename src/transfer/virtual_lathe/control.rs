//! The control of the virtual lathe, without link and clock.

use super::faults::FaultLane;
use super::{FaultSpec, LatheEvent, VirtualLathe};
use crate::machine::SerialProfile;
use crate::transfer::line::{DC1, Pace};
use crate::transfer::pages;
use std::collections::VecDeque;
use std::time::Duration;

/// A program that stops arriving for this long has broken off.
const BROKEN_OFF_AFTER: Duration = Duration::from_secs(2);

/// Most bytes of a program that are kept.
const LARGEST: usize = 256 * 1024;

/// With the fault `delay`, so many bytes pass between two delays.
const BYTES_PER_DELAY: usize = 16;

/// One connection to a virtual lathe.
pub(super) struct Control {
    lathe: VirtualLathe,
    profile: SerialProfile,
    faults: FaultSpec,
    lane_in: FaultLane,
    lane_out: FaultLane,
    pace_in: Pace,
    pace_out: Pace,
    /// Nothing is read or sent before this time (fault `delay`).
    paused_until: Duration,
    /// Bytes taken from the line on this connection.
    taken: usize,
    /// The program being received.
    incoming: Option<Vec<u8>>,
    last_byte: Duration,
    asked: bool,
    answer: VecDeque<u8>,
}

impl Control {
    pub(super) fn new(lathe: VirtualLathe, profile: &SerialProfile, unpaced: bool) -> Self {
        let faults = lathe.lock().faults.clone();
        let pace = Pace::new(profile, unpaced);
        Self {
            profile: profile.clone(),
            lane_in: FaultLane::new(&faults.incoming, faults.seed),
            lane_out: FaultLane::new(&faults.answer, faults.seed.wrapping_add(1)),
            pace_in: pace.clone(),
            pace_out: pace,
            paused_until: Duration::ZERO,
            taken: 0,
            incoming: None,
            last_byte: Duration::ZERO,
            asked: false,
            answer: VecDeque::new(),
            faults,
            lathe,
        }
    }

    /// How many bytes may be read from the line now.
    pub(super) fn room(&self, now: Duration) -> usize {
        if now < self.paused_until {
            return 0;
        }
        let until = [self.faults.stall_after, self.faults.unplug_after].into_iter().flatten().min();
        let room = until.map_or(usize::MAX, |until| until.saturating_sub(self.taken));
        let room = room.min(self.pace_in.allowance(now));
        if self.faults.delay.is_some() { room.min(BYTES_PER_DELAY) } else { room }
    }

    /// Takes bytes from the line.
    pub(super) fn received(&mut self, bytes: &[u8], now: Duration) {
        self.taken += bytes.len();
        self.pace_in.took(bytes.len(), now);
        self.pause(bytes.len(), now);
        for &byte in bytes {
            let (byte, copies) = self.lane_in.pass(byte);
            (0..copies).for_each(|_| self.take(byte, now));
        }
    }

    fn pause(&mut self, bytes: usize, now: Duration) {
        if let (Some(delay), true) = (self.faults.delay, bytes > 0) {
            self.paused_until = now + delay;
        }
    }

    fn take(&mut self, byte: u8, now: Duration) {
        self.last_byte = now;
        match &mut self.incoming {
            None if byte == self.profile.page_start => {
                self.lathe.lock().program = None;
                self.answer.clear();
                self.incoming = Some(vec![byte]);
            }
            None => self.asked |= byte == DC1,
            Some(_) if byte == self.profile.end => self.store(),
            Some(_) if byte == DC1 => {
                self.break_off();
                self.asked = true;
            }
            Some(program) if program.len() < LARGEST => program.push(byte),
            Some(_) => self.break_off(),
        }
    }

    fn store(&mut self) {
        let program = self.incoming.take().unwrap_or_default();
        let text = String::from_utf8_lossy(&program);
        let page_start = self.profile.page_start;
        let event = LatheEvent::Stored {
            bytes: program.len(),
            pages: pages::split(&text, page_start).pages.len(),
            problems: pages::problems(&text, page_start),
        };
        self.lathe.lock().program = Some(program);
        self.lathe.say(event);
    }

    fn break_off(&mut self) {
        if let Some(program) = self.incoming.take() {
            self.lathe.say(LatheEvent::BrokenOff { bytes: program.len() });
        }
    }

    /// Looks at the clock and the send key; true if a new answer begins.
    pub(super) fn begins_answer(&mut self, now: Duration) -> bool {
        if self.incoming.is_some() && now.saturating_sub(self.last_byte) >= BROKEN_OFF_AFTER {
            self.break_off();
        }
        if self.incoming.is_none() {
            self.asked |= std::mem::take(&mut self.lathe.lock().send_pressed);
        }
        let asked = std::mem::take(&mut self.asked);
        if asked {
            self.begin_answer();
        }
        asked
    }

    fn begin_answer(&mut self) {
        self.answer.clear();
        if self.faults.silent {
            self.lathe.say(LatheEvent::KeptSilent);
            return;
        }
        let mut program = self.lathe.lock().program.clone().unwrap_or_default();
        program.push(self.profile.end);
        for byte in program {
            let (byte, copies) = self.lane_out.pass(byte);
            self.answer.extend(std::iter::repeat_n(byte, copies));
        }
        self.answer.truncate(self.faults.truncate_after.unwrap_or(usize::MAX));
        self.lathe.say(LatheEvent::Answering { bytes: self.answer.len() });
    }

    /// The bytes to send now.
    pub(super) fn offer(&self, now: Duration) -> Vec<u8> {
        if now < self.paused_until {
            return Vec::new();
        }
        let most = if self.faults.delay.is_some() { BYTES_PER_DELAY } else { usize::MAX };
        self.answer.iter().take(self.pace_out.allowance(now).min(most)).copied().collect()
    }

    /// Notes that `count` offered bytes went out.
    pub(super) fn sent(&mut self, count: usize, now: Duration) {
        self.answer.drain(..count.min(self.answer.len()));
        self.pace_out.took(count, now);
        self.pause(count, now);
    }

    /// True while there is something to send.
    pub(super) fn has_answer(&self) -> bool {
        !self.answer.is_empty()
    }

    /// True once the fault `unplug` struck.
    pub(super) fn is_unplugged(&self) -> bool {
        self.faults.unplug_after.is_some_and(|after| self.taken >= after)
    }

    /// The connection is over.
    pub(super) fn closed(&mut self) {
        self.break_off();
        if self.is_unplugged() {
            self.lathe.say(LatheEvent::Unplugged);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transfer::line::tests::orac_profile;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn noise_never_breaks_it(bytes in prop::collection::vec(prop::sample::select(vec![2u8, 4, 17, 0, 65, 255]), 0..400)) {
            let mut control = control("drop=5%,duplicate=5%,answer-duplicate=5%");
            let mut answered = 0;
            for chunk in bytes.chunks(7) {
                answered += answer_to(&mut control, chunk).len();
            }
            prop_assert!(answered <= bytes.len() * bytes.len());
        }
    }

    const TEXT: &[u8] = b"\x02PAGE 01 MM-UNITS\r\n\x02PAGE 02 END-PROGRAM..M02\r\n\x04";

    fn control(faults: &str) -> Control {
        Control::new(VirtualLathe::new(faults.parse().unwrap()), &orac_profile(), true)
    }

    /// Everything it sends after it received `bytes`.
    fn answer_to(control: &mut Control, bytes: &[u8]) -> Vec<u8> {
        let now = Duration::ZERO;
        control.received(bytes, now);
        control.begins_answer(now);
        let mut all = Vec::new();
        while control.has_answer() {
            let chunk = control.offer(now);
            control.sent(chunk.len(), now);
            all.extend(chunk);
        }
        all
    }

    #[test]
    fn keeps_a_program_and_sends_it_back_when_asked() {
        let mut control = control("");
        assert_eq!(answer_to(&mut control, TEXT), b"");
        assert_eq!(answer_to(&mut control, &[DC1]), TEXT);
        let events = control.lathe.take_events();
        assert_eq!(events[0], LatheEvent::Stored { bytes: TEXT.len() - 1, pages: 2, problems: Vec::new() });
        assert_eq!(answer_to(&mut control, b"\x02PAGE 01 END\x04\x11"), b"\x02PAGE 01 END\x04");
        control.lathe.press_send();
        assert_eq!(answer_to(&mut control, b""), b"\x02PAGE 01 END\x04");
    }

    #[test]
    fn a_program_that_breaks_off_leaves_nothing() {
        let mut control = control("");
        answer_to(&mut control, TEXT);
        control.received(&TEXT[..20], Duration::ZERO);
        assert!(!control.begins_answer(Duration::from_secs(3)));
        assert_eq!(control.lathe.program(), None);
        assert_eq!(answer_to(&mut control, &[DC1]), [4]);
        control.received(&TEXT[..20], Duration::ZERO);
        assert_eq!(answer_to(&mut control, &[DC1]), [4]);
    }

    #[test]
    fn a_malformed_program_is_kept_and_named() {
        let mut control = control("");
        answer_to(&mut control, b"\x02PAGE 02 END\x04");
        let events = control.lathe.take_events();
        assert!(matches!(&events[0], LatheEvent::Stored { problems, .. } if problems.len() == 1), "{events:?}");
        assert!(control.lathe.program().is_some());
    }

    #[test]
    fn paced_it_takes_no_more_than_the_line_carries() {
        let control = Control::new(VirtualLathe::default(), &orac_profile(), false);
        assert!(control.room(Duration::ZERO) <= 5);
    }

    #[test]
    fn faults_strike_where_they_are_set() {
        assert_eq!(answer_to(&mut control("drop@2"), b"\x02AB\x04\x11"), b"\x02B\x04");
        assert_eq!(answer_to(&mut control("duplicate@3"), b"\x02AB\x04\x11"), b"\x02ABB\x04");
        assert_eq!(answer_to(&mut control("answer-change@2"), b"\x02AB\x04\x11"), b"\x02@B\x04");
        assert_eq!(answer_to(&mut control("truncate@2"), b"\x02AB\x04\x11"), b"\x02A");
        assert_eq!(answer_to(&mut control("silent"), b"\x02AB\x04\x11"), b"");
        let mut control = control("unplug@5");
        assert_eq!(control.room(Duration::ZERO), 5);
        control.received(b"\x02PAGE", Duration::ZERO);
        assert!(control.is_unplugged());
    }
}
