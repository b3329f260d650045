//! `convert`: one file format to another.

use super::{Ending, Outcome, build, catalog, complain, programs};
use clap::Args;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use turnwright::diagnostic::{Diagnostic, has_errors};
use turnwright::document::Document;
use turnwright::storage;

/// Convert between file formats by the files' extensions.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// Document (.turn), ORACAP part (.cad), DXF profile, TSV section table, roll profile in E layout (.txt), or ORAC
    /// program (.cnc, .anc, .bnc).
    input: PathBuf,
    /// .turn, .cad (with .SIZ and .END), .dxf, .svg, .csv or .tsv; of a program .cnc or .bnc.
    output: PathBuf,
    /// Machine, where the input names none.
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
    /// Cutting instructions for the published form-roll cycles (CU data, .json); their element numbers are row numbers.
    #[arg(long, value_name = "FILE")]
    instructions: Option<PathBuf>,
}

pub(super) fn run(args: &Convert) -> Outcome {
    if programs::is_program(&args.input) {
        programs::convert(&args.input, &args.output)?;
        return Ok(Ending::Good);
    }
    let catalog = catalog();
    let document = build::open(&args.input, args.machine.as_deref(), &catalog)?;
    let document = match &args.instructions {
        Some(file) => instructed(&document, file)?,
        None => document,
    };
    let diagnostics = storage::export::any(&document, &catalog, &args.output)?;
    complain(&diagnostics);
    Ok(if has_errors(&diagnostics) { Ending::FoundErrors } else { Ending::Good })
}

/// The document with the cutting instructions of a CU file.
fn instructed(document: &Document, file: &Path) -> Result<Arc<Document>, Vec<Diagnostic>> {
    let (document, diagnostics) = storage::import::with_instructions(document.clone(), file)?;
    complain(&diagnostics);
    Ok(Arc::new(document))
}
