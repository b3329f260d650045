//! The thread that owns an open link. Nobody ever waits for it: a driver that blocks blocks this thread alone, and the
//! link closes whenever the call returns.

use super::link::Link;
use super::ports::{Opened, Port, open};
use crate::machine::SerialProfile;
use std::io;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::thread;
use std::time::{Duration, Instant};

/// Longest wait of one write or read. Short, so that reading and writing take turns.
const TURN: Duration = Duration::from_millis(5);

/// After a write, the next one usually follows at once; waiting this long for it saves a turn of reading.
const NEXT_WRITE: Duration = Duration::from_millis(1);

/// Longest wait for a port to close; an abort is promised within 200 ms.
const CLOSING: Duration = Duration::from_millis(100);

pub(super) enum PortEvent {
    /// The port is open; settings that the driver did not take.
    Opened(Vec<String>),
    /// These bytes of the last write were taken.
    Wrote(Vec<u8>),
    /// Bytes came.
    Read(Vec<u8>),
    /// Answer to [`PortThread::ask_queued`].
    Queued(usize),
    /// The port is gone; a sentence.
    Failed(String),
}

enum Command {
    Write(Vec<u8>),
    Queued,
    Discard,
}

/// The handle of the job. Without it the thread ends as soon as the driver lets it.
pub(super) struct PortThread {
    commands: Sender<Command>,
    events: Receiver<PortEvent>,
}

impl PortThread {
    pub(super) fn start(port: Port, profile: SerialProfile, unpaced: bool) -> Self {
        let (commands, inbox) = mpsc::channel();
        let (outbox, events) = mpsc::channel();
        thread::spawn(move || {
            let last = match open(port, &profile, unpaced) {
                Err(reason) => Err(reason),
                Ok(Opened { link, remarks }) => {
                    let _ = outbox.send(PortEvent::Opened(remarks));
                    serve(link, &inbox, &outbox).map_err(|error| describe(&error))
                }
            };
            if let Err(reason) = last {
                let _ = outbox.send(PortEvent::Failed(reason));
            }
        });
        Self { commands, events }
    }

    /// Writes `bytes`; [`PortEvent::Wrote`] answers.
    pub(super) fn write(&self, bytes: Vec<u8>) {
        // A thread that has ended has said why; the next event tells.
        let _ = self.commands.send(Command::Write(bytes));
    }

    /// Asks how many bytes have not gone out yet.
    pub(super) fn ask_queued(&self) {
        let _ = self.commands.send(Command::Queued);
    }

    /// Forgets what has not gone out yet.
    pub(super) fn discard(&self) {
        let _ = self.commands.send(Command::Discard);
    }

    /// Waits until the port is closed, so that it can be opened again at once, but no longer than [`CLOSING`].
    pub(super) fn close(self) {
        let Self { commands, events } = self;
        drop(commands);
        let until = Instant::now() + CLOSING;
        while events.recv_timeout(until.saturating_duration_since(Instant::now())).is_ok() {}
    }

    /// The next event, none within `timeout`.
    pub(super) fn next(&self, timeout: Duration) -> Option<PortEvent> {
        match self.events.recv_timeout(timeout) {
            Ok(event) => Some(event),
            Err(RecvTimeoutError::Timeout) => None,
            Err(RecvTimeoutError::Disconnected) => {
                Some(PortEvent::Failed("The port stopped working unexpectedly. Close it and try again.".to_owned()))
            }
        }
    }
}

/// Serves commands and reads until the job is gone. Every write is followed by a look at what came, so that a control's
/// "wait" is never overtaken by a run of writes.
fn serve(mut link: Box<dyn Link>, inbox: &Receiver<Command>, outbox: &Sender<PortEvent>) -> io::Result<()> {
    let mut wrote = false;
    loop {
        let command = if wrote {
            inbox.recv_timeout(NEXT_WRITE).map_err(|e| e == RecvTimeoutError::Disconnected)
        } else {
            inbox.try_recv().map_err(|e| e == TryRecvError::Disconnected)
        };
        wrote = matches!(command, Ok(Command::Write(_)));
        let event = match command {
            Ok(Command::Write(mut bytes)) => {
                bytes.truncate(link.write_some(&bytes, TURN)?);
                let read = read(link.as_mut(), Duration::ZERO)?;
                if read.is_some_and(|event| outbox.send(event).is_err()) {
                    return Ok(());
                }
                Some(PortEvent::Wrote(bytes))
            }
            Ok(Command::Queued) => Some(PortEvent::Queued(link.queued()?)),
            Ok(Command::Discard) => {
                link.discard_queued();
                None
            }
            Err(true) => return Ok(()),
            Err(false) => read(link.as_mut(), TURN)?,
        };
        if event.is_some_and(|event| outbox.send(event).is_err()) {
            return Ok(());
        }
    }
}

fn read(link: &mut dyn Link, timeout: Duration) -> io::Result<Option<PortEvent>> {
    let mut buffer = [0; 256];
    let count = link.read_some(&mut buffer, timeout)?;
    Ok(buffer.get(..count).filter(|bytes| !bytes.is_empty()).map(|bytes| PortEvent::Read(bytes.to_vec())))
}

fn describe(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::BrokenPipe | io::ErrorKind::NotFound | io::ErrorKind::ConnectionReset => {
            "The port was closed from the other side or unplugged.".to_owned()
        }
        _ => "The port failed: its driver reports an error. Check the cable or adapter, then try again.".to_owned(),
    }
}
