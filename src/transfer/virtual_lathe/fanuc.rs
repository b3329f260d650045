//! What a Fanuc does with bytes: it reads a tape, stopping its sender with DC3 whenever its buffer is full, and punches it.
//!
//! Its operator presses READ for a lone DC2 and PUNCH for a lone DC1; a real control has keys for that.

use super::control::{Brain, Reply};
use super::{LatheEvent, VirtualLathe};
use crate::machine::{DC1, DC2, DC3, DC4, Protocol, ReaderPunch};
use crate::transfer::fanuc::{TAPE_MARK, problems};
use std::time::Duration;

/// Characters in the buffer at which DC3 is sent.
const STOP_AT: usize = 100;

/// Characters for which there is room after DC3.
const ROOM: usize = 16;

/// How long the control works off a full buffer at the speed of the line, and unpaced.
const WORK: Duration = Duration::from_millis(100);
const UNPACED_WORK: Duration = Duration::from_millis(2);

/// Most bytes of a program that are kept.
const LARGEST: usize = 256 * 1024;

pub(super) struct Fanuc {
    lathe: VirtualLathe,
    habits: ReaderPunch,
    unpaced: bool,
    /// So many characters too late comes DC3 (fault `late-dc3`).
    late: usize,
    reader: Option<Reader>,
    /// DC1 and DC3 to be sent.
    codes: Vec<u8>,
    asked: bool,
    alarm: bool,
}

/// A tape being read.
#[derive(Default)]
struct Reader {
    tape: Vec<u8>,
    /// The first end of block has come; what is before it is skipped.
    after_label: bool,
    /// Characters of the present block.
    block: usize,
    buffered: usize,
    /// DC3 was sent; DC1 follows then.
    held_until: Option<Duration>,
}

impl Fanuc {
    pub(super) const fn new(lathe: VirtualLathe, habits: ReaderPunch, late: usize, unpaced: bool) -> Self {
        Self { lathe, habits, unpaced, late, reader: None, codes: Vec::new(), asked: false, alarm: false }
    }

    const fn protocol(&self) -> Protocol {
        Protocol::FanucReaderPunch(self.habits)
    }

    fn start_reading(&mut self) {
        self.break_off();
        self.lathe.forget();
        self.alarm = false;
        self.reader = Some(Reader::default());
        self.codes = vec![DC1];
    }

    fn break_off(&mut self) {
        if let Some(reader) = self.reader.take() {
            self.lathe.say(LatheEvent::BrokenOff { bytes: reader.tape.len() });
        }
    }

    /// Stops and keeps nothing; the sender is told to wait, and never to go on.
    fn alarm(&mut self, text: &'static str) {
        self.reader = None;
        self.alarm = true;
        self.codes.push(DC3);
        self.lathe.say(LatheEvent::Alarm(text));
    }

    fn read(&mut self, byte: u8, now: Duration) {
        let Some(reader) = &mut self.reader else { return };
        reader.buffered += 1;
        if reader.buffered > STOP_AT + ROOM {
            return self.alarm("087 BUFFER OVERFLOW: characters were lost");
        }
        if reader.buffered == STOP_AT + self.late {
            reader.held_until = Some(now + if self.unpaced { UNPACED_WORK } else { WORK });
            self.codes.push(DC3);
        }
        if byte > 127 || (byte == 0 && reader.after_label) {
            return self.alarm("085 COMMUNICATION ERROR: parity");
        }
        if !reader.after_label {
            reader.after_label = byte == b'\n';
        } else if byte == TAPE_MARK as u8 {
            self.store();
        } else if let Err(text) = reader.keep(byte, self.habits.tv_check) {
            self.alarm(text);
        }
    }

    fn store(&mut self) {
        let tape = self.reader.take().unwrap_or_default().tape;
        let whole = format!("{}{}", self.label(), String::from_utf8_lossy(&tape));
        let blocks = whole.matches('\n').count() - 1;
        let problems = problems(&whole, self.habits);
        let event = LatheEvent::Stored { bytes: tape.len(), blocks, problems };
        self.lathe.keep(self.protocol(), tape);
        self.lathe.say(event);
        // A real control says in this way that it has read the end.
        self.codes.push(DC3);
    }

    fn label(&self) -> String {
        format!("{TAPE_MARK}{}", self.habits.end_of_block.text())
    }

    fn punch(&self) -> Vec<u8> {
        let tape = self.lathe.kept(self.protocol()).unwrap_or_default();
        [&[DC2][..], self.label().as_bytes(), &tape, &[TAPE_MARK as u8, DC4]].concat()
    }
}

impl Reader {
    fn keep(&mut self, byte: u8, tv_check: bool) -> Result<(), &'static str> {
        if self.tape.is_empty() && byte == b'\r' {
            // It belongs to the end of the label.
            return Ok(());
        }
        if self.tape.len() >= LARGEST {
            return Err("070 NO PROGRAM SPACE IN MEMORY");
        }
        self.tape.push(byte);
        self.block += 1;
        if byte == b'\n' && std::mem::take(&mut self.block) % 2 == 1 && tv_check {
            return Err("002 TV PARITY ALARM: a block has an odd number of characters");
        }
        Ok(())
    }
}

impl Brain for Fanuc {
    fn take(&mut self, byte: u8, now: Duration) {
        match byte {
            DC1 => {
                self.break_off();
                self.asked = true;
            }
            DC2 => self.start_reading(),
            _ => self.read(byte, now),
        }
    }

    fn turn(&mut self, now: Duration) -> Option<Reply> {
        if let Some(reader) = &mut self.reader
            && reader.held_until.is_some_and(|until| now >= until)
        {
            (reader.held_until, reader.buffered) = (None, 0);
            self.codes.push(DC1);
        }
        if !self.codes.is_empty() {
            return Some(Reply::Codes(std::mem::take(&mut self.codes)));
        }
        if self.reader.is_none() {
            self.asked |= self.lathe.send_was_pressed();
        }
        let punches = std::mem::take(&mut self.asked) && !self.alarm;
        punches.then(|| Reply::Program(self.punch()))
    }

    /// At the speed of the line, a sender that does not stop overruns the buffer. Unpaced, more is on its way than any
    /// buffer holds, so nothing is taken until the control goes on.
    fn room(&self) -> usize {
        match &self.reader {
            Some(reader) if self.unpaced && reader.held_until.is_some() => 0,
            Some(reader) if self.unpaced => (STOP_AT + self.late).saturating_sub(reader.buffered).max(1),
            _ => usize::MAX,
        }
    }

    fn reset(&mut self) {
        self.break_off();
        self.codes.push(DC3);
    }
}
