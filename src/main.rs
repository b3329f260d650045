//! The `turnwright` command: the window, or a headless command.

mod cli;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = cli::Arguments::parse();
    match arguments.command {
        Some(command) => cli::run(command).into(),
        None => window(arguments.file),
    }
}

/// Opens the window; without a display it says so in one line and names the headless command.
#[cfg(feature = "gui")]
fn window(file: Option<std::path::PathBuf>) -> ExitCode {
    match turnwright::app::run(file) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            cli::complain_line(&format!("{} Without a window use: {HEADLESS}", reason.trim_end()));
            ExitCode::from(2)
        }
    }
}

#[cfg(not(feature = "gui"))]
fn window(_file: Option<std::path::PathBuf>) -> ExitCode {
    cli::complain_line(&format!("This turnwright was built without its window. Use: {HEADLESS}"));
    ExitCode::from(2)
}

/// The command to name when there is no window.
const HEADLESS: &str = "turnwright build FILE --out DIR (see turnwright --help)";
