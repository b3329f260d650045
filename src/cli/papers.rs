//! `draw` and `sheet`: papers of a document.

use super::build::{derive, open};
use super::{Ending, Outcome, catalog, complain, say};
use clap::Args;
use std::path::{Path, PathBuf};
use turnwright::diagnostic::{Diagnostic, has_errors};
use turnwright::papers::{self, DrawingChoice, Paper, PaperKind};
use turnwright::regen::Derived;

/// Draw the finished part with its dimensions.
#[derive(Debug, Args)]
pub(crate) struct Draw {
    /// Document or importable file.
    file: PathBuf,
    /// Drawing: .pdf, .svg, .dxf or .plt (HP-GL).
    out: PathBuf,
    /// Of a set of form-rolls: the finished cross-section with the table of its elements, not the rolls.
    #[arg(long, conflicts_with_all = ["templates", "stations"])]
    section: bool,
    /// Of a set of form-rolls: the strip of every station, at most ten times its size.
    #[arg(long, conflicts_with = "stations")]
    templates: bool,
    /// Of a set of form-rolls: the rolls of every station with the strip between them.
    #[arg(long)]
    stations: bool,
    /// Paper, A4 to A0, landscape; without, the smallest that shows the part well.
    #[arg(long)]
    paper: Option<Paper>,
    /// Scale, such as 2 for 2:1 or 0.5 for 1:2; the largest usual one that fits without.
    #[arg(long)]
    scale: Option<f64>,
    /// Machine, where the file names none or another one is wanted.
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
}

/// Write the setup sheet: stock, holding, tools with pictures, operations, programs, times.
#[derive(Debug, Args)]
pub(crate) struct Sheet {
    /// Document or importable file.
    file: PathBuf,
    /// Sheet: .pdf with every page of every clamping, or .svg, .dxf or .plt with one numbered file a page.
    out: PathBuf,
    /// Machine, where the file names none or another one is wanted.
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
}

pub(super) fn draw(args: &Draw) -> Outcome {
    let choice = DrawingChoice { paper: args.paper, scale: args.scale };
    let kind = match (args.section, args.templates, args.stations) {
        (true, ..) => PaperKind::Section(choice),
        (_, true, _) => PaperKind::Templates(choice),
        (.., true) => PaperKind::Stations(choice),
        _ => PaperKind::Drawing(choice),
    };
    let derived = make(kind, &args.file, args.machine.as_deref(), &args.out)?;
    Ok(if has_errors(&derived.diagnostics) { Ending::FoundErrors } else { Ending::Good })
}

pub(super) fn sheet(args: &Sheet) -> Outcome {
    let derived = make(PaperKind::SetupSheet, &args.file, args.machine.as_deref(), &args.out)?;
    Ok(if turnwright::output::has_errors(&derived) { Ending::FoundErrors } else { Ending::Good })
}

/// Makes and writes papers of a file, and says where they are.
fn make(kind: PaperKind, file: &Path, machine: Option<&str>, out: &Path) -> Result<Derived, Vec<Diagnostic>> {
    let catalog = catalog();
    let derived = derive(&open(file, machine, &catalog)?, &catalog)?;
    complain(&derived.diagnostics);
    let pages = kind.pages(&derived, &catalog).map_err(|d| vec![d])?;
    for written in papers::save(out, &pages).map_err(|d| vec![d])? {
        say(&written.display().to_string());
    }
    Ok(derived)
}
