//! The serial line: checking its settings, and its speed as time per character.

use super::link::LARGEST_WRITE;
use crate::machine::{Parity, SerialProfile};
use std::time::Duration;

/// How far ahead of the wire bytes are handed to the port. Long enough to keep the wire busy between two looks at the
/// port, short enough that little is left to run after an abort or a DC3.
const AHEAD: Duration = Duration::from_millis(20);

/// The same where the control stops the sender with DC3: so much may still arrive after it, and a control has room for
/// few characters only (Fanuc: ten). At 4800 baud this is four.
const AHEAD_OF_DC3: Duration = Duration::from_millis(8);

/// Checks that a profile can be used.
///
/// # Errors
/// A sentence with the value and what is allowed.
pub fn check(profile: &SerialProfile) -> Result<(), String> {
    match profile.faults().into_iter().next() {
        Some((key, message)) => Err(format!("Line setting {key}: {message}")),
        None => Ok(()),
    }
}

/// Bits of one character on the wire: start, data, parity and stop bits.
#[must_use]
pub fn bits_per_character(profile: &SerialProfile) -> u32 {
    let parity = u32::from(profile.parity != Parity::None);
    1 + u32::from(profile.data_bits) + parity + u32::from(profile.stop_bits)
}

/// Time of one character on the wire.
#[must_use]
pub fn character_time(profile: &SerialProfile) -> Duration {
    Duration::from_secs(1) * bits_per_character(profile) / profile.baud.max(1)
}

/// Hands out bytes at the speed of the wire. Times count from any fixed moment.
#[derive(Debug, Clone)]
pub struct Pace {
    /// Time per character; zero when unpaced.
    character: Duration,
    /// How far ahead of the wire bytes are handed out.
    ahead: Duration,
    /// When the wire has carried all that was handed out.
    free_at: Duration,
}

impl Pace {
    /// A pace at the profile's speed, or none at all.
    #[must_use]
    pub fn new(profile: &SerialProfile, unpaced: bool) -> Self {
        let character = if unpaced { Duration::ZERO } else { character_time(profile) };
        let ahead = if profile.heeds_dc3() { AHEAD_OF_DC3 } else { AHEAD };
        Self { character, ahead, free_at: Duration::ZERO }
    }

    /// How many bytes may be handed out now, at most [`LARGEST_WRITE`].
    #[must_use]
    pub fn allowance(&self, now: Duration) -> usize {
        if self.character.is_zero() {
            return LARGEST_WRITE;
        }
        let backlog = self.free_at.saturating_sub(now);
        let fit = self.ahead.saturating_sub(backlog).as_nanos() / self.character.as_nanos();
        let fit = usize::try_from(fit).unwrap_or(LARGEST_WRITE).min(LARGEST_WRITE);
        if backlog.is_zero() { fit.max(1) } else { fit }
    }

    /// Notes that `count` bytes were handed out.
    pub fn took(&mut self, count: usize, now: Duration) {
        let count = u32::try_from(count).unwrap_or(u32::MAX);
        self.free_at = self.free_at.max(now) + self.character * count;
    }

    /// How long until [`Pace::allowance`] is at least one.
    #[must_use]
    pub fn wait(&self, now: Duration) -> Duration {
        let backlog = self.free_at.saturating_sub(now);
        let may_stay = self.ahead.saturating_sub(self.character);
        backlog.saturating_sub(may_stay)
    }

    /// How long until the wire has carried all that was handed out.
    #[must_use]
    pub fn backlog(&self, now: Duration) -> Duration {
        self.free_at.saturating_sub(now)
    }

    /// Time that `count` bytes take, none if unpaced.
    #[must_use]
    pub fn time_for(&self, count: usize) -> Option<Duration> {
        (!self.character.is_zero()).then(|| self.character * u32::try_from(count).unwrap_or(u32::MAX))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::machine::{EndOfBlock, FlowControl, PageMarks, Protocol, ReaderPunch};

    pub(in crate::transfer) fn orac_profile() -> SerialProfile {
        SerialProfile {
            baud: 2400,
            data_bits: 7,
            parity: Parity::Odd,
            stop_bits: 1,
            flow: FlowControl::None,
            protocol: Protocol::OracPages(PageMarks { page_start: 2, end: 4 }),
        }
    }

    pub(in crate::transfer) fn fanuc_profile() -> SerialProfile {
        let habits = ReaderPunch { end_of_block: EndOfBlock::Lf, tv_check: false, confirms_end: true };
        SerialProfile {
            baud: 4800,
            data_bits: 7,
            parity: Parity::Even,
            stop_bits: 2,
            flow: FlowControl::Software,
            protocol: Protocol::FanucReaderPunch(habits),
        }
    }

    #[test]
    fn a_character_has_start_data_parity_and_stop_bits() {
        assert_eq!(bits_per_character(&fanuc_profile()), 11);
        let profile = orac_profile();
        assert_eq!(bits_per_character(&profile), 10);
        assert_eq!(character_time(&profile).as_micros(), 4166);
        let plain = SerialProfile { parity: Parity::None, stop_bits: 2, data_bits: 8, ..profile };
        assert_eq!(bits_per_character(&plain), 11);
    }

    #[test]
    fn impossible_settings_are_told_with_their_key() {
        assert_eq!(check(&orac_profile()), Ok(()));
        let wrong = SerialProfile { baud: 0, ..orac_profile() };
        assert!(check(&wrong).unwrap_err().contains("baud: The speed is 0 bits/s"));
    }

    #[test]
    fn the_pace_is_the_speed_of_the_wire() {
        let mut pace = Pace::new(&orac_profile(), false);
        let (mut now, mut sent) = (Duration::ZERO, 0);
        while now < Duration::from_secs(10) {
            let count = pace.allowance(now);
            pace.took(count, now);
            sent += count;
            now += pace.wait(now).max(Duration::from_micros(100));
        }
        assert!((2395..=2410).contains(&sent), "{sent} characters in 10 s at 240 a second");
    }

    #[test]
    fn a_slow_line_still_moves() {
        let mut pace = Pace::new(&SerialProfile { baud: 50, ..orac_profile() }, false);
        assert_eq!(pace.allowance(Duration::ZERO), 1);
        pace.took(1, Duration::ZERO);
        assert_eq!(pace.allowance(Duration::from_millis(199)), 0);
        assert_eq!(pace.wait(Duration::ZERO), Duration::from_millis(200));
        assert_eq!(pace.allowance(Duration::from_millis(200)), 1);
    }
}
