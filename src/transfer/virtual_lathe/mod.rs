//! A lathe without metal: takes a program at the speed of the line, keeps it, and sends it back when asked.
//!
//! It plays the control whose profile it is given. "Asked" is the operator's send key: [`VirtualLathe::press_send`], or,
//! for a lathe in another process, a lone DC1 (0x11) received outside a program; a lone DC2 (0x12) presses a Fanuc's READ
//! key. A second program replaces the first. Faults are set with a [`FaultSpec`].

mod control;
mod fanuc;
mod faults;
mod orac;
#[cfg(all(unix, feature = "serial"))]
mod pty;

use super::link::{self, Link, PipeEnd};
use crate::cancel::Cancel;
use crate::machine::{Protocol, SerialProfile};
use control::Control;
pub use faults::{BadFault, ByteFault, ByteFaultKind, FaultSpec, When};
#[cfg(all(unix, feature = "serial"))]
pub use pty::run_on_pty;
use std::fmt;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// What a virtual lathe has to say.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LatheEvent {
    /// It can be reached at this port.
    Ready {
        /// Path of the port, or of the link to it.
        port: String,
    },
    /// A program came and is kept, with what is wrong with its form.
    Stored {
        /// Bytes of the program.
        bytes: usize,
        /// Pages or blocks of the program.
        blocks: usize,
        /// What is wrong with its form; empty if it is well-formed.
        problems: Vec<String>,
    },
    /// A program broke off before its end mark; nothing is kept.
    BrokenOff {
        /// Bytes that had come.
        bytes: usize,
    },
    /// It sends its program.
    Answering {
        /// Bytes of the answer, the end mark included.
        bytes: usize,
    },
    /// It was asked to send, and a fault keeps it silent.
    KeptSilent,
    /// It stopped with this alarm; nothing is kept.
    Alarm(&'static str),
    /// A fault reset it.
    Reset,
    /// A fault pulled its plug.
    Unplugged,
}

impl fmt::Display for LatheEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ready { port } => write!(f, "The virtual lathe listens at {port}"),
            Self::Stored { bytes, blocks, problems } => {
                write!(f, "Program stored: {bytes} bytes, {blocks} blocks.")?;
                problems.iter().try_for_each(|problem| write!(f, "\n  {problem}"))
            }
            Self::BrokenOff { bytes } => write!(f, "A program broke off after {bytes} bytes; nothing is kept."),
            Self::Answering { bytes } => write!(f, "Sending the program back: {bytes} bytes."),
            Self::KeptSilent => f.write_str("Asked to send; the fault `silent` keeps it quiet."),
            Self::Alarm(text) => write!(f, "Alarm {text}; nothing is kept."),
            Self::Reset => f.write_str("Reset by a fault."),
            Self::Unplugged => f.write_str("Unplugged by a fault."),
        }
    }
}

/// How to run a virtual lathe on a pseudo-terminal.
#[derive(Debug, Clone, Default)]
pub struct PtyOptions {
    /// A symbolic link to make to the port; replaced if it is a symbolic link already, removed at the end.
    pub link: Option<PathBuf>,
    /// What goes wrong.
    pub faults: FaultSpec,
    /// Do not keep to the speed of the line.
    pub unpaced: bool,
}

/// There are no pseudo-terminals here.
///
/// # Errors
/// Always: a sentence that says so.
#[cfg(not(all(unix, feature = "serial")))]
pub fn run_on_pty(
    _profile: &SerialProfile,
    _options: &PtyOptions,
    _on_event: &mut dyn FnMut(LatheEvent),
    _cancel: &Cancel,
) -> Result<(), String> {
    Err("This Turnwright cannot offer its virtual lathe to other programs: that needs Unix and the feature `serial`. \
         Use the port `virtual`."
        .to_owned())
}

/// What outlives a connection.
#[derive(Debug, Default)]
struct Memory {
    program: Option<(Protocol, Vec<u8>)>,
    send_pressed: bool,
    faults: FaultSpec,
    events: Vec<LatheEvent>,
}

/// A virtual lathe in this process; clones are the same lathe. It keeps its program between transfers.
#[derive(Debug, Clone, Default)]
pub struct VirtualLathe(Arc<Mutex<Memory>>);

impl VirtualLathe {
    /// A lathe without a program.
    #[must_use]
    pub fn new(faults: FaultSpec) -> Self {
        let lathe = Self::default();
        lathe.set_faults(faults);
        lathe
    }

    /// Sets the faults of connections opened from now on.
    pub fn set_faults(&self, faults: FaultSpec) {
        self.lock().faults = faults;
    }

    /// Presses the lathe's send key.
    pub fn press_send(&self) {
        self.lock().send_pressed = true;
    }

    /// The program that it holds.
    #[must_use]
    pub fn program(&self) -> Option<String> {
        self.lock().program.as_ref().map(|(_, bytes)| String::from_utf8_lossy(bytes).into_owned())
    }

    fn keep(&self, protocol: Protocol, program: Vec<u8>) {
        self.lock().program = Some((protocol, program));
    }

    /// The program, if it came by the same protocol.
    fn kept(&self, protocol: Protocol) -> Option<Vec<u8>> {
        self.lock().program.as_ref().filter(|(by, _)| *by == protocol).map(|(_, bytes)| bytes.clone())
    }

    fn forget(&self) {
        self.lock().program = None;
    }

    fn send_was_pressed(&self) -> bool {
        std::mem::take(&mut self.lock().send_pressed)
    }

    /// What it had to say since the last call.
    #[must_use]
    pub fn take_events(&self) -> Vec<LatheEvent> {
        std::mem::take(&mut self.lock().events)
    }

    /// Plugs a cable in; the lathe serves it on a thread of its own until the returned end is dropped.
    #[must_use]
    pub fn connect(&self, profile: &SerialProfile, unpaced: bool) -> PipeEnd {
        let (near, mut far) = link::pipe();
        let control = Control::new(self.clone(), profile, unpaced);
        thread::spawn(move || serve(&mut far, control, &Cancel::default(), &mut || ()));
        near
    }

    fn lock(&self) -> MutexGuard<'_, Memory> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn say(&self, event: LatheEvent) {
        /// More events than anyone reads are not kept.
        const MOST: usize = 100;
        let mut memory = self.lock();
        if memory.events.len() < MOST {
            memory.events.push(event);
        }
    }
}

/// Serves one connection until it is closed, unplugged or cancelled; `after_turn` is called often.
fn serve(link: &mut dyn Link, mut control: Control, cancel: &Cancel, after_turn: &mut dyn FnMut()) {
    /// Longest wait of one read or write.
    const TURN: Duration = Duration::from_millis(5);
    let began = Instant::now();
    let mut buffer = [0; link::LARGEST_WRITE];
    while !cancel.is_cancelled() && !control.is_unplugged() {
        let now = began.elapsed();
        let room = control.room(now).min(buffer.len());
        let turn = if control.has_answer() { Duration::ZERO } else { TURN };
        if let Some(space) = buffer.get_mut(..room).filter(|space| !space.is_empty()) {
            let Ok(count) = link.read_some(space, turn) else { break };
            control.received(space.get(..count).unwrap_or_default(), now);
        } else {
            thread::sleep(Duration::from_millis(1));
        }
        if control.begins_answer(began.elapsed()) {
            // What nobody has read of an earlier answer must not mix with the new one.
            link.discard_queued();
        }
        let chunk = control.offer(began.elapsed());
        if !chunk.is_empty() {
            let Ok(count) = link.write_some(&chunk, TURN) else { break };
            control.sent(count, began.elapsed());
        }
        after_turn();
    }
    control.closed();
    after_turn();
}
