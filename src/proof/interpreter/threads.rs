//! Threads: single passes and the cycles that make them.

use super::Run;
use super::block::Taken;
use crate::cancel::Cancelled;
use crate::geometry::{Point, Segment, Vector};
use crate::machine::Dialect;
use crate::proof::step::{Drive, Speed, Step};
use std::f64::consts::TAU;

/// Cuts of one thread at most. Nobody cuts a thread in more.
const MOST_CUTS: u32 = 1_000;
/// A cut thinner than this, mm, is none.
const THINNEST_MM: f64 = 0.000_5;

/// A complete thread in several cuts. Radii and lengths in mm, as the program counts.
#[derive(Debug, Clone)]
struct ThreadCuts {
    /// Where every cut starts and the cycle ends.
    from: Point,
    /// Root at the far end.
    to: Point,
    /// Root radius at the start less that at the end.
    taper: f64,
    /// Height of the thread on the radius.
    height: f64,
    /// Positive outside the work, negative in a bore.
    side: f64,
    /// Depth below the crest of every cut.
    depths: Vec<f64>,
    /// Half the angle between the flanks; cuts that are not deep yet are set back by it, radians. 0 feeds in straight.
    flank: f64,
    /// Advance for one turn.
    lead: f64,
    /// Before the end, the length on which the tool goes out and how far it goes out.
    run_out: (f64, f64),
}

impl Run<'_, '_> {
    /// The lead of a thread from the block, or the one in force.
    fn lead(&mut self, letter: char, words: &mut Taken<'_>) -> f64 {
        let lead = words.take(letter).map(|f| {
            let decimals = self.control.words.feed_per_rev_decimals;
            let linuxcnc = self.control.machine.dialect == Dialect::Linuxcnc;
            let value = if linuxcnc { f.plain() } else { f.in_increments(decimals, self.control.words) };
            value * self.state.mm_per_unit()
        });
        if let Some(lead) = lead {
            self.state.lead = Some(lead);
        }
        // A Fanuc thread without F takes the feed in force.
        let lead = self.state.lead.or(self.state.feed.filter(|_| self.state.per_rev)).unwrap_or(0.0);
        if lead <= 0.0 {
            self.limit_error("lead", lead, 0.0, format!("The thread's lead is {lead:.3} mm; it must be above 0."));
        }
        lead
    }

    /// G32 and G33.
    pub(super) fn thread_pass_words(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let from = self.here();
        let to = self.target(words);
        let letter = if self.control.machine.dialect == Dialect::Linuxcnc { 'K' } else { 'F' };
        let lead = self.lead(letter, words);
        // The angle at which the pass starts, in thousandths of a degree, moves the groove along.
        let start = words.take('Q').map_or(0.0, |q| q.plain() / 1000.0);
        self.thread_pass(from, to, lead, start)
    }

    fn thread_pass(&mut self, from: Point, to: Point, lead: f64, start_degrees: f64) -> Result<(), Cancelled> {
        if !self.count_step() {
            return Ok(());
        }
        self.end_compensation()?;
        let speed = self.state.drive_speed(self.control.machine);
        self.check_before_move(Drive { rapid: false, ..self.cutting_drive() });
        if matches!(speed, Speed::Surface { .. }) && (from.r - to.r).abs() > f64::EPSILON {
            let message = "A thread on a taper is cut with constant cutting speed (G96): its lead follows the changing spindle speed only late.";
            self.structure_warning("thread in G96", message);
        }
        let path = self.moved(Segment::line(from, to));
        let d = path.end() - path.start();
        if lead <= 0.0 || d.norm() == 0.0 {
            return Ok(());
        }
        let aside = Vector::new(lead * start_degrees.rem_euclid(360.0) / 360.0 * d.x.signum(), 0.0);
        let slope = d.norm() / d.x.abs().max(d.y.abs());
        let tool = self.control.tool.unwrap_or(0);
        let rpm = speed.rpm_at(f64::midpoint(path.start().r, path.end().r));
        // The groove is set back by its share of a turn; the slide starts where it stands.
        let path = if start_degrees == 0.0 { path } else { path.translated(-aside) };
        self.step(Step::ThreadPass { path, lead: lead * slope, rpm, tool })
    }

    /// Fanuc's G92: in, one cut, out, back.
    pub(super) fn simple_thread_cycle(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let from = self.here();
        let to = self.repeated_end(words);
        let taper = self.repeated_taper(words);
        let lead = self.lead('F', words);
        let start = words.take('Q').map_or(0.0, |q| q.plain() / 1000.0);
        self.rapid_to(Point::new(from.z, to.r + taper))?;
        let near = self.here();
        self.thread_pass(near, to, lead, start)?;
        self.rapid_to(Point::new(to.z, from.r))?;
        self.rapid_to(from)
    }

    /// G76 of either dialect.
    pub(super) fn thread_cycle(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        if self.control.machine.dialect == Dialect::Linuxcnc {
            return self.thread_cycle_linuxcnc(words);
        }
        let one_line = words.has('K') && words.has('D');
        if !words.moves() && !one_line {
            self.thread_cycle_settings(words);
            return Ok(());
        }
        let from = self.here();
        let to = self.target(words);
        let (height, first, taper) = if one_line {
            // The 6T's form: K height, D first depth, A angle between the flanks, I taper.
            let height = words.take('K').map_or(0.0, |k| self.mm(k).abs());
            let first = words.take('D').map_or(0.0, |d| self.increments(d).abs());
            self.state.cycle.angle = words.take('A').map_or(0.0, |a| a.plain());
            (height, first, words.take('I').map_or(0.0, |i| self.radial(i)))
        } else {
            let height = words.take('P').map_or(0.0, |p| self.increments(p).abs());
            let first = words.take('Q').map_or(0.0, |q| self.increments(q).abs());
            (height, first, words.take('R').map_or(0.0, |r| self.radial(r)))
        };
        let lead = self.lead('F', words);
        if first <= 0.0 || height <= 0.0 {
            let message =
                format!("G76 needs a first depth and a height above 0; they are {first:.3} mm and {height:.3} mm.");
            self.control_error("thread depth", first.min(height), 0.0, message);
            return Ok(());
        }
        let settings = self.state.cycle;
        let mut depths = fanuc_depths(height - settings.finish_depth.clamp(0.0, height), first, settings.thinnest);
        depths.extend(std::iter::repeat_n(height, settings.finishes.clamp(1, 99) as usize));
        let side = if to.r <= from.r { 1.0 } else { -1.0 };
        let flank = (settings.angle / 2.0).to_radians();
        // The control goes out at 45°, as far as the place where the cycle began.
        let run_out = if one_line { 0.0 } else { settings.run_out_leads * lead };
        self.cut_thread(&ThreadCuts { from, to, taper, height, side, depths, flank, lead, run_out: (run_out, run_out) })
    }

    /// The first line of the two-line form: `G76 P(mmrraa) Q(thinnest) R(last depth)`.
    fn thread_cycle_settings(&mut self, words: &mut Taken<'_>) {
        if let Some(p) = words.take('P').and_then(|p| p.whole()) {
            self.state.cycle.finishes = p / 10_000;
            self.state.cycle.run_out_leads = f64::from(p / 100 % 100) / 10.0;
            self.state.cycle.angle = f64::from(p % 100);
        }
        self.state.cycle.thinnest = words.take('Q').map_or(0.0, |q| self.increments(q).abs());
        self.state.cycle.finish_depth = words.take('R').map_or(0.0, |r| self.mm(r).abs());
    }

    /// `G76 P pitch Z end I offset J first depth K height [R degression Q angle H spring passes E taper L which end]`.
    fn thread_cycle_linuxcnc(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let from = self.here();
        let to = self.target(words);
        // With G7 they are diameters, like X.
        let crest = words.take('I').map_or(0.0, |i| self.radius(i));
        let first = words.take('J').map_or(0.0, |j| self.radius(j));
        let height = words.take('K').map_or(0.0, |k| self.radius(k));
        let degression = words.take('R').map_or(1.0, |r| r.plain());
        let flank = words.take('Q').map_or(0.0, |q| q.plain()).to_radians();
        let springs = words.take('H').and_then(|h| h.whole()).unwrap_or(0).min(99);
        let run_out = words.take('E').map_or(0.0, |e| self.mm(e).abs());
        let ends = words.take('L').and_then(|l| l.whole()).unwrap_or(0);
        if run_out > 0.0 && !matches!(ends, 0 | 2) {
            let message = format!("G76 with L{ends} tapers the thread where it begins; that is not computed here.");
            self.control_error("thread taper", f64::from(ends), 2.0, message);
        }
        let run_out = if ends == 2 { run_out } else { 0.0 };
        let lead = self.lead('P', words);
        if first <= 0.0 || height < first || degression < 1.0 {
            let message = format!(
                "G76 needs a first depth J above 0, a height K not below it and a degression R from 1 up; they are {first:.3} mm, \
                 {height:.3} mm and {degression}."
            );
            self.control_error("thread depth", first, 0.0, message);
            return Ok(());
        }
        let mut depths: Vec<f64> = (1..=MOST_CUTS)
            .map(|pass| first * f64::from(pass).powf(1.0 / degression))
            .take_while(|depth| *depth < height - THINNEST_MM)
            .collect();
        depths.extend(std::iter::repeat_n(height, 1 + springs as usize));
        // A negative I is an outside thread: the crest lies towards the axis from the drive line.
        let side = if crest <= 0.0 { 1.0 } else { -1.0 };
        let root = from.r + crest - side * height;
        let to = Point::new(to.z, root);
        // Over that length every pass goes out by the whole height.
        let run_out = (run_out, height);
        self.cut_thread(&ThreadCuts { from, to, taper: 0.0, height, side, depths, flank, lead, run_out })
    }

    /// A whole number that counts least increments, such as a Q or P of a cycle.
    pub(super) fn increments(&mut self, number: crate::proof::reader::words::Number) -> f64 {
        self.mm(number)
    }

    /// From `near` along the thread at the radius `r`, and out of it on the last length.
    fn pass_with_run_out(&mut self, cuts: &ThreadCuts, near: Point, r: f64) -> Result<(), Cancelled> {
        let ThreadCuts { from, to, side, lead, run_out: (length, rise), .. } = *cuts;
        if length <= 0.0 {
            return self.thread_pass(near, Point::new(to.z, r), lead, 0.0);
        }
        let begins = to.z - (to.z - from.z).signum() * length.min((to.z - near.z).abs());
        let out = r + side * rise.min((from.r - r).abs());
        self.thread_pass(near, Point::new(begins, r), lead, 0.0)?;
        self.thread_pass(Point::new(begins, r), Point::new(to.z, out), lead, 0.0)
    }

    fn cut_thread(&mut self, cuts: &ThreadCuts) -> Result<(), Cancelled> {
        let ThreadCuts { from, to, taper, height, side, flank, .. } = *cuts;
        let towards = (to.z - from.z).signum();
        for &depth in &cuts.depths {
            let above = side * (height - depth);
            let back = towards * (height - depth) * flank.rem_euclid(TAU).tan();
            let near = Point::new(from.z - back, to.r + taper + above);
            self.rapid_to(Point::new(near.z, from.r))?;
            self.rapid_to(near)?;
            self.pass_with_run_out(cuts, near, to.r + above)?;
            self.rapid_to(Point::new(to.z, from.r))?;
            self.rapid_to(from)?;
        }
        Ok(())
    }
}

/// Depths that take equal areas: the first one times the root of the cut's number, no step below the thinnest.
fn fanuc_depths(height: f64, first: f64, thinnest: f64) -> Vec<f64> {
    let mut depths: Vec<f64> = Vec::new();
    let mut depth = 0.0_f64;
    for cut in 1..=MOST_CUTS {
        depth = (first * f64::from(cut).sqrt()).max(depth + thinnest).min(height);
        depths.push(depth);
        if depth >= height - THINNEST_MM {
            break;
        }
    }
    depths
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depths_take_equal_areas() {
        let depths = fanuc_depths(1.0, 0.5, 0.0);
        assert_eq!(depths.len(), 4);
        for (cut, depth) in (1..).zip(&depths) {
            assert!((depth - 0.5 * f64::from(cut).sqrt()).abs() < 1e-12);
        }
        assert_eq!(fanuc_depths(1.0, 0.4, 0.3), [0.4, 0.7, 1.0]);
    }
}
