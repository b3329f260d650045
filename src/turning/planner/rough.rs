//! Roughing: strokes along the spindle, one depth below the other, where there is stock and the tool can go.
//!
//! A stretch of one level is cut from right to left. What is then open below it is divided by the limit into the stretches of
//! the next level, and each of those is cut to its bottom before its left neighbour, so that ways through air stay short. Every
//! stroke is looked at with the stock that is left when its turn comes, and ends where holder or insert would run into it.

use super::chain::{Chain, Run};
use super::link::{CLEARANCE_MM, go};
use super::path::Path;
use super::piece::{Form, Piece, SAME_MM};
use super::trace::{ArcRules, simplified, trace};
use super::work::{AIR_MM, Limit};
use crate::geometry::{Point, Segment, Vector};

/// Strokes shorter than this are left to the pass along the contour, mm.
const SHORTEST_STROKE_MM: f64 = 0.1;

/// Stock lower than this over a level is left to the pass along the contour, mm.
const LOWEST_STOCK_MM: f64 = 0.05;

/// Strokes of one level that are closer than this are made in one, mm.
const JOINED_MM: f64 = 1.0;

/// A way down that is steeper than this goes straight down.
const STEEPEST: f64 = 10.0;

/// Moves of one stroke with the ways to it and home, at most; a ramp with more is rare and only lengthens its program.
const MOST_MOVES_OF_A_STROKE: usize = 9;

/// Levels at most; a depth of cut that asks for more is not one.
const MOST_LEVELS: u32 = 100_000;

/// How often a stroke is shortened before it is given up.
const MOST_TRIES: u32 = 8;

/// How much further on a stroke begins that cannot be entered where it should, mm.
const SHIFTS_MM: [f64; 6] = [0.0, 0.5, 1.0, 2.0, 4.0, 8.0];

/// Distance that a shortened stroke keeps from what is in its way, mm.
const SHORTENED_MM: f64 = 0.01;

/// One stroke to `a` at the height `r`, after a way into it.
struct Stroke {
    r: f64,
    a: f64,
    /// Where it begins on its own height.
    b: f64,
    /// Where the tool comes from, in air.
    start: Point,
    /// Down along the limit, or nothing.
    ramp: Vec<Segment>,
}

impl Stroke {
    /// The same begun `by` mm further on, where that leaves anything of it: next to something in the way.
    fn shifted(&self, by: f64) -> Option<Self> {
        let on = Vector::new(-by, 0.0);
        (by == 0.0 || self.b - by > self.a + by).then(|| Self {
            b: self.b - by,
            start: self.start + on,
            ramp: self.ramp.iter().map(|s| s.translated(on)).collect(),
            ..*self
        })
    }

    /// The same begun where there is air.
    fn begun_in_air(self, path: &Path<'_>) -> Self {
        let low = path.air(self.start.z, self.start.z, self.r).at(self.start.z);
        let height = low.map_or(self.start.r, |low| self.start.r.max(low + CLEARANCE_MM));
        Self { start: Point::new(self.start.z, height), ..self }
    }

    /// All of it as far as `a`. The tool comes from above the ramp's beginning, so a first line of it is cut short.
    fn way(&self, a: f64) -> Vec<Segment> {
        let mut way = Vec::with_capacity(self.ramp.len() + 3);
        for segment in &self.ramp {
            if let Segment::Arc { start, .. } = segment {
                self.straight(&mut way, *start);
                way.push(*segment);
            } else {
                self.straight(&mut way, segment.end());
            }
        }
        self.straight(&mut way, Point::new(self.b, self.r));
        self.straight(&mut way, Point::new(a, self.r));
        way
    }

    /// Goes on straight to a place.
    fn straight(&self, way: &mut Vec<Segment>, to: Point) {
        let at = way.last().map_or(self.start, Segment::end);
        if at.distance(to) > SAME_MM {
            way.push(Segment::line(at, to));
        }
    }
}

/// What roughing needs to know.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rough<'a> {
    pub(super) limit: &'a Limit,
    /// Largest radius of the stock, mm.
    pub(super) top: f64,
    /// From one level to the next, mm.
    pub(super) depth: f64,
    /// Radius of the arcs on which the nose rolls over corners.
    pub(super) rolled: f64,
    pub(super) rules: ArcRules,
    /// Moves after which the tool goes home.
    pub(super) room: usize,
}

impl Rough<'_> {
    /// Makes all strokes, or so many that there are more than `most` moves.
    pub(super) fn cut(&self, path: &mut Path<'_>, most: usize) {
        let whole = Run { z0: self.limit.z0, z1: self.limit.z1 };
        // A stack instead of recursion: the depth of a part over the depth of a cut may be large.
        let mut open = self.below(whole, 1);
        while let Some((parent, run, level)) = open.pop().filter(|_| path.len() <= most) {
            let blocked = self.level(path, parent, run, self.height(level));
            for rest in without(run, &blocked) {
                open.extend(self.below(rest, level + 1));
            }
        }
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

    /// Makes the strokes of one stretch of a level, the right one first; gives the stretches where the tool could not go.
    fn level(&self, path: &mut Path<'_>, parent: Run, run: Run, r: f64) -> Vec<Run> {
        let mut blocked = Vec::new();
        for full in wanted(&path.touch(run.z0, run.z1, r), r).into_iter().rev() {
            let stroke = self.stroke(parent, run, full, r);
            let entries = SHIFTS_MM.into_iter().filter_map(|by| stroke.shifted(by)).map(|s| s.begun_in_air(path));
            let found = entries.map(|s| (Self::shortened(path, &s), s)).find(|(a, _)| a.is_some());
            let Some((Some(a), entered)) = found else {
                blocked.push(Run { z0: full.z0, z1: full.z1 });
                continue;
            };
            if entered.b < stroke.b {
                blocked.push(Run { z0: entered.b, z1: run.z1 });
            }
            if a > full.z0 {
                blocked.push(Run { z0: full.z0, z1: a });
            }
            if entered.b - a >= SHORTEST_STROKE_MM.min(stroke.b - stroke.a) {
                self.make(path, &Stroke { a, ..entered });
            }
        }
        blocked
    }

    /// The stroke that cuts a stretch, and how it is entered.
    fn stroke(&self, parent: Run, run: Run, full: Run, r: f64) -> Stroke {
        let room = run.z1 - full.z1;
        if room > SHORTEST_STROKE_MM {
            let start = Point::new(full.z1 + room.min(AIR_MM), r);
            return Stroke { r, a: full.z0, b: full.z1, start, ramp: Vec::new() };
        }
        let above = r + self.depth;
        let (top, ramp) = self.ramp(parent, run.z1, above);
        let ramp = simplified(&ramp, self.depth);
        let start = Point::new(top, above + CLEARANCE_MM);
        if (top - run.z1) * STEEPEST <= self.depth {
            return Stroke { r, a: full.z0, b: run.z1, start: Point::new(run.z1, start.r), ramp: Vec::new() };
        }
        Stroke { r, a: full.z0, b: run.z1, start, ramp }
    }

    /// How far a stroke can go before something is in its way; `None` if it cannot be entered.
    fn shortened(path: &Path<'_>, stroke: &Stroke) -> Option<f64> {
        let mut a = stroke.a;
        for _ in 0..MOST_TRIES {
            let way = stroke.way(a);
            let Some(blocked) = path.blocked(&way) else { return Some(a) };
            if blocked.index + 1 < way.len() {
                return None;
            }
            a = blocked.zone.z1 + SHORTENED_MM;
            if a >= stroke.b {
                return None;
            }
        }
        None
    }

    /// Down along the limit from the level above to `b`.
    fn ramp(&self, parent: Run, b: f64, above: f64) -> (f64, Vec<Segment>) {
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
        (top, trace(&self.limit.chain, b, top, self.rolled, self.rules))
    }

    /// Makes a stroke from wherever the tool is.
    fn make(&self, path: &mut Path<'_>, stroke: &Stroke) {
        if path.since_home() + MOST_MOVES_OF_A_STROKE > self.room {
            path.home();
        }
        go(path, stroke.start);
        for segment in stroke.way(stroke.a) {
            path.along(&segment);
        }
    }
}

/// The stretches of a level at `r` where there is stock worth a stroke, from left to right.
fn wanted(touch: &Chain, r: f64) -> Vec<Run> {
    let mut wanted: Vec<Run> = Vec::new();
    for full in touch.runs_above(r + SAME_MM) {
        match wanted.last_mut() {
            Some(last) if full.z0 - last.z1 < JOINED_MM => last.z1 = full.z1,
            _ => wanted.push(full),
        }
    }
    wanted.retain(|w| {
        let height = touch.highest(w.z0, w.z1) - r;
        height > LOWEST_STOCK_MM && (w.width() >= SHORTEST_STROKE_MM || height > CLEARANCE_MM / 2.0)
    });
    wanted
}

/// What is left of a stretch without some others, which are in order from right to left.
fn without(run: Run, others: &[Run]) -> Vec<Run> {
    let mut rest = Vec::new();
    let mut from = run.z0;
    for other in others.iter().rev() {
        if other.z0 - from > SAME_MM {
            rest.push(Run { z0: from, z1: other.z0 });
        }
        from = from.max(other.z1);
    }
    if run.z1 - from > SAME_MM {
        rest.push(Run { z0: from, z1: run.z1 });
    }
    rest
}
