//! The planner: from stock, contour, holding, tools and material to a complete ordered plan.
//!
//! Everything is a function of z made of lines and arcs: the finished contour, the stock that is left, and for every tool
//! the lowest place that its programmed point may take. That limit is the contour pushed off by the tool's true outline,
//! insert and holder (`dilate`); it is the exact path of the finishing pass, nose radius and all, and whatever lies on or
//! above it neither gouges nor collides. The stock after a pass is what the insert leaves below it, by the same operation.
//!
//! | file | duty |
//! |---|---|
//! | `piece`, `chain` | functions of z: values, the larger of two, where one is above the other |
//! | `outline`, `shape`, `rolling`, `lows`, `dilate` | outlines of tools turned over and rolled along functions |
//! | `tool`, `guard`, `work` | what a tool is for, what of it must not meet stock; contour, jaws, stock, limits |
//! | `surface`, `hanging` | the top of the stock in chunks; stock that hangs over what was cut |
//! | `rest` | where tools are changed that have no place of their own |
//! | `trace`, `corner`, `path`, `link` | limits as paths that a control can take; moves; ways through air |
//! | `rough`, `follow`, `groove`, `thread` | one kind of operation each |
//! | `side` | a bore seen as an outside |
//! | `recipes`, `rough_recipe` | contours for controls that compensate the nose, or rough by a cycle of their own |
//! | `left`, `reach` | what no tool could reach; what every tool cannot |
//! | `conditions`, `hand`, `order` | feeds, speeds, depths; which tool does what, and when |
//! | `order/face`, `order/drill`, `order/bore`, `order/part_off` | facing of the free end; the bore; parting off |
//! | `order/steps` | the order of operations as planned and as changed by the user |
//! | `order/threads`, `order/thread_passes` | threads of one side; their passes |

mod chain;
mod conditions;
mod corner;
mod dilate;
mod follow;
mod groove;
mod guard;
mod hand;
mod hanging;
mod left;
mod link;
mod lows;
mod order;
mod outline;
mod path;
mod piece;
mod reach;
mod recipes;
mod rest;
mod rolling;
mod rough;
mod rough_recipe;
mod shape;
mod side;
mod surface;
mod thread;
mod tool;
mod trace;
mod work;

use super::{CutterPath, Task};
use crate::diagnostic::Diagnostic;
use crate::machine::ZeroEnd;
use crate::part;
pub use reach::{UnreachableArea, unreachable};

/// How far arcs may leave a parabola of the contour in a planned path, mm.
const PARABOLA_TOLERANCE_MM: f64 = 0.002;

/// The planned cutter path of a set-up.
#[must_use]
pub fn plan(task: &Task<'_>) -> (CutterPath, Vec<Diagnostic>) {
    let (setup, machine) = (task.setup, task.machine);
    let datum = rest::place(task);
    let zero_z = match machine.datum.zero {
        ZeroEnd::FreeEnd => setup.length,
        ZeroEnd::ClampedEnd => 0.0,
    };
    let contour = part::contour(&setup.profile, PARABOLA_TOLERANCE_MM);
    let mut order = order::Order::new(task, &contour, datum, zero_z);
    if datum.is_finite() && !contour.contour.segments.is_empty() {
        order.plan(setup, &contour);
    }
    let (mut operations, diagnostics) = order.done();
    recipes::add(task, datum, &mut operations);
    rough_recipe::add(task, &mut operations);
    (CutterPath { datum, program_zero_z: zero_z, operations }, diagnostics)
}
