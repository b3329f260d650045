//! Which tool does what, and in which order.

mod bore;
mod drill;
mod face;
mod part_off;
mod steps;
mod thread_passes;
mod threads;

use super::chain::PIT_MM;
use super::conditions::Conditions;
use super::follow::Follow;
use super::groove;
use super::left::{self, Left};
use super::link::{LEAN, go};
use super::path::Path;
use super::rough::Rough;
use super::side::Side;
use super::tool::{Cutter, Use};
use super::trace::ArcRules;
use super::work::Work;
use crate::diagnostic::{Diagnostic, Place, SectionTable, Severity};
use crate::document::OperationEdit;
use crate::geometry::Point;
use crate::machine::{Machine, ToolOutline};
use crate::part::{PartContour, Setup};
use crate::turning::{Operation, OperationKind, Task};
use std::sync::Arc;

/// Share of the depth of cut above which steps that roughing leaves are cut away along the contour before finishing.
const CLEANED_SHARE: f64 = 0.4;

/// The same where blocks are scarce: finishing may take a full depth, but not more.
const CLEANED_SHARE_SPARING: f64 = 1.05;

/// Depth of a cut below the height of the edge, mm: the last bit of an edge is no good.
const EDGE_KEPT_MM: f64 = 0.05;

/// A control that holds fewer blocks than this is spared passes that only even out the load.
const SCARCE_BLOCKS: usize = 500;

/// What may stay above the contour without a further pass, mm: a tenth of what a drawing asks of a turned part.
const FINISH_WORTH_MM: f64 = 0.002;

/// What may stay before another tool is taken for it, mm.
const TOOL_WORTH_MM: f64 = 0.02;

/// Blocks of a program that are no moves, at most: start and end.
const BLOCKS_AROUND: usize = 4;

/// Blocks that signal a tool change and the end to automatic handling.
const BLOCKS_OF_SIGNALS: usize = 6;

/// Moves home, at most.
const MOVES_HOME: usize = 3;

/// The plan as it grows.
pub(super) struct Order<'a> {
    machine: &'a Machine,
    task: &'a Task<'a>,
    /// Where operations begin and end whose tool has no place of its own; its radius is free everywhere.
    datum: Point,
    /// Where tools are changed that have no place of their own, as the machine sees it.
    rest: Point,
    /// Position of the control's zero.
    zero_z: f64,
    /// From where the work is cut.
    side: Side,
    work: Work,
    rules: ArcRules,
    cutters: Vec<Arc<Cutter>>,
    /// What the user changed of the operation that is planned.
    edit: Option<OperationEdit>,
    operations: Vec<Operation>,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Order<'a> {
    /// A plan without operations.
    pub(super) fn new(task: &'a Task<'a>, contour: &PartContour, datum: Point, zero_z: f64) -> Self {
        Self {
            machine: task.machine,
            task,
            datum,
            rest: datum,
            zero_z,
            side: Side::Outside,
            work: Work::new(task.setup, contour, task.machine),
            rules: ArcRules::from(&task.machine.limits),
            cutters: task
                .tools
                .iter()
                .filter_map(|(&k, outline)| cutter(k, outline, task.setup).map(Arc::new))
                .collect(),
            edit: None,
            operations: Vec::new(),
            diagnostics: Vec::new(),
        }
    }

    /// The operations, and what is to be said about them.
    pub(super) fn done(self) -> (Vec<Operation>, Vec<Diagnostic>) {
        (self.operations, self.diagnostics)
    }

    /// The row of a section.
    fn row(&self, id: u32) -> Place {
        let (table, index) = self.task.part_mm.row(id).map_or((SectionTable::Outside, 0), |(table, k, _)| (table, k));
        Place::Section { id, row: index + 1, column: None, table }
    }

    /// Feeds, speeds and depths; without them the operation is left out, and that is said once.
    fn conditions(&mut self, kind: OperationKind, station: u32) -> Option<Conditions> {
        let found = self.looked_up(kind, station);
        if found.is_none() && !self.diagnostics.iter().any(|d| d.code == "no-cutting-data") {
            let message = format!(
                "The material table has no usable speed, feed and depth of {} for \"{}\" on {}.",
                self.task.material_mm.name,
                self.side.kind(kind).name(),
                self.machine.name
            );
            let said = Diagnostic::error("no-cutting-data", Place::Stock, message)
                .with_hint("Choose another material, or add the row to the material table.");
            self.diagnostics.push(said);
        }
        found
    }

    /// Feeds, speeds and depths, as changed by the user.
    fn looked_up(&self, kind: OperationKind, station: u32) -> Option<Conditions> {
        let (machine, material) = (self.machine, self.task.material_mm);
        let edge = self.task.tools.get(&station).map(|tool| tool.edge).unwrap_or_default();
        let found = Conditions::of(self.side.kind(kind), edge, self.side, machine, material)?;
        let found = match &self.edit {
            Some(edit) => found.changed(edit, machine),
            None => found,
        };
        let width = self.chip_width(kind, station, &found);
        Some(found.within_power(&machine.spindle, material, width))
    }

    /// Depth of cut, or of blades and drills the width of the edge, mm.
    fn chip_width(&self, kind: OperationKind, station: u32, conditions: &Conditions) -> f64 {
        let insert = self.task.tools.get(&station).and_then(|tool| tool.insert.bounds());
        match (kind, insert) {
            (OperationKind::Groove | OperationKind::PartOff, Some(bounds)) => bounds.max.z - bounds.min.z,
            (OperationKind::Drill, Some(bounds)) => bounds.max.r,
            (OperationKind::FinishRight | OperationKind::FinishLeft | OperationKind::FinishBore, _) => {
                conditions.depth.max(conditions.allowance)
            }
            _ => conditions.depth,
        }
    }

    /// Where the turret turns to a station.
    fn change(&self, station: u32) -> Option<Point> {
        let of_machine = self.machine.change_position(station);
        let change = of_machine.map(|place| Point::new(place.z_mm + self.zero_z, place.diameter_mm / 2.0));
        match self.side {
            Side::Outside => change,
            Side::Inside { .. } => Some(self.side.point(change.unwrap_or(self.rest))),
        }
    }

    /// The moves of an operation that begins where its tool is changed.
    fn path<'c>(&self, conditions: &'c Conditions, cutter: &'c Cutter) -> Path<'c> {
        let home = self.change(cutter.station).unwrap_or(self.datum);
        Path::new(conditions, cutter, &self.work, home, self.datum.r, self.machine.limits.taper_ratio)
    }

    /// Strokes, then once along what they leave where it is rough.
    fn rough(&mut self, cutter: &Cutter) {
        let left_handed = cutter.turned || cutter.r#use == Use::Left;
        let kind = if left_handed { OperationKind::RoughLeft } else { OperationKind::RoughRight };
        let Some(conditions) = self.conditions(kind, cutter.station) else { return };
        let share =
            if self.machine.limits.blocks_per_program < SCARCE_BLOCKS { CLEANED_SHARE_SPARING } else { CLEANED_SHARE };
        let depth = conditions.depth.min(cutter.reach - EDGE_KEPT_MM);
        let worth = share * depth;
        // Another tool of a hand is taken only for what is too thick to be finished.
        let least = if self.operations.iter().any(|o| o.kind == kind) { depth } else { worth };
        let work = self.work.seen_by(cutter);
        let kept = work.kept(conditions.allowance);
        if depth <= 0.0 || !work.has_above(&kept, least) {
            return;
        }
        let limit = work.limit_over(cutter, &kept);
        let touch = cutter.insert.over_floor(&work.stock.chain(), limit.z0, limit.z1, &limit.chain);
        let thick = touch.runs_over(&limit.chain, least);
        if thick.iter().all(|run| run.width() <= PIT_MM) {
            return;
        }
        let rolled = cutter.nose + conditions.allowance;
        let rough = Rough { limit: &limit, top: work.top(), depth, rolled, rules: self.rules, room: usize::MAX };
        let mut path = self.path(&conditions, cutter);
        rough.cut(&mut path, self.room());
        if path.len() + MOVES_HOME > self.room() {
            path = self.path(&conditions, cutter);
            Rough { room: self.room(), ..rough }.cut(&mut path, usize::MAX);
        }
        Follow { cutter, limit: &limit, allowance: conditions.allowance, worth, rules: self.rules }.cut(&mut path);
        self.add(kind, cutter, path);
    }

    /// Along the contour wherever something is left that the tool can reach.
    fn finish(&mut self, cutter: &Cutter, worth: f64) {
        let left_handed = cutter.turned || cutter.r#use == Use::Left;
        let kind = if left_handed { OperationKind::FinishLeft } else { OperationKind::FinishRight };
        let Some(conditions) =
            self.conditions(kind, cutter.station).filter(|_| self.work.has_above(&self.work.part, worth))
        else {
            return;
        };
        let mut path = self.path(&conditions, cutter);
        self.follow(&mut path, cutter, worth);
        self.add(kind, cutter, path);
    }

    /// Along the finished contour.
    fn follow(&self, path: &mut Path<'_>, cutter: &Cutter, worth: f64) {
        let limit = path.work.limit(cutter, 0.0);
        Follow { cutter, limit: &limit, allowance: 0.0, worth, rules: self.rules }.cut(path);
    }

    /// Plunges, then down along either wall.
    fn groove(&mut self, cutter: &Cutter) {
        let Use::Blade { width } = cutter.r#use else { return };
        let Some(conditions) = self.conditions(OperationKind::Groove, cutter.station) else { return };
        let limit = self.work.limit(cutter, conditions.allowance);
        let touch = cutter.insert.over(&self.work.stock.chain());
        let plunges = groove::plunges(&limit, &touch, width);
        if plunges.is_empty() {
            return;
        }
        let seen = self.task.tools.get(&cutter.station).and_then(|outline| self.side.tool(outline));
        let twin = seen.and_then(|outline| Cutter::turned(cutter.station, &outline));
        let mut path = self.path(&conditions, cutter);
        groove::cut(&mut path, &plunges, &limit);
        self.follow(&mut path, cutter, TOOL_WORTH_MM);
        if let Some(twin) = &twin {
            path.turn(twin);
            self.follow(&mut path, twin, TOOL_WORTH_MM);
        }
        self.add(OperationKind::Groove, cutter, path);
    }

    /// Takes what was cut from the stock, brings the tool home and keeps the operation, if it does anything.
    fn add(&mut self, kind: OperationKind, cutter: &Cutter, mut path: Path<'_>) {
        if let Side::Inside { .. } = self.side {
            // Off the wall, and out along the hole.
            let height = self.datum.r.max(path.at.r);
            let off = Point::new(path.at.z + LEAN * (height - path.at.r), height);
            go(&mut path, off);
        }
        path.home();
        let (rounds, work) = path.done();
        self.work = work;
        let change = self.change(cutter.station);
        let kind = self.side.kind(kind);
        let name = kind.name();
        self.operations.extend(rounds.into_iter().map(|moves| Operation {
            kind,
            name: name.to_owned(),
            tool: cutter.station,
            change,
            moves,
            recipes: Vec::new(),
        }));
    }

    /// Moves of one operation at most.
    fn room(&self) -> usize {
        let signals = if self.task.part_mm.automatic { BLOCKS_OF_SIGNALS } else { 0 };
        self.machine.limits.blocks_per_program.saturating_sub(BLOCKS_AROUND + signals)
    }

    /// Says what is left where no tool could go.
    fn left(&mut self, contour: &PartContour) {
        for left in left::measure(&self.work, contour) {
            let Left { section, height, at } = left;
            let at = self.side.point(at);
            let message = format!(
                "No tool of {} reaches all of this row: {height:.3} mm are left at z {:.3}, diameter {:.3}.",
                self.machine.name,
                at.z,
                2.0 * at.r
            );
            let largest_nose = self.cutters.iter().map(|c| c.nose).fold(0.0, f64::max);
            let hint =
                "A smaller nose radius, a blade, or a tool of the other hand may reach it; all else is programmed.";
            let row = self.row(section);
            let said = if height > largest_nose {
                Diagnostic::warning("not-reached", row, message)
            } else {
                Diagnostic::new(Severity::Info, "not-reached", row, message)
            };
            self.diagnostics.push(said.with_hint(hint));
        }
    }

    /// Says which kinds of tools are missing outside.
    fn missing(&mut self, setup: &Setup) {
        if self.lacks_turning() {
            self.lacks("turning-tool-missing", "an outside to be turned", "turning tool");
        }
        if !setup.threads.is_empty() && !self.cutters.iter().any(|c| c.r#use == Use::Thread) {
            self.lacks("threading-tool-missing", "a thread", "threading tool");
        }
        if setup.part_off_width.is_some() && self.blades().is_empty() {
            self.lacks("blade-missing", "to be parted off", "parting blade");
        }
    }

    /// True if something is left on a surface, and no tool is there that follows one.
    fn lacks_turning(&self) -> bool {
        let turns = |c: &Arc<Cutter>| matches!(c.r#use, Use::Right | Use::Left);
        self.diagnostics.iter().any(|d| d.code == "not-reached") && !self.cutters.iter().any(turns)
    }

    /// Says that a tool is missing; every kind has a code of its own, for several may be missing.
    fn lacks(&mut self, code: &'static str, what: &str, tool: &str) {
        let message = format!("The part has {what}, and {} has no {tool} in its turret.", self.machine.name);
        let said = Diagnostic::warning(code, Place::Document, message);
        self.diagnostics.push(said.with_hint("Add the tool to the machine."));
    }
}

/// A tool as it is planned: where both directions may be cut, one that cuts away from the headstock is seen from the other end.
pub(super) fn cutter(station: u32, outline: &ToolOutline, setup: &Setup) -> Option<Cutter> {
    if setup.may_cut_both_ways() && !outline.cuts_towards_headstock() && outline.cuts_away_from_headstock() {
        Cutter::turned(station, outline)
    } else {
        Cutter::new(station, outline)
    }
}
