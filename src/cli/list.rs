//! `machines`, `tools`, `materials`.

use super::{Ending, Outcome, catalog, say};
use clap::Args;
use serde::Serialize;
use turnwright::machine::{CuttingOperation, ToolMaterial, ToolShape};
use turnwright::units::Unit;

/// List what is known.
#[derive(Debug, Args)]
pub(crate) struct List {
    /// Print everything as JSON.
    #[arg(long)]
    json: bool,
}

#[allow(clippy::unnecessary_wraps, reason = "every command has the same signature")]
pub(super) fn machines(args: &List) -> Outcome {
    let catalog = catalog();
    let lines = catalog.machines.iter().map(|m| {
        let power = m.spindle.power_kw.map_or_else(String::new, |kw| format!(", {kw} kW"));
        format!("{:<16} {}: {} rev/min{power}, {} tools", m.id, m.name, m.rpm_limit(), m.tools.len())
    });
    print(args, &catalog.machines, lines);
    Ok(Ending::Good)
}

#[allow(clippy::unnecessary_wraps, reason = "every command has the same signature")]
pub(super) fn tools(args: &List) -> Outcome {
    let catalog = catalog();
    let lines = catalog.tools.iter().map(|t| {
        let codes = match &t.shape {
            ToolShape::Iso { insert, holder } => format!(": {insert}, {holder}"),
            _ => String::new(),
        };
        format!("{:<24} {}{codes}", t.id, t.name)
    });
    print(args, &catalog.tools, lines);
    Ok(Ending::Good)
}

#[allow(clippy::unnecessary_wraps, reason = "every command has the same signature")]
pub(super) fn materials(args: &List) -> Outcome {
    let catalog = catalog();
    let lines = catalog.materials.iter().map(|m| {
        let unit = if m.unit == Unit::Inch { "in" } else { "mm" };
        let published = m.orac.map(|row| {
            format!(
                "cut {:>4} {unit}/min, rough {:.3} {unit}, finish 2 x {:.3} {unit}, thread {:.3} {unit}",
                row.feed_cut, row.depth_rough, row.depth_finish, row.depth_thread
            )
        });
        let rough = m.cutting(CuttingOperation::Rough, ToolMaterial::Carbide).map(|data| {
            format!(
                "rough {:>3} m/min, {} mm/rev, {} mm deep",
                data.speed_m_per_min, data.feed_mm_per_rev, data.depth_mm
            )
        });
        format!("{:<16} {}", m.name, published.into_iter().chain(rough).collect::<Vec<_>>().join("; "))
    });
    print(args, &catalog.materials, lines);
    Ok(Ending::Good)
}

fn print<T: Serialize>(args: &List, all: &[T], lines: impl Iterator<Item = String>) {
    if args.json {
        say(&serde_json::to_string_pretty(all).unwrap_or_default());
    } else {
        lines.for_each(|line| say(&line));
    }
}
