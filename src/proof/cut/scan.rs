//! Rings to columns.

use super::columns::{Columns, Span};
use super::grid::{GridPoint, Ring, edges};
use super::line::Line;
use super::overlap::{crossing, middle};

impl Columns {
    /// What rings wind around, crossing themselves and each other as they like.
    pub(super) fn of_rings(rings: &[Ring]) -> Self {
        match rings {
            [] => Self::default(),
            [ring] if is_convex(ring) => Self::of_convex(ring),
            _ => Scan::of(rings).run(),
        }
    }

    /// The inside of a convex ring, counter-clockwise, with three corners at least.
    pub(super) fn of_convex(ring: &[GridPoint]) -> Self {
        let count = ring.len();
        let mut columns = Self::with_capacity(count);
        let Some(first) = (0..count).min_by_key(|&i| ring[i].x) else { return columns };
        // The lower border runs on from the first point, the upper one back from it.
        let (mut low, mut high) = (Border { ring, at: first, step: 1 }, Border { ring, at: first, step: count - 1 });
        let (Some(mut lower), Some(mut upper)) = (low.next_line(), high.next_line()) else { return columns };
        let mut from = lower.a.x;
        loop {
            let to = lower.b.x.min(upper.b.x);
            columns.push(from, to, &[Span { low: lower, high: upper }]);
            from = to;
            if lower.b.x == to {
                let Some(next) = low.next_line() else { return columns };
                lower = next;
            }
            if upper.b.x == to {
                let Some(next) = high.next_line() else { return columns };
                upper = next;
            }
        }
    }
}

/// One of the two borders of a convex ring, walked towards larger z.
struct Border<'a> {
    ring: &'a [GridPoint],
    at: usize,
    step: usize,
}

impl Border<'_> {
    /// The next edge that is not vertical; `None` where the ring turns back.
    fn next_line(&mut self) -> Option<Line> {
        for _ in 0..self.ring.len() {
            let from = self.ring[self.at];
            let next = (self.at + self.step) % self.ring.len();
            let to = self.ring[next];
            if to.x < from.x {
                return None;
            }
            self.at = next;
            if to.x > from.x {
                return Line::through(from, to);
            }
        }
        None
    }
}

/// True if a ring turns left everywhere and once around. A point that comes twice would hide how the ring turns there.
fn is_convex(ring: &[GridPoint]) -> bool {
    let count = ring.len();
    let corner = |i: usize| [ring[i], ring[(i + 1) % count], ring[(i + 2) % count]];
    let turns_back = |i: &usize| {
        let [a, b, c] = corner(*i);
        (a.x <= b.x) && (b.x > c.x)
    };
    count >= 3
        && (0..count).all(|i| {
            let [a, b, c] = corner(i);
            a != b && super::grid::turn(a, b, c) >= 0
        })
        && (0..count).filter(turns_back).count() == 1
}

/// An edge and whether material lies above it.
#[derive(Debug, Clone, Copy)]
struct Edge {
    line: Line,
    winding: i32,
}

/// Sweeps over the edges of rings in order of z.
struct Scan {
    /// In order of their beginnings, the first one last.
    coming: Vec<Edge>,
    places: Vec<i32>,
    columns: Columns,
    spans: Vec<Span>,
}

impl Scan {
    fn of(rings: &[Ring]) -> Self {
        let all = || rings.iter().flat_map(|ring| edges(ring));
        let edge = |(p, q): (GridPoint, GridPoint)| {
            Some(Edge { line: Line::through(p, q)?, winding: if p.x < q.x { 1 } else { -1 } })
        };
        let mut coming: Vec<Edge> = all().filter_map(edge).collect();
        coming.sort_unstable_by_key(|edge| std::cmp::Reverse(edge.line.a.x));
        let mut places: Vec<i32> = all().map(|(p, _)| p.x).collect();
        places.sort_unstable();
        places.dedup();
        Self { coming, places, columns: Columns::default(), spans: Vec::new() }
    }

    fn run(mut self) -> Columns {
        let mut active: Vec<Edge> = Vec::new();
        let places = std::mem::take(&mut self.places);
        for stretch in places.windows(2) {
            let (from, to) = (stretch[0], stretch[1]);
            active.retain(|edge| edge.line.b.x > from);
            while let Some(edge) = self.coming.pop_if(|edge| edge.line.a.x <= from) {
                active.push(edge);
            }
            self.stretch(from, to, &mut active);
        }
        self.columns
    }

    /// Adds a stretch in which no edge begins or ends.
    fn stretch(&mut self, from: i32, to: i32, active: &mut [Edge]) {
        active.sort_by(|e, f| middle(&e.line, from, to).total_cmp(&middle(&f.line, from, to)));
        // If neighbours do not cross, nothing does: heights then rise in the same order at both ends.
        let crossed = active.windows(2).find_map(|pair| crossing(&pair[0].line, &pair[1].line, from, to));
        if let Some(at) = crossed {
            self.stretch(from, at, active);
            self.stretch(at, to, active);
            return;
        }
        self.spans.clear();
        let mut winding = 0;
        let mut low = None;
        for edge in active {
            winding += edge.winding;
            match low {
                None if winding != 0 => low = Some(edge.line),
                Some(begin) if winding == 0 => {
                    low = None;
                    if middle(&begin, from, to) < middle(&edge.line, from, to) {
                        self.spans.push(Span { low: begin, high: edge.line });
                    }
                }
                _ => {}
            }
        }
        self.columns.push(from, to, &self.spans);
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::area_of;
    use super::*;

    #[test]
    fn a_point_that_comes_twice_hides_no_hollow_corner() {
        // A stepped bar from its hollow corner, which is the only one, and closed by the same point.
        let step = [(5000, 5000), (0, 5000), (0, 0), (9000, 0), (9000, 2000), (5000, 2000), (5000, 5000)];
        let corners = [(5000, 2000), (5000, 5000), (0, 5000), (0, 0), (9000, 0), (9000, 2000), (5000, 2000)];
        for points in [step, corners] {
            let ring: Ring = points.iter().map(|&(x, y)| GridPoint::new(x, y)).collect();
            let columns = Columns::of_rings(std::slice::from_ref(&ring));
            assert!(!is_convex(&ring));
            assert!((columns.area_mm2() - area_of(&[ring])).abs() < 1e-12);
        }
        let square: Ring = [(0, 0), (9, 0), (9, 9), (0, 9)].iter().map(|&(x, y)| GridPoint::new(x, y)).collect();
        assert!(is_convex(&square));
    }
}
