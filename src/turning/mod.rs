//! Generators and planners: from a set-up of a part to cutter location data.

mod cutter_path;
pub mod cycles;
pub mod figures;
pub mod planner;
pub mod published;
mod recipe;

use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Generator, TurnedPart};
use crate::machine::{Dialect, Machine, Material, ToolOutline};
use crate::part::Setup;
pub use cutter_path::{Cut, CutMove, CutterPath, Feed, Operation, OperationKind, Speed};
pub use planner::{UnreachableArea, unreachable};
pub use recipe::{FinishRecipe, Recipe, RecipeKind, RoughRecipe, Side, ThreadRecipe};
use std::collections::BTreeMap;

/// Everything that cutter location data are made from. Lengths in mm, feeds in mm/min.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// The clamping: stock, profile, holding.
    pub setup: &'a Setup,
    /// The part with the choice of the generator.
    pub part_mm: &'a TurnedPart,
    /// The machine.
    pub machine: &'a Machine,
    /// True outline of every tool by turret station.
    pub tools: &'a BTreeMap<u32, ToolOutline>,
    /// Cutting data.
    pub material_mm: &'a Material,
}

/// The cutter path of one set-up by the generator that the part names, and what is to be said about it.
#[must_use]
pub fn generate(task: &Task<'_>) -> (CutterPath, Vec<Diagnostic>) {
    match &task.part_mm.generator {
        Generator::Oracap { .. } => {
            let (path, mut said) = published::generate(task.setup, task.part_mm, task.machine, task.material_mm);
            said.extend(made_for_another(task.machine));
            (path, said)
        }
        Generator::Cycles { instructions } => cycles::generate(task, instructions),
        Generator::Planned { .. } => planner::plan(task),
    }
}

/// What is to be said of the published ORACAP generator on a machine that it was not written for.
fn made_for_another(machine: &Machine) -> Option<Diagnostic> {
    let message = format!(
        "The ORACAP generator was written for the ORAC, whose tools have small noses and stand at stations 1 to 4; it knows \
         nothing of the tools of {}.",
        machine.name
    );
    (machine.dialect != Dialect::Orac).then(|| {
        Diagnostic::warning("generator-for-another-machine", Place::Machine { id: machine.id.clone() }, message)
            .with_hint("Let the planner make the program: choose it under Made by.")
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    #[test]
    fn oracap_on_a_machine_of_words_is_warned_of() {
        let catalog = Catalog::shipped();
        let said = |id: &str| made_for_another(catalog.machine(id).unwrap());
        assert_eq!(said("orac"), None);
        let warning = said("linuxcnc").unwrap();
        assert!(warning.message.contains("LinuxCNC") && warning.hint.is_some(), "{warning:?}");
    }
}
