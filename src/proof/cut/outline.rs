//! Columns to rings.

use super::columns::{Column, Columns};
use super::grid::{GridPoint, Ring, is_sliver, turn};
use super::line::Line;

/// The start of a border: a lower border runs to larger z, an upper one to smaller z, so material lies to the left of both.
type Border = usize;

impl Columns {
    /// The outlines of the material, slivers left out: outer ones counter-clockwise, holes clockwise.
    pub(super) fn rings(&self) -> Vec<Ring> {
        Walk::default().rings(self)
    }
}

/// The borders of all spans, numbered 2k for the lower and 2k + 1 for the upper border of span k, and which follows which.
#[derive(Debug, Default)]
pub(super) struct Walk {
    lines: Vec<(Line, i32, i32)>,
    /// The border that follows, with itself where it was walked already.
    next: Vec<Border>,
    done: Vec<bool>,
    ring: Ring,
}

impl Walk {
    /// The outlines of the material, as [`Columns::rings`].
    pub(super) fn rings(&mut self, columns: &Columns) -> Vec<Ring> {
        self.take(columns);
        let mut rings = Vec::new();
        for start in 0..self.next.len() {
            self.walk_from(start);
            if self.ring.len() > 2 && !is_sliver(&self.ring) {
                rings.push(self.ring.clone());
            }
        }
        rings
    }

    /// Takes the borders of columns and finds which follows which.
    fn take(&mut self, columns: &Columns) {
        self.lines.clear();
        for column in columns.iter() {
            for span in column.spans {
                self.lines.extend([(span.low, column.from, column.to), (span.high, column.from, column.to)]);
            }
        }
        self.next.clear();
        self.next.resize(self.lines.len(), 0);
        self.done.clear();
        self.done.resize(self.lines.len(), false);
        let mut first = 0;
        let mut left: Option<(Column<'_>, Border)> = None;
        for column in columns.iter() {
            let joint = left.filter(|(before, _)| before.to == column.from);
            if let (Some(before), None) = (left, joint) {
                self.join(before.0.to, before.1..first, first..first);
            }
            let end = first + 2 * column.spans.len();
            self.join(column.from, joint.map_or(first, |j| j.1)..first, first..end);
            left = Some((column, first));
            first = end;
        }
        if let Some((column, begin)) = left {
            self.join(column.to, begin..first, first..first);
        }
    }

    /// Joins the borders that end and begin at a position.
    ///
    /// The borders from both sides cut that vertical into pieces with material on neither, one or both sides. Every border is
    /// the end of a piece with material on one side, so two and two follow one another, and of each two one comes in and one
    /// goes out.
    fn join(&mut self, x: i32, left: std::ops::Range<Border>, right: std::ops::Range<Border>) {
        let mut sides = [left.peekable(), right.peekable()];
        let mut pending: Option<(Border, bool)> = None;
        loop {
            let heights = [0, 1].map(|side| sides[side].peek().map(|&border| self.lines[border].0.at(x)));
            let side = match heights {
                [Some(l), Some(r)] => usize::from(r < l),
                [Some(_), None] => 0,
                [None, Some(_)] => 1,
                [None, None] => return,
            };
            let Some(border) = sides[side].next() else { return };
            // Lower borders of the left side and upper ones of the right side come in.
            let comes_in = (side == 0) == (border.is_multiple_of(2));
            match pending.take() {
                None => pending = Some((border, comes_in)),
                Some((other, true)) => self.next[other] = border,
                Some((other, false)) => self.next[border] = other,
            }
        }
    }

    /// Walks from a border until it comes back; the ring is empty if that was walked already.
    fn walk_from(&mut self, start: Border) {
        let ring = &mut self.ring;
        ring.clear();
        let mut border = start;
        let mut goes_on = false;
        while !self.done[border] {
            self.done[border] = true;
            let (line, from, to) = self.lines[border];
            let (begin, end) = if border.is_multiple_of(2) { (from, to) } else { (to, from) };
            if !goes_on {
                push(ring, on_line(&line, begin));
            }
            let next = self.next[border];
            // A line that goes on has no corner at its end.
            goes_on = next % 2 == border % 2 && line.joined(&self.lines[next].0).is_some();
            if !goes_on {
                push(ring, on_line(&line, end));
            }
            border = next;
        }
        if goes_on {
            ring.remove(0);
        }
        close(ring);
    }
}

#[allow(clippy::cast_possible_truncation, reason = "heights lie on the grid")]
fn on_line(line: &Line, x: i32) -> GridPoint {
    GridPoint::new(x, line.at(x).round() as i32)
}

/// Adds a point; the last one is dropped if it turns out to be no corner.
fn push(ring: &mut Ring, p: GridPoint) {
    while let [.., a, b] = ring[..] {
        if turn(a, b, p) != 0 {
            break;
        }
        ring.pop();
    }
    if ring.last() != Some(&p) {
        ring.push(p);
    }
}

/// Drops points at the seam that are no corners.
fn close(ring: &mut Ring) {
    while let [first, second, .., before, last] = ring[..] {
        if turn(before, last, first) == 0 {
            ring.pop();
        } else if turn(last, first, second) == 0 {
            ring.remove(0);
        } else {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::area_of;
    use super::*;

    fn ring(points: &[(i32, i32)]) -> Ring {
        points.iter().map(|&(x, y)| GridPoint::new(x, y)).collect()
    }

    #[test]
    fn rings_come_back_from_columns() {
        // A square with a hole, a triangle in the hole, and a hook beside it.
        let rings = [
            ring(&[(0, 0), (9000, 0), (9000, 9000), (0, 9000)]),
            ring(&[(1000, 1000), (1000, 8000), (8000, 8000), (8000, 1000)]),
            ring(&[(2000, 2000), (6000, 3000), (3000, 7000)]),
            ring(&[
                (10000, 0),
                (19000, 0),
                (19000, 2000),
                (12000, 2000),
                (12000, 6000),
                (19000, 6000),
                (19000, 9000),
                (10000, 9000),
            ]),
        ];
        let columns = Columns::of_rings(&rings);
        let back = columns.rings();
        assert_eq!(back.len(), 4);
        assert!((area_of(&back) - area_of(&rings)).abs() < 1e-12);
        assert!((columns.area_mm2() - area_of(&rings)).abs() < 1e-12);
        let mut corners = [back.iter().flatten().count(), rings.iter().flatten().count()];
        corners.sort_unstable();
        assert_eq!(corners[0], corners[1]);
    }
}
