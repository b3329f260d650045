//! From cutter location data to instructions. Numbers are rounded once, here.
//!
//! Positions are rounded to 0.001 mm in absolute terms and increments taken between rounded positions, so that the moves
//! of a file add up to exactly zero.

use super::instruction::{Instruction, Sense};
use super::number::{rounded, thousandths};
use crate::geometry::Point;
use crate::turning::{CutMove, CutterPath, Operation};

/// The instructions that every program begins with: incremental format, mm, and the datum.
pub(super) fn start(path: &CutterPath) -> [Instruction; 3] {
    let at = Place::of(path.datum, path.program_zero_z);
    [Instruction::Inc, Instruction::Mm, Instruction::Pdat { x: at.x, z: at.z }]
}

/// The instructions of one operation, from the datum.
pub(super) fn operation(path: &CutterPath, operation: &Operation, rapid_mm_per_min: f64) -> Vec<Instruction> {
    let mut writer = Writer {
        zero_z: path.program_zero_z,
        at: Place::of(path.datum, path.program_zero_z),
        tool: i32::try_from(operation.tool).unwrap_or(i32::MAX),
        rapid: rapid_mm_per_min,
        rpm: first_rpm(&operation.moves),
        out: Vec::new(),
    };
    operation.moves.iter().for_each(|m| writer.cut_move(m));
    writer.out
}

/// Spindle speed of the first cut, rev/min: the tool approaches with it.
fn first_rpm(moves: &[CutMove]) -> f64 {
    let speeds = moves.iter().filter_map(|m| match m {
        CutMove::Line { to, cut } | CutMove::Arc { to, cut, .. } => Some(cut.rpm_at(to.r)),
        CutMove::Thread { rpm, .. } | CutMove::ThreadPass { rpm, .. } => Some(*rpm),
        CutMove::Rapid { .. } | CutMove::Dwell { .. } | CutMove::Repeat { .. } => None,
    });
    speeds.into_iter().next().unwrap_or(0.0)
}

/// A position in thousandths of a mm, in program space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Place {
    x: i32,
    z: i32,
}

impl Place {
    fn of(p: Point, zero_z: f64) -> Self {
        Self { x: thousandths(p.r), z: thousandths(p.z - zero_z) }
    }

    /// The increment from `from` to here.
    const fn less(self, from: Self) -> Self {
        Self { x: self.x.saturating_sub(from.x), z: self.z.saturating_sub(from.z) }
    }
}

/// How far the middle of an arc may lie from where the path has it, mm: half of the control's smallest step.
const OFF_MIDDLE_MM: f64 = 0.0005;

/// How much larger than its own radius that of an arc may become: one that would need more is so short that the rounding of its
/// ends decides.
const MOST_CHANGE: f64 = 0.01;

/// Radius of an arc of less than half a turn between rounded ends: that of the path, or where this would move the middle of the
/// arc by more than the rounding of a number, the one that keeps the middle. With the height h of the middle over the chord c it
/// is (c²/4 + h²) / 2h. It is never below the path's, which may be the least that the control takes.
fn radius_over(start: Point, end: Point, center: Point, radius: f64) -> f64 {
    let half = start.distance(end) / 2.0;
    let outwards = (start - center).normalize() + (end - center).normalize();
    let middle = center + outwards.normalize() * radius;
    let wanted = (middle - start).perp(&(end - start)).abs() / (2.0 * half);
    let kept = radius - ((radius - half) * (radius + half)).max(0.0).sqrt();
    let over = (half * half + wanted * wanted) / (2.0 * wanted);
    let near = (radius..=radius * (1.0 + MOST_CHANGE)).contains(&over);
    if near && (wanted - kept).abs() > OFF_MIDDLE_MM { over } else { radius }
}

struct Writer {
    zero_z: f64,
    at: Place,
    tool: i32,
    /// Feed through air, mm/min: the control has no rapid word.
    rapid: f64,
    /// Speed of the last cut, rev/min; kept through air.
    rpm: f64,
    out: Vec<Instruction>,
}

impl Writer {
    /// Goes to `to` and returns the increment.
    fn advance(&mut self, to: Point) -> Place {
        let to = Place::of(to, self.zero_z);
        let step = to.less(self.at);
        self.at = to;
        step
    }

    fn cut_move(&mut self, m: &CutMove) {
        match *m {
            CutMove::Rapid { to } => {
                let Place { x, z } = self.advance(to);
                self.point_to_point(x, z, self.rapid, self.rpm);
            }
            CutMove::Line { to, cut } => {
                self.rpm = cut.rpm_at(to.r);
                let Place { x, z } = self.advance(to);
                self.point_to_point(x, z, cut.mm_per_min_at(to.r), self.rpm);
            }
            CutMove::Arc { to, center, ccw, cut } => {
                self.rpm = cut.rpm_at(to.r);
                self.arc(to, center, ccw, cut.mm_per_min_at(to.r), self.rpm);
            }
            CutMove::Dwell { seconds } => self.out.push(Instruction::Dwel { time: thousandths(seconds) }),
            // The control has no single threading pass; the post refuses such a path.
            CutMove::ThreadPass { .. } => {}
            CutMove::Thread { to_z, outside_radius, base_radius, pitch, depth_per_cut, rpm } => {
                self.out.push(Instruction::Thrd {
                    z: thousandths(to_z - self.zero_z).saturating_sub(self.at.z),
                    outside_diameter: thousandths(2.0 * outside_radius),
                    base_diameter: thousandths(2.0 * base_radius),
                    pitch: thousandths(pitch),
                    cut_depth: thousandths(depth_per_cut),
                    tool: self.tool,
                    rpm: rounded(rpm),
                });
            }
            CutMove::Repeat { count, step: _, ref body } => self.repeat(count, body),
        }
    }

    /// A rounded place in part space.
    fn part(&self, place: Place) -> Point {
        Point::new(f64::from(place.z) / 1000.0 + self.zero_z, f64::from(place.x) / 1000.0)
    }

    fn point_to_point(&mut self, x: i32, z: i32, feed: f64, rpm: f64) {
        self.out.push(Instruction::Ptp { x, z, feed: rounded(feed), tool: self.tool, rpm: rounded(rpm) });
    }

    /// An arc; one that rounding leaves without length is a move of zero. The radius is never below half the chord.
    fn arc(&mut self, to: Point, center: Point, ccw: bool, feed: f64, rpm: f64) {
        let from = self.at;
        let Place { x, z } = self.advance(to);
        let radius = radius_over(self.part(from), self.part(self.at), center, to.distance(center));
        if (x, z) == (0, 0) {
            return self.point_to_point(x, z, feed, rpm);
        }
        let half_chord = rounded((f64::from(x).hypot(f64::from(z)) / 2.0).ceil());
        self.out.push(Instruction::Circ {
            x,
            z,
            radius: thousandths(radius).max(half_chord),
            sense: if ccw { Sense::Ccw } else { Sense::Cw },
            feed: rounded(feed),
            tool: self.tool,
            rpm: rounded(rpm),
        });
    }

    /// A loop: its body is written once; the place after it follows from the rounded body, however often it is run.
    fn repeat(&mut self, count: u32, body: &[CutMove]) {
        let start = self.at;
        let count = i32::try_from(count).unwrap_or(i32::MAX);
        self.out.push(Instruction::Do { count });
        for m in body {
            self.cut_move(m);
        }
        self.out.push(Instruction::Edo);
        let once = self.at.less(start);
        let times = |step: i32, start: i32| start.saturating_add(step.saturating_mul(count));
        self.at = Place { x: times(once.x, start.x), z: times(once.z, start.z) };
    }
}
