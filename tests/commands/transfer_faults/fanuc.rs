//! A Fanuc: a tape read one way, punched the other.

use super::*;
use turnwright::machine::{EndOfBlock, FlowControl, Parity, Protocol, ReaderPunch};

const HABITS: ReaderPunch = ReaderPunch { end_of_block: EndOfBlock::Lf, tv_check: false, confirms_end: true };

pub(crate) fn profile() -> SerialProfile {
    with(HABITS)
}

fn with(habits: ReaderPunch) -> SerialProfile {
    SerialProfile {
        baud: 4800,
        data_bits: 7,
        parity: Parity::Even,
        stop_bits: 2,
        flow: FlowControl::Software,
        protocol: Protocol::FanucReaderPunch(habits),
    }
}

/// Blocks such as a form-roll's program has.
fn program(blocks: usize) -> String {
    let block = |n: usize| format!("N{}G1X-{:.3}Z{:.3}F0.10\n", n * 5, n as f64 * 0.8, 160.0 - n as f64 * 1.25);
    format!("O0201\nN0G21\n{}M30\n", (1..=blocks).map(block).collect::<String>())
}

/// Byte 1 is the key READ, `%` is byte 2, its line feed byte 3, the `O` byte 4; `LAST` is the closing `%`.
/// Where a reason is left open, it depends on how much was on its way when the control stopped.
const TABLE: &[Row] = &[
    row("", false, PATIENT, Expected::Sent),
    row("", true, PATIENT, Expected::Verified),
    row("drop@1", true, SHORT, Expected::Failed("did not start the transfer (DC1)")),
    row("drop@2", true, PATIENT, Expected::Verified),
    row("drop@3", true, PATIENT, Expected::Different),
    row("drop@100", true, PATIENT, Expected::Different),
    row("drop@LAST", true, SHORT, Expected::Failed("did not say (DC3)")),
    row("drop@LAST", false, SHORT, Expected::Failed("did not say (DC3)")),
    row("drop=1%,seed=7", true, PATIENT, Expected::Different),
    row("change@4", true, PATIENT, Expected::Different),
    row("change@250", true, PATIENT, Expected::Different),
    row("change@LAST", true, SHORT, Expected::Failed("did not say (DC3)")),
    row("change=1%,seed=7", true, PATIENT, Expected::Different),
    row("duplicate@2", true, PATIENT, Expected::Verified),
    row("duplicate@4", true, PATIENT, Expected::Different),
    row("duplicate@300", true, PATIENT, Expected::Different),
    row("duplicate@LAST", true, PATIENT, Expected::Verified),
    row("duplicate=1%,seed=7", true, PATIENT, Expected::Different),
    row("delay=1ms", true, PATIENT, Expected::Verified),
    row("late-dc3@8", true, PATIENT, Expected::Verified),
    row("late-dc3@17", true, SHORT, Expected::Failed("")),
    row("parity@250", true, SHORT, Expected::Failed("")),
    row("reset@250", true, SHORT, Expected::Failed("")),
    row("parity@LAST", true, SHORT, Expected::Failed("Nothing came from the control")),
    row("reset@LAST", true, PATIENT, Expected::Verified),
    row("answer-drop@1", true, PATIENT, Expected::Verified),
    row("answer-drop@2", true, PATIENT, Expected::Failed("instead of %")),
    row("answer-drop@3", true, PATIENT, Expected::Different),
    row("answer-drop@400", true, PATIENT, Expected::Different),
    row("answer-change@400", true, PATIENT, Expected::Different),
    row("answer-duplicate@400", true, PATIENT, Expected::Different),
    row("answer-parity@400", true, PATIENT, Expected::Failed("arrived as character 0")),
    row("answer-drop@LAST", true, PATIENT, Expected::Failed("before the closing %")),
    row("truncate@300", true, BROKEN_OFF, Expected::Failed("no end mark and nothing more")),
    row("silent", true, SHORT, Expected::Failed("did not start the transfer (DC1)")),
    row("silent", false, SHORT, Expected::Failed("did not start the transfer (DC1)")),
    row("stall@100", true, SHORT, Expected::Failed("")),
    row("stall@100", false, SHORT, Expected::Failed("")),
    row("unplug@1", true, PATIENT, Expected::Failed("unplugged")),
    row("unplug@500", true, PATIENT, Expected::Failed("unplugged")),
];

/// Runs the table for a program of 30 blocks.
pub(crate) fn table(medium: &str, run: impl Fn(&str, Task, Timing) -> Outcome + Sync) {
    let text = program(30);
    // The key and `%` with its line feed before the blocks, `%` after them.
    run_table(medium, TABLE, &text, text.len() + 4, run);
}

#[test]
fn every_fault_is_told_in_process() {
    table("Fanuc in process", |faults, task, timing| outcome(start(task, to_lathe(&profile(), faults), timing)));
}

#[test]
fn every_habit_of_a_control_verifies_and_is_received_as_it_was_written() {
    for end_of_block in [EndOfBlock::Lf, EndOfBlock::LfCrCr] {
        for tv_check in [false, true] {
            let profile = with(ReaderPunch { end_of_block, tv_check, ..HABITS });
            let lathe = VirtualLathe::default();
            let run = |task| outcome(start(task, line(VIRTUAL, &profile, &lathe), PATIENT));
            assert!(matches!(run(Task::Receive), Outcome::Failed(reason) if reason.contains("holds no program")));
            assert_eq!(run(send(program(20), true)), Outcome::Verified);
            let text = format!("%\n{}%\n", program(20));
            assert_eq!(run(Task::Receive), Outcome::Received { text: text.clone(), problems: Vec::new() });
            assert_eq!(run(compare(text)), Outcome::Verified);
            assert!(matches!(run(compare(program(21))), Outcome::Different(_)));
        }
    }
}

#[test]
fn a_lost_character_is_an_alarm_of_the_tv_check() {
    let profile = with(ReaderPunch { tv_check: true, ..HABITS });
    let failed = outcome(start(send(program(30), false), to_lathe(&profile, "drop@250"), SHORT));
    assert!(Expected::Failed("asked to wait (DC3)").is(&failed), "{failed:?}");
}

#[test]
fn a_control_that_does_not_confirm_the_end_is_believed_if_its_file_says_so() {
    let profile = with(ReaderPunch { confirms_end: false, ..HABITS });
    let last = program(3).len() + 4;
    let sent = outcome(start(send(program(3), false), to_lathe(&profile, &format!("drop@{last}")), PATIENT));
    assert_eq!(sent, Outcome::SentNotVerified);
}

#[test]
fn at_the_speed_of_the_line_the_sender_never_overruns_the_control() {
    // Slow, so that a busy computer has time enough between DC3 and the seventeenth character.
    let slow = SerialProfile { baud: 1200, ..profile() };
    let lathe = VirtualLathe::default();
    let mut request = request(send(program(6), false), line(VIRTUAL, &slow, &lathe), PATIENT);
    request.unpaced = false;
    let mut states = Vec::new();
    let outcome = Job::start(request, &Cancel::default(), || ()).run_to_end(&mut |event| {
        if let Event::State(state) = event {
            states.push(*state);
        }
    });
    assert_eq!(outcome, Outcome::SentNotVerified);
    assert_eq!(states, [State::Opening, State::WaitingForReader, State::Sending]);
    assert_eq!(lathe.program(), Some(program(6)));
}

#[test]
fn what_the_control_cannot_read_is_refused_before_anything_is_sent() {
    let lathe = VirtualLathe::default();
    for (text, words) in [("O1\nN5 g1\n", "Line 2, character 4: `g` is lower case"), ("", "no block")] {
        let refused = outcome(start(send(text.to_owned(), false), line(VIRTUAL, &profile(), &lathe), PATIENT));
        assert!(matches!(&refused, Outcome::Failed(reason) if reason.contains(words)), "{refused:?}");
    }
    assert_eq!(lathe.take_events(), []);
}

#[test]
fn abort_never_waits_for_the_control() {
    for reads in [false, true] {
        assert_eq!(aborted(send(program(12), true), to_link(&profile(), Blocked { reads })), Outcome::Aborted);
    }
    for faults in ["silent", "stall@50", "parity@50"] {
        assert_eq!(aborted(send(program(300), false), to_lathe(&profile(), faults)), Outcome::Aborted, "{faults}");
        assert_eq!(aborted(Task::Receive, to_lathe(&profile(), "silent")), Outcome::Aborted);
    }
}
