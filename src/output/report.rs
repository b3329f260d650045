//! `report.json`: what was built, whether it is proved, and what there is to say about it.

use crate::regen::{Derived, SetupDerived};
use serde_json::{Value, json};

pub(super) fn report(derived: &Derived) -> Value {
    json!({
        "turnwright": env!("CARGO_PKG_VERSION"),
        "document": derived.document.name,
        "unit": derived.document.unit,
        "machine": derived.machine.as_deref().map(|m| &m.id),
        "good": !super::has_errors(derived),
        "items": derived.setups.iter().map(|s| item(derived, s)).chain(derived.shell.iter().map(|made| super::shell::item(made))).collect::<Vec<_>>(),
        "diagnostics": derived.diagnostics,
    })
}

fn item(derived: &Derived, item: &SetupDerived) -> Value {
    let programs = item.programs.iter().zip(&item.post.programs).map(|(text, program)| {
        json!({
            "name": program.name,
            "file": super::program_file(derived, program),
            "blocks": program.blocks.len(),
            "edited_by_hand": text.edited,
        })
    });
    let side = item.post.side_files.iter().map(|f| json!({ "file": f.name, "instructions": f.instructions }));
    json!({
        "name": item.name,
        "contour": format!("{}.contour.json", item.name),
        "setup": format!("{}.setup.json", item.name),
        "proof": format!("{}.proof.json", item.name),
        "programs": programs.collect::<Vec<_>>(),
        "instruction_files": side.collect::<Vec<_>>(),
        "proved": item.proof.passed,
        "times": item.proof.times,
        "deepest_gouge_mm": item.proof.deepest_gouge_mm,
        "largest_chip_mm2": item.proof.largest_chip_mm2,
        "findings": item.proof.findings.len(),
        "unreachable": item.unreachable.iter().map(|a| json!({
            "tool": a.tool,
            "sections": a.sections,
            "height_mm": a.height_mm,
        })).collect::<Vec<_>>(),
    })
}
