//! `send`, `receive`, `lathe`.

use super::prove::{input_for_machine, read_program};
use super::{Ending, Outcome as CommandOutcome, catalog, complain_line, machine, say};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::{Diagnostic, Place, Severity};
use turnwright::machine::{Delivery, Machine};
use turnwright::proof::{self, ProofInput};
use turnwright::storage;
use turnwright::transfer::commands::{self, Line};
use turnwright::transfer::{Event, Outcome, Timing};

/// Send a program, and with --verify wait until it comes back and compare.
#[derive(Debug, Args)]
pub(crate) struct Send {
    /// Program: pages (.cnc) for an ORAC, word-address text for other controls.
    program: PathBuf,
    #[command(flatten)]
    line: LineArgs,
    /// Wait until the lathe sends the program back, and compare.
    #[arg(long)]
    verify: bool,
    /// Send it although the proof found errors.
    #[arg(long)]
    insist: bool,
}

/// Receive a program; start the transfer at the lathe.
#[derive(Debug, Args)]
pub(crate) struct Receive {
    #[command(flatten)]
    line: LineArgs,
    /// File for the program.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// The line to the lathe.
#[derive(Debug, Args)]
struct LineArgs {
    /// Machine whose line settings are used.
    #[arg(long, value_name = "ID")]
    machine: String,
    /// Serial port, or `virtual` for the virtual lathe in this process. For a machine that takes its programs from a
    /// folder: that folder; by default the one of the machine's file.
    #[arg(long)]
    port: Option<String>,
    /// Do not keep to the speed of the line.
    #[arg(long)]
    unpaced: bool,
    /// How long to wait for the lathe's first character, s.
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    wait: u64,
}

/// Run a virtual lathe on a pseudo-terminal.
#[derive(Debug, Args)]
pub(crate) struct Lathe {
    /// Machine that the lathe plays.
    #[arg(long, value_name = "ID")]
    machine: String,
    /// Symbolic link to make to the port.
    #[arg(long, value_name = "PATH")]
    link: Option<PathBuf>,
    /// What goes wrong: drop@N, change@N, duplicate@N, parity@N, delay=T, stall@N, unplug@N, reset@N, late-dc3@N, silent,
    /// truncate@N, separated by commas.
    #[arg(long, value_name = "SPEC", default_value = "")]
    faults: String,
    /// Do not keep to the speed of the line.
    #[arg(long)]
    unpaced: bool,
}

pub(super) fn send(args: &Send) -> CommandOutcome {
    let catalog = catalog();
    let machine = machine(&catalog, &args.line.machine)?;
    let program = read_program(&args.program).map_err(|d| vec![d])?;
    let input = ProofInput { programs: Arc::new(vec![program.clone()]), ..input_for_machine(machine, &catalog) };
    let report = proof::prove(&input, &Cancel::default())
        .map_err(|e| vec![Diagnostic::error("cancelled", Place::Document, e.to_string())])?;
    if !report.passed && !args.insist {
        for finding in report.findings.iter().filter(|f| f.severity == Severity::Error) {
            complain_line(&format!("{} block {}: {}", finding.program, finding.block, finding.message));
        }
        complain_line("Not sent: the proof found errors. Correct the program, or insist with --insist.");
        return Ok(Ending::FoundErrors);
    }
    let line = line(&args.line, machine)?;
    let outcome = watched(|on_event| {
        commands::send(&program.name, &program.text, args.verify, line, on_event, &Cancel::default())
    });
    Ok(ended(&outcome))
}

pub(super) fn receive(args: &Receive) -> CommandOutcome {
    let catalog = catalog();
    let machine = machine(&catalog, &args.line.machine)?;
    let line = line(&args.line, machine)?;
    let outcome = watched(|on_event| commands::receive(line, on_event, &Cancel::default()));
    if let Outcome::Received { text, .. } = &outcome {
        storage::replace_file(&args.out, text.as_bytes()).map_err(|d| vec![d])?;
    }
    Ok(ended(&outcome))
}

#[cfg(all(unix, feature = "serial"))]
pub(super) fn lathe(args: &Lathe) -> CommandOutcome {
    use turnwright::transfer::virtual_lathe::{FaultSpec, LatheEvent, PtyOptions};
    let catalog = catalog();
    let machine = machine(&catalog, &args.machine)?;
    let unusable = |message: String| vec![Diagnostic::error("virtual-lathe", Place::Document, message)];
    let Delivery::Line(profile) = &machine.serial else {
        let message = format!("{} takes its programs from a folder; there is no line to play.", machine.name);
        return Err(unusable(message));
    };
    let faults = args.faults.parse::<FaultSpec>().map_err(|e| unusable(e.to_string()))?;
    let options = PtyOptions { link: args.link.clone(), faults, unpaced: args.unpaced };
    let mut tell = |event: LatheEvent| match event {
        LatheEvent::Ready { port } => say(&port),
        other => complain_line(&other.to_string()),
    };
    commands::lathe(profile, &options, &mut tell, &Cancel::default()).map_err(unusable)?;
    Ok(Ending::Good)
}

#[cfg(not(all(unix, feature = "serial")))]
pub(super) fn lathe(_args: &Lathe) -> CommandOutcome {
    let message = "A virtual lathe for other programs needs pseudo-terminals, which this build has not.";
    Err(vec![
        Diagnostic::error("virtual-lathe", Place::Document, message)
            .with_hint("Use `--port virtual` with send: the virtual lathe in the same process."),
    ])
}

fn line<'a>(args: &'a LineArgs, machine: &'a Machine) -> Result<Line<'a>, Vec<Diagnostic>> {
    let port = match (&args.port, &machine.serial) {
        (Some(port), _) => port,
        (None, Delivery::Folder(profile)) => &profile.folder,
        (None, Delivery::Line(_)) => {
            let message = format!("The line to {} needs a port.", machine.name);
            return Err(vec![
                Diagnostic::error("no-port", Place::Document, message)
                    .with_hint("Give it with --port, or use `--port virtual`."),
            ]);
        }
    };
    let timing = Timing { first: Duration::from_secs(args.wait), ..Timing::default() };
    Ok(Line { port, delivery: &machine.serial, unpaced: args.unpaced, timing })
}

/// Runs a transfer with a progress bar and the log on standard error.
fn watched(transfer: impl FnOnce(&mut dyn FnMut(&Event)) -> Outcome) -> Outcome {
    let bar = ProgressBar::no_length();
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {bytes}/{total_bytes} {msg}") {
        bar.set_style(style);
    }
    let outcome = transfer(&mut |event| match event {
        Event::State(state) => bar.set_message(state.to_string()),
        Event::Progress(progress) => {
            if let Some(total) = progress.bytes_total {
                bar.set_length(total as u64);
            }
            bar.set_position(progress.bytes as u64);
        }
        Event::Log(line) => bar.suspend(|| complain_line(&line.to_string())),
        Event::Done(_) => {}
    });
    bar.finish_and_clear();
    outcome
}

fn ended(outcome: &Outcome) -> Ending {
    say(&outcome.to_string());
    if outcome.is_good() { Ending::Good } else { Ending::FoundErrors }
}
