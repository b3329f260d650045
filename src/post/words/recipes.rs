//! What a control can make by itself: compensation of the nose, and cycles for roughing, finishing and threads.

use super::writer::Writer;
use crate::geometry::{Point, Vector};
use crate::turning::{CutMove, FinishRecipe, Operation, RecipeKind, RoughRecipe, Side, ThreadRecipe};

/// Angles of the tool tip that G76 of a Fanuc knows, degrees.
const FANUC_TIP_DEG: [u32; 6] = [0, 29, 30, 55, 60, 80];

/// A contour that G71 left in the program for G70.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Profile {
    contour: Vec<CutMove>,
    /// Where G71 began, and where G70 must begin too: both go back there straight.
    start: Point,
    first: u32,
    last: u32,
}

impl Writer<'_> {
    /// The moves of an operation, recipes in place of those that they stand for where control and user want them.
    pub(super) fn body(&mut self, operation: &Operation) {
        let mut done = 0;
        for recipe in &operation.recipes {
            let (start, end) = (recipe.moves.start, recipe.moves.end);
            let parts = operation.moves.get(done..start).zip(operation.moves.get(start..end));
            let Some((before, moves)) = parts else { break };
            self.moves(before, Vector::zeros());
            if !self.recipe(&recipe.kind, moves) {
                self.moves(moves, Vector::zeros());
            }
            done = end;
        }
        self.moves(operation.moves.get(done..).unwrap_or_default(), Vector::zeros());
    }

    /// Writes a recipe in place of `moves`; false if the moves are to be written.
    fn recipe(&mut self, kind: &RecipeKind, moves: &[CutMove]) -> bool {
        let control = self.control;
        let cycles = control.options.canned_cycles && control.words.canned_cycles && !control.words.incremental;
        match kind {
            RecipeKind::Finish(recipe) if control.options.compensated_by_control => self.compensated(recipe, moves),
            RecipeKind::Finish(_) if cycles => self.finish_cycle(moves),
            RecipeKind::Rough(recipe) if cycles && !control.is_linuxcnc() => self.rough_cycle(recipe),
            RecipeKind::Thread(recipe) if cycles => {
                self.thread_cycle(recipe);
                true
            }
            RecipeKind::Finish(_) | RecipeKind::Rough(_) | RecipeKind::Thread(_) => false,
        }
    }

    /// The contour itself with G41 or G42, from the block that goes to it to the block that leaves it.
    fn compensated(&mut self, recipe: &FinishRecipe, moves: &[CutMove]) -> bool {
        let Some(end) = moves.last().and_then(end_of) else { return false };
        let control = self.control;
        // A control that counts arcs the other way round sees the work in a mirror.
        let code = if (recipe.side == Side::Right) == control.words.g2_is_ccw { "G41" } else { "G42" };
        self.pending = Some(if control.is_linuxcnc() {
            let diameter = control.in_unit(2.0 * recipe.nose_radius);
            format!("{code}.1 D{diameter:.4} L{}", linuxcnc_orientation(recipe.orientation))
        } else {
            code.to_owned()
        });
        self.moves(&recipe.contour, Vector::zeros());
        self.pending = Some("G40".to_owned());
        self.state.exact = end;
        if !control.words.incremental {
            self.state.at = None;
        }
        true
    }

    /// G71 with the contour behind it.
    fn rough_cycle(&mut self, recipe: &RoughRecipe) -> bool {
        let Some(first) = recipe.contour.first().and_then(end_of) else { return false };
        if self.control.grid.counts(first).z != self.control.grid.counts(recipe.start).z {
            return false;
        }
        self.rapid(recipe.start);
        self.spindle_for(&recipe.cut, recipe.start.r.abs());
        let mut trial = self.clone();
        trial.profile_blocks(recipe);
        let count = u32::try_from(trial.blocks.len() - self.blocks.len()).unwrap_or(u32::MAX);
        let numbers = self.number_ahead(2).zip(self.number_ahead(count.saturating_add(1)));
        let Some((first, last)) = numbers else { return false };
        let length = |mm: f64| self.control.grid.format.counts(self.control.in_unit(mm));
        let (depth, retract) = (length(recipe.depth), length(recipe.retract));
        let x_per_radius = self.control.words.x_at(1.0);
        let (u, w) = (length(recipe.allowance_radius * x_per_radius), length(recipe.allowance_z));
        let mut line = self.line();
        line.whole('G', 71).length('U', depth).length('R', retract);
        self.push(line);
        let mut line = self.line();
        line.whole('G', 71).whole('P', first).whole('Q', last).length('U', u).length('W', w);
        let feed = self.control.feed_counts(&recipe.cut, recipe.start.r);
        line.number('F', self.control.feed, feed);
        self.push(line);
        self.profile_blocks(recipe);
        self.profile = Some(Profile { contour: recipe.contour.clone(), start: recipe.start, first, last });
        self.cycle_done(recipe.start);
        true
    }

    /// The blocks between P and Q: the first goes in across the spindle, and every one has what G70 needs.
    fn profile_blocks(&mut self, recipe: &RoughRecipe) {
        self.state.motion = None;
        self.state.feed = None;
        // G71 has its own speed, and the operation of G70 sets its own: no speed stands between P and Q.
        let cut = recipe.contour.iter().find_map(|m| match m {
            CutMove::Line { cut, .. } | CutMove::Arc { cut, .. } => Some(cut),
            _ => None,
        });
        if let Some(cut) = cut {
            self.state.spindle = Some(self.control.spindle(cut, recipe.start.r.abs()));
        }
        self.moves(&recipe.contour, Vector::zeros());
    }

    /// G70 along the contour that G71 left in this program, if the moves are the same, its rapid way in across the spindle
    /// aside.
    fn finish_cycle(&mut self, moves: &[CutMove]) -> bool {
        let same = |profile: &mut Profile| match profile.contour.split_first() {
            Some((CutMove::Rapid { .. }, rest)) => rest == moves,
            _ => profile.contour == moves,
        };
        let Some(profile) = self.profile.take_if(same) else { return false };
        self.rapid(profile.start);
        let mut line = self.line();
        line.whole('G', 70).whole('P', profile.first).whole('Q', profile.last);
        self.push(line);
        self.profile = Some(profile);
        self.cycle_done(self.state.exact);
        true
    }

    /// G76: the whole thread.
    fn thread_cycle(&mut self, recipe: &ThreadRecipe) {
        let start = self.state.exact;
        self.spindle(self.control.fixed(recipe.rpm));
        if self.control.is_linuxcnc() {
            self.linuxcnc_thread(recipe, start);
        } else {
            self.fanuc_thread(recipe, start);
        }
        self.state.feed = None;
        self.cycle_done(start);
    }

    /// Two blocks: passes at full depth, run-out, tip angle, least cut and finishing cut; then the thread. Depths are counts.
    fn fanuc_thread(&mut self, recipe: &ThreadRecipe, start: Point) {
        let control = self.control;
        let counts = |mm: f64| control.grid.format.counts(control.in_unit(mm));
        let tip = 2.0 * recipe.flank_deg;
        let off = |angle: u32| (f64::from(angle) - tip).abs();
        let angle = FANUC_TIP_DEG.into_iter().min_by(|a, b| off(*a).total_cmp(&off(*b))).unwrap_or(0);
        let passes = u32::from(recipe.spring_passes) + 1;
        let mut line = self.line();
        let run_out = tenths_of_lead(recipe);
        line.whole('G', 76).word(&format!("P{passes:02}{run_out:02}{angle:02}"));
        line.word(&format!("Q{}", counts(recipe.least_depth))).length('R', counts(recipe.finish_depth));
        self.push(line);
        let end = control.grid.counts(Point::new(end_z(recipe, start), recipe.root_radius));
        let height = counts((recipe.crest_radius - recipe.root_radius).abs());
        let mut line = self.line();
        line.whole('G', 76).length('X', end.x).length('Z', end.z);
        line.word(&format!("P{height}")).word(&format!("Q{}", counts(recipe.first_depth)));
        line.number('F', control.lead, control.lead.counts(control.in_unit(recipe.lead)));
        self.push(line);
    }

    /// One block: lead, end, crest from the drive line (the present X), first and full depth, equal chip areas, flank angle.
    fn linuxcnc_thread(&mut self, recipe: &ThreadRecipe, start: Point) {
        let control = self.control;
        let counts = |mm: f64| control.grid.format.counts(control.in_unit(mm));
        let end = control.grid.counts(Point::new(end_z(recipe, start), recipe.root_radius));
        // With G7 the control takes I, J and K as diameters, like X.
        let across = control.words.x_at(1.0).abs();
        let mut line = self.line();
        line.whole('G', 76).number('P', control.lead, control.lead.counts(control.in_unit(recipe.lead)));
        line.length('Z', end.z).length('I', counts((recipe.crest_radius - start.r) * across));
        line.length('J', counts(recipe.first_depth * across));
        line.length('K', counts((recipe.crest_radius - recipe.root_radius).abs() * across));
        line.word("R2.0").word(&format!("Q{:.1}", recipe.flank_deg)).word(&format!("H{}", recipe.spring_passes));
        if recipe.run_out > 0.0 {
            line.length('E', counts(recipe.run_out)).word("L2");
        }
        self.push(line);
    }

    /// After a cycle the tool is where the cycle began, and nothing modal is relied on.
    fn cycle_done(&mut self, start: Point) {
        self.state.motion = None;
        self.state.feed = None;
        self.arrived(start, self.control.grid.counts(start));
    }
}

/// Where the tool is clear again behind the thread, mm.
fn end_z(recipe: &ThreadRecipe, start: Point) -> f64 {
    recipe.to_z + recipe.run_out * (recipe.to_z - start.z).signum()
}

/// The run-out as G76 of a Fanuc has it in the middle digits of its P: tenths of the lead, 99 at most. On that length, and
/// not further in than the thread ends, the tool goes out at 45°.
fn tenths_of_lead(recipe: &ThreadRecipe) -> u32 {
    const MOST: u32 = 99;
    // Rounded down: a longer one would begin within the thread.
    let tenths = (10.0 * recipe.run_out / recipe.lead + 1e-6).floor();
    super::control::rounded(tenths.max(0.0)).min(MOST)
}

/// Where a move ends, if it goes anywhere by itself.
const fn end_of(cut_move: &CutMove) -> Option<Point> {
    match *cut_move {
        CutMove::Rapid { to } | CutMove::Line { to, .. } | CutMove::Arc { to, .. } => Some(to),
        CutMove::Thread { .. } | CutMove::ThreadPass { .. } | CutMove::Dwell { .. } | CutMove::Repeat { .. } => None,
    }
}

/// The orientation in LinuxCNC's count, which mirrors the one of a rear turret at the spindle.
const fn linuxcnc_orientation(orientation: u8) -> u8 {
    match orientation {
        1 => 4,
        2 => 3,
        3 => 2,
        4 => 1,
        6 => 8,
        8 => 6,
        other => other,
    }
}
