//! `lathe`, `send` and `receive` as a user runs them: two processes and a pseudo-terminal between them.

#![cfg(all(unix, feature = "serial"))]

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

fn turnwright() -> Command {
    Command::new(env!("CARGO_BIN_EXE_turnwright"))
}

/// The machine file of the ORAC with another way to its control, in a configuration folder of its own.
fn configuration(id: &str, serial: &str) -> tempfile::TempDir {
    let orac = include_str!("../../assets/machines/orac.toml").replace("id = \"orac\"", &format!("id = \"{id}\""));
    let (before, rest) = orac.split_once("[serial]").expect("the way to the control");
    let (_, after) = rest.split_once("[[tools]]").expect("tools after it");
    let folder = tempfile::tempdir().expect("a folder");
    let machines = folder.path().join("turnwright/machines");
    std::fs::create_dir_all(&machines).expect("made");
    let text = format!("{before}[serial]\n{serial}\n[[tools]]{after}");
    std::fs::write(machines.join("own.toml"), text).expect("written");
    folder
}

fn configured(configuration: Option<&tempfile::TempDir>) -> Command {
    let mut command = turnwright();
    if let Some(folder) = configuration {
        command.env("XDG_CONFIG_HOME", folder.path()).env("HOME", folder.path());
    }
    command
}

/// A virtual lathe in a process of its own; ends with the test.
struct Lathe {
    process: Child,
    port: String,
    machine: &'static str,
    configuration: Option<tempfile::TempDir>,
}

impl Lathe {
    fn start(faults: &str) -> Self {
        Self::of("orac", None, faults)
    }

    /// A machine of the test's own, played by the lathe and known to the commands that are run with it.
    fn of(machine: &'static str, configuration: Option<tempfile::TempDir>, faults: &str) -> Self {
        let mut process = configured(configuration.as_ref())
            .args(["lathe", "--machine", machine, "--unpaced", "--faults", faults])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the lathe starts");
        let mut port = String::new();
        let out = process.stdout.take().expect("its output");
        BufReader::new(out).read_line(&mut port).expect("the lathe prints its port");
        Self { process, port: port.trim().to_owned(), machine, configuration }
    }

    fn run(&self, args: &[&str]) -> Output {
        let line = ["--machine", self.machine, "--port", &self.port, "--unpaced", "--wait", "2"];
        configured(self.configuration.as_ref()).args(args).args(line).output().expect("the command runs")
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

#[test]
fn a_fanuc_reads_and_punches() {
    let serial = "protocol = \"fanuc-reader-punch\"\nbaud = 4800\ndata_bits = 7\nparity = \"even\"\nstop_bits = 2\n\
                  flow = \"software\"\nend_of_block = \"lf-cr-cr\"\ntv_check = true\nconfirms_end = true\n";
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("O0201.nc");
    std::fs::write(&program, "%\nO0201\nN10G21\nN15G50X-455.000Z320.000M08\nM30\n%\n").expect("written");
    let sent_as = program.display().to_string();
    let lathe = Lathe::of("own-fanuc", Some(configuration("own-fanuc", serial)), "");
    // The machine's programs are still read as those of an ORAC, so the proof cannot pass.
    let sent = lathe.run(&["send", &sent_as, "--verify", "--insist"]);
    let said = |output: &Output| {
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
    };
    assert!(sent.status.success(), "{}", said(&sent));
    assert!(said(&sent).starts_with("Verified"), "{}", said(&sent));
    let back = folder.path().join("back.nc");
    let received = lathe.run(&["receive", "--out", &back.display().to_string()]);
    assert!(received.status.success(), "{}", said(&received));
    assert_eq!(std::fs::read(back).expect("received"), std::fs::read(program).expect("sent"));

    let alarmed = Lathe::of("own-fanuc", Some(configuration("own-fanuc", serial)), "parity@20");
    let failed = alarmed.run(&["send", &sent_as, "--verify", "--insist"]);
    assert_eq!(failed.status.code(), Some(1), "{}", said(&failed));
}

#[test]
fn a_program_for_a_folder_is_saved_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let program = program(folder.path());
    let own = configuration("own-folder", "protocol = \"folder\"\nfolder = \"~/nc\"\nextension = \"ngc\"\n");
    let send = || {
        let args = ["send", &program, "--machine", "own-folder"];
        configured(Some(&own)).args(args).output().expect("the command runs")
    };
    let refused = send();
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stdout).contains("there is no folder"), "{refused:?}");
    std::fs::create_dir(own.path().join("nc")).expect("made");
    let saved = send();
    assert!(saved.status.success() && String::from_utf8_lossy(&saved.stdout).starts_with("Saved as"), "{saved:?}");
    let file = own.path().join("nc/QUEEN1.ngc");
    assert_eq!(std::fs::read(file).expect("saved"), std::fs::read(&program).expect("sent"));
}
