//! The published form-roll cycles: roughing, grooving, pocketing and finishing between given elements.
//!
//! Source: Wong, "Computer aided design and manufacture of form-rolls", 1983, 8.5 and 8.6, with the program of figure 8.31
//! for what the text leaves open. All 261 blocks of that program for the top roll follow from the rules here; the joints of
//! small corners, where it differs by some hundredths of a mm, are those at which single precision lost its last figures.
//! What only the program shows: the ways of approach (5 mm in front of the area, 10 mm above the blank), the lead-in of 3 mm
//! under 45° to a rough contour, that the blank's radius is carried from one roughing to the next operation, and which
//! small corners are rolled around (see `offset`).

mod area;
mod blank;
mod cut_in;
mod fault;
mod finish;
mod groove;
mod job;
mod level;
mod offset;
mod pocket;
mod rough;
mod strokes;
mod tool;
mod undercut;

use super::{Cut, CutMove, CutterPath, Feed, Operation, OperationKind, Speed, Task};
use crate::diagnostic::{Diagnostic, Place, SectionTable};
use crate::document::{Cycle, Ends, Instruction};
use crate::geometry::Point;
use crate::machine::{Machine, ZeroEnd};
use area::Direction;
use blank::Blank;
pub use blank::{BLANK_ALLOWANCE_MM, standard_blank_mm};
use fault::Fault;
use job::Job;
use tool::CycleTool;

/// The cutter path of the instructions, in order, each with a tool of its own from its change position and back to it.
///
/// An instruction that cannot be carried out becomes an operation without moves, with an error; the others are carried out. The elements are the
/// rows of the section table, the blank is the bar of the set-up.
#[must_use]
pub fn generate(task: &Task<'_>, instructions: &[Instruction]) -> (CutterPath, Vec<Diagnostic>) {
    let setup = task.setup;
    let datum = &task.machine.datum;
    let mut path = CutterPath {
        datum: Point::new(setup.length + datum.axial_clearance_mm, setup.bar_radius + datum.radial_clearance_mm),
        program_zero_z: match datum.zero {
            ZeroEnd::FreeEnd => setup.length,
            ZeroEnd::ClampedEnd => 0.0,
        },
        operations: Vec::with_capacity(instructions.len()),
    };
    if task.part_mm.ends != Ends::One {
        let message = "The published cycles machine a part in one clamping; this one is machined at two ends.";
        let two = Diagnostic::error("cycles-two-ends", Place::Document, message);
        return (path, vec![two.with_hint("Machine one end, or choose another generator.")]);
    }
    let mut diagnostics = Vec::new();
    let mut blank = Blank { first_radius: setup.bar_radius, radius: setup.bar_radius };
    for (number, instruction) in (1_usize..).zip(instructions) {
        let name = format!("Operation {number}, {}", instruction.cycle.name());
        let at = place(task, instruction.from);
        diagnostics.extend(warnings(task, instruction, &name, &at));
        match operation(task, instruction, &mut blank, path.program_zero_z, path.datum) {
            Ok(operation) => path.operations.push(operation),
            Err(fault) => {
                diagnostics.push(fault.diagnostic(&name, at));
                path.operations.push(left_out(instruction));
            }
        }
    }
    (path, diagnostics)
}

/// Stands for an instruction that cannot be carried out, so that every operation has the place of its instruction.
fn left_out(instruction: &Instruction) -> Operation {
    let kind = kind(instruction.cycle, Direction::TowardsClampedEnd);
    let (name, tool) = (kind.name().to_owned(), instruction.tool);
    Operation { kind, name, tool, change: None, moves: Vec::new(), recipes: Vec::new() }
}

/// The row where an instruction begins, if there is one.
fn place(task: &Task<'_>, id: u32) -> Place {
    let row = task.part_mm.sections.iter().position(|s| s.id == id);
    row.map_or(Place::Document, |index| Place::Section {
        id,
        table: SectionTable::Outside,
        row: index + 1,
        column: None,
    })
}

fn operation(
    task: &Task<'_>,
    instruction: &Instruction,
    blank: &mut Blank,
    zero_z: f64,
    datum: Point,
) -> Result<Operation, Fault> {
    check_figures(instruction)?;
    let tool = tool(task, instruction)?;
    let job = Job::new(instruction, &task.part_mm.sections, tool, cut(task.machine, instruction), *blank)?;
    let mut moves = match (instruction.cycle, &instruction.cut_in) {
        (Cycle::Rough, _) => {
            let (moves, through) = rough::rough(&job)?;
            blank.radius = through;
            moves
        }
        (Cycle::Groove, _) => groove::groove(&job, tool.blade_width.unwrap_or_default())?,
        (Cycle::Finish, _) => finish::finish(&job)?,
        (Cycle::Pocket, Some(cut_in)) => pocket::pocket(&job, cut_in)?,
        (Cycle::Pocket, None) => return Err(no_cut_in()),
    };
    let change = task.machine.change_position(tool.station).map(|p| Point::new(p.z_mm + zero_z, p.diameter_mm / 2.0));
    moves.push(CutMove::Rapid { to: change.unwrap_or(datum) });
    let kind = kind(instruction.cycle, job.direction());
    let name = kind.name().to_owned();
    Ok(Operation { kind, name, tool: tool.station, change, moves, recipes: Vec::new() })
}

const fn kind(cycle: Cycle, direction: Direction) -> OperationKind {
    match (cycle, direction) {
        (Cycle::Rough, Direction::TowardsClampedEnd) => OperationKind::RoughRight,
        (Cycle::Rough, Direction::TowardsFreeEnd) => OperationKind::RoughLeft,
        (Cycle::Finish, Direction::TowardsClampedEnd) => OperationKind::FinishRight,
        (Cycle::Finish, Direction::TowardsFreeEnd) => OperationKind::FinishLeft,
        (Cycle::Groove, _) => OperationKind::Groove,
        (Cycle::Pocket, _) => OperationKind::Pocket,
    }
}

/// The published programs feed per turn at a constant cutting speed.
fn cut(machine: &Machine, instruction: &Instruction) -> Cut {
    Cut {
        feed: Feed::PerRev(instruction.feed_per_rev),
        speed: Speed::Surface { m_per_min: instruction.speed_m_per_min, max_rpm: machine.rpm_limit() },
    }
}

/// The instruction's tool, fit for its cycle.
fn tool(task: &Task<'_>, instruction: &Instruction) -> Result<CycleTool, Fault> {
    let station = instruction.tool;
    let outline = task.tools.get(&station).ok_or_else(|| {
        let stations: Vec<String> = task.tools.keys().map(u32::to_string).collect();
        let message = format!("Turret station {station} of {} holds no tool.", task.machine.name);
        let message = format!("{message} There are tools in {}.", stations.join(", "));
        Fault::new("tool-missing", message, "Choose another station, or add the tool to the machine file.")
    })?;
    let tool = CycleTool::new(station, outline)?;
    let grooves = instruction.cycle == Cycle::Groove;
    match tool.blade_width {
        Some(width) if grooves && width > 0.0 => Ok(tool),
        None if !grooves => Ok(tool),
        Some(_) if !grooves => Err(Fault::new(
            "tool-unfit",
            format!("The tool in station {station} is a blade; this cycle follows the contour with a nose."),
            "Choose a turning tool.",
        )),
        _ => Err(Fault::new(
            "tool-unfit",
            format!("The tool in station {station} has no width; grooving needs a blade wider than 0 mm."),
            "Choose a parting or grooving tool.",
        )),
    }
}

fn check_figures(instruction: &Instruction) -> Result<(), Fault> {
    let above_zero =
        [("cutting speed", instruction.speed_m_per_min, "m/min"), ("feed", instruction.feed_per_rev, "mm per turn")];
    for (name, value, unit) in above_zero {
        if !(value.is_finite() && value > 0.0) {
            let message = format!("The {name} is {value} {unit}; it must be more than 0 {unit}.");
            return Err(Fault::new("cutting-data", message, "Enter a figure above 0."));
        }
    }
    let stock = instruction.stock_left;
    if !(stock.is_finite() && stock >= 0.0) {
        let message = format!("The stock left is {stock} mm; it must be 0 mm or more.");
        return Err(Fault::new("stock-left", message, "Enter 0 for the finished contour."));
    }
    Ok(())
}

fn no_cut_in() -> Fault {
    let message = "Pocketing enters the hollow along a cut-in line, and the instruction has none.";
    Fault::new("cut-in-missing", message, "Enter a point and an angle of the line.")
}

/// What is carried out, but hardly meant.
fn warnings(task: &Task<'_>, instruction: &Instruction, name: &str, at: &Place) -> Vec<Diagnostic> {
    let mut all = Vec::new();
    let mut warn = |code: &str, message: String, hint: &str| {
        all.push(Diagnostic::warning(code, at.clone(), format!("{name}: {message}")).with_hint(hint));
    };
    let area = area::Area::of(&task.part_mm.sections, instruction.from, instruction.to);
    let tool = task.tools.get(&instruction.tool).and_then(|o| CycleTool::new(instruction.tool, o).ok());
    if let (Ok(area), Some(only)) = (area, tool.and_then(|t| t.cuts_only))
        && area.direction != only
        && instruction.cycle != Cycle::Groove
    {
        let station = instruction.tool;
        let message = format!("The tool in station {station} is ground to cut in the other direction.");
        warn("tool-hand", message, "Exchange first and last element, or choose the other hand.");
    }
    if matches!(instruction.cycle, Cycle::Rough | Cycle::Groove) && instruction.cut_in.is_some() {
        let message = "The cycle comes from outside and has no use for the cut-in line.".to_owned();
        warn("cut-in-unused", message, "Remove the line, or choose pocketing.");
    }
    if matches!(instruction.cycle, Cycle::Finish | Cycle::Groove) && instruction.depth != 0.0 {
        let depth = instruction.depth;
        let message = format!("The cycle has no strokes for the depth of cut of {depth} mm.");
        warn("depth-unused", message, "Enter 0.");
    }
    all
}

#[cfg(test)]
mod tests;
