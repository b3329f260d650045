//! The side of a virtual control that is turned to the line, without link and clock: pacing and faults.

use super::fanuc::Fanuc;
use super::faults::FaultLane;
use super::orac::Orac;
use super::{FaultSpec, LatheEvent, VirtualLathe};
use crate::machine::{Protocol, SerialProfile};
use crate::transfer::line::Pace;
use std::collections::VecDeque;
use std::time::Duration;

/// With the fault `delay`, so many bytes pass between two delays.
const BYTES_PER_DELAY: usize = 16;

/// The side that knows a protocol.
pub(super) trait Brain: Send {
    /// A byte came.
    fn take(&mut self, byte: u8, now: Duration);

    /// Looks at the clock and the keys; what it sends now.
    fn turn(&mut self, now: Duration) -> Option<Reply>;

    /// How many bytes it takes now.
    fn room(&self) -> usize {
        usize::MAX
    }

    /// Its operator presses RESET, or its cable is pulled: a program that is coming in is lost.
    fn reset(&mut self);
}

/// What a control sends.
pub(super) enum Reply {
    /// Characters that start and stop its sender.
    Codes(Vec<u8>),
    /// A program with its marks; it takes the place of one that is still going out.
    Program(Vec<u8>),
}

/// One connection to a virtual lathe.
pub(super) struct Control {
    lathe: VirtualLathe,
    brain: Box<dyn Brain>,
    faults: FaultSpec,
    lane_in: FaultLane,
    lane_out: FaultLane,
    pace_in: Pace,
    pace_out: Pace,
    /// Nothing is read or sent before this time (fault `delay`).
    paused_until: Duration,
    /// Bytes taken from the line on this connection.
    taken: usize,
    answer: VecDeque<u8>,
}

impl Control {
    pub(super) fn new(lathe: VirtualLathe, profile: &SerialProfile, unpaced: bool) -> Self {
        let faults = lathe.lock().faults.clone();
        let pace = Pace::new(profile, unpaced);
        let brain: Box<dyn Brain> = match profile.protocol {
            Protocol::OracPages(marks) => Box::new(Orac::new(lathe.clone(), marks)),
            Protocol::FanucReaderPunch(habits) => {
                let late = faults.late_dc3.unwrap_or_default();
                Box::new(Fanuc::new(lathe.clone(), habits, late, unpaced))
            }
        };
        Self {
            brain,
            lane_in: FaultLane::new(&faults.incoming, faults.seed),
            lane_out: FaultLane::new(&faults.answer, faults.seed.wrapping_add(1)),
            pace_in: pace.clone(),
            pace_out: pace,
            paused_until: Duration::ZERO,
            taken: 0,
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
        let room = room.min(self.pace_in.allowance(now)).min(self.brain.room());
        if self.faults.delay.is_some() { room.min(BYTES_PER_DELAY) } else { room }
    }

    /// Takes bytes from the line.
    pub(super) fn received(&mut self, bytes: &[u8], now: Duration) {
        self.pace_in.took(bytes.len(), now);
        self.pause(bytes.len(), now);
        for &byte in bytes {
            self.taken += 1;
            let (byte, copies) = self.lane_in.pass(byte);
            (0..copies).for_each(|_| self.brain.take(byte, now));
            if self.faults.reset_after == Some(self.taken) {
                self.lathe.say(LatheEvent::Reset);
                self.brain.reset();
            }
        }
    }

    fn pause(&mut self, bytes: usize, now: Duration) {
        if let (Some(delay), true) = (self.faults.delay, bytes > 0) {
            self.paused_until = now + delay;
        }
    }

    /// Lets the control look at the clock and its keys; true if a new answer begins.
    pub(super) fn begins_answer(&mut self, now: Duration) -> bool {
        match self.brain.turn(now) {
            None => false,
            Some(Reply::Codes(codes)) => {
                if !self.faults.silent {
                    self.answer.extend(codes);
                }
                false
            }
            Some(Reply::Program(program)) => {
                self.begin_answer(&program);
                true
            }
        }
    }

    fn begin_answer(&mut self, program: &[u8]) {
        self.answer.clear();
        if self.faults.silent {
            self.lathe.say(LatheEvent::KeptSilent);
            return;
        }
        for &byte in program {
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
        self.brain.reset();
        if self.is_unplugged() {
            self.lathe.say(LatheEvent::Unplugged);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{DC1, DC2, ReaderPunch};
    use crate::transfer::line::tests::{fanuc_profile, orac_profile};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn noise_never_breaks_it(is_fanuc in any::<bool>(), bytes in prop::collection::vec(prop::sample::select(vec![2u8, 4, 17, 18, 10, 37, 0, 65, 255]), 0..400)) {
            let faults = "drop=5%,duplicate=5%,answer-duplicate=5%";
            let mut control = if is_fanuc { Control::new(VirtualLathe::new(faults.parse().unwrap()), &fanuc_profile(), true) } else { control(faults) };
            let mut answered = 0;
            for chunk in bytes.chunks(7) {
                answered += answer_to(&mut control, chunk).len();
            }
            prop_assert!(answered <= (bytes.len() + 9) * (bytes.len() + 9));
        }
    }

    const TEXT: &[u8] = b"\x02PAGE 01 MM-UNITS\r\n\x02PAGE 02 END-PROGRAM..M02\r\n\x04";

    fn control(faults: &str) -> Control {
        Control::new(VirtualLathe::new(faults.parse().unwrap()), &orac_profile(), true)
    }

    /// Everything it sends after it received `bytes` at the beginning.
    fn answer_to(control: &mut Control, bytes: &[u8]) -> Vec<u8> {
        answer_at(control, Duration::ZERO, bytes)
    }

    fn answer_at(control: &mut Control, now: Duration, bytes: &[u8]) -> Vec<u8> {
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
        assert_eq!(events[0], LatheEvent::Stored { bytes: TEXT.len() - 1, blocks: 2, problems: Vec::new() });
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

    const TAPE: &[u8] = b"%\nO0201\nN10G21\nM30\n%";

    /// Strict about overruns, on a line so fast that no test has to wait.
    fn fanuc(faults: &str, tv_check: bool) -> Control {
        let mut profile = SerialProfile { baud: 4_000_000, ..fanuc_profile() };
        let Protocol::FanucReaderPunch(habits) = profile.protocol else { panic!("no Fanuc") };
        profile.protocol = Protocol::FanucReaderPunch(ReaderPunch { tv_check, ..habits });
        Control::new(VirtualLathe::new(faults.parse().unwrap()), &profile, false)
    }

    /// Presses READ, sends, and returns the start and stop characters that came.
    fn read_by(control: &mut Control, tape: &[u8]) -> Vec<u8> {
        let mut codes = answer_to(control, &[DC2]);
        codes.extend(answer_to(control, tape));
        codes
    }

    fn alarms(control: &Control) -> Vec<&'static str> {
        let alarm = |event| if let LatheEvent::Alarm(text) = event { Some(text) } else { None };
        control.lathe.take_events().into_iter().filter_map(alarm).collect()
    }

    #[test]
    fn a_fanuc_reads_a_tape_and_punches_it() {
        let mut control = fanuc("", false);
        assert_eq!(answer_to(&mut control, &[DC1]), b"\x12%\n%\x14");
        assert_eq!(read_by(&mut control, TAPE), b"\x11\x13");
        let expected = LatheEvent::Stored { bytes: TAPE.len() - 3, blocks: 3, problems: Vec::new() };
        assert!(control.lathe.take_events().contains(&expected));
        assert_eq!(answer_to(&mut control, &[DC1]), [b"\x12", TAPE, b"\x14"].concat());
        assert_eq!(read_by(&mut control, b"\0\0noise\nO1\n%"), b"\x11\x13");
        assert_eq!(control.lathe.program().unwrap(), "O1\n");
    }

    #[test]
    fn a_full_buffer_stops_the_sender_and_overruns_after_sixteen_characters() {
        let mut control = fanuc("", false);
        assert_eq!(read_by(&mut control, &[b'X'; 99]), b"\x11");
        assert_eq!(answer_to(&mut control, b"X"), b"\x13");
        assert_eq!(answer_to(&mut control, &[b'X'; 16]), b"");
        let later = Duration::from_secs(1);
        assert_eq!(answer_at(&mut control, later, b""), b"\x11");
        assert_eq!(answer_at(&mut control, later, &[b'X'; 116]), b"\x13");
        assert_eq!(alarms(&control), Vec::<&str>::new());
        assert_eq!(answer_at(&mut control, later, b"X"), b"\x13");
        assert!(alarms(&control)[0].starts_with("087"));
        assert_eq!(answer_at(&mut control, later, &[DC1]), b"", "an alarm is no answer");
        assert_eq!(answer_at(&mut control, later, &[DC2]), b"\x11", "the next READ clears it");
    }

    #[test]
    fn a_fanuc_misbehaves_where_it_is_told_to() {
        for (faults, tv_check, tape, alarm) in [
            ("late-dc3@17", false, [b"%\n", &[b'X'; 115][..]].concat(), "087"),
            ("parity@6", false, TAPE.to_vec(), "085"),
            ("drop@8", true, b"%\nO1 \nG21\n%".to_vec(), "002"),
            ("", false, b"%\nO\xc7".to_vec(), "085"),
        ] {
            let mut control = fanuc(faults, tv_check);
            assert_eq!(read_by(&mut control, &tape), b"\x11\x13", "{faults}");
            let alarms = alarms(&control);
            assert!(alarms.len() == 1 && alarms[0].starts_with(alarm), "{faults}: {alarms:?}");
            assert_eq!(control.lathe.program(), None);
        }
        let mut control = fanuc("reset@6", false);
        assert_eq!(read_by(&mut control, TAPE), b"\x11\x13");
        assert_eq!(answer_to(&mut control, &[DC1]), b"\x12%\n%\x14");
        assert_eq!(read_by(&mut fanuc("silent", false), TAPE), b"");
        assert_eq!(read_by(&mut fanuc("", true), b"%\nO1 \nG21\n%"), b"\x11\x13");
    }
}
