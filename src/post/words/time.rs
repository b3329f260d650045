//! About how long an operation takes, for the head of its program. The proof measures it from the program's text.

use crate::geometry::{Point, Segment, Vector};
use crate::machine::{Axis, Machine};
use crate::turning::{Cut, CutMove, CutterPath, Operation};

/// Seconds for an operation; the change to its tool is not counted.
pub(super) fn seconds(operation: &Operation, path: &CutterPath, machine: &Machine) -> f64 {
    let mut clock = Clock { machine, at: operation.change.unwrap_or(path.datum), minutes: 0.0 };
    clock.moves(&operation.moves, Vector::zeros());
    clock.minutes * 60.0
}

struct Clock<'a> {
    machine: &'a Machine,
    at: Point,
    minutes: f64,
}

impl Clock<'_> {
    fn moves(&mut self, moves: &[CutMove], by: Vector) {
        for cut_move in moves {
            self.cut_move(cut_move, by);
        }
    }

    fn cut_move(&mut self, cut_move: &CutMove, by: Vector) {
        match *cut_move {
            CutMove::Rapid { to } => self.rapid(to + by),
            CutMove::Line { to, cut } => self.cut(&Segment::line(self.at, to + by), &cut),
            CutMove::Arc { to, center, ccw, cut } => {
                let arc = Segment::Arc { start: self.at, end: to + by, center: center + by, ccw };
                self.cut(&arc, &cut);
            }
            CutMove::Thread { to_z, outside_radius, base_radius, pitch, depth_per_cut, rpm } => {
                let passes = ((outside_radius - base_radius) / depth_per_cut).ceil().clamp(1.0, 1000.0);
                self.minutes += passes * (to_z - self.at.z).abs() / (pitch * rpm);
            }
            CutMove::ThreadPass { to, lead, rpm, .. } => {
                self.minutes += (to + by).distance(self.at) / (lead * rpm);
                self.at = to + by;
            }
            CutMove::Dwell { seconds } => self.minutes += seconds / 60.0,
            CutMove::Repeat { count, step, ref body } => {
                let (before, at) = (self.minutes, self.at);
                self.moves(body, by);
                self.minutes = before + (self.minutes - before) * f64::from(count);
                self.at = if count == 0 { at } else { self.at + step * f64::from(count - 1) };
            }
        }
    }

    fn rapid(&mut self, to: Point) {
        let way = to - self.at;
        self.minutes += self.slide(way.y.abs(), Axis::X).max(self.slide(way.x.abs(), Axis::Z)) / 60.0;
        self.at = to;
    }

    /// Seconds of a slide from rest to rest over `way` mm: at its rapid rate and, from there and to there, at the machine's
    /// acceleration; a short way is over before the rate is reached.
    fn slide(&self, way: f64, axis: Axis) -> f64 {
        let rate = self.machine.rapid_mm_per_min(axis) / 60.0;
        let Some(motion) = self.machine.motion else { return way / rate };
        let run_up = rate / motion.acceleration_mm_per_s2;
        if way >= rate * run_up { way / rate + run_up } else { 2.0 * (way / motion.acceleration_mm_per_s2).sqrt() }
    }

    /// Simpson's rule over the move: under a constant cutting speed the feed follows the radius.
    fn cut(&mut self, segment: &Segment, cut: &Cut) {
        let slowness = |t: f64| 1.0 / cut.mm_per_min_at(segment.point_at(t).r);
        let mean = (slowness(0.0) + 4.0 * slowness(0.5) + slowness(1.0)) / 6.0;
        self.minutes += segment.length() * mean;
        self.at = segment.end();
    }
}
