//! A rig behind a line, on a thread of its own that nobody waits for: orders go in, events come out.

use super::host::{Host, HostError, Position};
use crate::machine::{FlowControl, PageMarks, Parity, Protocol, SerialProfile};
use crate::spinning::control::Plan;
use crate::transfer::link::Link;
use crate::transfer::ports::{Opened, Port, open};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

/// Time between two questions for the position.
const LOOK: Duration = Duration::from_millis(20);

/// Longest way of the roller to its datum: a full stroke at the slowest speed, three times over.
const LONGEST_WAY: Duration = Duration::from_secs(36);

/// What the rig's thread tells.
#[derive(Debug, Clone, PartialEq)]
pub enum RigEvent {
    /// The rig has answered; settings that the port did not take.
    Ready(Vec<String>),
    /// The roller is at its datum.
    AtDatum,
    /// Where roller and carriage are in a run.
    At(Position),
    /// The run has ended as planned.
    Completed,
    /// The run was stopped.
    Stopped {
        /// Why, as a sentence.
        reason: String,
        /// The roller has reached its datum.
        drawn_back: bool,
    },
    /// The rig cannot be reached, or not any more; a sentence. Nothing comes after it.
    Lost(String),
}

enum Order {
    Datum,
    Run(Box<Plan>),
}

/// A rig behind a line. Dropping it closes the line; a run that goes on is stopped by the device itself then.
#[derive(Debug)]
pub struct RigLine {
    orders: Sender<Order>,
    events: Receiver<RigEvent>,
    hurry: Arc<AtomicBool>,
}

/// Settings of the line to a rig.
#[must_use]
pub const fn profile() -> SerialProfile {
    SerialProfile {
        baud: 115_200,
        data_bits: 8,
        parity: Parity::None,
        stop_bits: 1,
        flow: FlowControl::None,
        // Not spoken here: a profile names one.
        protocol: Protocol::OracPages(PageMarks { page_start: 0, end: 0 }),
    }
}

impl RigLine {
    /// Opens a port, greets the rig and draws its roller back. `wake` is called after every event.
    #[must_use]
    pub fn open(port: Port, wake: impl Fn() + Send + 'static) -> Self {
        let (orders, inbox) = mpsc::channel();
        let (outbox, events) = mpsc::channel();
        let hurry = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&hurry);
        thread::spawn(move || {
            let tell = |event| {
                let heard = outbox.send(event).is_ok();
                wake();
                heard
            };
            if let Err(reason) = serve(port, &inbox, &flag, &tell) {
                tell(RigEvent::Lost(reason));
            }
        });
        Self { orders, events, hurry }
    }

    /// Draws the roller back to its datum.
    pub fn seek_datum(&self) {
        let _ = self.orders.send(Order::Datum);
    }

    /// Sends a plan to the rig and starts it.
    pub fn run(&self, plan: Plan) {
        let _ = self.orders.send(Order::Run(Box::new(plan)));
    }

    /// Emergency stop, in front of everything else.
    pub fn emergency_stop(&self) {
        self.hurry.store(true, Ordering::SeqCst);
    }

    /// What has happened since.
    pub fn events(&self) -> impl Iterator<Item = RigEvent> + '_ {
        self.events.try_iter()
    }
}

type RigHost = Host<Box<dyn Link>>;

fn serve(
    port: Port,
    orders: &Receiver<Order>,
    hurry: &Arc<AtomicBool>,
    tell: &dyn Fn(RigEvent) -> bool,
) -> Result<(), String> {
    let Opened { link, remarks } = open(port, &profile(), true)?;
    let mut host = Host::connect_until(link, Arc::clone(hurry)).map_err(|e| e.to_string())?;
    tell(RigEvent::Ready(remarks));
    to_datum(&mut host, tell).map_err(|e| e.to_string())?;
    loop {
        match orders.recv_timeout(LOOK) {
            Ok(Order::Datum) => to_datum(&mut host, tell).map_err(|e| e.to_string())?,
            Ok(Order::Run(plan)) => run(&mut host, &plan, tell).map_err(|e| {
                format!("{e} The rig stops by itself after 2 s without a word; look at it before you touch it.")
            })?,
            Err(RecvTimeoutError::Timeout) if hurry.load(Ordering::SeqCst) => {
                stop_between_runs(&mut host, tell).map_err(|e| e.to_string())?;
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return Ok(()),
        }
    }
}

/// Lathe and pump are switched off at once, though nothing runs.
fn stop_between_runs(host: &mut RigHost, tell: &dyn Fn(RigEvent) -> bool) -> Result<(), HostError> {
    loop {
        host.emergency_stop()?;
        match host.position() {
            Err(HostError::Interrupted) => {}
            at => {
                let drawn_back = at?.state != 'N';
                tell(RigEvent::Stopped { reason: HostError::Interrupted.to_string(), drawn_back });
                return Ok(());
            }
        }
    }
}

fn to_datum(host: &mut RigHost, tell: &dyn Fn(RigEvent) -> bool) -> Result<(), HostError> {
    let until = Instant::now() + LONGEST_WAY;
    let arrived = host.seek_datum().and_then(|()| wait_for_datum(host, until));
    match arrived {
        Ok(()) => {
            tell(RigEvent::AtDatum);
        }
        Err(HostError::Interrupted) => {
            host.emergency_stop()?;
            let reason = HostError::Interrupted.to_string();
            tell(RigEvent::Stopped { reason, drawn_back: false });
        }
        Err(error) => return Err(error),
    }
    Ok(())
}

fn wait_for_datum(host: &mut RigHost, until: Instant) -> Result<(), HostError> {
    while host.position()?.state == 'T' {
        if Instant::now() > until {
            host.emergency_stop()?;
            return Err(HostError::Refused("the roller does not reach its datum".to_owned()));
        }
        thread::sleep(LOOK);
    }
    Ok(())
}

/// From the table to the end of the run, however it ends.
fn run(host: &mut RigHost, plan: &Plan, tell: &dyn Fn(RigEvent) -> bool) -> Result<(), HostError> {
    let started = host.load(plan).and_then(|()| host.go());
    let mut stopping = match started {
        Err(HostError::Interrupted) => true,
        other => {
            other?;
            false
        }
    };
    loop {
        if std::mem::take(&mut stopping) {
            host.emergency_stop()?;
        }
        match host.position() {
            Ok(at) if at.is_over() => return ended(host, at, tell),
            // The stop came before the start: nothing moves.
            Ok(at) if at.state == 'I' => {
                let reason = HostError::Interrupted.to_string();
                tell(RigEvent::Stopped { reason, drawn_back: true });
                return Ok(());
            }
            Ok(at) if !tell(RigEvent::At(at)) => stopping = true,
            Ok(_) => {}
            Err(HostError::Interrupted) => stopping = true,
            Err(error) => return Err(error),
        }
        if !stopping {
            thread::sleep(LOOK);
        }
    }
}

fn ended(host: &mut RigHost, at: Position, tell: &dyn Fn(RigEvent) -> bool) -> Result<(), HostError> {
    tell(RigEvent::At(at));
    if at.state == 'C' {
        tell(RigEvent::Completed);
        return Ok(());
    }
    let reason = match host.why() {
        Ok(why) => why.to_string(),
        Err(HostError::Interrupted) => HostError::Interrupted.to_string(),
        Err(error) => return Err(error),
    };
    tell(RigEvent::Stopped { reason, drawn_back: at.state == 'D' });
    Ok(())
}

#[cfg(test)]
#[path = "line_tests.rs"]
mod tests;
