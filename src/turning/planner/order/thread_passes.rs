//! Threads pass by pass, outside and in a bore, for controls that couple the slide to the spindle.
//!
//! Passes of equal chip area: the depth after n of them is that of the first times √n. Along a flank the tool begins further
//! back while it is not deep yet, so that every pass lies within the last one's groove.

use crate::document::{Infeed, ThreadChoices};
use crate::geometry::{Point, Segment};
use crate::machine::{Machine, ToolOutline};
use crate::part::ThreadSpec;
use crate::turning::planner::conditions::Conditions;
use crate::turning::planner::path::Path;
use crate::turning::planner::thread::Reach;
use crate::turning::{CutMove, Recipe, RecipeKind, ThreadRecipe};

/// Thinnest pass but the last, mm on the radius: a thinner one rubs.
const LEAST_DEPTH_MM: f64 = 0.03;

/// What the last pass takes, mm on the radius.
const FINISH_DEPTH_MM: f64 = 0.02;

/// First pass where the material's table gives none, in pitches.
const USUAL_FIRST_DEPTH: f64 = 0.1;

/// The infeed keeps this far off the flank that must not rub, degrees (makers of threading inserts ask for 1 to 5).
const OFF_FLANK_DEG: f64 = 1.0;

/// How far a run-out goes above the crest, mm.
const ABOVE_CREST_MM: f64 = 0.05;

/// Passes of one start at most; a thread that asks for more is a slip.
const MOST_PASSES: u32 = 500;

/// One thread to be cut, on the planner's radii.
pub(super) struct Passes<'a> {
    pub(super) spec: &'a ThreadSpec,
    pub(super) reach: &'a Reach,
    pub(super) machine: &'a Machine,
    pub(super) conditions: &'a Conditions,
    pub(super) choices: ThreadChoices,
    /// Largest angle of infeed, degrees.
    pub(super) flank_deg: f64,
    /// Height at which the tool goes back, mm.
    pub(super) clear: f64,
}

impl Passes<'_> {
    /// Depths below the crest after every pass, mm.
    fn depths(&self) -> Vec<f64> {
        let total = self.spec.crest_radius - self.spec.base_radius;
        let mut depths = depths(self.first_depth(), total);
        depths.extend(std::iter::repeat_n(total, usize::from(self.choices.spring_passes)));
        depths
    }

    fn first_depth(&self) -> f64 {
        let depth = self.conditions.depth;
        if depth > 0.0 { depth } else { USUAL_FIRST_DEPTH * self.spec.pitch }
    }

    /// The moves of every start, from and to the place above the start, and what they are made from.
    pub(super) fn cut(&self, path: &mut Path<'_>) -> Option<Recipe> {
        let first = path.len();
        for start in 0..self.spec.starts {
            let start_deg = 360.0 * f64::from(start) / f64::from(self.spec.starts);
            for (number, depth) in self.depths().into_iter().enumerate() {
                self.pass(path, number, depth, start_deg);
            }
        }
        let moves = first..path.len();
        let by_control = self.spec.starts == 1 && self.choices.infeed != Infeed::Alternating;
        by_control.then(|| Recipe { moves, kind: RecipeKind::Thread(self.recipe()) })
    }

    fn pass(&self, path: &mut Path<'_>, number: usize, depth: f64, start_deg: f64) {
        let (above, rpm, lead) = (self.above(), self.rpm(), self.spec.lead());
        let r = self.spec.crest_radius - depth;
        let to = Point::new(self.reach.to_z, r);
        path.rapid(Point::new(above.z + self.aside(number, depth), above.r));
        let down = Point::new(path.at.z, r);
        if self.reach.in_air {
            path.rapid(down);
        } else {
            path.line(down);
        }
        path.thread(CutMove::ThreadPass { to, lead, start_deg, rpm }, to);
        let out = Point::new(self.reach.to_z - self.run_out(), self.spec.crest_radius + ABOVE_CREST_MM);
        if self.run_out() > 0.0 {
            path.thread(CutMove::ThreadPass { to: out, lead, start_deg: 0.0, rpm }, out);
        }
        path.rapid(Point::new(path.at.z, self.clear));
        path.rapid(above);
    }

    /// Where every pass starts and ends.
    pub(super) fn above(&self) -> Point {
        Point::new(self.reach.start, self.clear)
    }

    fn run_out(&self) -> f64 {
        self.reach.run_out
    }

    /// How far behind its last place a pass starts, mm.
    fn aside(&self, number: usize, depth: f64) -> f64 {
        let total = self.spec.crest_radius - self.spec.base_radius;
        let along = (total - depth) * self.flank_deg.to_radians().tan();
        match self.choices.infeed {
            Infeed::Radial => 0.0,
            Infeed::Flank => along,
            Infeed::Alternating if number.is_multiple_of(2) => along,
            Infeed::Alternating => -along,
        }
    }

    /// Speed by the material, and by what slide and spindle can follow, rev/min.
    fn rpm(&self) -> f64 {
        let machine = self.machine;
        let feed = machine.spindle.thread_feed_mm_per_min.min(machine.limits.feed_max_mm_per_min);
        let cut = self.conditions.cut(self.spec.crest_radius, self.spec.crest_radius, 0.0);
        let by_material = cut.rpm_at(self.conditions.radius(self.spec.crest_radius));
        machine.nearest_rpm(by_material.min(feed / self.spec.lead()).min(machine.rpm_limit()))
    }

    fn recipe(&self) -> ThreadRecipe {
        let flank_deg = if self.choices.infeed == Infeed::Flank { self.flank_deg } else { 0.0 };
        ThreadRecipe {
            to_z: self.reach.to_z,
            crest_radius: self.spec.crest_radius,
            root_radius: self.spec.base_radius,
            lead: self.spec.lead(),
            first_depth: self.first_depth(),
            least_depth: LEAST_DEPTH_MM,
            finish_depth: FINISH_DEPTH_MM,
            spring_passes: self.choices.spring_passes,
            flank_deg,
            run_out: self.run_out(),
            rpm: self.rpm(),
        }
    }
}

/// Depths of equal chip area from `first` to `total`, mm; the last pass takes a finishing cut.
fn depths(first: f64, total: f64) -> Vec<f64> {
    let (mut depths, mut depth) = (Vec::new(), 0.0_f64);
    for n in 1..=MOST_PASSES {
        let next = (first * f64::from(n).sqrt()).max(depth + LEAST_DEPTH_MM);
        if next >= total - FINISH_DEPTH_MM {
            break;
        }
        depth = next;
        depths.push(depth);
    }
    if total > 2.0 * FINISH_DEPTH_MM {
        depths.push(total - FINISH_DEPTH_MM);
    }
    depths.push(total);
    depths
}

/// Largest angle of infeed along a flank of the tool, degrees: half its point's angle, less a degree.
pub(super) fn flank_deg(outline: &ToolOutline) -> f64 {
    let edges = outline.cutting_edges().filter_map(|edge| match *edge {
        Segment::Line { start, end } => Some((end.z - start.z).abs().atan2((end.r - start.r).abs()).to_degrees()),
        Segment::Arc { .. } => None,
    });
    let half = edges.filter(|angle| *angle < 89.0).fold(f64::INFINITY, f64::min);
    if half.is_finite() { (half - OFF_FLANK_DEG).max(0.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    #[test]
    fn passes_take_equal_areas_and_end_with_a_finishing_cut() {
        let depths = depths(0.2, 0.92);
        let areas: Vec<f64> = depths.windows(2).map(|w| w[1] * w[1] - w[0] * w[0]).collect();
        let steps: Vec<f64> = depths.windows(2).map(|w| w[1] - w[0]).collect();
        let (before_last, last) = (areas.len() - 2, depths.len() - 1);
        // Equal areas until the pass would be too thin, then passes of the least depth, then what is left.
        let full = |k: usize| (areas[k] - 0.04).abs() < 1e-9 && steps[k] >= LEAST_DEPTH_MM;
        let least = |k: usize| (steps[k] - LEAST_DEPTH_MM).abs() < 1e-9 && areas[k] > 0.04;
        assert!((0..before_last).all(|k| full(k) || least(k)) && full(0) && least(before_last - 1), "{depths:?}");
        assert!(steps[before_last] <= LEAST_DEPTH_MM + 1e-9 && (depths[last] - 0.92).abs() < 1e-12);
        assert!((depths[depths.len() - 1] - depths[depths.len() - 2] - FINISH_DEPTH_MM).abs() < 1e-12);
        assert_eq!(super::depths(0.2, 0.03), [0.03]);
        assert!(super::depths(1e-9, 1.0).len() < 40, "no pass is thinner than {LEAST_DEPTH_MM} mm");
    }

    #[test]
    fn the_infeed_keeps_a_degree_off_the_flank() {
        let catalog = Catalog::shipped();
        for (id, deg) in [("thread-60-outside", 29.0), ("thread-55-outside", 26.5), ("thread-60-inside", 29.0)] {
            let found = flank_deg(&catalog.tool(id).unwrap().outline());
            assert!((found - deg).abs() < 1e-6, "{id}: {found}");
        }
    }
}
