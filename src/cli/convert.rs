//! `convert`: one file format to another.

use super::{Ending, Outcome, build, catalog, complain, programs};
use clap::Args;
use std::path::PathBuf;
use turnwright::diagnostic::has_errors;
use turnwright::storage;

/// Convert between file formats by the files' extensions.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// Document (.turn), ORACAP part (.cad), DXF profile, TSV section table, or ORAC program (.cnc, .anc, .bnc).
    input: PathBuf,
    /// .turn, .cad (with .SIZ and .END), .dxf, .svg, .csv or .tsv; of a program .cnc or .bnc.
    output: PathBuf,
    /// Machine, where the input names none.
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
}

pub(super) fn run(args: &Convert) -> Outcome {
    if programs::is_program(&args.input) {
        programs::convert(&args.input, &args.output)?;
        return Ok(Ending::Good);
    }
    let catalog = catalog();
    let document = build::open(&args.input, args.machine.as_deref(), &catalog)?;
    let diagnostics = storage::export::any(&document, &catalog, &args.output)?;
    complain(&diagnostics);
    Ok(if has_errors(&diagnostics) { Ending::FoundErrors } else { Ending::Good })
}
