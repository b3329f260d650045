//! Facing: the material beyond the free end is cut away square to the spindle, to the axis, or between centres as far as the
//! tailstock's centre lets the tool.

use super::Order;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::Point;
use crate::part::Setup;
use crate::turning::OperationKind;
use crate::turning::planner::link::{CLEARANCE_MM, go};
use crate::turning::planner::tool::{Cutter, Use};
use crate::turning::planner::work::AXIS_OVERSHOOT_MM;
use std::sync::Arc;

/// Material beyond the end up to this is none, mm.
const FACE_WORTH_MM: f64 = 0.002;

/// Facing cuts at most; an allowance that asks for more is a slip.
const MOST_CUTS: f64 = 1000.0;

/// Where a tool faces.
struct Facing {
    cutter: Arc<Cutter>,
    /// From the programmed point to the tool's leftmost point, mm.
    left: f64,
    /// Radius of the programmed point where the cut ends.
    to_r: f64,
}

impl Order<'_> {
    /// Cuts the free end down to the part's length, if there is more material, with the chosen tool or the first that can.
    pub(super) fn face(&mut self, setup: &Setup, chosen: Option<u32>) {
        let over = self.work.end_z() - setup.length;
        if over <= FACE_WORTH_MM {
            return;
        }
        let Some(facing) = self.facing_tool(setup, chosen) else {
            self.diagnostics.push(not_faced(over, &self.machine.name));
            return;
        };
        let Facing { cutter, left, to_r } = facing;
        let Some(conditions) = self.conditions(OperationKind::Face, cutter.station) else { return };
        let most = if conditions.depth > 0.0 { conditions.depth } else { over };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_CUTS")]
        let cuts = (over / most - 1e-6).ceil().clamp(1.0, MOST_CUTS) as u32;
        let mut path = self.path(&conditions, &cutter);
        let above = self.work.top() + CLEARANCE_MM;
        for cut in 1..=cuts {
            let z = setup.length + over * f64::from(cuts - cut) / f64::from(cuts) - left;
            let start = Point::new(z, above);
            if cut == 1 {
                go(&mut path, start);
            } else {
                path.rapid(start);
            }
            path.line(Point::new(z, to_r));
            // Back beside the cut: what the slanting flank leaves at the middle stands in front of the face.
            go(&mut path, Point::new(z + CLEARANCE_MM, above));
        }
        self.add(OperationKind::Face, &cutter, path);
    }

    /// Says what stub is left around the tailstock's centre when everything is done: a finer tool may have gone further down than
    /// the one that faced.
    pub(super) fn stub(&mut self, setup: &Setup) {
        let end = self.work.end_z();
        let over = end - setup.length;
        let faced = self.operations.iter().any(|o| o.kind == OperationKind::Face);
        if setup.tailstock.is_some() && faced && over > FACE_WORTH_MM {
            let radius = self.work.stock.highest(setup.length + FACE_WORTH_MM, end);
            self.diagnostics.push(faced_to_the_centre(over, radius));
        }
    }

    /// The station of the tool that faces; 0 if none can.
    pub(super) fn facing_station(&self, setup: &Setup) -> u32 {
        self.facing_tool(setup, None).map_or(0, |facing| facing.cutter.station)
    }

    /// The chosen tool, or the first, that can go down along the finished face to the axis or the hole, or as far as the
    /// tailstock's centre lets it.
    fn facing_tool(&self, setup: &Setup, chosen: Option<u32>) -> Option<Facing> {
        let right = self.cutters.iter().filter(|c| c.r#use == Use::Right && !c.turned && c.square);
        let mut able = right.filter(|c| chosen.is_none_or(|station| c.station == station));
        able.find_map(|cutter| {
            let outline = self.task.tools.get(&cutter.station).filter(|o| o.cuts_face())?;
            let left = outline.insert.bounds()?.min.z;
            let z = setup.length - left;
            let limit = cutter.body.over(&self.work.part.max(&self.work.jaws));
            let to_r = if setup.tailstock.is_some() {
                let low = limit.highest(z + FACE_WORTH_MM / 2.0, self.work.end_z() - left + CLEARANCE_MM);
                Some(low).filter(|low| low + cutter.nose < self.work.top() - FACE_WORTH_MM)
            } else {
                let low = limit.highest(z + FACE_WORTH_MM / 2.0, z + CLEARANCE_MM);
                let free = low.max(-AXIS_OVERSHOOT_MM);
                Some(past_the_middle(setup, cutter)).filter(|to_r| free <= to_r + FACE_WORTH_MM)
            };
            to_r.map(|to_r| Facing { cutter: cutter.clone(), left, to_r })
        })
    }
}

/// Where the programmed point ends so that nothing is left in the middle: the side of the nose that faces has come to the axis, or
/// is through the wall of the hole.
fn past_the_middle(setup: &Setup, cutter: &Cutter) -> f64 {
    let hole = setup.stock.bounds().map_or(0.0, |b| b.min.r);
    let through = if hole > 0.0 { hole - CLEARANCE_MM } else { 0.0 };
    through.max(0.0) - cutter.nose
}

fn not_faced(over: f64, machine: &str) -> Diagnostic {
    let message = format!("No tool of {machine} can face the {over:.3} mm beyond the free end down to the axis.");
    Diagnostic::warning("not-faced", Place::Stock, message)
        .with_hint("Add a right-hand turning tool whose front edge leans away from the face.")
}

/// Between centres a stub stays around the centre.
fn faced_to_the_centre(over: f64, radius: f64) -> Diagnostic {
    let message = format!(
        "The free end is faced down to a diameter of {:.3} mm; a stub {over:.3} mm long stays around the tailstock's centre.",
        2.0 * radius
    );
    Diagnostic::warning("not-faced", Place::Stock, message)
        .with_hint("To have none, face the end in the chuck before it is centred, and set the facing allowance to 0.")
}
