//! Facing: the material beyond the free end is cut away square to the spindle.

use super::Order;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::Point;
use crate::part::Setup;
use crate::turning::OperationKind;
use crate::turning::planner::link::{CLEARANCE_MM, go};
use crate::turning::planner::tool::{Cutter, Use};
use crate::turning::planner::work::AXIS_OVERSHOOT_MM;

/// Material beyond the end up to this is none, mm.
const FACE_WORTH_MM: f64 = 0.002;

/// Facing cuts at most; an allowance that asks for more is a slip.
const MOST_CUTS: f64 = 1000.0;

/// Where a tool faces.
struct Facing {
    cutter: Cutter,
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
            self.diagnostics.push(not_faced(setup, over, &self.machine.name));
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
            path.rapid(Point::new(z + CLEARANCE_MM, to_r));
            path.rapid(Point::new(z + CLEARANCE_MM, above));
        }
        self.add(OperationKind::Face, &cutter, path);
    }

    /// The station of the tool that faces; 0 if none can.
    pub(super) fn facing_station(&self, setup: &Setup) -> u32 {
        self.facing_tool(setup, None).map_or(0, |facing| facing.cutter.station)
    }

    /// The chosen tool, or the first, that can go down along the finished face to the axis or the hole.
    fn facing_tool(&self, setup: &Setup, chosen: Option<u32>) -> Option<Facing> {
        if setup.tailstock.is_some() {
            return None;
        }
        let hole = setup.stock.bounds().map_or(0.0, |b| b.min.r);
        let right = self.cutters.iter().filter(|c| c.r#use == Use::Right);
        right.filter(|c| chosen.is_none_or(|station| c.station == station)).find_map(|cutter| {
            let outline = self.task.tools.get(&cutter.station).filter(|o| o.cuts_face())?;
            let left = outline.insert.bounds()?.min.z;
            let over = cutter.nose.min(AXIS_OVERSHOOT_MM);
            let to_r = if hole > 0.0 { (hole - cutter.nose - CLEARANCE_MM).max(-over) } else { -over };
            let z = setup.length - left;
            let low = self.work.limit(cutter, 0.0).chain.highest(z + FACE_WORTH_MM / 2.0, z + CLEARANCE_MM);
            (low <= to_r + FACE_WORTH_MM).then(|| Facing { cutter: cutter.clone(), left, to_r })
        })
    }
}

fn not_faced(setup: &Setup, over: f64, machine: &str) -> Diagnostic {
    let message = if setup.tailstock.is_some() {
        format!("The {over:.3} mm beyond the free end cannot be faced: the tailstock's centre stands there.")
    } else {
        format!("No tool of {machine} can face the {over:.3} mm beyond the free end down to the axis.")
    };
    let hint = if setup.tailstock.is_some() {
        "Face the end before it is centred, and set the facing allowance to 0."
    } else {
        "Add a right-hand turning tool whose front edge leans away from the face."
    };
    Diagnostic::warning("not-faced", Place::Stock, message).with_hint(hint)
}
