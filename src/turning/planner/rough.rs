//! Roughing: strokes along the spindle, one depth below the other, where there is stock and the tool can go.
//!
//! A stretch of one level is cut from right to left. What is then open below it is divided by the limit into the stretches of
//! the next level, and each of those is cut to its bottom before its left neighbour, so that ways through air stay short: the
//! tool was at every place of the level above, so that level is free.

use super::chain::{Chain, Run};
use super::link::{self, CLEARANCE_MM, LEAN};
use super::path::Path;
use super::piece::{Form, Piece, SAME_MM};
use super::trace::{ArcRules, trace};
use super::work::{AIR_MM, Limit};
use crate::geometry::{Point, Segment};

/// Strokes shorter than this are left to the pass along the contour, mm.
const SHORTEST_STROKE_MM: f64 = 0.1;

/// Stock lower than this over a level is left to the pass along the contour, mm.
const LOWEST_STOCK_MM: f64 = 0.05;

/// Strokes of one level that are closer than this are made in one, mm.
const JOINED_MM: f64 = 1.0;

/// Moves of one stroke with the ways to it and home, at most; a ramp with more is rare and only lengthens its program.
const MOST_MOVES_OF_A_STROKE: usize = 9;

/// Levels at most; a depth of cut that asks for more is not one.
const MOST_LEVELS: u32 = 100_000;

/// One stroke from `b` to `a` at the height `r`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stroke {
    r: f64,
    a: f64,
    b: f64,
    /// Height of the level above, at which the tool may go between this stroke and the one before.
    above: f64,
    entry: Entry,
}

/// How a stroke begins.
#[derive(Debug, Clone, PartialEq)]
enum Entry {
    /// From this place in air, on the stroke's own height.
    Air(f64),
    /// Down along the limit from this place at the height of the level above.
    Ramp(f64, Vec<Segment>),
}

/// What roughing needs to know.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rough<'a> {
    pub(super) limit: &'a Limit,
    /// How low the insert may go without touching stock.
    pub(super) touch: &'a Chain,
    pub(super) top: f64,
    pub(super) depth: f64,
    /// Radius of the arcs on which the nose rolls over corners.
    pub(super) rolled: f64,
    pub(super) rules: ArcRules,
}

impl Rough<'_> {
    /// All strokes in order of cutting.
    pub(super) fn strokes(&self) -> Vec<Stroke> {
        let mut out = Vec::new();
        let whole = Run { z0: self.limit.z0, z1: self.limit.z1 };
        // A stack instead of recursion: the depth of a part over the depth of a cut may be large.
        let mut open = self.below(whole, 1);
        while let Some((parent, run, level)) = open.pop() {
            self.level(parent, run, self.height(level), &mut out);
            open.extend(self.below(run, level + 1));
        }
        out
    }

    fn height(&self, level: u32) -> f64 {
        self.top - self.depth * f64::from(level)
    }

    /// The stretches of a level that can be entered from the stretch above, from left to right.
    fn below(&self, parent: Run, level: u32) -> Vec<(Run, Run, u32)> {
        if level > MOST_LEVELS {
            return Vec::new();
        }
        let runs = self.limit.chain.clipped(parent.z0, parent.z1).runs_below(self.height(level));
        runs.into_iter().map(|run| (parent, run, level)).collect()
    }

    /// The strokes of one stretch of a level, the right one first.
    fn level(&self, parent: Run, run: Run, r: f64, out: &mut Vec<Stroke>) {
        let stock = self.touch.clipped(run.z0, run.z1);
        let mut wanted: Vec<Run> = Vec::new();
        for full in stock.runs_above(r + SAME_MM) {
            match wanted.last_mut() {
                Some(last) if full.z0 - last.z1 < JOINED_MM => last.z1 = full.z1,
                _ => wanted.push(full),
            }
        }
        wanted.retain(|w| {
            let height = stock.highest(w.z0, w.z1) - r;
            height > LOWEST_STOCK_MM && (w.width() >= SHORTEST_STROKE_MM || height > CLEARANCE_MM / 2.0)
        });
        for full in wanted.into_iter().rev() {
            let above = r + self.depth;
            let room = run.z1 - full.z1;
            let (b, entry) = if room > SHORTEST_STROKE_MM {
                (full.z1, Entry::Air(full.z1 + room.min(AIR_MM)))
            } else {
                (run.z1, self.ramp(parent, run.z1, above))
            };
            out.push(Stroke { r, a: full.z0, b, above, entry });
        }
    }

    /// Down along the limit from the level above to `b`.
    fn ramp(&self, parent: Run, b: f64, above: f64) -> Entry {
        let mut top = b;
        for piece in self.limit.chain.over(b, parent.z1) {
            let piece = Piece { z0: piece.z0.max(b), z1: piece.z1.min(parent.z1), form: piece.form };
            if piece.at(piece.z0) > above {
                break;
            }
            let crest = match piece.form {
                Form::Arc { center, upper: true, .. } if center.z < piece.z1 => center.z.max(piece.z0),
                Form::Line { p, q } if q.r < p.r => piece.z0,
                Form::Arc { center, upper: false, .. } if center.z > piece.z0 && top > b => piece.z0,
                _ => piece.z1,
            };
            let meets = piece.meets(&Piece::level(piece.z0, piece.z1, above)).iter().next();
            top = meets.map_or(crest, |z| z.min(crest));
            if top < piece.z1 {
                break;
            }
        }
        Entry::Ramp(top, trace(&self.limit.chain, b, top, self.rolled, self.rules))
    }
}

impl Rough<'_> {
    /// The moves of the strokes, from where the tool is changed. The tool goes back there before `room` moves are exceeded.
    pub(super) fn cut(&self, path: &mut Path<'_>, strokes: &[Stroke], air: &Chain, ceiling: f64, room: usize) {
        // Where a straight descent began: the way back along it is free.
        let mut back = None;
        for (k, stroke) in strokes.iter().enumerate() {
            let z = match stroke.entry {
                Entry::Air(z) | Entry::Ramp(z, _) => z,
            };
            let height = self.free_height(path.at.z, z, stroke.above) + CLEARANCE_MM;
            let over = Point::new(z, height);
            let before = k.checked_sub(1).and_then(|k| strokes.get(k));
            if path.since_home() + MOST_MOVES_OF_A_STROKE > room {
                Self::withdraw(path, before, back, ceiling);
                path.home(air, ceiling);
            }
            if path.since_home() == 0 {
                link::link(path, over, air, ceiling);
            } else if path.at.z < z && height <= stroke.above + CLEARANCE_MM + SAME_MM {
                // Back over what was just cut, rising.
                path.rapid(over);
            } else {
                Self::withdraw(path, before, back, height);
                path.rapid(over);
            }
            back = matches!(&stroke.entry, Entry::Ramp(_, ramp) if is_straight(ramp)).then_some(path.at);
            match &stroke.entry {
                Entry::Air(z) => path.rapid(Point::new(*z, stroke.r)),
                Entry::Ramp(_, ramp) => descend(path, ramp, Point::new(stroke.b, stroke.r)),
            }
            path.line(Point::new(stroke.a, stroke.r));
        }
        Self::withdraw(path, strokes.last(), back, ceiling);
    }

    /// Straight out to `height` from the end of a stroke, leaning away from the wall there; from a stroke too short for that
    /// back where it came from.
    fn withdraw(path: &mut Path<'_>, stroke: Option<&Stroke>, back: Option<Point>, height: f64) {
        let Some(stroke) = stroke else { return };
        let (room, lean) = (stroke.b - stroke.a, LEAN * (height - path.at.r));
        if lean <= room {
            path.rapid(Point::new(path.at.z + lean, height));
            return;
        }
        match (&stroke.entry, back) {
            (_, Some(place)) => path.rapid(place),
            (Entry::Air(z), None) => path.rapid(Point::new(*z, stroke.r)),
            (Entry::Ramp(_, ramp), None) => {
                path.line(Point::new(stroke.b, stroke.r));
                ramp.iter().rev().for_each(|s| path.along(&s.reversed()));
            }
        }
        path.rapid(Point::new(path.at.z, height));
    }

    /// The level that is free between two positions: that of the stretch which holds both, at least `least`.
    fn free_height(&self, z0: f64, z1: f64, least: f64) -> f64 {
        let highest = self.limit.chain.highest(z0.min(z1), z0.max(z1)).max(least);
        let level = ((self.top - highest) / self.depth + SAME_MM).floor().max(0.0);
        (self.top - self.depth * level).max(least)
    }
}

/// True if the tool descends along the ramp in one line.
fn is_straight(ramp: &[Segment]) -> bool {
    matches!(ramp, [] | [Segment::Line { .. }])
}

/// Down along the ramp to `to`. The tool comes from above the ramp's beginning, so a first line may be cut short.
fn descend(path: &mut Path<'_>, ramp: &[Segment], to: Point) {
    match ramp.first() {
        Some(Segment::Line { .. }) | None => {}
        Some(arc) => path.line(arc.start()),
    }
    for segment in ramp {
        path.along(segment);
    }
    path.line(to);
}
