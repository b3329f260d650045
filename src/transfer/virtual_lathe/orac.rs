//! What an ORAC does with bytes: it keeps what comes between a page mark and an end mark.

use super::control::{Brain, Reply};
use super::{LatheEvent, VirtualLathe};
use crate::machine::{DC1, PageMarks, Protocol};
use crate::transfer::orac::pages;
use std::time::Duration;

/// A program that stops arriving for this long has broken off.
const BROKEN_OFF_AFTER: Duration = Duration::from_secs(2);

/// Most bytes of a program that are kept.
const LARGEST: usize = 256 * 1024;

pub(super) struct Orac {
    lathe: VirtualLathe,
    marks: PageMarks,
    /// The program being received.
    incoming: Option<Vec<u8>>,
    last_byte: Duration,
    asked: bool,
}

impl Orac {
    pub(super) const fn new(lathe: VirtualLathe, marks: PageMarks) -> Self {
        Self { lathe, marks, incoming: None, last_byte: Duration::ZERO, asked: false }
    }

    fn store(&mut self) {
        let program = self.incoming.take().unwrap_or_default();
        let text = String::from_utf8_lossy(&program);
        let page_start = self.marks.page_start;
        let event = LatheEvent::Stored {
            bytes: program.len(),
            blocks: pages::split(&text, page_start).pages.len(),
            problems: pages::problems(&text, page_start),
        };
        self.lathe.keep(Protocol::OracPages(self.marks), program);
        self.lathe.say(event);
    }

    fn break_off(&mut self) {
        if let Some(program) = self.incoming.take() {
            self.lathe.say(LatheEvent::BrokenOff { bytes: program.len() });
        }
    }
}

impl Brain for Orac {
    fn take(&mut self, byte: u8, now: Duration) {
        self.last_byte = now;
        match &mut self.incoming {
            None if byte == self.marks.page_start => {
                self.lathe.forget();
                self.incoming = Some(vec![byte]);
            }
            None => self.asked |= byte == DC1,
            Some(_) if byte == self.marks.end => self.store(),
            Some(_) if byte == DC1 => {
                self.break_off();
                self.asked = true;
            }
            Some(program) if program.len() < LARGEST => program.push(byte),
            Some(_) => self.break_off(),
        }
    }

    fn turn(&mut self, now: Duration) -> Option<Reply> {
        if self.incoming.is_some() && now.saturating_sub(self.last_byte) >= BROKEN_OFF_AFTER {
            self.break_off();
        }
        if self.incoming.is_none() {
            self.asked |= self.lathe.send_was_pressed();
        }
        std::mem::take(&mut self.asked).then(|| {
            let mut program = self.lathe.kept(Protocol::OracPages(self.marks)).unwrap_or_default();
            program.push(self.marks.end);
            Reply::Program(program)
        })
    }

    fn reset(&mut self) {
        self.break_off();
    }
}
