//! Drilling on the axis: in one go, or in pecks where the hole is deeper than the drill clears its chips by itself.

use super::Order;
use super::bore::Bore;
use super::steps::unsuitable;
use crate::geometry::{Contour, Point, Segment};
use crate::machine::{PECKS_FROM, ToolKind, ToolOutline};
use crate::turning::planner::link::CLEARANCE_MM;
use crate::turning::planner::outline::Turn;
use crate::turning::planner::path::Path;
use crate::turning::planner::shape::Shape;
use crate::turning::planner::tool::Cutter;
use crate::turning::{OperationKind, Task};

/// How far the full diameter of a drill goes beyond a hole that is open there, mm.
const BREAK_THROUGH_MM: f64 = 1.0;

/// A hole this narrow is none to a drill, mm on the radius: it drills into solid material.
const SOLID_MM: f64 = 0.05;

/// Solid material shorter than this is not drilled, mm.
const SHORTEST_MM: f64 = 0.5;

/// Distance in front of the work from which a drill feeds, mm.
const IN_FRONT_MM: f64 = 4.0 * CLEARANCE_MM;

/// Distance that the sleeve of a drill keeps from the work, mm.
const SLEEVE_MM: f64 = 1.0;

/// Advance of a peck after the first, diameters of the drill: what text books give for twist drills (guide value).
const PECK: f64 = 1.0;

/// Distance in front of the bottom from which a peck feeds, mm: what the way back may leave of the chips.
const ABOVE_BOTTOM_MM: f64 = 1.0;

/// Pecks at most; a drill that needs more has no diameter.
const MOST_PECKS: u32 = 1000;

/// What of a drill's own outline may be off, mm: rounding.
const ROUNDING_MM: f64 = 1e-6;

impl Order<'_> {
    /// Drills what is solid as deep as the drill of a station may go.
    pub(super) fn drill(&mut self, bore: &Bore, station: u32) {
        let outline = self.task.tools.get(&station).filter(|outline| outline.kind == ToolKind::Drill);
        let seen = outline.and_then(|outline| Some((outline, bore.side.tool(outline)?)));
        let cutter = seen.as_ref().and_then(|(_, seen)| Cutter::new(station, seen));
        let (Some((outline, seen)), Some(cutter)) = (seen, cutter) else {
            self.diagnostics.push(unsuitable(OperationKind::Drill, station, &self.machine.name));
            return;
        };
        if let Some(tip) = self.tip(bore, &seen).filter(|&tip| self.is_solid(bore, tip)) {
            self.drill_to(bore, &cutter, outline, tip);
        }
    }

    /// The deepest place of a drill's tip; `None` if it does not go in with its full diameter.
    fn tip(&self, bore: &Bore, seen: &ToolOutline) -> Option<f64> {
        let end = self.work.end_z();
        let kept = Shape::of([&seen.insert], Turn::Both).over(&self.work.part.max(&self.work.jaws));
        let sleeve = Shape::grown(&seen.holder, Turn::Both, SLEEVE_MM).over(&self.work.stock.chain());
        let limit = kept.max(&sleeve).clipped(f64::NEG_INFINITY, end);
        let free = limit.runs_below(bore.axis + ROUNDING_MM).last().copied()?;
        let point = point(&seen.insert);
        let through = if bore.open { bore.from_z - point - BREAK_THROUGH_MM } else { f64::NEG_INFINITY };
        let tip = free.z0.max(through);
        (free.z1 >= end - ROUNDING_MM && tip + point < end - SHORTEST_MM).then_some(tip)
    }

    /// True if there is solid material that the tip goes through.
    pub(super) fn is_solid(&self, bore: &Bore, tip: f64) -> bool {
        let ahead = self.work.stock.between(tip.max(bore.from_z), f64::INFINITY);
        ahead.runs_above(bore.axis - SOLID_MM).iter().any(|run| run.width() > SHORTEST_MM)
    }

    fn drill_to(&mut self, bore: &Bore, cutter: &Cutter, drill: &ToolOutline, tip: f64) {
        let Some(conditions) = self.conditions(OperationKind::Drill, cutter.station) else { return };
        self.datum.r = bore.axis;
        let (end, radius) = (self.work.end_z(), radius(&drill.insert));
        let at = |z: f64| Point::new(z, bore.axis);
        let start = at(end + IN_FRONT_MM);
        let mut path: Path<'_> = self.path(&conditions, cutter);
        path.rapid(start);
        let mut bottom = f64::INFINITY;
        for to in pecks(end, tip, 2.0 * radius, drill.pecks_from) {
            // Down through the hole that the drill made itself.
            path.rapid(at((bottom + ABOVE_BOTTOM_MM).min(start.z)));
            path.line_at(at(to), conditions.fixed(radius));
            path.rapid(start);
            bottom = to;
        }
        self.add(OperationKind::Drill, cutter, path);
    }
}

/// Where the tip of a drill turns back, one after the other: at the end of the hole where it is not deeper than `pecks_from`
/// diameters, else there first, and then every diameter at most, in equal parts.
fn pecks(from: f64, to: f64, diameter: f64, pecks_from: f64) -> Vec<f64> {
    let first = diameter * if pecks_from > 0.0 { pecks_from } else { PECKS_FROM };
    let rest = from - first - to;
    if rest <= ROUNDING_MM {
        return vec![to];
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_PECKS")]
    let count = (rest / (PECK * diameter)).ceil().clamp(1.0, f64::from(MOST_PECKS)) as u32;
    (0..=count).map(|k| to + rest * f64::from(count - k) / f64::from(count)).collect()
}

/// The stations of all drills, the widest first.
pub(super) fn drills(task: &Task<'_>) -> Vec<u32> {
    let of_drills = task.tools.iter().filter(|(_, outline)| outline.kind == ToolKind::Drill);
    let mut drills: Vec<(u32, f64)> = of_drills.map(|(&station, outline)| (station, radius(&outline.insert))).collect();
    drills.sort_by(|a, b| b.1.total_cmp(&a.1));
    drills.into_iter().map(|(station, _)| station).collect()
}

/// Radius of a drill, mm.
fn radius(insert: &Contour) -> f64 {
    insert.bounds().map_or(0.0, |b| b.max.r)
}

/// Length of a drill's point, mm.
fn point(seen: &Contour) -> f64 {
    let full = radius(seen) - ROUNDING_MM;
    seen.segments.iter().map(Segment::start).filter(|p| p.r >= full).map(|p| p.z).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hole_that_is_not_deep_is_drilled_in_one_go() {
        assert_eq!(pecks(50.0, 20.0, 10.0, 3.0), [20.0]);
        assert_eq!(pecks(50.0, 20.0, 10.0, 0.0), [20.0], "the usual depth where the file says nothing");
    }

    #[test]
    fn a_deep_hole_is_drilled_in_pecks_of_a_diameter_at_most() {
        assert_eq!(pecks(50.0, 19.0, 10.0, 3.0), [20.0, 19.0]);
        assert_eq!(pecks(50.0, 0.0, 10.0, 2.0), [30.0, 20.0, 10.0, 0.0]);
        assert_eq!(pecks(50.0, 5.0, 10.0, 0.0), [20.0, 12.5, 5.0]);
    }
}
