//! The thread of a transfer: drives the protocol machines, looks at the abort flag, tells what happens.

use super::{Event, Outcome, Progress, State, Task, Timing};
use crate::cancel::Cancel;
use crate::machine::{DC1, DC2, DC3, SerialProfile};
use crate::transfer::compare::Blanks;
use crate::transfer::line;
use crate::transfer::log::{Direction, Gatherer, LogLine};
use crate::transfer::port_thread::{PortEvent, PortThread};
use crate::transfer::ports::Port;
use crate::transfer::protocol;
use crate::transfer::receiver::{ReceiveStep, Receiver};
use crate::transfer::sender::{SendStep, Sender};
use std::time::{Duration, Instant};

/// Longest wait between two looks at the abort flag; an abort is promised within 200 ms.
const LOOK: Duration = Duration::from_millis(20);

/// Least time between two progress events, so that a fast port does not flood the window.
const PROGRESS_EVERY: Duration = Duration::from_millis(50);

/// After the last byte of a program the port is watched this long for a late failure, such as a pulled plug.
const SETTLE: Duration = Duration::from_millis(100);

/// Longest time for reading away what came before the transfer; it ends as soon as nothing more comes.
const STALE: Duration = Duration::from_secs(1);

type Tell<'a> = &'a dyn Fn(Event);

/// How a transfer over a line is done, as in [`super::Request`].
pub(super) struct Options {
    pub(super) unpaced: bool,
    pub(super) press_keys: bool,
    pub(super) blanks: Blanks,
    pub(super) timing: Timing,
}

/// Runs a transfer to its outcome.
pub(super) fn run(
    task: Task,
    port: Port,
    profile: SerialProfile,
    options: Options,
    cancel: Cancel,
    tell: Tell<'_>,
) -> Outcome {
    begin(task, port, profile, options, cancel, tell).unwrap_or_else(|ended| ended)
}

/// The early end of a transfer comes as the error.
fn begin(
    task: Task,
    port: Port,
    profile: SerialProfile,
    options: Options,
    cancel: Cancel,
    tell: Tell<'_>,
) -> Result<Outcome, Outcome> {
    line::check(&profile).map_err(Outcome::Failed)?;
    let unpaced = options.unpaced;
    let sender = match &task {
        Task::Send { text, .. } => Some(
            Sender::new(text, &profile, unpaced, options.timing.patience())
                .map_err(|refused| Outcome::Failed(refused.to_string()))?,
        ),
        Task::Receive | Task::Compare { .. } => None,
    };
    tell(Event::State(State::Opening));
    let port = PortThread::start(port, profile.clone(), unpaced);
    let mut worker = Worker {
        port,
        character_time: (!unpaced).then(|| line::character_time(&profile)),
        profile,
        cancel,
        options,
        tell,
        began: Instant::now(),
        told_progress: None,
        early: Vec::new(),
        sent_log: Gatherer::new(Direction::Sent),
        received_log: Gatherer::new(Direction::Received),
    };
    let is_sending = sender.is_some();
    let result = worker.run(task, sender);
    worker.finish_log();
    if result == Err(Outcome::Aborted) {
        worker.port.discard();
        if is_sending {
            worker.note("Aborted; the control may hold part of the program.".to_owned());
        }
    }
    worker.port.close();
    result
}

struct Worker<'a> {
    port: PortThread,
    profile: SerialProfile,
    /// None if unpaced.
    character_time: Option<Duration>,
    cancel: Cancel,
    options: Options,
    tell: Tell<'a>,
    began: Instant,
    told_progress: Option<Duration>,
    /// What came after the last byte had been sent and before receiving began.
    early: Vec<u8>,
    sent_log: Gatherer,
    received_log: Gatherer,
}

impl Worker<'_> {
    fn run(&mut self, task: Task, sender: Option<Sender>) -> Result<Outcome, Outcome> {
        self.wait_until_open()?;
        if task != Task::Receive {
            self.drop_stale()?;
        }
        match (task, sender) {
            (Task::Send { name, text, verify }, Some(sender)) => self.send(&name, &text, sender, verify),
            (Task::Compare { sent, .. } | Task::Send { text: sent, .. }, _) => self.receive_and_compare(&sent),
            (Task::Receive, _) => {
                let received = self.receive(None)?;
                let problems = protocol::problems(&received, self.profile.protocol);
                Ok(Outcome::Received { text: protocol::text_of(received, self.profile.protocol), problems })
            }
        }
    }

    fn wait_until_open(&mut self) -> Result<(), Outcome> {
        while self.now() < self.options.timing.stuck {
            if let Some(PortEvent::Opened(remarks)) = self.next(LOOK)? {
                for remark in remarks {
                    self.note(remark);
                }
                return Ok(());
            }
        }
        let waited = self.options.timing.stuck.as_secs_f64();
        Err(Outcome::Failed(format!("The port did not open within {waited} s. Check the cable or adapter.")))
    }

    /// Reads away what the control sent before it was asked: an old answer must not be compared with a new program.
    fn drop_stale(&mut self) -> Result<(), Outcome> {
        let until = self.now() + STALE;
        let mut stale = 0;
        while self.now() < until {
            match self.next(LOOK)? {
                Some(PortEvent::Read(bytes)) => stale += bytes.len(),
                _ => break,
            }
        }
        if stale > 0 {
            self.note(format!("{stale} bytes that came from the control before the transfer were dropped."));
        }
        Ok(())
    }

    fn send(&mut self, name: &str, text: &str, mut sender: Sender, verify: bool) -> Result<Outcome, Outcome> {
        if !sender.has_started() {
            self.wait_for_reader(&mut sender)?;
        }
        (self.tell)(Event::State(State::Sending));
        self.note(format!("Sending {name}: {} bytes, {} blocks.", sender.bytes().1, sender.blocks().1));
        self.send_bytes(&mut sender)?;
        self.wait_until_out()?;
        self.progress(sending(&sender, self.now()), true);
        if verify {
            return self.receive_and_compare(text);
        }
        self.settle()?;
        Ok(Outcome::SentNotVerified)
    }

    /// Waits until the control asks for the program.
    fn wait_for_reader(&mut self, sender: &mut Sender) -> Result<(), Outcome> {
        (self.tell)(Event::State(State::WaitingForReader));
        self.note(State::WaitingForReader.to_string());
        // What was written is counted as sent from here on, so the key must be out before.
        let mut key_is_out = !self.options.press_keys;
        if !key_is_out {
            self.port.write(vec![DC2]);
        }
        while !(sender.has_started() && key_is_out) {
            if let SendStep::Failed(reason) = sender.poll(self.now()) {
                return Err(Outcome::Failed(reason));
            }
            match self.next(LOOK)? {
                Some(PortEvent::Read(bytes)) => sender.received(&bytes, self.now()),
                Some(PortEvent::Wrote(bytes)) if bytes.is_empty() => self.port.write(vec![DC2]),
                Some(PortEvent::Wrote(_)) => key_is_out = true,
                _ => {}
            }
        }
        Ok(())
    }

    fn send_bytes(&mut self, sender: &mut Sender) -> Result<(), Outcome> {
        let mut writing = false;
        loop {
            let now = self.now();
            let wait = match sender.poll(now) {
                SendStep::Failed(reason) => return Err(Outcome::Failed(reason)),
                SendStep::Done => return Ok(()),
                SendStep::Wait(time) => time.min(LOOK),
                SendStep::Write(_) if writing => LOOK,
                SendStep::Write(bytes) => {
                    self.port.write(bytes.to_vec());
                    writing = true;
                    LOOK
                }
            };
            match self.next(wait)? {
                Some(PortEvent::Wrote(bytes)) => {
                    writing = false;
                    sender.written(bytes.len(), self.now());
                    self.progress(sending(sender, self.now()), false);
                }
                Some(PortEvent::Read(bytes)) => sender.received(&bytes, self.now()),
                _ => {}
            }
        }
    }

    /// Waits until the driver has let go of the last byte.
    fn wait_until_out(&mut self) -> Result<(), Outcome> {
        let since = self.now();
        self.port.ask_queued();
        loop {
            match self.next(LOOK)? {
                Some(PortEvent::Queued(0)) => return Ok(()),
                Some(PortEvent::Read(bytes)) => self.early.extend(bytes),
                Some(_) => {}
                None => self.port.ask_queued(),
            }
            if self.now().saturating_sub(since) >= self.options.timing.stuck {
                return Err(Outcome::Failed(format!(
                    "The port keeps the last bytes back for more than {} s. Check the cable and the flow control.",
                    self.options.timing.stuck.as_secs_f64()
                )));
            }
        }
    }

    fn settle(&mut self) -> Result<(), Outcome> {
        let until = self.now() + SETTLE;
        while self.now() < until {
            self.next(LOOK)?;
        }
        Ok(())
    }

    fn receive_and_compare(&mut self, sent: &str) -> Result<Outcome, Outcome> {
        let received = self.receive(Some(sent))?;
        let differences = protocol::compare(sent, &received, self.profile.protocol, self.options.blanks);
        Ok(if differences.is_empty() { Outcome::Verified } else { Outcome::Different(differences) })
    }

    fn receive(&mut self, expected: Option<&str>) -> Result<String, Outcome> {
        (self.tell)(Event::State(State::WaitingForControl));
        self.note(State::WaitingForControl.to_string());
        let mut receiver = Receiver::new(&self.profile, self.options.timing.first, self.options.timing.idle);
        let expected = expected
            .and_then(|text| protocol::outgoing(text, self.profile.protocol).ok())
            .map(|outgoing| (outgoing.bytes.len(), outgoing.block_starts.len()));
        let mut arrived = std::mem::take(&mut self.early);
        let mut asking = self.options.press_keys && arrived.iter().all(|byte| [DC1, DC3].contains(byte));
        loop {
            self.take(&mut receiver, &arrived, expected);
            match receiver.poll(self.now()) {
                ReceiveStep::Done => return Ok(receiver.into_received()),
                ReceiveStep::Failed(reason) => return Err(Outcome::Failed(reason)),
                ReceiveStep::Wait => {}
            }
            if std::mem::take(&mut asking) {
                self.port.write(vec![DC1]);
            }
            arrived = match self.next(LOOK)? {
                Some(PortEvent::Read(bytes)) => bytes,
                Some(PortEvent::Wrote(bytes)) => {
                    asking = bytes.is_empty();
                    Vec::new()
                }
                _ => Vec::new(),
            };
        }
    }

    fn take(&mut self, receiver: &mut Receiver, bytes: &[u8], expected: Option<(usize, usize)>) {
        if bytes.is_empty() {
            return;
        }
        let before = receiver.bytes();
        receiver.received(bytes, self.now());
        if before == 0 && receiver.bytes() > 0 {
            (self.tell)(Event::State(State::Receiving));
        }
        self.progress(receiving(receiver, expected, self.character_time, self.now()), false);
    }

    /// The next event of the port, none within `wait`. Abort and failure come as errors.
    fn next(&mut self, wait: Duration) -> Result<Option<PortEvent>, Outcome> {
        if self.cancel.is_cancelled() {
            return Err(Outcome::Aborted);
        }
        let event = self.port.next(wait);
        let (now, end) = (self.now(), protocol::end_mark(self.profile.protocol));
        let lines = match &event {
            _ if self.cancel.is_cancelled() => return Err(Outcome::Aborted),
            Some(PortEvent::Failed(reason)) => return Err(Outcome::Failed(reason.clone())),
            Some(PortEvent::Wrote(bytes)) => self.sent_log.add(bytes, end, now),
            Some(PortEvent::Read(bytes)) => self.received_log.add(bytes, end, now),
            _ => Vec::new(),
        };
        self.log(lines);
        Ok(event)
    }

    fn now(&self) -> Duration {
        self.began.elapsed()
    }

    fn note(&self, text: String) {
        self.log([LogLine { at: self.now(), direction: Direction::Note, text }]);
    }

    fn log(&self, lines: impl IntoIterator<Item = LogLine>) {
        lines.into_iter().for_each(|line| (self.tell)(Event::Log(line)));
    }

    fn finish_log(&mut self) {
        let at = self.now();
        let rest = [self.sent_log.finish(at), self.received_log.finish(at)];
        self.log(rest.into_iter().flatten());
    }

    fn progress(&mut self, progress: Progress, at_once: bool) {
        let due = self.told_progress.is_none_or(|told| progress.elapsed.saturating_sub(told) >= PROGRESS_EVERY);
        if due || at_once {
            self.told_progress = Some(progress.elapsed);
            (self.tell)(Event::Progress(progress));
        }
    }
}

fn sending(sender: &Sender, now: Duration) -> Progress {
    let ((bytes, bytes_total), (block, blocks_total)) = (sender.bytes(), sender.blocks());
    let eta = sender.time_left(now);
    Progress { bytes, bytes_total: Some(bytes_total), block, blocks_total: Some(blocks_total), elapsed: now, eta }
}

fn receiving(
    receiver: &Receiver,
    expected: Option<(usize, usize)>,
    character_time: Option<Duration>,
    now: Duration,
) -> Progress {
    let left = expected.and_then(|(bytes, _)| u32::try_from(bytes.saturating_sub(receiver.bytes())).ok());
    Progress {
        bytes: receiver.bytes(),
        bytes_total: expected.map(|(bytes, _)| bytes),
        block: receiver.blocks(),
        blocks_total: expected.map(|(_, blocks)| blocks),
        elapsed: now,
        eta: left.zip(character_time).map(|(left, time)| time * left),
    }
}
