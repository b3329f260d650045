//! The files that a build writes: programs, contour, set-up, proof and a report over all of them.

mod contour;
mod report;
mod rolls;
mod setup;
mod shell;

use crate::post::Program;
use crate::proof;
use crate::regen::{self, Derived, SetupDerived};
use serde_json::Value;

/// A file to be written, by name in the output folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    /// File name with extension: `QUEEN1.cnc`.
    pub name: String,
    /// Its contents.
    pub text: String,
}

/// Every file of a build, the report last.
#[must_use]
pub fn files(derived: &Derived) -> Vec<OutputFile> {
    let mut files: Vec<OutputFile> = derived.setups.iter().flat_map(|s| setup_files(derived, s)).collect();
    files.extend(derived.shell.iter().flat_map(|made| shell::files(made)));
    files.extend(rolls::files(derived));
    files.push(OutputFile { name: "report.json".to_owned(), text: pretty(&report::report(derived)) });
    files
}

/// True if a diagnostic or a proof of `derived` is an error.
#[must_use]
pub fn has_errors(derived: &Derived) -> bool {
    crate::diagnostic::has_errors(&derived.diagnostics)
        || derived.setups.iter().any(|s| !s.proof.passed)
        || derived.shell.as_ref().is_some_and(|made| !made.proof.passed)
}

/// File name of a program. Those of form-rolls are called as the published ones: `NC1470b-2T.nc`.
fn program_file(derived: &Derived, program: &Program) -> String {
    let before = if derived.rolls.is_some() { "NC" } else { "" };
    format!("{before}{}.{}", program.name, program.extension)
}

fn setup_files(derived: &Derived, item: &SetupDerived) -> Vec<OutputFile> {
    let named =
        |ending: &str, value: &Value| OutputFile { name: format!("{}.{ending}", item.name), text: pretty(value) };
    let side = item.post.side_files.iter().map(|f| OutputFile { name: f.name.clone(), text: f.text.clone() });
    let programs = item
        .programs
        .iter()
        .zip(&item.post.programs)
        .map(|(text, program)| OutputFile { name: program_file(derived, program), text: text.text.clone() });
    let mut files: Vec<OutputFile> = side.chain(programs).collect();
    files.push(named("contour.json", &contour::contour(item)));
    files.push(named("setup.json", &setup::setup(derived, item)));
    if let Some(input) = regen::proof_input(derived, item) {
        files.push(OutputFile {
            name: format!("{}.proof.json", item.name),
            text: proof::proof_json(&input, &item.proof),
        });
    }
    files
}

fn pretty(value: &Value) -> String {
    // A `Value` has string keys and finite numbers only, so writing it cannot fail.
    let mut text = serde_json::to_string_pretty(value).unwrap_or_default();
    text.push('\n');
    text
}
