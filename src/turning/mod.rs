//! Generators and planners: from a set-up of a part to cutter location data.

mod cutter_path;
pub mod cycles;
pub mod figures;
pub mod planner;
pub mod published;
mod recipe;

use crate::diagnostic::Diagnostic;
use crate::document::{Generator, TurnedPart};
use crate::machine::{Machine, Material, ToolOutline};
use crate::part::Setup;
pub use cutter_path::{Cut, CutMove, CutterPath, Feed, Operation, OperationKind, Speed};
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
        Generator::Oracap { .. } => published::generate(task.setup, task.part_mm, task.machine, task.material_mm),
        Generator::Cycles { instructions } => cycles::generate(task, instructions),
        Generator::Planned { .. } => planner::plan(task),
    }
}
