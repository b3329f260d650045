//! `convert`: one file format to another.

use super::{Ending, Outcome, build, catalog, complain, programs};
use clap::Args;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use turnwright::diagnostic::{Diagnostic, has_errors};
use turnwright::document::Document;
use turnwright::storage;
use turnwright::storage::import::MidLineThickness;

/// Convert between file formats by the files' extensions.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// Document (.turn), ORACAP part (.cad), DXF profile, TSV section table, roll profile in E layout (.txt), published
    /// input of a finished section (.json), or ORAC program (.cnc, .anc, .bnc).
    input: PathBuf,
    /// .turn, .cad (with .SIZ and .END), .dxf, .svg, .csv or .tsv; of a program .cnc or .bnc.
    output: PathBuf,
    /// Machine, where the input names none.
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
    /// Cutting instructions for the published form-roll cycles (CU data, .json); their element numbers are row numbers.
    #[arg(long, value_name = "FILE")]
    instructions: Option<PathBuf>,
    /// Published input of the flower (.json) for a set of form-rolls.
    #[arg(long, value_name = "FILE")]
    flower: Option<PathBuf>,
    /// Published input of the roll design (.json) for a set of form-rolls.
    #[arg(long, value_name = "FILE")]
    design: Option<PathBuf>,
    /// The .dxf drawing is the cross-section of a set of form-rolls: its closed outline, or its mid-line with --thickness.
    #[arg(long)]
    section: bool,
    /// Thickness of the strip for --section, in the unit of the drawing.
    #[arg(long, value_name = "LENGTH", requires = "section")]
    thickness: Option<f64>,
}

pub(super) fn run(args: &Convert) -> Outcome {
    if programs::is_program(&args.input) {
        programs::convert(&args.input, &args.output)?;
        return Ok(Ending::Good);
    }
    let catalog = catalog();
    let document = if args.section {
        let thickness = args.thickness.map_or(MidLineThickness::Unknown, MidLineThickness::OfDrawing);
        let (document, diagnostics) = storage::import::section_drawing(&args.input, thickness)?;
        complain(&diagnostics);
        Arc::new(document)
    } else {
        build::open(&args.input, args.machine.as_deref(), &catalog)?
    };
    let document = match &args.flower {
        Some(file) => with_more(&document, file, storage::import::with_flower)?,
        None => document,
    };
    let document = match &args.design {
        Some(file) => with_more(&document, file, storage::import::with_design)?,
        None => document,
    };
    let document = match &args.instructions {
        Some(file) => with_more(&document, file, storage::import::with_instructions)?,
        None => document,
    };
    let diagnostics = storage::export::any(&document, &catalog, &args.output)?;
    complain(&diagnostics);
    Ok(if has_errors(&diagnostics) { Ending::FoundErrors } else { Ending::Good })
}

/// Reads a file that adds to a document.
type Addition = fn(Document, &Path) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>>;

/// The document with what another file adds to it.
fn with_more(document: &Document, file: &Path, add: Addition) -> Result<Arc<Document>, Vec<Diagnostic>> {
    let (document, diagnostics) = add(document.clone(), file)?;
    complain(&diagnostics);
    Ok(Arc::new(document))
}
