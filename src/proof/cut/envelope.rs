//! What a convex outline covers on a path that runs one way along z: everything between two chains of lines.
//!
//! Where the outline stands over a position, it does so for one stretch of the path, and what it covers there moves without a
//! jump, so at every position the moved outline covers one span. Its lower border is the lowest of the edges that the outline
//! leaves to the right of the path: the path moved by the corner that is furthest to the right, and at corners that turn left
//! the outline's own edges between two such corners. The upper border is the same upside down.

use super::columns::{Columns, Span};
use super::grid::{GridPoint, Ring, plus};
use super::line::Line;
use super::overlap::Border;
use super::sweep::{cross, direction, dot, support, support_near};

/// The region that a convex outline, counter-clockwise, covers along a path; `None` if the path turns back along z.
pub(super) fn swept_one_way(outline: &[GridPoint], path: &[GridPoint]) -> Option<Columns> {
    let forth = path.windows(2).all(|w| w[0].x <= w[1].x);
    let back = path.windows(2).all(|w| w[0].x >= w[1].x);
    if !forth && !back || outline.len() < 3 {
        return None;
    }
    let mut path = path.to_vec();
    if !forth {
        path.reverse();
    }
    path.dedup();
    let low = lowest(outline, &path);
    let high = lowest(&upside_down(outline.iter().rev()), &upside_down(path.iter()));
    Some(between(&low, &high))
}

fn upside_down<'a>(points: impl Iterator<Item = &'a GridPoint>) -> Ring {
    points.map(|p| GridPoint::new(p.x, -p.y)).collect()
}

/// A part of a chain of lines.
#[derive(Debug, Clone, Copy)]
struct Piece {
    line: Line,
    from: i32,
    to: i32,
}

/// The lower border of what an outline covers along a path that never runs to smaller z.
fn lowest(outline: &[GridPoint], path: &[GridPoint]) -> Vec<Piece> {
    let mut chain = Chain { pieces: Vec::with_capacity(outline.len() + 2 * path.len()), tail: Vec::new() };
    let (down, up) = ((0, -1), (0, 1));
    let mut vertex = support(outline, down);
    let mut before = down;
    for (index, &at) in path.iter().enumerate() {
        let next = path.get(index + 1);
        let along = next.map_or(up, |&next| direction(at, next));
        let last = support_near(outline, vertex, along);
        let turns_left = cross(before, along) > 0 || (cross(before, along) == 0 && dot(before, along) < 0);
        while turns_left && vertex != last {
            let corner = (vertex + 1) % outline.len();
            chain.add(plus(outline[vertex], at), plus(outline[corner], at));
            vertex = corner;
        }
        vertex = last;
        if let Some(&next) = next {
            chain.add(plus(outline[vertex], at), plus(outline[vertex], next));
        }
        before = along;
    }
    chain.pieces
}

/// The lowest of edges that are added as they follow one another, without a gap.
struct Chain {
    pieces: Vec<Piece>,
    /// Pieces that the next edge is compared with.
    tail: Vec<Piece>,
}

impl Chain {
    /// Adds an edge; one that runs to smaller z or nowhere is no border.
    fn add(&mut self, begin: GridPoint, end: GridPoint) {
        if begin.x >= end.x {
            return;
        }
        let Some(line) = Line::through(begin, end) else { return };
        let (mut from, to) = (begin.x, end.x);
        self.tail.clear();
        while let Some(piece) = self.pieces.pop_if(|piece| piece.to > from) {
            self.tail.push(piece);
        }
        while let Some(piece) = self.tail.pop() {
            self.push(piece.line, piece.from, piece.to.min(from));
            let (begin, end) = (piece.from.max(from), piece.to.min(to));
            if begin < end {
                self.lower(piece.line, line, begin, end);
            }
            self.push(piece.line, piece.from.max(to), piece.to);
            from = from.max(piece.to);
        }
        self.push(line, from, to);
    }

    /// Adds the lower one of two lines over a stretch.
    fn lower(&mut self, old: Line, new: Line, from: i32, to: i32) {
        let (a, b) = (Border::over(old, from, to), Border::over(new, from, to));
        if let Some(at) = a.crossing(&b, from, to) {
            self.lower(old, new, from, at);
            self.lower(old, new, at, to);
        } else {
            self.push(if a.is_above(&b) { new } else { old }, from, to);
        }
    }

    fn push(&mut self, line: Line, from: i32, to: i32) {
        if from >= to {
            return;
        }
        match self.pieces.last_mut() {
            Some(last) if last.line == line && last.to == from => last.to = to,
            _ => self.pieces.push(Piece { line, from, to }),
        }
    }
}

/// What lies between a lower border and an upper one that is upside down.
fn between(low: &[Piece], high: &[Piece]) -> Columns {
    let mut columns = Columns::with_capacity(low.len() + high.len());
    let (mut lows, mut highs) = (low.iter(), high.iter());
    let (mut lower, mut upper) = (lows.next(), highs.next());
    while let (Some(l), Some(h)) = (lower, upper) {
        let (from, to) = (l.from.max(h.from), l.to.min(h.to));
        let flipped = |p: GridPoint| GridPoint::new(p.x, -p.y);
        columns.push(from, to, &[Span { low: l.line, high: Line { a: flipped(h.line.a), b: flipped(h.line.b) } }]);
        if l.to == to {
            lower = lows.next();
        }
        if h.to == to {
            upper = highs.next();
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::super::grid::hull;
    use super::super::sweep::swept;
    use super::*;
    use proptest::prelude::*;

    fn points(raw: &[(i32, i32)]) -> Ring {
        raw.iter().map(|&(x, y)| GridPoint::new(x, y)).collect()
    }

    #[allow(clippy::cast_possible_truncation, reason = "positions on the grid")]
    fn whole(position: f64) -> i32 {
        position.round() as i32
    }

    /// The largest difference of two regions of one span each in height, where neither end is near.
    fn apart(a: &Columns, b: &Columns) -> f64 {
        let heights = |columns: &Columns, x: i32| {
            let column = columns.get(columns.first_beyond(x)).filter(|c| c.from <= x && c.spans.len() == 1);
            column.map(|c| [c.spans[0].low.at(x), c.spans[0].high.at(x)])
        };
        let (from, to) = a.reach().unwrap();
        let at = |k: i32| from + whole(f64::from(to - from) * f64::from(k) / 400.0);
        let far = |x: i32| match (heights(a, x), heights(b, x)) {
            (Some(p), Some(q)) => (p[0] - q[0]).abs().max((p[1] - q[1]).abs()),
            _ => f64::INFINITY,
        };
        (1..400).map(at).map(far).fold(0.0, f64::max)
    }

    /// A way that never turns back along z.
    fn path() -> impl Strategy<Value = Ring> {
        let bend = (prop_oneof![Just(0), 1..90_000, 1..900_000], -300_000..300_000, prop::bool::weighted(0.2));
        prop::collection::vec(bend, 2..30).prop_map(|bends| {
            let mut x = 0;
            bends
                .into_iter()
                .map(|(dx, y, level)| {
                    x += dx;
                    GridPoint::new(x, if level { 0 } else { y })
                })
                .collect()
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]

        #[test]
        fn chains_are_what_the_scan_of_the_swept_ring_finds(
            raw in prop::collection::vec((-90_000..90_000, -90_000..90_000), 3..12),
            path in path(),
            reversed in any::<bool>(),
        ) {
            let outline = hull(points(&raw));
            prop_assume!(outline.len() >= 3);
            let path: Ring = if reversed { path.into_iter().rev().collect() } else { path };
            let columns = swept_one_way(&outline, &path).unwrap();
            let scanned = Columns::of_rings(&[swept(&outline, &path)]);
            prop_assert_eq!(columns.reach(), scanned.reach());
            // Steep lines turn the rounding of a crossing along z into a far greater height.
            let area = (columns.area_mm2() - scanned.area_mm2()).abs();
            prop_assert!(area < 1e-4, "{} {}", columns.area_mm2(), scanned.area_mm2());
        }

        #[test]
        fn along_an_arc_both_agree_within_the_rounding(radius in 1_000..900_000_i32, nose in 500..90_000_i32, chords in 3..90_i32, quarter in 0..4_i32) {
            let on = |r: i32, part: f64| {
                let turned = (f64::from(quarter) + part) * std::f64::consts::FRAC_PI_2;
                let unit = |v: f64| whole(f64::from(r) * v);
                GridPoint::new(unit(turned.cos()), unit(turned.sin()))
            };
            let path: Ring = (0..=chords).map(|k| on(radius, f64::from(k) / f64::from(chords))).collect();
            let outline = hull((0..40).map(|k| on(nose, f64::from(k) / 10.0)).collect());
            let columns = swept_one_way(&outline, &path).unwrap();
            let scanned = Columns::of_rings(&[swept(&outline, &path)]);
            prop_assert!((columns.area_mm2() - scanned.area_mm2()).abs() < 1e-4);
            prop_assert!(apart(&columns, &scanned) < 4.0 * f64::from(nose.max(60)), "{}", apart(&columns, &scanned));
        }
    }

    #[test]
    fn a_path_that_turns_back_is_refused() {
        let outline = points(&[(0, 0), (100, 0), (0, 100)]);
        assert!(swept_one_way(&outline, &points(&[(0, 0), (500, 300), (400, 600)])).is_none());
        assert!(swept_one_way(&outline, &points(&[(0, 0), (0, 300), (-400, 600)])).is_some());
    }
}
