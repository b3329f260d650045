//! Arcs in the words of a control: divided as it needs them, with centres that fit the rounded ends.

use super::grid::{Counts, Grid};
use crate::geometry::{Point, Segment};
use crate::machine::{ArcCenter, Limits, Words};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// An arc whose ends are no more than this many counts apart on either axis has no centre worth writing: a line.
const VANISHING_COUNTS: f64 = 2.0;

/// Distance of chords from an arc whose radius or centre the control cannot take, counts: with the rounding of their ends, half a
/// count on either axis, they stay within one.
const CHORD_COUNTS: f64 = 0.25;

/// Most chords that one arc becomes.
const MOST_CHORDS: f64 = 10_000.0;

/// By how much the distances of a centre from both ends may differ, counts; above it another centre is looked for.
const UNEQUAL_COUNTS: f64 = 1.0;

/// How far beyond a whole quadrant or half turn an arc still counts as one, radians: rounding noise of its ends.
const SWEEP_NOISE: f64 = 1e-9;

/// A part of an arc that one block can make.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Piece {
    /// Straight, to this position.
    Line(Counts),
    /// Along a circle.
    Arc {
        /// End.
        to: Counts,
        /// Centre from the start, counts: I and K.
        center: (i64, i64),
        /// Radius, counts.
        radius: i64,
        /// Counter-clockwise with z right and the radius up.
        ccw: bool,
    },
}

/// What a control asks of an arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcRules {
    pub(super) center: ArcCenter,
    /// One arc stays in one quadrant.
    pub(super) one_quadrant: bool,
    /// The centre is a position without sign: it must not be negative.
    positive_center: bool,
    /// Smallest and largest radius, mm.
    pub(super) radii_mm: (f64, f64),
}

impl ArcRules {
    pub(super) const fn new(words: &Words, limits: &Limits) -> Self {
        Self {
            center: words.arc_center,
            positive_center: matches!(words.arc_center, ArcCenter::Absolute) && !words.arc_center_signed,
            one_quadrant: limits.arc_one_quadrant || !words.arc_center_signed,
            radii_mm: (limits.arc_radius_min_mm, limits.arc_radius_max_mm),
        }
    }

    /// Most that one block sweeps. A radius word says least about the centre near half a turn: there a count more of the
    /// radius moves the arc by many, up to a quarter turn by less than one.
    const fn most_sweep(&self) -> f64 {
        match self.center {
            ArcCenter::Radius => FRAC_PI_2,
            ArcCenter::Incremental | ArcCenter::Absolute => PI,
        }
    }
}

/// The blocks of an exact arc, from the rounded position `from`.
pub(super) fn pieces(arc: &Segment, from: Counts, grid: &Grid, rules: &ArcRules) -> Vec<Piece> {
    let Segment::Arc { start, end, center, ccw } = *arc else { return vec![Piece::Line(grid.counts(arc.end()))] };
    let (radius, sweep) = (start.distance(center), arc.sweep());
    if is_short(grid, start, end) {
        return vec![Piece::Line(grid.counts(end))];
    }
    let (least, most) = rules.radii_mm;
    let (i, k) = grid.absolute(center);
    let by_chords = radius < least || radius > most || rules.positive_center && i.min(k) < 0;
    let cuts = if by_chords { chords(radius, sweep, grid) } else { divisions(start, center, sweep, grid, rules) };
    let mut at = from;
    let mut exact = start;
    let mut all = Vec::with_capacity(cuts.len() + 1);
    let ends = cuts.iter().map(|&angle| turned(start, center, angle)).chain([end]);
    for next in ends {
        let to = grid.counts(next);
        if to != at {
            let line = by_chords || is_short(grid, grid.point(at), grid.point(to));
            let piece = Segment::Arc { start: exact, end: next, center, ccw };
            all.push(if line { Piece::Line(to) } else { fitted(&piece, at, to, grid, rules) });
        }
        (at, exact) = (to, next);
    }
    all
}

fn is_short(grid: &Grid, a: Point, b: Point) -> bool {
    let chord = b - a;
    chord.x.abs().max(chord.y.abs()) <= VANISHING_COUNTS * grid.step_mm()
}

/// Angles from the start at which an arc is divided so that no part sweeps too much or leaves its quadrant by more than a
/// vanishing piece.
fn divisions(start: Point, center: Point, sweep: f64, grid: &Grid, rules: &ArcRules) -> Vec<f64> {
    let mut cuts = vec![0.0, sweep.abs()];
    if rules.one_quadrant {
        let begin = (start.r - center.r).atan2(start.z - center.z) * sweep.signum();
        let first = (begin / FRAC_PI_2).ceil() * FRAC_PI_2 - begin;
        cuts.extend((0..4).map(|quarter| first + f64::from(quarter) * FRAC_PI_2).filter(|&a| a < sweep.abs()));
        cuts.sort_by(f64::total_cmp);
    }
    let mut fine = Vec::new();
    for pair in cuts.windows(2) {
        let [a, b] = *pair else { continue };
        let parts = ((b - a) / rules.most_sweep() - SWEEP_NOISE).ceil().max(1.0);
        let mut part = 1.0;
        while part <= parts {
            fine.push(a + (b - a) * part / parts);
            part += 1.0;
        }
    }
    let short = VANISHING_COUNTS * grid.step_mm() / start.distance(center);
    fine.retain(|&a| a > short && a < sweep.abs() - short);
    fine.iter().map(|a| a * sweep.signum()).collect()
}

/// Angles from the start that divide an arc into chords within the tolerance.
fn chords(radius: f64, sweep: f64, grid: &Grid) -> Vec<f64> {
    let tolerance = CHORD_COUNTS * grid.step_mm();
    let most = if radius > tolerance { 2.0 * (1.0 - tolerance / radius).acos() } else { TAU };
    let count = (sweep.abs() / most).ceil().clamp(1.0, MOST_CHORDS);
    let mut angles = Vec::new();
    let mut k = 1.0;
    while k < count {
        angles.push(sweep * k / count);
        k += 1.0;
    }
    angles
}

fn turned(start: Point, center: Point, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    let (z, r) = (start.z - center.z, start.r - center.r);
    Point::new(center.z + z * cos - r * sin, center.r + z * sin + r * cos)
}

/// The words of one piece: the centre that lies as far from both rounded ends as whole counts allow.
fn fitted(piece: &Segment, from: Counts, to: Counts, grid: &Grid, rules: &ArcRules) -> Piece {
    let Segment::Arc { start, end, center, ccw } = *piece else { return Piece::Line(to) };
    let (a, b) = (grid.point(from), grid.point(to));
    let chord = b - a;
    let middle = Point::new(f64::midpoint(a.z, b.z), f64::midpoint(a.r, b.r));
    let off = (center - middle).dot(&chord) / chord.norm_squared();
    let equidistant = center - chord * off;
    let (i, k) = grid.displacement(a, equidistant);
    let true_signs = [grid.displacement(start, center), grid.displacement(end, center)];
    let score = |candidate: (i64, i64)| {
        let c = grid.displaced(a, candidate.0, candidate.1);
        let difference = (c.distance(a) - c.distance(b)).abs() / grid.step_mm();
        let wrong = if rules.one_quadrant {
            let [(i0, k0), (i1, k1)] = true_signs;
            let (ib, kb) = grid.displacement(b, c);
            let (ia, ka) = (candidate.0 as f64, candidate.1 as f64);
            strays(ia, i0) + strays(ka, k0) + strays(ib, i1) + strays(kb, k1)
        } else {
            0.0
        };
        let unequal = (difference - UNEQUAL_COUNTS).max(0.0);
        10.0 * (wrong + unequal) + (candidate.0 as f64 - i).hypot(candidate.1 as f64 - k)
    };
    let (i0, k0) = (nearest(i), nearest(k));
    let around = (-1..=1).flat_map(|di| (-1..=1).map(move |dk| (i0 + di, k0 + dk)));
    let best = around.min_by(|&p, &q| score(p).total_cmp(&score(q))).unwrap_or((i0, k0));
    let half_chord = chord.norm() / 2.0 / grid.step_mm();
    let radius = nearest(equidistant.distance(a) / grid.step_mm()).max(nearest(half_chord.ceil()));
    if best == (0, 0) { Piece::Line(to) } else { Piece::Arc { to, center: best, radius, ccw } }
}

/// How far a component lies on the wrong side of the circle's axis, counts; a true component that rounds to 0 has none.
fn strays(component: f64, truth: f64) -> f64 {
    if truth.abs() < 0.5 || component * truth < 0.0 { component.abs() } else { 0.0 }
}

#[allow(clippy::cast_possible_truncation, reason = "`as` saturates; positions are range checked")]
fn nearest(value: f64) -> i64 {
    value.round() as i64
}
