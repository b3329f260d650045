//! `build`: every file of a document.

use super::{Ending, Outcome, catalog, complain, machine, say};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::{Diagnostic, Place, Severity};
use turnwright::document::Document;
use turnwright::machine::Catalog;
use turnwright::output::{self, OutputFile};
use turnwright::papers::{self, DrawingChoice, PaperKind};
use turnwright::regen::{self, Cache, Derived, SetupDerived, ShellDerived};
use turnwright::storage;

/// Make contour, set-up, programs, proof and report.
#[derive(Debug, Args)]
pub(crate) struct Build {
    /// Document (.turn), ORACAP part (.cad), DXF profile or TSV section table.
    file: PathBuf,
    /// Folder for the files; made if it is not there.
    #[arg(long)]
    out: PathBuf,
    /// Machine, where the file names none or another one is wanted.
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
}

pub(super) fn run(args: &Build) -> Outcome {
    let catalog = catalog();
    let document = open(&args.file, args.machine.as_deref(), &catalog)?;
    let derived = derive(&document, &catalog)?;
    let files = output::files(&derived);
    write_all(&args.out, &files)?;
    write_papers(&args.out, &derived, &catalog)?;
    complain(&derived.diagnostics);
    derived.setups.iter().for_each(report_setup);
    derived.shell.iter().for_each(|made| report_shell(made));
    say(&format!("{} files in {}", files.len(), args.out.display()));
    Ok(if output::has_errors(&derived) { Ending::FoundErrors } else { Ending::Good })
}

/// Opens a document or imports a file; with `machine_id` the part is made on that machine.
pub(super) fn open(file: &Path, machine_id: Option<&str>, catalog: &Catalog) -> Result<Arc<Document>, Vec<Diagnostic>> {
    /// The machine of an imported file that names none.
    const DEFAULT_MACHINE: &str = "orac";
    if let Some(id) = machine_id {
        machine(catalog, id)?;
    }
    let (mut document, diagnostics) = storage::import::any(file, machine_id.unwrap_or(DEFAULT_MACHINE))?;
    complain(&diagnostics);
    if let Some(id) = machine_id {
        id.clone_into(document.content.machine_mut());
    }
    Ok(Arc::new(document))
}

/// Regenerates a document once; without a machine nothing can be made of it.
pub(super) fn derive(document: &Arc<Document>, catalog: &Catalog) -> Result<Derived, Vec<Diagnostic>> {
    let bar = ProgressBar::new_spinner().with_style(ProgressStyle::default_spinner());
    bar.set_message(format!("{}: paths, programs and proof", document.name));
    bar.enable_steady_tick(std::time::Duration::from_millis(100));
    let derived = regen::regenerate(document, catalog, &mut Cache::default(), &Cancel::default());
    bar.finish_and_clear();
    match derived {
        Ok(derived) if derived.machine.is_some() => Ok(derived),
        Ok(derived) => Err(derived.diagnostics),
        Err(cancelled) => Err(vec![Diagnostic::error("cancelled", Place::Document, cancelled.to_string())]),
    }
}

fn report_shell(made: &ShellDerived) {
    let programs: Vec<String> =
        made.post.programs.iter().map(|p| format!("{} ({} blocks)", p.name, p.blocks.len())).collect();
    let verdict = if made.proof.passed { "proved" } else { "NOT PROVED" };
    let thinnest = made.shape.thinnest().map_or(0.0, |s| s.wall);
    say(&format!(
        "{}: {verdict}, {}, {:.1} min, wall down to {thinnest:.3} mm, blank ⌀ {:.2} mm, gap within {:.3} mm of the wall, \
         {} set points",
        made.name,
        programs.join(", "),
        made.proof.times.total_s / 60.0,
        2.0 * made.shape.blank_radius,
        made.proof.tightest_mm.abs().max(made.proof.widest_mm.abs()),
        made.set_points.len(),
    ));
}

fn write_all(folder: &Path, files: &[OutputFile]) -> Result<(), Vec<Diagnostic>> {
    let failed = |path: &Path, error: &std::io::Error| {
        let at = Place::File { file: path.display().to_string() };
        vec![Diagnostic::error("cannot-write", at, format!("The file cannot be written: {error}."))]
    };
    std::fs::create_dir_all(folder).map_err(|e| failed(folder, &e))?;
    for file in files {
        let path = folder.join(&file.name);
        std::fs::write(&path, &file.text).map_err(|e| failed(&path, &e))?;
    }
    Ok(())
}

/// Writes the drawing of every roll of a set and its parts list, and drawing and setup sheet of a shell, as PDF. Turned parts
/// have their papers by `draw` and `sheet`.
fn write_papers(folder: &Path, derived: &Derived, catalog: &Catalog) -> Result<(), Vec<Diagnostic>> {
    let save = |name: &str, kind: PaperKind, of: &Derived| -> Result<(), Vec<Diagnostic>> {
        let written = kind.pages(of, catalog).and_then(|pages| papers::save(&folder.join(name), &pages));
        written.map(|_| ()).map_err(|d| vec![d])
    };
    if let Some(made) = &derived.shell {
        save(&format!("{}.drawing.pdf", made.name), PaperKind::Drawing(DrawingChoice::default()), derived)?;
        save(&format!("{}.sheet.pdf", made.name), PaperKind::SetupSheet, derived)?;
    }
    let Some(set) = &derived.rolls else { return Ok(()) };
    for roll in &set.rolls {
        save(&format!("{}.pdf", roll.name), PaperKind::Drawing(DrawingChoice::default()), &roll.derived)?;
    }
    save(&format!("{}.parts.pdf", derived.document.name), PaperKind::PartsList, derived)
}

fn report_setup(item: &SetupDerived) {
    for finding in item.proof.findings.iter().filter(|f| f.severity != Severity::Info) {
        say(&format!("{} block {}: {}: {}", finding.program, finding.block, finding.severity, finding.message));
    }
    let programs: Vec<String> =
        item.post.programs.iter().map(|p| format!("{} ({} blocks)", p.name, p.blocks.len())).collect();
    let verdict = if item.proof.passed { "proved" } else { "NOT PROVED" };
    say(&format!(
        "{}: {verdict}, {}, {:.1} min, deepest gouge {:.3} mm, largest chip {:.4} mm²",
        item.name,
        programs.join(", "),
        item.proof.times.total_s / 60.0,
        item.proof.deepest_gouge_mm,
        item.proof.largest_chip_mm2,
    ));
}
