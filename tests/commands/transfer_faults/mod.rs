//! Every fault of a transfer ends in an outcome that tells of it: none in a silent success, none in a hang.
//!
//! `cargo test --test commands transfer_faults:: -- --nocapture` prints the fault table.

use std::io;
use std::thread;
use std::time::{Duration, Instant};
use turnwright::cancel::Cancel;
use turnwright::machine::{Delivery, SerialProfile};
use turnwright::transfer::ports::VIRTUAL;
use turnwright::transfer::virtual_lathe::VirtualLathe;
use turnwright::transfer::{Event, Job, Link, Outcome, Port, Request, State, Target, Task, Timing};

mod fanuc;
mod orac;
#[cfg(all(unix, feature = "serial"))]
mod pseudo_terminal;

/// Nothing here may take longer; it is far above what any case needs.
const HANG: Duration = Duration::from_secs(30);

/// Patient enough for a busy computer.
const PATIENT: Timing =
    Timing { first: Duration::from_secs(15), idle: Duration::from_secs(10), stuck: Duration::from_secs(10) };

/// For cases that are meant to run into a time limit.
const SHORT: Timing =
    Timing { first: Duration::from_secs(1), idle: Duration::from_secs(1), stuck: Duration::from_secs(1) };

/// For controls that begin to answer, however late, and break off.
const BROKEN_OFF: Timing = Timing { first: PATIENT.first, ..SHORT };

fn send(text: String, verify: bool) -> Task {
    Task::Send { name: "TEST1".to_owned(), text, verify }
}

fn compare(sent: String) -> Task {
    Task::Compare { name: "TEST1".to_owned(), sent }
}

fn request(task: Task, target: Target, timing: Timing) -> Request {
    Request { unpaced: true, timing, ..Request::new(task, target) }
}

/// The port `name` of a line; `lathe` is the virtual one.
fn line(name: &str, profile: &SerialProfile, lathe: &VirtualLathe) -> Target {
    Target::named(name, &Delivery::Line(profile.clone()), lathe)
}

fn to_lathe(profile: &SerialProfile, faults: &str) -> Target {
    line(VIRTUAL, profile, &VirtualLathe::new(faults.parse().unwrap()))
}

fn to_link(profile: &SerialProfile, link: impl Link + 'static) -> Target {
    Target::Line { port: Port::Open(Box::new(link)), profile: profile.clone() }
}

fn start(task: Task, target: Target, timing: Timing) -> Job {
    Job::start(request(task, target, timing), &Cancel::default(), || ())
}

/// Runs a job to its one outcome.
fn outcome(mut job: Job) -> Outcome {
    let began = Instant::now();
    loop {
        match job.next(Duration::from_millis(100)) {
            Some(Event::Done(outcome)) => {
                assert!(job.is_done() && job.next(Duration::from_millis(1)).is_none(), "an event after the last");
                return outcome;
            }
            _ => assert!(began.elapsed() < HANG, "the transfer hangs"),
        }
    }
}

#[derive(Debug, Clone, Copy)]
enum Expected {
    Sent,
    Verified,
    Different,
    Failed(&'static str),
}

impl Expected {
    fn is(self, outcome: &Outcome) -> bool {
        match (self, outcome) {
            (Self::Sent, Outcome::SentNotVerified) | (Self::Verified, Outcome::Verified) => true,
            (Self::Different, Outcome::Different(list)) => !list.is_empty(),
            (Self::Failed(words), Outcome::Failed(reason)) => reason.contains(words),
            _ => false,
        }
    }
}

/// One row of the fault table. `verify`: the program is asked back and compared.
struct Row {
    faults: &'static str,
    verify: bool,
    timing: Timing,
    expected: Expected,
}

const fn row(faults: &'static str, verify: bool, timing: Timing, expected: Expected) -> Row {
    Row { faults, verify, timing, expected }
}

/// Runs a table, eight rows at a time, and prints it. `LAST` is replaced by `last`, the place of the last byte.
fn run_table(medium: &str, table: &[Row], text: &str, last: usize, run: impl Fn(&str, Task, Timing) -> Outcome + Sync) {
    let last = last.to_string();
    let mut wrong = Vec::new();
    println!("| {medium}: fault | compared | outcome |\n|---|---|---|");
    for rows in table.chunks(8) {
        let outcomes: Vec<_> = thread::scope(|scope| {
            let jobs: Vec<_> = rows
                .iter()
                .map(|row| {
                    let (last, run) = (&last, &run);
                    let job =
                        move || run(&row.faults.replace("LAST", last), send(text.to_owned(), row.verify), row.timing);
                    scope.spawn(job)
                })
                .collect();
            jobs.into_iter().map(|job| job.join().unwrap()).collect()
        });
        for (row, outcome) in rows.iter().zip(outcomes) {
            let sentence = outcome.to_string().lines().take(2).collect::<Vec<_>>().join(" ");
            println!("| `{}` | {} | {sentence} |", row.faults, if row.verify { "yes" } else { "no" });
            if !row.expected.is(&outcome) {
                wrong.push(format!("{}: expected {:?}, came {outcome:?}", row.faults, row.expected));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A driver whose calls never return.
#[derive(Debug)]
struct Blocked {
    reads: bool,
}

fn never() -> ! {
    loop {
        thread::park();
    }
}

impl Link for Blocked {
    fn write_some(&mut self, _: &[u8], _: Duration) -> io::Result<usize> {
        never()
    }
    fn read_some(&mut self, _: &mut [u8], timeout: Duration) -> io::Result<usize> {
        if self.reads {
            never()
        }
        thread::sleep(timeout);
        Ok(0)
    }
    fn queued(&mut self) -> io::Result<usize> {
        never()
    }
    fn discard_queued(&mut self) {
        never()
    }
}

/// Starts, lets the transfer get under way, aborts.
fn aborted(task: Task, target: Target) -> Outcome {
    let mut job = start(task, target, PATIENT);
    while let Some(Event::State(State::Opening)) | None = job.next(Duration::from_millis(50)) {}
    thread::sleep(Duration::from_millis(50));
    job.abort();
    outcome(job)
}
