//! The steps of a plan: which the planner would take, what the user changed of them, and taking them one after another.
//!
//! Every step works on what the steps before it left, so that whatever is changed, left out or put elsewhere, the rest is
//! planned around it.

use super::bore::Inside;
use super::{FINISH_WORTH_MM, Order, TOOL_WORTH_MM};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{OperationEdit, OperationKind, OperationRef};
use crate::part::{PartContour, Setup};
use crate::turning::planner::hand;
use crate::turning::planner::tool::{Cutter, Use};
use std::sync::Arc;

/// One step: an operation that may turn out to have nothing to do.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Step {
    pub(super) kind: OperationKind,
    /// Turret station that the planner chose; 0 where the step itself chooses the tool.
    pub(super) tool: u32,
    /// What may stay without a further finishing pass, mm.
    pub(super) worth: f64,
}

impl Step {
    pub(super) const fn of(kind: OperationKind, tool: u32) -> Self {
        Self { kind, tool, worth: TOOL_WORTH_MM }
    }
}

impl Order<'_> {
    /// Plans everything.
    pub(in crate::turning::planner) fn plan(&mut self, setup: &Setup, contour: &PartContour) {
        let mut inside = Inside::of(self, setup);
        let mut steps = self.steps(setup);
        steps.extend(inside.as_ref().map(|inside| inside.steps(setup)).into_iter().flatten());
        steps.extend(self.last_steps(setup));
        for step in self.changed(steps) {
            let edit = self.edit_of(&step).cloned();
            if edit.as_ref().is_some_and(|edit| edit.skip) {
                continue;
            }
            match &mut inside {
                Some(inside) if self.is_in_bore(&step) => inside.take(self, setup, &step, edit),
                _ => {
                    let chosen = chosen(edit.as_ref());
                    self.edit = edit;
                    self.take(setup, &step, chosen);
                    self.edit = None;
                }
            }
        }
        self.left(contour);
        self.stub(setup);
        self.missing(setup);
        if let Some(inside) = inside {
            inside.end(self, setup);
        }
    }

    /// What the planner does outside, but for threads and parting off.
    fn steps(&self, setup: &Setup) -> Vec<Step> {
        let mut steps = vec![Step::of(OperationKind::Face, self.facing_station(setup))];
        steps.extend(self.turning());
        steps.extend(self.blades().iter().map(|c| Step::of(OperationKind::Groove, c.station)));
        steps
    }

    fn last_steps(&self, setup: &Setup) -> Vec<Step> {
        let threading = self.cutters.iter().find(|c| c.r#use == Use::Thread);
        let thread =
            threading.filter(|_| !setup.threads.is_empty()).map(|c| Step::of(OperationKind::Thread, c.station));
        let blade = setup.part_off_width.and(self.blades().first().map(|c| c.station));
        let off = blade.map(|_| Step::of(OperationKind::PartOff, 0));
        thread.into_iter().chain(off).collect()
    }

    pub(super) fn blades(&self) -> Vec<Arc<Cutter>> {
        self.cutters.iter().filter(|c| matches!(c.r#use, Use::Blade { .. })).cloned().collect()
    }

    /// Roughing and finishing with the turning tools of either hand.
    fn turning(&self) -> Vec<Step> {
        let of = |wanted: fn(&Cutter) -> bool| -> Vec<Arc<Cutter>> {
            self.cutters.iter().filter(|c| wanted(c)).cloned().collect()
        };
        let hands = [
            of(|c| c.r#use == Use::Right && !c.turned),
            of(|c| c.r#use == Use::Left || (c.r#use == Use::Right && c.turned)),
        ];
        let first = hands.iter().flatten().next().map(|c| c.station);
        let depth = first.and_then(|k| self.looked_up(OperationKind::RoughRight, k)).map_or(0.0, |c| c.depth);
        let kinds = [
            (OperationKind::RoughRight, OperationKind::FinishRight),
            (OperationKind::RoughLeft, OperationKind::FinishLeft),
        ];
        let hands: Vec<(Vec<Step>, Vec<Step>)> = hands
            .iter()
            .zip(kinds)
            .map(|(tools, (rough, finish))| {
                let roughing = hand::roughing(tools, depth).iter().map(|c| Step::of(rough, c.station)).collect();
                let finishing = hand::finishing(tools).iter().map(|c| Step::of(finish, c.station)).collect();
                (roughing, finishing)
            })
            .collect();
        let stays =
            |(rough, finish): &(Vec<Step>, Vec<Step>)| rough.first().map(|s| s.tool) == finish.first().map(|s| s.tool);
        let roughing = hands.iter().map(|(rough, _)| rough.as_slice());
        let finishing = hands.iter().map(|(_, finish)| finish.get(..1).unwrap_or_default());
        let mut steps: Vec<Step> = if hands.iter().all(stays) {
            // Finishing at once spares changes of tool.
            roughing.zip(finishing).flat_map(|(rough, finish)| rough.iter().chain(finish)).cloned().collect()
        } else {
            // The strongest tool of either hand, before others look for what is left.
            let strongest = hands.iter().map(|(rough, _)| rough.get(..1).unwrap_or_default());
            let others = hands.iter().map(|(rough, _)| rough.get(1..).unwrap_or_default());
            strongest.chain(others).chain(finishing).flatten().cloned().collect()
        };
        steps.extend(hands.iter().flat_map(|(_, finish)| finish.iter().skip(1)).cloned());
        // The first finishing tool cuts all that it can, others what is worth them.
        let is_finish = |s: &&mut Step| matches!(s.kind, OperationKind::FinishRight | OperationKind::FinishLeft);
        if let Some(first) = steps.iter_mut().find(is_finish) {
            first.worth = FINISH_WORTH_MM;
        }
        steps
    }

    /// The steps as the user changed them: in another order, and with those that are locked though the planner would not
    /// take them any more.
    fn changed(&self, mut steps: Vec<Step>) -> Vec<Step> {
        let (plan, clamping) = (&self.task.part_mm.plan, &self.task.setup.suffix);
        for locked in plan.operations.iter().filter(|e| e.locked && e.operation.clamping == *clamping) {
            let OperationRef { kind, tool, .. } = locked.operation;
            if !steps.iter().any(|s| locked.operation.is(clamping, s.kind, s.tool)) {
                let behind = steps.iter().rposition(|s| s.kind == kind).map_or(steps.len(), |k| k + 1);
                steps.insert(behind, Step::of(kind, tool));
            }
        }
        let name = |s: &Step| OperationRef { clamping: clamping.clone(), kind: s.kind, tool: s.tool };
        let ordered = plan.ordered(steps.iter().map(name).collect());
        let named = |wanted: &OperationRef| steps.iter().find(|s| wanted.is(clamping, s.kind, s.tool)).cloned();
        ordered.iter().filter_map(named).collect()
    }

    fn is_in_bore(&self, step: &Step) -> bool {
        use OperationKind::{Drill, FinishBore, Groove, RoughBore, ThreadBore};
        let tool_is_inside = || self.task.tools.get(&step.tool).is_some_and(|tool| tool.kind.is_inside());
        match step.kind {
            Drill | RoughBore | FinishBore | ThreadBore => true,
            Groove => tool_is_inside(),
            _ => false,
        }
    }

    fn edit_of(&self, step: &Step) -> Option<&OperationEdit> {
        self.task.part_mm.plan.of(&self.task.setup.suffix, step.kind, step.tool)
    }

    /// Takes a step outside with the chosen tool, or the planner's.
    fn take(&mut self, setup: &Setup, step: &Step, chosen: Option<u32>) {
        let station = chosen.unwrap_or(step.tool);
        match step.kind {
            OperationKind::Face => self.face(setup, chosen),
            OperationKind::PartOff => {
                let fits = |b: &Arc<Cutter>| chosen.is_none_or(|station| b.station == station);
                let blades: Vec<Arc<Cutter>> = self.blades().into_iter().filter(fits).collect();
                self.part_off(setup, &blades);
            }
            _ => match self.cutters.iter().find(|c| c.station == station && does(c, step.kind)).cloned() {
                Some(cutter) => self.take_with(setup, step, &cutter),
                None => self.diagnostics.push(unsuitable(step.kind, station, &self.machine.name)),
            },
        }
    }

    fn take_with(&mut self, setup: &Setup, step: &Step, cutter: &Cutter) {
        match step.kind {
            OperationKind::RoughRight | OperationKind::RoughLeft => self.rough(cutter),
            OperationKind::FinishRight | OperationKind::FinishLeft => self.finish(cutter, step.worth),
            OperationKind::Groove => self.groove(cutter),
            OperationKind::Thread => self.threads(&setup.threads, cutter),
            _ => {}
        }
    }
}

/// The tool that the user wants: another one, or of a locked operation its own.
pub(super) fn chosen(edit: Option<&OperationEdit>) -> Option<u32> {
    let edit = edit?;
    edit.tool.or(edit.locked.then_some(edit.operation.tool))
}

/// True if a tool can do such an operation.
pub(super) fn does(cutter: &Cutter, kind: OperationKind) -> bool {
    match kind {
        OperationKind::Groove | OperationKind::PartOff => matches!(cutter.r#use, Use::Blade { .. }),
        OperationKind::Thread | OperationKind::ThreadBore => cutter.r#use == Use::Thread,
        _ => matches!(cutter.r#use, Use::Right | Use::Left),
    }
}

pub(super) fn unsuitable(kind: OperationKind, station: u32, machine: &str) -> Diagnostic {
    let message =
        format!("\"{}\" was given tool {station}, which cannot do it on {machine}; it is left out.", kind.name());
    Diagnostic::warning("tool-unsuitable", Place::Tool { station }, message)
        .with_hint("Choose another tool for the operation, or take the planner's.")
}
