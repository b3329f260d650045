//! The host's side: sends a plan over a link, starts it, asks for positions, stops it.

use super::frame::{Frame, LONGEST};
use super::why::Why;
use crate::spinning::control::Plan;
use crate::transfer::link::{LARGEST_WRITE, Link};
use std::fmt;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Time for an answer.
const ANSWER: Duration = Duration::from_millis(500);
/// Time for one look at the line.
const LOOK: Duration = Duration::from_millis(20);
/// How often a damaged line is sent.
const TRIES: u32 = 4;

/// Why the rig cannot be reached or does not do as it is told.
#[derive(Debug)]
pub enum HostError {
    /// The line is gone.
    Line(io::Error),
    /// No answer came in time, or only damaged ones.
    Silent,
    /// The device refused a line, with its code.
    Refused(String),
    /// The device is another one, or of another version.
    Stranger(String),
    /// Emergency stop was asked for: nothing else is waited for.
    Interrupted,
}

impl fmt::Display for HostError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(error) => write!(f, "The line to the rig is gone: {error}."),
            Self::Silent => {
                write!(
                    f,
                    "The rig gave no answer in {} tries of {} ms; check cable and power.",
                    TRIES,
                    ANSWER.as_millis()
                )
            }
            Self::Refused(code) => write!(f, "The rig refused a line with the code \"{code}\"."),
            Self::Interrupted => write!(f, "Emergency stop by the operator."),
            Self::Stranger(name) => write!(f, "The device calls itself \"{name}\"; a turnwright-rig 1 is needed."),
        }
    }
}

impl std::error::Error for HostError {}

/// What the device tells of its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Position {
    /// Time since the run began, ms.
    pub ms: u64,
    /// Carriage, pulses.
    pub pulses: u32,
    /// Reading of the roller, steps.
    pub steps: u16,
    /// State letter of the protocol.
    pub state: char,
}

impl Position {
    /// True if the run is over.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        matches!(self.state, 'C' | 'D' | 'N')
    }
}

/// A rig at the other end of a link.
#[derive(Debug)]
pub struct Host<L> {
    link: L,
    heard: Vec<u8>,
    /// Set from elsewhere: whatever is under way is given up for an emergency stop.
    hurry: Arc<AtomicBool>,
}

impl<L: Link> Host<L> {
    /// Greets the device.
    ///
    /// # Errors
    /// It gives no answer, or is another one.
    pub fn connect(link: L) -> Result<Self, HostError> {
        Self::connect_until(link, Arc::default())
    }

    /// As [`Self::connect`]; when `hurry` is set, every call but [`Self::emergency_stop`] returns
    /// [`HostError::Interrupted`] at once.
    ///
    /// # Errors
    /// As [`Self::connect`], and where it was interrupted.
    pub fn connect_until(link: L, hurry: Arc<AtomicBool>) -> Result<Self, HostError> {
        let mut host = Self { link, heard: Vec::new(), hurry };
        let answer = host.ask(&Frame::of('H', &[]), |_| true)?;
        if answer.letter == 'H' && answer.words == ["turnwright-rig", "1"] {
            Ok(host)
        } else {
            Err(HostError::Stranger(answer.words.join(" ")))
        }
    }

    /// Sends a plan's table, point by point, each acknowledged.
    ///
    /// # Errors
    /// The line fails or the device refuses.
    pub fn load(&mut self, plan: &Plan) -> Result<(), HostError> {
        let count = i64::try_from(plan.targets.len()).unwrap_or(i64::MAX);
        let um = |mm: f64| {
            #[allow(clippy::cast_possible_truncation, reason = "micrometres of a lathe")]
            {
                (mm * 1000.0).round() as i64
            }
        };
        let (limit, speed) = plan.watch.map_or((0, 0), |w| (um(w.limit_mm), um(w.carriage_mm_per_s)));
        let head = [count, plan.roller_position.into(), plan.advance.into(), plan.retract.into(), limit, speed];
        self.told(&Frame::of('B', &head))?;
        for (index, target) in (0_i64..).zip(&plan.targets) {
            self.told(&Frame::of('S', &[index, target.pulses.into(), target.steps.into()]))?;
        }
        Ok(())
    }

    /// Starts the run.
    ///
    /// # Errors
    /// The line fails or the device refuses.
    pub fn go(&mut self) -> Result<(), HostError> {
        self.told(&Frame::of('G', &[]))
    }

    /// Draws the roller back to its datum, without a run.
    ///
    /// # Errors
    /// The line fails or the device refuses.
    pub fn seek_datum(&mut self) -> Result<(), HostError> {
        self.told(&Frame::of('Z', &[]))
    }

    /// Stops at once, and takes what interrupted the calls before as heard; asked for again meanwhile, it is sent again.
    ///
    /// # Errors
    /// The line fails; the device stops by itself when it hears nothing.
    pub fn emergency_stop(&mut self) -> Result<(), HostError> {
        loop {
            self.hurry.store(false, Ordering::SeqCst);
            match self.told(&Frame::of('X', &[])) {
                Err(HostError::Interrupted) => {}
                answered => return answered,
            }
        }
    }

    /// Asks why the last run stopped.
    ///
    /// # Errors
    /// The line fails or the answer is none.
    pub fn why(&mut self) -> Result<Why, HostError> {
        let answer = self.ask(&Frame::of('Y', &[]), |letter| letter == 'Y')?;
        Why::read(&answer).ok_or_else(|| HostError::Refused(answer.words.join(" ")))
    }

    /// Asks for the position.
    ///
    /// # Errors
    /// The line fails or the answer is none.
    pub fn position(&mut self) -> Result<Position, HostError> {
        let answer = self.ask(&Frame::of('Q', &[]), |letter| letter == 'P')?;
        let wrong = || HostError::Refused(format!("{} {}", answer.letter, answer.words.join(" ")));
        let [ms, pulses, steps, state] = answer.words.as_slice() else { return Err(wrong()) };
        let parsed = ms.parse().ok().zip(pulses.parse().ok()).zip(steps.parse().ok()).zip(state.chars().next());
        match parsed {
            Some((((ms, pulses), steps), state)) if answer.letter == 'P' => Ok(Position { ms, pulses, steps, state }),
            _ => Err(wrong()),
        }
    }

    fn told(&mut self, frame: &Frame) -> Result<(), HostError> {
        let answer = self.ask(frame, |letter| letter == 'K')?;
        if answer.letter == 'K' { Ok(()) } else { Err(HostError::Refused(answer.words.join(" "))) }
    }

    /// Sends a line and waits for its answer; a damaged line or answer is sent again. Answers to what was asked before, and
    /// not waited for, are passed over.
    fn ask(&mut self, frame: &Frame, is_answer: impl Fn(char) -> bool) -> Result<Frame, HostError> {
        let text = frame.to_string();
        for _ in 0..TRIES {
            self.write(text.as_bytes())?;
            while let Some(answer) = self.answer()? {
                match answer.letter {
                    'E' if answer.words == ["sum"] => break,
                    'E' => return Ok(answer),
                    letter if is_answer(letter) => return Ok(answer),
                    _ => {}
                }
            }
        }
        Err(HostError::Silent)
    }

    fn write(&mut self, mut bytes: &[u8]) -> Result<(), HostError> {
        let until = Instant::now() + ANSWER;
        while !bytes.is_empty() {
            let (now, _) = bytes.split_at(bytes.len().min(LARGEST_WRITE));
            let taken = self.link.write_some(now, LOOK).map_err(HostError::Line)?;
            bytes = bytes.get(taken..).unwrap_or_default();
            if Instant::now() > until {
                return Err(HostError::Silent);
            }
        }
        Ok(())
    }

    /// The next whole line; `None` if none came in time or it was damaged.
    fn answer(&mut self) -> Result<Option<Frame>, HostError> {
        let until = Instant::now() + ANSWER;
        let mut buffer = [0; 64];
        loop {
            if let Some(end) = self.heard.iter().position(|b| *b == b'\n') {
                let line: Vec<u8> = self.heard.drain(..=end).collect();
                let line = String::from_utf8_lossy(&line).into_owned();
                return Ok(Frame::read(line.trim_end_matches('\n')).ok());
            }
            if self.hurry.load(Ordering::SeqCst) {
                return Err(HostError::Interrupted);
            }
            let count = self.link.read_some(&mut buffer, LOOK).map_err(HostError::Line)?;
            self.heard.extend(buffer.iter().take(count));
            if self.heard.len() > 2 * LONGEST || Instant::now() > until {
                self.heard.clear();
                return Ok(None);
            }
        }
    }
}

#[cfg(test)]
#[path = "tests.rs"]
pub(super) mod tests;
