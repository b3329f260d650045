//! `convert` for ORAC programs: instructions to pages and back, and the published shortening.

use std::path::Path;
use turnwright::diagnostic::{Diagnostic, Place, has_errors};
use turnwright::post::orac::{compress, instructions_text, optimize, parse_instructions};
use turnwright::storage;

/// The three forms of an ORAC program, by file extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// `.anc`: instructions as generated.
    Generated,
    /// `.bnc`: instructions, shortened.
    Optimized,
    /// `.cnc`: pages for the lathe.
    Pages,
}

impl Form {
    fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "anc" => Some(Self::Generated),
            "bnc" => Some(Self::Optimized),
            "cnc" => Some(Self::Pages),
            _ => None,
        }
    }
}

/// True if the file's extension is that of an ORAC program.
pub(super) fn is_program(path: &Path) -> bool {
    Form::of(path).is_some()
}

/// Converts one form into another: `.anc` to `.bnc` shortens by the published rules, to `.cnc` assembles, from `.cnc` compresses.
pub(super) fn convert(input: &Path, output: &Path) -> Result<(), Vec<Diagnostic>> {
    let at = |path: &Path| Place::File { file: path.display().to_string() };
    let (Some(from), Some(to)) = (Form::of(input), Form::of(output)) else {
        let message = "A program can be converted to .anc, .bnc or .cnc only.";
        return Err(vec![Diagnostic::error("conversion", at(output), message)]);
    };
    let program = storage::read_program(input).map_err(|d| vec![d])?;
    let name = input.display().to_string();
    let (instructions, diagnostics) =
        if from == Form::Pages { compress(&program, &name) } else { parse_instructions(&program, &name) };
    if has_errors(&diagnostics) {
        return Err(diagnostics);
    }
    let text = match (from, to) {
        (_, Form::Pages) => storage::assembled(instructions),
        (Form::Generated, Form::Optimized) => instructions_text(&optimize(&instructions)),
        _ => instructions_text(&instructions),
    };
    storage::replace_file(output, text.as_bytes()).map_err(|d| vec![d])
}
