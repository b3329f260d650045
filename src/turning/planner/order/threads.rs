//! The threads of one side.

use super::Order;
use super::thread_passes::{Passes, flank_deg};
use crate::geometry::Point;
use crate::part::ThreadSpec;
use crate::turning::OperationKind;
use crate::turning::planner::link::go;
use crate::turning::planner::side::Side;
use crate::turning::planner::thread::{self, Reach};
use crate::turning::planner::tool::Cutter;

impl Order<'_> {
    /// Cuts threads with one tool: by the control's own cycle on the ORAC, pass by pass on controls that read words.
    pub(super) fn threads(&mut self, threads: &[ThreadSpec], cutter: &Cutter) {
        let Some(conditions) = self.conditions(OperationKind::Thread, cutter.station) else { return };
        let choices = self.task.part_mm.threading;
        let flank_deg = self.task.tools.get(&cutter.station).map_or(0.0, flank_deg);
        let mut path = self.path(&conditions, cutter);
        let mut recipes = Vec::new();
        for of_part in threads {
            let spec = self.side.thread(of_part);
            let by_words = self.machine.words.is_some();
            let run_out = if by_words { choices.run_out.max(0.0) * spec.pitch } else { 0.0 };
            let row = self.row(spec.section);
            let reach = Reach::of(&spec, &self.work, cutter, run_out, row);
            self.diagnostics.extend(reach.said.clone());
            if reach.is_empty(&spec) {
                continue;
            }
            let clear = self.clear_of(&spec);
            go(&mut path, Point::new(reach.start, clear));
            if by_words {
                let (spec, reach, machine, conditions) = (&spec, &reach, self.machine, &conditions);
                let passes = Passes { spec, reach, machine, conditions, choices, flank_deg, clear };
                recipes.extend(passes.cut(&mut path));
            } else {
                path.push(thread::cycle(&spec, &reach, self.machine, conditions.depth));
            }
        }
        self.add(OperationKind::Thread, cutter, path);
        if let Some(operation) = self.operations.last_mut().filter(|_| !recipes.is_empty()) {
            operation.recipes = recipes;
        }
    }

    /// Height at which the tool goes back over a thread, mm.
    fn clear_of(&self, spec: &ThreadSpec) -> f64 {
        let clear = spec.crest_radius + self.machine.datum.radial_clearance_mm;
        match self.side {
            Side::Outside => clear,
            Side::Inside { .. } => clear.min(self.datum.r.max(spec.crest_radius)),
        }
    }
}
