//! Every fault of a transfer ends in an outcome that tells of it: none in a silent success, none in a hang.
//!
//! `cargo test --test transfer_faults -- --nocapture` prints the fault table.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "helpers of tests fail like tests, and the fault table is printed"
)]

use std::io;
use std::thread;
use std::time::{Duration, Instant};
use turnwright::cancel::Cancel;
use turnwright::machine::{FlowControl, Parity, SerialProfile};
use turnwright::transfer::virtual_lathe::VirtualLathe;
use turnwright::transfer::{Event, Job, Link, Outcome, Port, Request, State, Task, Timing};

/// Nothing here may take longer; it is far above what any case needs.
const HANG: Duration = Duration::from_secs(30);

/// Patient enough for a busy computer.
const PATIENT: Timing =
    Timing { first: Duration::from_secs(15), idle: Duration::from_secs(10), stuck: Duration::from_secs(10) };

/// For cases that are meant to run into a time limit.
const SHORT: Timing =
    Timing { first: Duration::from_millis(300), idle: Duration::from_millis(300), stuck: Duration::from_millis(300) };

fn profile() -> SerialProfile {
    SerialProfile {
        baud: 2400,
        data_bits: 7,
        parity: Parity::Odd,
        stop_bits: 1,
        flow: FlowControl::None,
        page_start: 2,
        end: 4,
    }
}

fn program(pages: usize) -> String {
    let page = |n: usize| {
        format!(
            "\x02PAGE {n:02} POINT-TO-POINT.G00,G01\r\nX{:>9.3}\r\nZ{:>9.3}\r\nFEEDRATE{:>5}\r\nTOOL-NO 1\r\n\
             SPINDLE-SPEED 1214\r\n",
            n as f64 * 0.8,
            n as f64 * -1.25,
            80
        )
    };
    (1..=pages).map(page).collect()
}

fn send(text: String, verify: bool) -> Task {
    Task::Send { name: "TEST1".to_owned(), text, verify }
}

fn request(task: Task, port: Port, timing: Timing) -> Request {
    let mut request = Request::new(task, port, &profile());
    request.unpaced = true;
    request.timing = timing;
    request
}

fn start(task: Task, port: Port, timing: Timing) -> Job {
    Job::start(request(task, port, timing), &Cancel::default(), || ())
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

/// `LAST` is replaced by the place of the end mark.
const TABLE: &[Row] = &[
    row("", false, PATIENT, Expected::Sent),
    row("", true, PATIENT, Expected::Verified),
    row("drop@1", true, PATIENT, Expected::Different),
    row("drop@100", true, PATIENT, Expected::Different),
    row("drop@LAST", true, PATIENT, Expected::Failed("holds no program")),
    row("drop=2%,seed=7", true, PATIENT, Expected::Different),
    row("change@1", true, PATIENT, Expected::Different),
    row("change@250", true, PATIENT, Expected::Different),
    row("change@LAST", true, PATIENT, Expected::Failed("holds no program")),
    row("change=2%,seed=7", true, PATIENT, Expected::Different),
    row("duplicate@1", true, PATIENT, Expected::Different),
    row("duplicate@300", true, PATIENT, Expected::Different),
    row("duplicate@LAST", true, PATIENT, Expected::Verified),
    row("duplicate=2%,seed=7", true, PATIENT, Expected::Different),
    row("delay=2ms", true, PATIENT, Expected::Verified),
    row("answer-drop@1", true, PATIENT, Expected::Different),
    row("answer-drop@400", true, PATIENT, Expected::Different),
    row("answer-change@400", true, PATIENT, Expected::Different),
    row("answer-duplicate@400", true, PATIENT, Expected::Different),
    row("answer-drop@LAST", true, SHORT, Expected::Failed("no end mark and nothing more")),
    row("truncate@300", true, SHORT, Expected::Failed("stopped after 300 bytes")),
    row("silent", true, SHORT, Expected::Failed("Nothing came from the control")),
    row("stall@100", true, SHORT, Expected::Failed("")),
    row("unplug@1", true, PATIENT, Expected::Failed("unplugged")),
    row("unplug@500", true, PATIENT, Expected::Failed("unplugged")),
];

/// Runs the table, eight rows at a time, and prints it.
fn run_table(medium: &str, run: impl Fn(&str, Task, Timing) -> Outcome + Sync) {
    let text = program(12);
    let last = (text.len() + 1).to_string();
    let mut wrong = Vec::new();
    println!("| {medium}: fault | compared | outcome |\n|---|---|---|");
    for rows in TABLE.chunks(8) {
        let outcomes: Vec<_> = thread::scope(|scope| {
            let jobs: Vec<_> = rows
                .iter()
                .map(|row| {
                    let (text, last, run) = (&text, &last, &run);
                    let job =
                        move || run(&row.faults.replace("LAST", last), send(text.clone(), row.verify), row.timing);
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

#[test]
fn every_fault_is_told_in_process() {
    run_table("in process", |faults, task, timing| {
        let lathe = VirtualLathe::new(faults.parse().unwrap());
        outcome(start(task, Port::Virtual(lathe), timing))
    });
}

#[test]
fn a_peer_that_stops_reading_fails_the_send() {
    let lathe = VirtualLathe::new("stall@100".parse().unwrap());
    let outcome = outcome(start(send(program(12), false), Port::Virtual(lathe), SHORT));
    assert!(Expected::Failed("took no byte").is(&outcome), "{outcome:?}");
}

#[test]
fn a_paced_transfer_reports_its_progress() {
    let lathe = VirtualLathe::default();
    let mut request = request(send(program(12), true), Port::Virtual(lathe), PATIENT);
    request.unpaced = false;
    request.profile.baud = 19_200;
    let mut seen = Vec::new();
    let outcome = Job::start(request, &Cancel::default(), || ()).run_to_end(&mut |event| seen.push(event.clone()));
    assert_eq!(outcome, Outcome::Verified);
    let total = program(12).len() + 1;
    let progress: Vec<_> =
        seen.iter().filter_map(|e| if let Event::Progress(p) = e { Some(p) } else { None }).collect();
    assert!(
        progress
            .iter()
            .any(|p| (p.bytes, p.block, p.bytes_total, p.blocks_total) == (total, 12, Some(total), Some(12)))
    );
    assert!(progress.iter().all(|p| p.eta.is_some()));
    let states: Vec<_> = seen.iter().filter_map(|e| if let Event::State(s) = e { Some(*s) } else { None }).collect();
    assert_eq!(states, [State::Opening, State::Sending, State::WaitingForControl, State::Receiving]);
    let log: Vec<_> =
        seen.iter().filter_map(|e| if let Event::Log(l) = e { Some(l.to_string()) } else { None }).collect();
    assert!(log.iter().any(|line| line.contains("> ␂PAGE 01 POINT-TO-POINT.G00,G01␍␊")), "{log:?}");
    assert!(log.iter().any(|line| line.contains("< ␄")), "{log:?}");
}

#[test]
fn the_virtual_lathe_keeps_its_program_between_transfers() {
    let lathe = VirtualLathe::default();
    let run = |task| outcome(start(task, Port::Virtual(lathe.clone()), PATIENT));
    assert!(Expected::Failed("holds no program").is(&run(Task::Receive)));
    assert_eq!(run(send(program(3), false)), Outcome::SentNotVerified);
    assert_eq!(run(Task::Receive), Outcome::Received { text: program(3), problems: Vec::new() });
    assert_eq!(run(Task::Compare { sent: program(3) }), Outcome::Verified);
    assert!(matches!(run(Task::Compare { sent: program(2) }), Outcome::Different(_)));
}

#[test]
fn a_received_program_of_bad_form_is_no_good_outcome() {
    let lathe = VirtualLathe::new("answer-drop@5".parse().unwrap());
    let run = |task| outcome(start(task, Port::Virtual(lathe.clone()), PATIENT));
    assert_eq!(run(send(program(3), false)), Outcome::SentNotVerified);
    let received = run(Task::Receive);
    assert!(matches!(&received, Outcome::Received { problems, .. } if !problems.is_empty()), "{received:?}");
    assert!(!received.is_good());
}

#[test]
fn bad_texts_ports_and_settings_are_told_before_anything_is_sent() {
    let lathe = VirtualLathe::default();
    let virtual_port = || Port::Virtual(lathe.clone());
    let mut bad_line = request(Task::Receive, virtual_port(), PATIENT);
    bad_line.profile.baud = 0;
    let jobs = [
        ("character 189", start(send("\x02PAGE 01 ½\r\n".to_owned(), false), virtual_port(), PATIENT)),
        ("no page file", start(send("  1  INC\n".to_owned(), false), virtual_port(), PATIENT)),
        ("0 baud", Job::start(bad_line, &Cancel::default(), || ())),
        ("no-such-port", start(Task::Receive, Port::Serial("/dev/no-such-port".to_owned()), PATIENT)),
        ("/dev/null", start(Task::Receive, Port::Serial("/dev/null".to_owned()), PATIENT)),
    ];
    for (words, job) in jobs {
        let outcome = outcome(job);
        assert!(matches!(&outcome, Outcome::Failed(reason) if reason.contains(words)), "{words}: {outcome:?}");
    }
    assert_eq!(lathe.program(), None);
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
fn aborted(task: Task, port: Port) -> Outcome {
    let mut job = start(task, port, PATIENT);
    while let Some(Event::State(State::Opening)) | None = job.next(Duration::from_millis(50)) {}
    thread::sleep(Duration::from_millis(50));
    job.abort();
    outcome(job)
}

#[test]
fn abort_never_waits_for_the_port() {
    for reads in [false, true] {
        assert_eq!(aborted(send(program(12), true), Port::Open(Box::new(Blocked { reads }))), Outcome::Aborted);
    }
    let deaf = VirtualLathe::new("stall@1".parse().unwrap());
    assert_eq!(aborted(send(program(12), false), Port::Virtual(deaf)), Outcome::Aborted);
    let silent = VirtualLathe::new("silent".parse().unwrap());
    assert_eq!(aborted(Task::Receive, Port::Virtual(silent)), Outcome::Aborted);
}

#[test]
fn a_driver_that_never_returns_fails_without_an_abort() {
    let outcome = outcome(start(send(program(1), false), Port::Open(Box::new(Blocked { reads: false })), SHORT));
    assert!(Expected::Failed("took no byte").is(&outcome), "{outcome:?}");
}

#[cfg(all(unix, feature = "serial"))]
mod pseudo_terminal {
    use super::*;
    use std::sync::mpsc;
    use turnwright::transfer::virtual_lathe::{LatheEvent, PtyOptions, run_on_pty};

    /// Runs `use_port` while a lathe serves a pseudo-terminal; the lathe ends with it.
    fn with_lathe<T>(profile: &SerialProfile, options: PtyOptions, use_port: impl FnOnce(String) -> T) -> T {
        let cancel = Cancel::default();
        let (sender, ready) = mpsc::channel();
        let (for_lathe, profile) = (cancel.clone(), profile.clone());
        let lathe = thread::spawn(move || {
            let mut tell = |event| {
                if let LatheEvent::Ready { port } = event {
                    sender.send(port).unwrap();
                }
            };
            run_on_pty(&profile, &options, &mut tell, &for_lathe)
        });
        let result = use_port(ready.recv_timeout(HANG).expect("the lathe is ready"));
        cancel.cancel();
        assert_eq!(lathe.join().unwrap(), Ok(()));
        result
    }

    fn unpaced(faults: &str) -> PtyOptions {
        PtyOptions { faults: faults.parse().unwrap(), unpaced: true, link: None }
    }

    #[test]
    fn every_fault_is_told_on_a_pseudo_terminal() {
        run_table("pseudo-terminal", |faults, task, timing| {
            with_lathe(&profile(), unpaced(faults), |port| outcome(start(task, Port::Serial(port), timing)))
        });
    }

    #[test]
    fn send_then_receive_as_two_programs_through_a_link() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("lathe");
        std::os::unix::fs::symlink("/nowhere", &link).unwrap();
        let options = PtyOptions { link: Some(link.clone()), ..unpaced("") };
        with_lathe(&profile(), options, |port| {
            assert_eq!(port, link.display().to_string());
            let run = |task| outcome(start(task, Port::Serial(port.clone()), PATIENT));
            for pages in [12, 99] {
                assert_eq!(run(send(program(pages), false)), Outcome::SentNotVerified);
                assert_eq!(run(Task::Receive), Outcome::Received { text: program(pages), problems: Vec::new() });
            }
        });
        assert!(link.symlink_metadata().is_err(), "the link stays behind");
    }

    #[test]
    fn paced_on_both_sides() {
        let fast = SerialProfile { baud: 115_200, ..profile() };
        let mut request = request(send(program(12), true), Port::Serial(String::new()), PATIENT);
        request.profile = fast.clone();
        request.unpaced = false;
        let outcome = with_lathe(&fast, PtyOptions::default(), |port| {
            request.port = Port::Serial(port);
            outcome(Job::start(request, &Cancel::default(), || ()))
        });
        assert_eq!(outcome, Outcome::Verified);
    }

    #[test]
    fn an_old_answer_does_not_verify_a_new_program() {
        // So short that it is out in one write, before any old answer was read.
        let text = "\x02PAGE 01 END-PROGRAM..M02\r\n".to_owned();
        // The first program, the send key, and ten bytes of the second program.
        let options = unpaced(&format!("drop@{}", text.len() + 2 + 10));
        let second = with_lathe(&profile(), options, |port| {
            let run = |verify| outcome(start(send(text.clone(), verify), Port::Serial(port.clone()), PATIENT));
            assert_eq!(run(false), Outcome::SentNotVerified);
            let mut careless = serialport::new(&port, 2400).open().unwrap();
            assert_eq!(careless.write(&[0x11]).unwrap(), 1);
            thread::sleep(Duration::from_millis(100));
            drop(careless);
            run(true)
        });
        assert!(Expected::Different.is(&second), "{second:?}");
    }

    #[test]
    fn an_aborted_receive_leaves_nothing_that_passes_for_a_program() {
        with_lathe(&profile(), unpaced("delay=1ms"), |port| {
            let run = |task| outcome(start(task, Port::Serial(port.clone()), PATIENT));
            assert_eq!(run(send(program(60), false)), Outcome::SentNotVerified);
            let mut job = start(Task::Receive, Port::Serial(port.clone()), PATIENT);
            while job.next(HANG).is_some_and(|event| event != Event::State(State::Receiving)) {}
            job.abort();
            assert_eq!(outcome(job), Outcome::Aborted);
            let again = run(Task::Receive);
            let whole = Outcome::Received { text: program(60), problems: Vec::new() };
            assert!(again == whole || !again.is_good(), "{again:?}");
        });
    }

    #[test]
    fn a_link_never_replaces_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("notes.txt");
        std::fs::write(&link, "mine").unwrap();
        let options = PtyOptions { link: Some(link.clone()), ..unpaced("") };
        let refused = run_on_pty(&profile(), &options, &mut |_| (), &Cancel::default());
        assert!(refused.unwrap_err().contains("no symbolic link"));
        assert_eq!(std::fs::read_to_string(link).unwrap(), "mine");
    }

    #[test]
    fn settings_that_the_driver_did_not_take_are_told() {
        let log = with_lathe(&profile(), unpaced(""), |port| {
            let mut log = String::new();
            let job = start(send(program(1), false), Port::Serial(port), PATIENT);
            job.run_to_end(&mut |event| {
                if let Event::Log(line) = event {
                    log += &line.text;
                }
            });
            log
        });
        assert!(log.contains("did not take the number of data bits: Seven was asked for, Eight is set"), "{log}");
    }

    #[test]
    fn abort_never_waits_for_a_terminal_that_nobody_reads() {
        let (master, slave) = serialport::TTYPort::pair().unwrap();
        let port = serialport::SerialPort::name(&slave).unwrap();
        assert_eq!(aborted(send(program(3000), false), Port::Serial(port)), Outcome::Aborted);
        drop((master, slave));
    }
}
