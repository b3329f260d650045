//! `lathe`, `send` and `receive` as a user runs them: two processes and a pseudo-terminal between them.

#![cfg(all(unix, feature = "serial"))]
#![allow(clippy::expect_used, reason = "a test stops where what it needs is not there")]

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

fn turnwright() -> Command {
    Command::new(env!("CARGO_BIN_EXE_turnwright"))
}

/// A virtual lathe in a process of its own; ends with the test.
struct Lathe {
    process: Child,
    port: String,
}

impl Lathe {
    fn start(faults: &str) -> Self {
        let mut process = turnwright()
            .args(["lathe", "--machine", "orac", "--unpaced", "--faults", faults])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the lathe starts");
        let mut port = String::new();
        let out = process.stdout.take().expect("its output");
        BufReader::new(out).read_line(&mut port).expect("the lathe prints its port");
        Self { process, port: port.trim().to_owned() }
    }

    fn run(&self, args: &[&str]) -> Output {
        let line = ["--machine", "orac", "--port", &self.port, "--unpaced", "--wait", "2"];
        turnwright().args(args).args(line).output().expect("the command runs")
    }
}

impl Drop for Lathe {
    fn drop(&mut self) {
        // A lathe that has ended already, as when unplugged, needs no ending.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The pages of the chess queen's first program.
fn program(folder: &Path) -> String {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples/queen.turn");
    let built = turnwright().arg("build").arg(example).arg("--out").arg(folder).output().expect("build runs");
    assert!(built.status.success());
    folder.join("QUEEN1.cnc").display().to_string()
}

#[test]
fn a_program_goes_to_the_lathe_and_comes_back_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let (program, lathe) = (program(folder.path()), Lathe::start(""));
    let sent = lathe.run(&["send", &program, "--verify"]);
    assert!(sent.status.success(), "{}", String::from_utf8_lossy(&sent.stdout));
    assert!(String::from_utf8_lossy(&sent.stdout).starts_with("Verified"));
    let back = folder.path().join("back.cnc");
    let received = lathe.run(&["receive", "--out", &back.display().to_string()]);
    assert!(received.status.success(), "{}", String::from_utf8_lossy(&received.stdout));
    assert_eq!(std::fs::read(back).expect("received"), std::fs::read(program).expect("sent"));
}

#[test]
fn without_a_compare_nothing_is_called_verified() {
    let folder = tempfile::tempdir().expect("a folder");
    let (program, lathe) = (program(folder.path()), Lathe::start(""));
    let sent = lathe.run(&["send", &program]);
    assert_eq!(String::from_utf8_lossy(&sent.stdout).trim(), "Sent, not verified.");
}

#[test]
fn no_fault_ends_in_silent_success() {
    let folder = tempfile::tempdir().expect("a folder");
    let program = program(folder.path());
    for faults in ["drop@100", "change@2500", "duplicate@700", "silent", "unplug@500", "truncate@300"] {
        let sent = Lathe::start(faults).run(&["send", &program, "--verify"]);
        assert_eq!(sent.status.code(), Some(1), "{faults}: {}", String::from_utf8_lossy(&sent.stdout));
    }
}

#[test]
fn a_program_that_fails_its_proof_is_sent_only_on_insistence() {
    let folder = tempfile::tempdir().expect("a folder");
    let good = std::fs::read_to_string(program(folder.path())).expect("the program");
    let bad = folder.path().join("BAD.cnc");
    std::fs::write(&bad, good.replacen("FEEDRATE   80", "FEEDRATE 9000", 1)).expect("written");
    let (bad, lathe) = (bad.display().to_string(), Lathe::start(""));
    let refused = lathe.run(&["send", &bad]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("9000 mm/min"), "{:?}", refused.stderr);
    assert_eq!(lathe.run(&["send", &bad, "--insist"]).status.code(), Some(0));
}
