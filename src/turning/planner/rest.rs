//! Where tools are that have no change position of their own.

use super::chain::Chain;
use super::outline::Turn;
use super::shape::Shape;
use super::work::PASSING_MM;
use crate::geometry::{Contour, Point};
use crate::machine::ToolOutline;
use crate::turning::Task;

/// Beside and above the bar by the machine's clearances; further along the spindle where a holder would stand in the chuck.
pub(super) fn place(task: &Task<'_>) -> Point {
    let (setup, rule) = (task.setup, &task.machine.datum);
    let usual = Point::new(setup.length + rule.axial_clearance_mm, setup.bar_radius + rule.radial_clearance_mm);
    let resting = task.tools.iter().filter(|&(&station, _)| task.machine.change_position(station).is_none());
    let z = resting.map(|(_, tool)| clear_of_chuck(task, tool, usual)).fold(usual.z, f64::max);
    Point::new(z, usual.r)
}

/// The first position from `usual` on along the spindle, at the same radius, where a tool is clear of the chuck.
fn clear_of_chuck(task: &Task<'_>, tool: &ToolOutline, usual: Point) -> f64 {
    let (face, chuck) = (task.setup.chuck_face_z, &task.machine.chuck);
    let bounds = [&tool.insert, &tool.holder].into_iter().filter_map(Contour::bounds);
    let left = bounds.map(|b| b.min.z).fold(0.0, f64::min);
    if usual.z + left >= face + PASSING_MM {
        return usual.z;
    }
    let chuck = Chain::level(face - chuck.depth_mm - PASSING_MM, face + PASSING_MM, chuck.radius_mm + PASSING_MM);
    let lowest = Shape::of([&tool.insert, &tool.holder], Turn::Both).over(&chuck);
    lowest.runs_above(usual.r).last().map_or(usual.z, |run| run.z1.max(usual.z))
}
