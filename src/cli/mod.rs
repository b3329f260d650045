//! The headless commands. Exit codes: 0 good, 1 it ran and found errors, 2 bad usage or unreadable input.

mod build;
mod convert;
mod list;
mod papers;
mod programs;
mod prove;
mod transfer;

use clap::{Parser, Subcommand};
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use turnwright::diagnostic::Diagnostic;
use turnwright::machine::{Catalog, Machine};

/// The command line.
#[derive(Debug, Parser)]
#[command(
    name = "turnwright",
    version,
    about = "Turned parts from a dragged dimension to a proved NC program on the lathe.",
    long_about = "Turned parts from a dragged dimension to a proved NC program on the lathe.\n\n\
        Without a command it opens the window, on FILE if one is given.",
    after_help = "Exit codes: 0 good, 1 it ran and found errors, 2 bad usage or unreadable input.",
    args_conflicts_with_subcommands = true
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    /// Document or importable file to open in the window.
    pub(crate) file: Option<PathBuf>,
}

/// The headless commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Make contour, set-up, programs, proof and report of a document or any importable file.
    Build(build::Build),
    /// Read a program as the lathe would, cut the bar with it and say what is wrong.
    Prove(prove::Prove),
    /// Send a program to a lathe.
    Send(transfer::Send),
    /// Receive a program from a lathe.
    Receive(transfer::Receive),
    /// Run a virtual lathe on a pseudo-terminal and print its port.
    Lathe(transfer::Lathe),
    /// Convert between documents, ORACAP part files, DXF, SVG, CSV and TSV.
    Convert(convert::Convert),
    /// Draw the finished part with its dimensions.
    Draw(papers::Draw),
    /// Write the setup sheet of every clamping.
    Sheet(papers::Sheet),
    /// List the machines.
    Machines(list::List),
    /// List the tools.
    Tools(list::List),
    /// List the materials.
    Materials(list::List),
}

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ending {
    /// Everything is good.
    Good,
    /// It ran and found errors.
    FoundErrors,
    /// Bad usage or unreadable input.
    Unusable,
}

impl From<Ending> for ExitCode {
    fn from(ending: Ending) -> Self {
        match ending {
            Ending::Good => Self::from(0),
            Ending::FoundErrors => Self::from(1),
            Ending::Unusable => Self::from(2),
        }
    }
}

/// Runs one command.
pub(crate) fn run(command: Command) -> Ending {
    let result = match command {
        Command::Build(args) => build::run(&args),
        Command::Prove(args) => prove::run(&args),
        Command::Send(args) => transfer::send(&args),
        Command::Receive(args) => transfer::receive(&args),
        Command::Lathe(args) => transfer::lathe(&args),
        Command::Convert(args) => convert::run(&args),
        Command::Draw(args) => papers::draw(&args),
        Command::Sheet(args) => papers::sheet(&args),
        Command::Machines(args) => list::machines(&args),
        Command::Tools(args) => list::tools(&args),
        Command::Materials(args) => list::materials(&args),
    };
    result.unwrap_or_else(|diagnostics| {
        complain(&diagnostics);
        Ending::Unusable
    })
}

/// A command ends well or badly, or its input cannot be used at all.
type Outcome = Result<Ending, Vec<Diagnostic>>;

/// Writes diagnostics to standard error, one a paragraph.
fn complain(diagnostics: &[Diagnostic]) {
    let mut out = io::stderr().lock();
    for diagnostic in diagnostics {
        // Nobody is left to tell if standard error itself is closed.
        let _ = writeln!(out, "{diagnostic}");
    }
}

/// Writes one line to standard error.
pub(crate) fn complain_line(line: &str) {
    // Nobody is left to tell if standard error itself is closed.
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// Writes to standard output; a closed pipe ends the output, not the command.
fn say(text: &str) {
    let mut out = io::stdout().lock();
    let _ = writeln!(out, "{text}").and_then(|()| out.flush());
}

/// The shipped data and the user's own; mistakes in the user's files are said, the rest is used.
fn catalog() -> Catalog {
    let (catalog, diagnostics) = Catalog::load(turnwright::storage::config_folder().as_deref());
    complain(&diagnostics);
    catalog
}

fn machine<'a>(catalog: &'a Catalog, id: &str) -> Result<&'a Machine, Vec<Diagnostic>> {
    catalog.machine(id).ok_or_else(|| {
        let known: Vec<&str> = catalog.machines.iter().map(|m| m.id.as_str()).collect();
        let at = turnwright::diagnostic::Place::Machine { id: id.to_owned() };
        vec![
            Diagnostic::error("unknown-machine", at, format!("There is no machine \"{id}\"."))
                .with_hint(format!("Known machines: {}.", known.join(", "))),
        ]
    })
}
