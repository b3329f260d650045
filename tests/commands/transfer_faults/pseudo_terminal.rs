//! The same across a pseudo-terminal, as two programs.

use super::fanuc;
use super::orac::{self, profile, program};
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

fn to_port(port: &str, profile: &SerialProfile) -> Target {
    line(port, profile, &VirtualLathe::default())
}

fn unpaced(faults: &str) -> PtyOptions {
    PtyOptions { faults: faults.parse().unwrap(), unpaced: true, link: None }
}

/// Runs a row of a table.
fn on_terminal(profile: &SerialProfile, faults: &str, task: Task, timing: Timing) -> Outcome {
    with_lathe(profile, unpaced(faults), |port| outcome(start(task, to_port(&port, profile), timing)))
}

#[test]
fn every_fault_is_told_on_a_pseudo_terminal() {
    let profile = profile();
    orac::table("ORAC on a pseudo-terminal", |faults, task, timing| on_terminal(&profile, faults, task, timing));
}

#[test]
fn every_fault_of_a_fanuc_is_told_on_a_pseudo_terminal() {
    let profile = fanuc::profile();
    fanuc::table("Fanuc on a pseudo-terminal", |faults, task, timing| on_terminal(&profile, faults, task, timing));
}

#[test]
fn send_then_receive_as_two_programs_through_a_link() {
    let folder = tempfile::tempdir().unwrap();
    let link = folder.path().join("lathe");
    std::os::unix::fs::symlink("/nowhere", &link).unwrap();
    let options = PtyOptions { link: Some(link.clone()), ..unpaced("") };
    with_lathe(&profile(), options, |port| {
        assert_eq!(port, link.display().to_string());
        let run = |task| outcome(start(task, to_port(&port, &profile()), PATIENT));
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
    let outcome = with_lathe(&fast, PtyOptions::default(), |port| {
        let request = request(send(program(12), true), to_port(&port, &fast), PATIENT);
        outcome(Job::start(Request { unpaced: false, ..request }, &Cancel::default(), || ()))
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
        let run = |verify| outcome(start(send(text.clone(), verify), to_port(&port, &profile()), PATIENT));
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
        let run = |task| outcome(start(task, to_port(&port, &profile()), PATIENT));
        assert_eq!(run(send(program(60), false)), Outcome::SentNotVerified);
        let mut job = start(Task::Receive, to_port(&port, &profile()), PATIENT);
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
        let job = start(send(program(1), false), to_port(&port, &profile()), PATIENT);
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
    assert_eq!(aborted(send(program(3000), false), to_port(&port, &profile())), Outcome::Aborted);
    drop((master, slave));
}
