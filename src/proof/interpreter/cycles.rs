//! Turning cycles of Fanuc controls: G70 to G75 over a contour, G90 and G94 for single cuts.

use super::block::Taken;
use super::{Next, Run, SAME_MM};
use crate::cancel::Cancelled;
use crate::geometry::{Point, Segment, Vector};
use crate::proof::control::Sink;
use crate::proof::findings::Findings;
use crate::proof::step::Step;

/// Cuts of one cycle at most.
const MOST_CUTS: u32 = 10_000;

/// Keeps the paths of a contour instead of cutting them.
struct Collect {
    paths: Vec<Segment>,
}

impl Sink for Collect {
    fn block(&mut self, _block: usize) {}

    fn step(&mut self, _block: usize, step: Step, _findings: &mut Findings) -> Result<(), Cancelled> {
        if let Step::Move { path, .. } = step {
            self.paths.push(path);
        }
        Ok(())
    }
}

/// Swaps the axes if `facing`, so that cuts run along the first one.
fn turned(p: Point, facing: bool) -> Point {
    if facing { Point::new(p.r, p.z) } else { p }
}

fn turned_path(path: &Segment, facing: bool) -> Segment {
    match *path {
        Segment::Line { start, end } => Segment::line(turned(start, facing), turned(end, facing)),
        Segment::Arc { start, end, center, ccw } => Segment::Arc {
            start: turned(start, facing),
            end: turned(end, facing),
            center: turned(center, facing),
            ccw: ccw != facing,
        },
    }
}

impl Run<'_, '_> {
    /// End point of G90, G92 or G94; what the block does not say stays.
    pub(super) fn repeated_end(&mut self, words: &mut Taken<'_>) -> Point {
        let (has_x, has_z) = (words.has('X') || words.has('U'), words.has('Z') || words.has('W'));
        let said = self.target(words);
        let old = self.state.repeated.end.unwrap_or(said);
        let end = Point::new(if has_z { said.z } else { old.z }, if has_x { said.r } else { old.r });
        self.state.repeated.end = Some(end);
        end
    }

    /// R of G90 and G92, on the radius; of G94 along z.
    pub(super) fn repeated_taper(&mut self, words: &mut Taken<'_>) -> f64 {
        if let Some(taper) = words.take('R').or(words.take('I')) {
            self.state.repeated.taper = self.radial(taper);
        }
        self.state.repeated.taper
    }

    /// G90: in, along, out, back.
    pub(super) fn turn_cycle(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let from = self.here();
        let to = self.repeated_end(words);
        let taper = self.repeated_taper(words);
        self.rapid_to(Point::new(from.z, to.r + taper))?;
        self.feed_to(to)?;
        self.feed_to(Point::new(to.z, from.r))?;
        self.rapid_to(from)
    }

    /// G94: along, in, back along, out.
    pub(super) fn face_cycle(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let from = self.here();
        let to = self.repeated_end(words);
        if let Some(taper) = words.take('R').or(words.take('K')) {
            self.state.repeated.taper = self.mm(taper);
        }
        self.rapid_to(Point::new(to.z + self.state.repeated.taper, from.r))?;
        self.feed_to(to)?;
        self.feed_to(Point::new(from.z, to.r))?;
        self.rapid_to(from)
    }

    /// The blocks N p to N q of the text by index.
    fn contour_blocks(&mut self, words: &mut Taken<'_>) -> Option<(usize, usize)> {
        let number = |n: Option<crate::proof::reader::words::Number>| n.and_then(|n| n.whole());
        let (p, q) = (number(words.take('P')), number(words.take('Q')));
        let at = |n: Option<u32>| n.and_then(|n| self.tape.blocks.iter().position(|b| b.printed == Some(n)));
        let found = at(p).zip(at(q)).filter(|(first, last)| first <= last);
        if found.is_none() {
            let shown = |n: Option<u32>| n.map_or("nothing".to_owned(), |n| format!("N{n}"));
            let message = format!(
                "The cycle's contour runs from {} to {}; both must be in the text, in this order.",
                shown(p),
                shown(q)
            );
            self.control_error("contour", 0.0, 1.0, message);
        }
        found
    }

    /// The paths of a contour from the present point, as the program counts.
    fn contour(&mut self, first: usize, last: usize) -> Result<Vec<Segment>, Cancelled> {
        let here = self.here();
        let back = -(self.shift() + Vector::new(self.control.zero_z, 0.0));
        let (state, place, block) = (self.state.clone(), self.control.place, self.at_block);
        let mut collect = Collect { paths: Vec::new() };
        let mut run = Run {
            control: &mut *self.control,
            tape: self.tape,
            program: self.program,
            findings: &mut *self.findings,
            sink: &mut collect,
            state: state.clone(),
            calls: super::Calls::default(),
            compensation: super::Compensation::default(),
            at_block: first,
            steps: self.steps,
            contour_only: true,
            begun: true,
        };
        run.state.at = Some(here);
        for index in first..=last {
            run.at_block = index;
            run.block(index)?;
        }
        self.steps = run.steps;
        self.control.place = place;
        self.state = state;
        self.at_block = block;
        Ok(collect.paths.iter().map(|path| path.translated(back)).collect())
    }

    /// G70: the contour itself, then back.
    pub(super) fn finish_cycle(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let from = self.here();
        let Some((first, last)) = self.contour_blocks(words) else { return Ok(()) };
        let cycle = self.at_block;
        if (first..=last).contains(&cycle) {
            self.control_error("contour", 1.0, 0.0, "The cycle stands within its own contour.".to_owned());
            return Ok(());
        }
        for index in first..=last {
            self.at_block = index;
            self.sink.block(index + 1);
            if !self.count_step() {
                return Ok(());
            }
            self.block(index)?;
        }
        self.end_compensation()?;
        self.at_block = cycle;
        self.rapid_to(from)
    }

    /// G71 and G72. The first of two lines gives depth and retraction; the 6T's single line has the depth in D.
    pub(super) fn rough_cycle(&mut self, facing: bool, words: &mut Taken<'_>) -> Result<Option<Next>, Cancelled> {
        if !words.has('P') {
            let letter = if facing { 'W' } else { 'U' };
            self.state.cycle.depth = words.take(letter).map(|d| self.mm(d).abs());
            self.state.cycle.retract = words.take('R').map_or(0.0, |r| self.mm(r).abs());
            return Ok(None);
        }
        self.end_compensation()?;
        let Some((first, last)) = self.contour_blocks(words) else { return Ok(None) };
        if (first..=last).contains(&self.at_block) {
            self.control_error("contour", 1.0, 0.0, "The cycle stands within its own contour.".to_owned());
            return Ok(None);
        }
        let allowance = self.allowance(words);
        if let Some(depth) = words.take('D') {
            self.state.cycle.depth = Some(self.mm(depth).abs());
        }
        let next = Some(Next::Block(last + 1));
        let depth = self.state.cycle.depth.unwrap_or(0.0);
        if depth <= 0.0 {
            self.control_error(
                "cycle depth",
                depth,
                0.0,
                format!("The depth of cut is {depth:.3} mm; it must be above 0."),
            );
            return Ok(next);
        }
        let paths = self.contour(first, last)?;
        self.rough(facing, &paths, allowance, depth)?;
        Ok(next)
    }

    /// U and W of the second line: what stays for finishing, as a displacement of the contour.
    fn allowance(&mut self, words: &mut Taken<'_>) -> Vector {
        let u = words.take('U').map_or(0.0, |u| self.radial(u) / if self.state.diameter { 2.0 } else { 1.0 });
        let w = words.take('W').map_or(0.0, |w| self.mm(w));
        Vector::new(w, u)
    }

    fn rough(&mut self, facing: bool, paths: &[Segment], allowance: Vector, depth: f64) -> Result<(), Cancelled> {
        let start = self.here();
        // The first path leads to the contour; it is not part of it.
        let Some((_, contour)) = paths.split_first().filter(|(_, contour)| !contour.is_empty()) else {
            self.control_error("contour", 0.0, 2.0, "The contour has fewer than two moves.".to_owned());
            return Ok(());
        };
        let contour: Vec<Segment> = contour.iter().map(|s| turned_path(&s.translated(allowance), facing)).collect();
        let from = turned(start, facing);
        let first = contour[0].start();
        let side = if first.r <= from.r { 1.0 } else { -1.0 };
        let climbs = |s: &Segment| (s.end().r - s.start().r) * side >= -SAME_MM;
        if !contour.iter().all(climbs) {
            let message = "The contour falls again behind its highest place: how the control clears such pockets is not computed here; they are left to the finishing cut.";
            self.structure_warning("pockets", message);
        }
        let far = contour.last().map_or(first, Segment::end);
        let retract = self.state.cycle.retract;
        let back = |z: f64| if z < from.z { retract } else { -retract };
        for cut in 1..=MOST_CUTS {
            let level = from.r - side * depth * f64::from(cut);
            if (level - first.r) * side <= SAME_MM {
                break;
            }
            let end = crossing(&contour, Point::new(from.z, level), far.z);
            self.feed_or_rapid_to(turned(Point::new(from.z, level), facing), true)?;
            self.feed_or_rapid_to(turned(Point::new(end, level), facing), false)?;
            self.feed_or_rapid_to(turned(Point::new(end + back(end), level + side * retract), facing), true)?;
            self.feed_or_rapid_to(turned(Point::new(from.z, level + side * retract), facing), true)?;
        }
        self.rapid_to(turned(Point::new(from.z, first.r), facing))?;
        self.feed_to(turned(first, facing))?;
        for path in &contour {
            self.go(turned_path(path, facing), false)?;
        }
        self.rapid_to(start)
    }

    fn feed_or_rapid_to(&mut self, to: Point, rapid: bool) -> Result<(), Cancelled> {
        if rapid { self.rapid_to(to) } else { self.feed_to(to) }
    }

    /// G73: the contour several times, each time nearer.
    pub(super) fn pattern_cycle(&mut self, words: &mut Taken<'_>) -> Result<Option<Next>, Cancelled> {
        if !words.has('P') {
            let u = words.take('U').map_or(0.0, |u| self.radial(u));
            let w = words.take('W').map_or(0.0, |w| self.mm(w));
            self.state.cycle.repeat_away = Some((w, u));
            // The number of cuts is written as a whole number or with a point.
            self.state.cycle.repeats = words.take('R').map_or(1, |r| r.whole().unwrap_or(1));
            return Ok(None);
        }
        self.end_compensation()?;
        let Some((first, last)) = self.contour_blocks(words) else { return Ok(None) };
        if (first..=last).contains(&self.at_block) {
            self.control_error("contour", 1.0, 0.0, "The cycle stands within its own contour.".to_owned());
            return Ok(None);
        }
        let allowance = self.allowance(words);
        let away = self.state.cycle.repeat_away.unwrap_or_default();
        let repeats = self.state.cycle.repeats.clamp(1, MOST_CUTS);
        let start = self.here();
        let paths = self.contour(first, last)?;
        for cut in 0..repeats {
            let share = if repeats > 1 { 1.0 - f64::from(cut) / f64::from(repeats - 1) } else { 0.0 };
            let shift = allowance + Vector::new(away.0, away.1) * share;
            for (index, path) in paths.iter().enumerate() {
                let path = path.translated(shift);
                if index == 0 {
                    self.rapid_to(path.end())?;
                } else {
                    self.go(path, false)?;
                }
            }
            self.rapid_to(start)?;
        }
        Ok(Some(Next::Block(last + 1)))
    }

    /// G74 and G75: pecks into the face or into the outside, one beside the other.
    pub(super) fn peck_cycle(&mut self, groove: bool, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        if !words.moves() {
            self.state.cycle.retract = words.take('R').map_or(0.0, |r| self.mm(r).abs());
            return Ok(());
        }
        let start = self.here();
        let to = self.target(words);
        let (p, q) = (words.take('P'), words.take('Q'));
        // P steps across the spindle, Q along it; both count least increments on the radius.
        let (p, q) = (p.map_or(0.0, |p| self.increments(p).abs()), q.map_or(0.0, |q| self.increments(q).abs()));
        let aside = words.take('R').map_or(0.0, |r| self.mm(r).abs());
        let (from, to) = (turned(start, groove), turned(to, groove));
        let (step, peck) = if groove { (q, p) } else { (p, q) };
        let retract = self.state.cycle.retract;
        let deep = to.z - from.z;
        let wide = to.r - from.r;
        let peck = if peck > 0.0 { peck } else { deep.abs() };
        let count = |length: f64, step: f64| {
            if step > 0.0 { (length.abs() / step - 1e-9).ceil() } else { f64::from(u8::from(length != 0.0)) }
        };
        let (rows, pecks) = (count(wide, step), count(deep, peck));
        if rows > f64::from(MOST_CUTS) || pecks > f64::from(MOST_CUTS) {
            self.control_error(
                "pecks",
                rows.max(pecks),
                f64::from(MOST_CUTS),
                "The cycle has too many pecks.".to_owned(),
            );
            return Ok(());
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded above")]
        let (rows, pecks) = (rows.max(0.0) as u32, pecks.max(0.0) as u32);
        let at = |z: f64, r: f64| turned(Point::new(z, r), groove);
        for row in 0..=rows {
            let r = from.r
                + (step.max(wide.abs() / f64::from(rows.max(1))) * f64::from(row)).min(wide.abs()) * wide.signum();
            self.rapid_to(at(from.z, r))?;
            for k in 1..=pecks {
                let z = from.z + (peck * f64::from(k)).min(deep.abs()) * deep.signum();
                self.feed_to(at(z, r))?;
                if k < pecks {
                    self.rapid_to(at(z - retract * deep.signum(), r))?;
                }
            }
            if aside > 0.0 && row > 0 {
                self.rapid_to(at(to.z, r - aside * wide.signum()))?;
                self.rapid_to(at(from.z, r - aside * wide.signum()))?;
            } else {
                self.rapid_to(at(from.z, r))?;
            }
        }
        self.rapid_to(start)
    }
}

/// Where a cut that runs along the first axis from `from` towards `far` first meets the contour.
fn crossing(contour: &[Segment], from: Point, far: f64) -> f64 {
    let cut = Segment::line(from, Point::new(far, from.r));
    let points = contour.iter().flat_map(|s| s.intersection(&cut, SAME_MM).points());
    points.map(|p| p.z).min_by(|a, b| (a - from.z).abs().total_cmp(&(b - from.z).abs())).unwrap_or(far)
}
