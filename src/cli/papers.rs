//! `draw` and `sheet`: papers of a document.

use super::build::{derive, open};
use super::{Ending, Outcome, catalog, complain, say};
use clap::Args;
use std::path::{Path, PathBuf};
use turnwright::diagnostic::{Diagnostic, Place, has_errors};
use turnwright::papers::{self, DrawingChoice, Paper, PaperKind};
use turnwright::regen::{Derived, RollDerived};

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
    /// Of a set of form-rolls: one roll alone, such as 2T; all of them without.
    #[arg(long, conflicts_with_all = ["section", "templates", "stations"])]
    roll: Option<String>,
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
    /// Of a set of form-rolls: one roll alone, such as 2T; all of them without.
    #[arg(long)]
    roll: Option<String>,
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
    let made =
        Made { kind, file: &args.file, machine: args.machine.as_deref(), out: &args.out, roll: args.roll.as_deref() };
    let derived = make(&made)?;
    Ok(if has_errors(&derived.diagnostics) { Ending::FoundErrors } else { Ending::Good })
}

pub(super) fn sheet(args: &Sheet) -> Outcome {
    let (kind, roll) = (PaperKind::SetupSheet, args.roll.as_deref());
    let derived = make(&Made { kind, file: &args.file, machine: args.machine.as_deref(), out: &args.out, roll })?;
    Ok(if turnwright::output::has_errors(&derived) { Ending::FoundErrors } else { Ending::Good })
}

/// Which papers are made of what, and where they are written.
struct Made<'a> {
    kind: PaperKind,
    file: &'a Path,
    machine: Option<&'a str>,
    out: &'a Path,
    /// The roll that is meant alone, by its name or the end of it.
    roll: Option<&'a str>,
}

/// Makes and writes papers of a file, and says where they are.
fn make(made: &Made<'_>) -> Result<Derived, Vec<Diagnostic>> {
    let catalog = catalog();
    let derived = derive(&open(made.file, made.machine, &catalog)?, &catalog)?;
    complain(&derived.diagnostics);
    let of = match made.roll {
        Some(name) => roll(&derived, name).map_err(|d| vec![d])?,
        None => &derived,
    };
    let pages = made.kind.pages(of, &catalog).map_err(|d| vec![d])?;
    for written in papers::save(made.out, &pages).map_err(|d| vec![d])? {
        say(&written.display().to_string());
    }
    Ok(derived)
}

/// What follows from the roll of a set with this name: `1470b-2T`, or `2T` of it.
fn roll<'a>(derived: &'a Derived, name: &str) -> Result<&'a Derived, Diagnostic> {
    let rolls = derived.rolls.as_ref().map_or(&[][..], |set| set.rolls.as_slice());
    let is_it = |roll: &&RollDerived| roll.name == name || roll.name.rsplit('-').next() == Some(name);
    rolls.iter().find(is_it).map(|roll| &*roll.derived).ok_or_else(|| {
        let names: Vec<&str> = rolls.iter().map(|roll| roll.name.as_str()).collect();
        let known = if names.is_empty() {
            "the document has none".to_owned()
        } else {
            format!("there are {}", names.join(", "))
        };
        Diagnostic::error("no-such-roll", Place::Document, format!("There is no roll \"{name}\"; {known}."))
    })
}
