//! Parting off with a blade that reaches deep enough, slower near the axis.

use super::Order;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::Point;
use crate::part::Setup;
use crate::turning::planner::link::{CLEARANCE_MM, go};
use crate::turning::planner::outline::Turn;
use crate::turning::planner::shape::Shape;
use crate::turning::planner::tool::{Cutter, HOLDER_CLEARANCE_MM};
use crate::turning::{Feed, OperationKind};
use std::sync::Arc;

/// How far the blade goes below the wall of a hole that it opens, mm.
const INTO_HOLE_MM: f64 = 0.5;

/// Below this radius the cutting speed falls with the spindle at its limit, and the part may break off, mm (makers of parting
/// blades ask for about 2 mm).
const NEAR_AXIS_MM: f64 = 2.0;

/// Share of the feed near the axis (makers of parting blades ask for a reduction by about 75 %).
const SHARE_NEAR_AXIS: f64 = 0.25;

/// Where a blade parts off.
struct Parting {
    blade: Arc<Cutter>,
    /// Position of the programmed point: the blade's right side is at the part's end.
    z: f64,
}

impl Order<'_> {
    /// Parts the piece off, if there is a blade that can.
    pub(super) fn part_off(&mut self, setup: &Setup, blades: &[Arc<Cutter>]) {
        let to_r = parted_at(setup);
        let Some(Parting { blade, z }) = blades.iter().find_map(|b| self.parting(b, to_r)) else {
            self.diagnostics.push(self.not_parted(setup, to_r));
            return;
        };
        let Some(conditions) = self.conditions(OperationKind::PartOff, blade.station) else { return };
        let mut path = self.path(&conditions, &blade);
        let air = self.work.air(&blade);
        let above = Point::new(z, air.at(z).unwrap_or(0.0).max(0.0) + CLEARANCE_MM);
        go(&mut path, above);
        let last = conditions.cut(NEAR_AXIS_MM, to_r, 0.0);
        // Feeds per minute are published for the whole way to the axis.
        if to_r < NEAR_AXIS_MM && matches!(last.feed, Feed::PerRev(_)) {
            path.line(Point::new(z, NEAR_AXIS_MM));
            path.line_at(Point::new(z, to_r), last.slower(SHARE_NEAR_AXIS));
        } else {
            path.line(Point::new(z, to_r));
        }
        path.rapid(above);
        self.add(OperationKind::PartOff, &blade, path);
    }

    /// Where this blade parts off; `None` if its holder would run into the stock or the jaws before it is through.
    fn parting(&self, blade: &Arc<Cutter>, to_r: f64) -> Option<Parting> {
        let outline = self.task.tools.get(&blade.station)?;
        let edge = outline.insert.bounds()?;
        let z = -edge.max.z;
        let holder = Shape::grown(&outline.holder, Turn::Both, HOLDER_CLEARANCE_MM);
        let stock = self.work.stock.chain().max(&self.work.jaws);
        // What stands beside the cut.
        let beside = stock.clipped(f64::NEG_INFINITY, z + edge.min.z).max(&stock.clipped(0.0, f64::INFINITY));
        let low = holder.over(&beside).at(z).unwrap_or(f64::NEG_INFINITY);
        let jaws = Shape::of([&outline.insert], Turn::Both).over(&self.work.jaws).at(z).unwrap_or(f64::NEG_INFINITY);
        (low.max(jaws) <= to_r).then(|| Parting { blade: blade.clone(), z })
    }

    fn not_parted(&self, setup: &Setup, to_r: f64) -> Diagnostic {
        let message = format!(
            "No blade of {} reaches from the bar's radius, {:.3} mm, to {to_r:.3} mm; the part is not parted off.",
            self.machine.name, setup.bar_radius
        );
        Diagnostic::warning("not-parted-off", Place::Document, message)
            .with_hint("Add a longer blade to the machine, or saw the part off.")
    }
}

/// Radius at which the part comes off: just inside the hole that is open there, else the axis, mm.
fn parted_at(setup: &Setup) -> f64 {
    let hole = setup.bore.as_ref().and_then(|bore| {
        let first = bore.pieces.first().filter(|p| p.start().z <= 0.0)?;
        Some(first.start().r.min(bore.radius_at(0.0)?))
    });
    hole.map_or(0.0, |r| (r - INTO_HOLE_MM).max(0.0))
}
