//! `prove`: the second opinion about any program.

use super::{Ending, Outcome, build, catalog, machine, say};
use clap::Args;
use serde::Serialize;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::{Diagnostic, Place};
use turnwright::machine::{Catalog, Dialect, Machine, outlines};
use turnwright::proof::{self, Change, ProgramText, ProofInput, ProofReport};
use turnwright::regen::{self, Derived, SetupDerived};
use turnwright::storage;

/// Read programs as the lathe would and say what is wrong.
#[derive(Debug, Args)]
pub(crate) struct Prove {
    /// Programs in the order they are run: page files (.cnc) or instruction files (.anc, .bnc) of the ORAC, programs of words
    /// (.nc, .ngc) of all other controls.
    #[arg(required = true)]
    programs: Vec<PathBuf>,
    /// Machine that will run them.
    #[arg(long, value_name = "ID")]
    machine: String,
    /// Part that must come out; programs of the part before the given one are taken as generated.
    #[arg(long, value_name = "FILE")]
    part: Option<PathBuf>,
    /// Print the report as JSON.
    #[arg(long)]
    json: bool,
    /// Print every move as well.
    #[arg(long)]
    path: bool,
}

pub(super) fn run(args: &Prove) -> Outcome {
    let catalog = catalog();
    let machine = machine(&catalog, &args.machine)?;
    let given = args.programs.iter().map(|p| read_program(p)).collect::<Result<Vec<_>, _>>().map_err(|d| vec![d])?;
    let part = args.part.as_deref().map(|file| derive_part(file, machine, &catalog)).transpose()?;
    let item = part.as_ref().and_then(|derived| matching_setup(derived, &given));
    let input =
        match part.as_ref().zip(item).and_then(|(derived, item)| regen::proof_input(derived, item).zip(Some(item))) {
            Some((input, item)) => ProofInput { programs: Arc::new(after_earlier_programs(item, &given)), ..input },
            None => ProofInput { programs: Arc::new(given.clone()), ..input_for_machine(machine, &catalog) },
        };
    let report = proof::prove(&input, &Cancel::default())
        .map_err(|e| vec![Diagnostic::error("cancelled", Place::Document, e.to_string())])?;
    let differences = item.map(|item| differences(item, &given, machine.dialect)).unwrap_or_default();
    if args.json {
        print_json(args, &input, &report, &differences);
    } else {
        print_text(args, &input, &report, &differences);
    }
    Ok(if report.passed { Ending::Good } else { Ending::FoundErrors })
}

/// A word that differs from the program as it is generated from the part.
#[derive(Debug, Serialize)]
struct Difference {
    /// Name of the program.
    program: String,
    #[serde(flatten)]
    change: Change,
}

/// Nothing to cut yet: what the machine can do is all that is checked.
pub(super) fn input_for_machine(machine: &Machine, catalog: &Catalog) -> ProofInput {
    ProofInput {
        machine: Arc::new(machine.clone()),
        tools: Arc::new(outlines(machine, catalog)),
        programs: Arc::default(),
        work: None,
    }
}

/// The program in a file, by the file's name.
pub(super) fn read_program(path: &Path) -> Result<ProgramText, Diagnostic> {
    let name = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    Ok(ProgramText { name, text: storage::read_program(path)?, edited: true })
}

fn derive_part(file: &Path, machine: &Machine, catalog: &Catalog) -> Result<Derived, Vec<Diagnostic>> {
    build::derive(&build::open(file, Some(&machine.id), catalog)?, catalog)
}

/// The clamping whose program names fit the given ones; the first clamping if none does.
fn matching_setup<'a>(derived: &'a Derived, given: &[ProgramText]) -> Option<&'a SetupDerived> {
    let fits = |item: &&SetupDerived| given.iter().any(|g| index_of(item, &g.name).is_some());
    derived.setups.iter().find(fits).or_else(|| derived.setups.first())
}

fn index_of(item: &SetupDerived, name: &str) -> Option<usize> {
    item.programs.iter().position(|p| p.name.eq_ignore_ascii_case(name))
}

/// The given programs after those of the part that are run before them.
fn after_earlier_programs(item: &SetupDerived, given: &[ProgramText]) -> Vec<ProgramText> {
    let first = given.iter().filter_map(|g| index_of(item, &g.name)).min().unwrap_or(0);
    item.programs.iter().take(first).chain(given).cloned().collect()
}

fn differences(item: &SetupDerived, given: &[ProgramText], dialect: Dialect) -> Vec<Difference> {
    let generated = |g: &ProgramText| index_of(item, &g.name).and_then(|k| item.post.programs.get(k));
    let of_program = |g: &ProgramText| {
        let changes = generated(g).map(|program| proof::compare(&program.text, &g.text, dialect)).unwrap_or_default();
        changes.into_iter().map(|change| Difference { program: g.name.clone(), change }).collect::<Vec<_>>()
    };
    given.iter().flat_map(of_program).collect()
}

fn print_json(args: &Prove, input: &ProofInput, report: &ProofReport, differences: &[Difference]) {
    let parsed = |text: &str| serde_json::from_str::<Value>(text).unwrap_or_default();
    let mut value = parsed(&proof::proof_json(input, report));
    value["differences"] = json!(differences);
    if args.path {
        value["path"] = parsed(&proof::path_json(input, report));
    }
    say(&serde_json::to_string_pretty(&value).unwrap_or_default());
}

fn print_text(args: &Prove, input: &ProofInput, report: &ProofReport, differences: &[Difference]) {
    if args.path {
        say(&proof::path_json(input, report));
    }
    for finding in &report.findings {
        let printed = report.blocks.iter().find(|b| b.program == finding.program && b.block == finding.block);
        let words = input.machine.words.is_some();
        let printed = printed.and_then(|b| b.printed).filter(|_| words).map(|n| format!(" (N{n})")).unwrap_or_default();
        say(&format!(
            "{} block {}{printed}: {}: {}",
            finding.program, finding.block, finding.severity, finding.message
        ));
    }
    for difference in differences {
        say(&sentence(difference));
    }
    let times = report.times;
    if let Some(cost) = &report.cost {
        let blank = cost.blank.map(|blank| format!("blank {blank:.2}, ")).unwrap_or_default();
        say(&format!("{:.2} {} a part ({blank}machining {:.2})", cost.part, cost.currency, cost.machining));
    }
    say(&format!(
        "{}: {:.1} min (feed {:.1}, rapid {:.1}, dwell {:.1}, tool changes {:.1}), deepest gouge {:.3} mm",
        if report.passed { "proved" } else { "NOT PROVED" },
        times.total_s / 60.0,
        times.feed_s / 60.0,
        times.rapid_s / 60.0,
        times.dwell_s / 60.0,
        times.tool_change_s / 60.0,
        report.deepest_gouge_mm,
    ));
}

/// `QUEEN1 block 12: Z is -46.116 instead of -51.116 of the part's own program, 5.000 more.`
fn sentence(difference: &Difference) -> String {
    let Difference { program, change } = difference;
    let shown = |value: &Option<String>| value.clone().unwrap_or_else(|| "nothing".to_owned());
    let by = change.difference.map(|by| format!(" ({by:+.3})")).unwrap_or_default();
    format!(
        "{program} block {}: {} is {} instead of {} in the part's own program{by}.",
        change.block,
        change.word,
        shown(&change.is),
        shown(&change.was)
    )
}
