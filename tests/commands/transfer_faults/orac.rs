//! The ORAC: pages one way, and back.

use super::*;
use turnwright::machine::{FlowControl, PageMarks, Parity, Protocol};

pub(crate) fn profile() -> SerialProfile {
    SerialProfile {
        baud: 2400,
        data_bits: 7,
        parity: Parity::Odd,
        stop_bits: 1,
        flow: FlowControl::None,
        protocol: Protocol::OracPages(PageMarks { page_start: 2, end: 4 }),
    }
}

pub(crate) fn program(pages: usize) -> String {
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

/// `LAST` is the place of the end mark.
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
    row("parity@250", true, PATIENT, Expected::Failed("character 0")),
    row("answer-parity@250", true, PATIENT, Expected::Failed("character 0")),
    row("reset@250", true, PATIENT, Expected::Different),
    row("delay=2ms", true, PATIENT, Expected::Verified),
    row("answer-drop@1", true, PATIENT, Expected::Different),
    row("answer-drop@400", true, PATIENT, Expected::Different),
    row("answer-change@400", true, PATIENT, Expected::Different),
    row("answer-duplicate@400", true, PATIENT, Expected::Different),
    row("answer-drop@LAST", true, BROKEN_OFF, Expected::Failed("no end mark and nothing more")),
    row("truncate@300", true, BROKEN_OFF, Expected::Failed("stopped after 300 bytes")),
    row("silent", true, SHORT, Expected::Failed("Nothing came from the control")),
    row("stall@100", true, SHORT, Expected::Failed("")),
    row("unplug@1", true, PATIENT, Expected::Failed("unplugged")),
    row("unplug@500", true, PATIENT, Expected::Failed("unplugged")),
];

/// Runs the table for a program of 12 pages.
pub(crate) fn table(medium: &str, run: impl Fn(&str, Task, Timing) -> Outcome + Sync) {
    let text = program(12);
    run_table(medium, TABLE, &text, text.len() + 1, run);
}

#[test]
fn every_fault_is_told_in_process() {
    table("ORAC in process", |faults, task, timing| outcome(start(task, to_lathe(&profile(), faults), timing)));
}

#[test]
fn a_peer_that_stops_reading_fails_the_send() {
    let outcome = outcome(start(send(program(12), false), to_lathe(&profile(), "stall@100"), SHORT));
    assert!(Expected::Failed("took no byte").is(&outcome), "{outcome:?}");
}

#[test]
fn a_paced_transfer_reports_its_progress() {
    let fast = SerialProfile { baud: 19_200, ..profile() };
    let mut request = request(send(program(12), true), to_lathe(&fast, ""), PATIENT);
    request.unpaced = false;
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
    let run = |task| outcome(start(task, line(VIRTUAL, &profile(), &lathe), PATIENT));
    assert!(Expected::Failed("holds no program").is(&run(Task::Receive)));
    assert_eq!(run(send(program(3), false)), Outcome::SentNotVerified);
    assert_eq!(run(Task::Receive), Outcome::Received { text: program(3), problems: Vec::new() });
    assert_eq!(run(compare(program(3))), Outcome::Verified);
    assert!(matches!(run(compare(program(2))), Outcome::Different(_)));
}

#[test]
fn a_received_program_of_bad_form_is_no_good_outcome() {
    let lathe = VirtualLathe::new("answer-drop@5".parse().unwrap());
    let run = |task| outcome(start(task, line(VIRTUAL, &profile(), &lathe), PATIENT));
    assert_eq!(run(send(program(3), false)), Outcome::SentNotVerified);
    let received = run(Task::Receive);
    assert!(matches!(&received, Outcome::Received { problems, .. } if !problems.is_empty()), "{received:?}");
    assert!(!received.is_good());
}

#[test]
fn bad_texts_ports_and_settings_are_told_before_anything_is_sent() {
    let lathe = VirtualLathe::default();
    let to = |name| line(name, &profile(), &lathe);
    let bad_line = line(VIRTUAL, &SerialProfile { baud: 0, ..profile() }, &lathe);
    let jobs = [
        ("character 189", start(send("\x02PAGE 01 ½\r\n".to_owned(), false), to(VIRTUAL), PATIENT)),
        ("no page file", start(send("  1  INC\n".to_owned(), false), to(VIRTUAL), PATIENT)),
        ("0 bits/s", start(Task::Receive, bad_line, PATIENT)),
        ("no-such-port", start(Task::Receive, to("/dev/no-such-port"), PATIENT)),
        ("/dev/null", start(Task::Receive, to("/dev/null"), PATIENT)),
    ];
    for (words, job) in jobs {
        let outcome = outcome(job);
        assert!(matches!(&outcome, Outcome::Failed(reason) if reason.contains(words)), "{words}: {outcome:?}");
    }
    assert_eq!(lathe.program(), None);
}

#[test]
fn abort_never_waits_for_the_port() {
    for reads in [false, true] {
        assert_eq!(aborted(send(program(12), true), to_link(&profile(), Blocked { reads })), Outcome::Aborted);
    }
    assert_eq!(aborted(send(program(12), false), to_lathe(&profile(), "stall@1")), Outcome::Aborted);
    assert_eq!(aborted(Task::Receive, to_lathe(&profile(), "silent")), Outcome::Aborted);
}

#[test]
fn a_driver_that_never_returns_fails_without_an_abort() {
    let outcome = outcome(start(send(program(1), false), to_link(&profile(), Blocked { reads: false }), SHORT));
    assert!(Expected::Failed("took no byte").is(&outcome), "{outcome:?}");
}
