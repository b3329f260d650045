//! Bores: drilled where the stock is solid, then roughed and finished with the boring bars.
//!
//! The bore is planned by the same steps as the outside, on radii counted from outside (`Side::Inside`). What is new is that
//! there is a wall behind the tool, too: how deep a bar goes is found from the hole as it is.

use super::drill::drills;
use super::steps::{Step, chosen, does, unsuitable};
use super::{FINISH_WORTH_MM, Order};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{OperationEdit, OperationKind};
use crate::geometry::{Point, Segment};
use crate::machine::{Machine, ToolKind};
use crate::part::{self, PartContour, Setup};
use crate::turning::planner::PARABOLA_TOLERANCE_MM;
use crate::turning::planner::chain::Chain;
use crate::turning::planner::link::CLEARANCE_MM;
use crate::turning::planner::outline::{Turn, upper_pieces};
use crate::turning::planner::piece::{Piece, SAME_MM};
use crate::turning::planner::shape::Shape;
use crate::turning::planner::side::Side;
use crate::turning::planner::tool::{Cutter, Use};
use crate::turning::planner::work::Work;
use std::sync::Arc;

/// Distance of the line that radii count from beyond the bar, mm: every radius stays positive.
const BEYOND_BAR_MM: f64 = 100.0;

/// Distance that the back of a bar keeps from the wall behind it, mm.
const BEHIND_MM: f64 = 0.2;

/// Distance that the sleeve of a bar keeps from the work's end, mm.
const SLEEVE_MM: f64 = 1.0;

/// A bar that does not come in further than this does not come in, mm.
const SHALLOW_MM: f64 = 0.1;

/// How far tools go beyond the mouth of the bore on the radius, mm: more than any nose of a bar.
const OUT_OF_MOUTH_MM: f64 = 2.0;

/// Halvings of a stretch along the spindle until a place is found: 2⁻⁵⁰ of any bar is nothing.
const HALVINGS: u32 = 50;

/// Cut edges below this radius lie on the axis, mm.
const ON_AXIS_MM: f64 = 1e-6;

/// The bore of a set-up.
pub(super) struct Bore {
    pub(super) side: Side,
    /// The axis as the planner counts radii, mm.
    pub(super) axis: f64,
    /// Machined from here.
    pub(super) from_z: f64,
    /// True if the hole goes on beyond `from_z`.
    pub(super) open: bool,
    contour: PartContour,
}

impl Bore {
    /// The bore of a set-up; `None` if nothing of it is machined.
    fn of(setup: &Setup) -> Option<Self> {
        let profile = setup.bore.as_ref()?;
        // What is parted off needs no bore.
        let from_z = setup.part_off_width.map_or(setup.bored_from_z, |_| setup.bored_from_z.max(0.0));
        if from_z >= setup.length - SAME_MM || setup.tailstock.is_some() {
            return None;
        }
        let axis = setup.bar_radius + BEYOND_BAR_MM;
        let side = Side::Inside { from: axis };
        let mut contour = part::contour(profile, PARABOLA_TOLERANCE_MM);
        contour.contour.segments.iter_mut().for_each(|s| *s = side.segment(s));
        let open =
            profile.radius_at(from_z).is_some_and(|_| profile.pieces.first().is_some_and(|p| is_open(p, from_z)));
        Some(Self { side, axis, from_z, open, contour })
    }

    /// The work seen from inside; `end_z`: where the stock ends now.
    fn work(&self, setup: &Setup, machine: &Machine, end_z: f64) -> Work {
        let segments = &self.contour.contour.segments;
        let mut pieces: Vec<Piece> = segments.iter().filter_map(Piece::of).collect();
        // Solid behind the bottom of a blind hole.
        let bottom = segments.first().map(Segment::start).filter(|first| first.r >= self.axis - ON_AXIS_MM);
        if let Some(bottom) = bottom {
            pieces.insert(0, Piece::level(bottom.z - setup.length - setup.bar_radius, bottom.z, self.axis));
        }
        let stock = upper_pieces(&self.side.contour(&setup.stock), Turn::None);
        let stock: Vec<Chain> = stock.into_iter().map(|p| Chain { pieces: vec![p] }).collect();
        let face = setup.chuck_face_z;
        let held = Chain::level(face - machine.chuck.depth_mm, face, self.axis);
        let floor = segments.last().map_or(0.0, |s| s.end().r) - OUT_OF_MOUTH_MM;
        let stock = Chain::largest(&stock).clipped(f64::NEG_INFINITY, end_z);
        Work::of(Chain { pieces }, stock, &held, (self.from_z, setup.length), floor)
    }
}

/// True if the first piece of a bore shows that it goes on to the left of `z`: it begins before it, or open at it.
fn is_open(first: &part::Piece, z: f64) -> bool {
    let start = first.start();
    start.z < z - SAME_MM || start.r > ON_AXIS_MM
}

/// The bore as it is planned: a work of its own, seen from inside.
pub(super) struct Inside<'a> {
    order: Order<'a>,
    bore: Bore,
    /// Where bars could rough; the hole is wider then, but what was not roughed is not finished.
    roughed: f64,
}

impl<'a> Inside<'a> {
    /// The bore of a set-up; `None` if nothing of it is machined.
    pub(super) fn of(outside: &Order<'a>, setup: &Setup) -> Option<Self> {
        let bore = Bore::of(setup)?;
        let side = bore.side;
        let seen = outside.task.tools.iter().filter(|(_, outline)| outline.kind != ToolKind::Drill);
        let order = Order {
            machine: outside.machine,
            task: outside.task,
            datum: Point::new(outside.datum.z, bore.axis),
            rest: outside.rest,
            zero_z: outside.zero_z,
            side,
            work: bore.work(setup, outside.machine, outside.work.end_z()),
            rules: outside.rules,
            cutters: seen
                .filter_map(|(&station, outline)| Cutter::new(station, &side.tool(outline)?).map(Arc::new))
                .collect(),
            edit: None,
            operations: Vec::new(),
            diagnostics: Vec::new(),
        };
        Some(Self { order, bore, roughed: f64::INFINITY })
    }

    /// Drills, the widest first; bars rough, the strongest first, and finish, the finest first; grooves; threads.
    pub(super) fn steps(&self, setup: &Setup) -> Vec<Step> {
        let of = |wanted: fn(&Use) -> bool| -> Vec<&Arc<Cutter>> {
            let mut found: Vec<&Arc<Cutter>> = self.order.cutters.iter().filter(|c| wanted(&c.r#use)).collect();
            found.sort_by(|a, b| b.nose.total_cmp(&a.nose));
            found
        };
        let (right, left) = (of(|u| *u == Use::Right), of(|u| *u == Use::Left));
        let step = |kind| move |c: &&Arc<Cutter>| Step::of(kind, c.station);
        let mut steps: Vec<Step> =
            drills(self.order.task).into_iter().map(|k| Step::of(OperationKind::Drill, k)).collect();
        steps.extend(right.iter().map(step(OperationKind::RoughBore)));
        let finishing = steps.len();
        steps.extend(right.iter().rev().map(step(OperationKind::FinishBore)));
        if let Some(first) = steps.get_mut(finishing) {
            first.worth = FINISH_WORTH_MM;
        }
        for bar in &left {
            steps.extend([OperationKind::RoughBore, OperationKind::FinishBore].map(|k| Step::of(k, bar.station)));
        }
        steps.extend(of(|u| matches!(u, Use::Blade { .. })).iter().map(step(OperationKind::Groove)));
        let threading = of(|u| *u == Use::Thread).into_iter().min_by_key(|c| c.station);
        let thread = threading.filter(|_| !setup.bore_threads.is_empty());
        steps.extend(thread.map(|c| Step::of(OperationKind::ThreadBore, c.station)));
        steps
    }

    /// Takes a step; its operations go to those outside.
    pub(super) fn take(&mut self, outside: &mut Order<'a>, setup: &Setup, step: &Step, edit: Option<OperationEdit>) {
        let chosen = chosen(edit.as_ref());
        let station = chosen.unwrap_or(step.tool);
        let end_z = outside.work.end_z();
        let work = &mut self.order.work;
        for chain in [&mut work.stock, &mut work.cover] {
            *chain = chain.ended_at(end_z);
        }
        work.hanging = work.hanging.clipped_at(end_z);
        self.order.edit = edit;
        match step.kind {
            OperationKind::Drill => self.order.drill(&self.bore, station),
            OperationKind::ThreadBore => self.threads(setup, chosen),
            _ => self.cut(step, station),
        }
        self.order.edit = None;
        self.order.work.from_z = self.bore.from_z;
        let operations = std::mem::take(&mut self.order.operations);
        outside.operations.extend(operations.into_iter().map(|o| self.bore.side.operation(o)));
        outside.diagnostics.append(&mut self.order.diagnostics);
    }

    fn cut(&mut self, step: &Step, station: u32) {
        let found = self.order.cutters.iter().find(|c| c.station == station && does(c, step.kind));
        let Some(bar) = found.cloned() else {
            self.order.diagnostics.push(unsuitable(step.kind, station, &self.order.machine.name));
            return;
        };
        let roughs = step.kind == OperationKind::RoughBore;
        let from_z = if roughs { self.bore.from_z } else { self.bore.from_z.max(self.roughed) };
        if !self.order.comes_in(&bar, from_z) {
            return;
        }
        match step.kind {
            OperationKind::RoughBore => {
                self.order.rough(&bar);
                self.roughed = self.roughed.min(self.order.work.from_z);
            }
            OperationKind::FinishBore => self.order.finish(&bar, step.worth),
            _ => self.order.groove(&bar),
        }
    }

    /// Cuts every thread of the bore with the first bar for threads that comes in, or with the chosen one.
    fn threads(&mut self, setup: &Setup, chosen: Option<u32>) {
        let bars = self.order.cutters.iter().filter(|c| c.r#use == Use::Thread);
        let bars: Vec<Arc<Cutter>> = bars.filter(|c| chosen.is_none_or(|k| c.station == k)).cloned().collect();
        for thread in &setup.bore_threads {
            let from_z = self.bore.from_z;
            let reaches = |order: &mut Order<'_>, bar: &Cutter| {
                order.comes_in(bar, from_z) && order.work.from_z - bar.bottom.0 <= thread.z1 + thread.pitch
            };
            if let Some(bar) = bars.iter().find(|bar| reaches(&mut self.order, bar)) {
                self.order.threads(std::slice::from_ref(thread), bar);
            } else {
                let row = self.order.row(thread.section);
                self.order.diagnostics.push(not_threaded(row, &self.order.machine.name));
            }
        }
    }

    /// Says what is left, and what could not be made for want of a tool.
    pub(super) fn end(mut self, outside: &mut Order<'a>, setup: &Setup) {
        self.order.left(&self.bore.contour);
        if self.order.is_solid(&self.bore, self.bore.from_z) {
            let none = drills(self.order.task).is_empty();
            let drill = if none { "drill" } else { "drill that fits into it" };
            self.order.lacks("drill-missing", "a bore in solid stock", drill);
        }
        if self.order.lacks_turning() {
            self.order.lacks("boring-bar-missing", "a bore to be turned", "boring bar");
        }
        let has_bar = self.order.cutters.iter().any(|c| c.r#use == Use::Thread);
        if !setup.bore_threads.is_empty() && !has_bar {
            self.order.lacks("threading-bar-missing", "a thread in its bore", "threading bar");
        }
        outside.diagnostics.append(&mut self.order.diagnostics);
    }
}

impl Order<'_> {
    /// Finds how deep a bar can go into the hole as it is: with the way back from the wall that it cuts free, clear of the wall
    /// behind it, its tip not beyond the axis, and with its sleeve in the open. That is where machining begins for it. False if
    /// it does not come in.
    pub(super) fn comes_in(&mut self, bar: &Cutter, from_z: f64) -> bool {
        let (Some(outline), Side::Inside { from: axis }) = (self.task.tools.get(&bar.station), self.side) else {
            return false;
        };
        let air = self.work.air(bar);
        let behind = Shape::of([&outline.insert, &outline.holder], Turn::Both).over(&self.work.stock.chain());
        let height = |z: f64| air.highest(z, f64::INFINITY) + CLEARANCE_MM;
        let room = |z: f64| (2.0 * axis - behind.highest(z, f64::INFINITY) - BEHIND_MM).min(axis);
        let fits = |z: f64| height(z) <= room(z);
        let end = self.work.end_z();
        let deepest = (from_z - bar.bottom.0).max(end - bar.extent.1 + SLEEVE_MM);
        let mut place = deepest;
        if !fits(deepest) {
            let (mut tight, mut free) = (deepest, end);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(tight, free);
                if fits(middle) { free = middle } else { tight = middle }
            }
            place = free;
        }
        if end - place < SHALLOW_MM {
            return false;
        }
        self.work.from_z = place + bar.bottom.0;
        self.datum.r = height(place);
        true
    }
}

fn not_threaded(row: Place, machine: &str) -> Diagnostic {
    let message = format!("No threading bar of {machine} reaches the end of this thread; it is not cut.");
    Diagnostic::warning("thread-not-reached", row, message)
        .with_hint("Add a longer or thinner threading bar to the machine.")
}
