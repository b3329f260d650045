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
    lines: Vec<Side>,
    /// The border that follows, with itself where it was walked already.
    next: Vec<Border>,
    done: Vec<bool>,
    ring: Ring,
    found: Vec<Ring>,
}

/// A border with its ends and its heights there.
#[derive(Debug, Clone, Copy)]
struct Side {
    line: Line,
    ends: [i32; 2],
    heights: [f64; 2],
}

impl Side {
    fn of(line: Line, from: i32, to: i32) -> Self {
        Self { line, ends: [from, to], heights: line.over(from, to) }
    }

    /// The point at its beginning (0) or end (1).
    #[allow(clippy::cast_possible_truncation, reason = "heights lie on the grid")]
    fn point(&self, end: usize) -> GridPoint {
        GridPoint::new(self.ends[end], self.heights[end].round() as i32)
    }
}

impl Walk {
    /// The outlines of the material, as [`Columns::rings`].
    pub(super) fn rings(&mut self, columns: &Columns) -> Vec<Ring> {
        self.found.clear();
        if columns.iter().all(|column| column.spans.len() == 1) {
            self.walk_strips(columns);
        } else {
            self.take(columns);
            for start in 0..self.next.len() {
                self.walk_from(start);
                self.keep_ring();
            }
        }
        std::mem::take(&mut self.found)
    }

    fn keep_ring(&mut self) {
        if self.ring.len() > 2 && !is_sliver(&self.ring) {
            self.found.push(self.ring.clone());
        }
    }

    /// Walks around columns of one span each: along the lower borders of those that hang together, back along the upper ones.
    fn walk_strips(&mut self, columns: &Columns) {
        self.lines.clear();
        for column in columns.iter() {
            let sides = column.spans.first().map(|s| [s.low, s.high].map(|l| Side::of(l, column.from, column.to)));
            let Some([low, high]) = sides else { continue };
            if let [.., l, h] = &self.lines[..]
                && !(l.ends[1] == column.from
                    && hang_together([l.heights[1], h.heights[1]], [low.heights[0], high.heights[0]]))
            {
                self.walk_strip();
                self.lines.clear();
            }
            self.lines.extend([low, high]);
        }
        self.walk_strip();
    }

    /// Walks around the borders of columns that hang together.
    fn walk_strip(&mut self) {
        self.ring.clear();
        let (lines, ring) = (&self.lines, &mut self.ring);
        walk_side(lines.iter().step_by(2), [0, 1], ring);
        walk_side(lines.iter().skip(1).step_by(2).rev(), [1, 0], ring);
        close(ring);
        self.keep_ring();
    }

    /// Takes the borders of columns and finds which follows which.
    fn take(&mut self, columns: &Columns) {
        self.lines.clear();
        for column in columns.iter() {
            for span in column.spans {
                self.lines.extend([span.low, span.high].map(|line| Side::of(line, column.from, column.to)));
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
                self.join(before.1..first, first..first);
            }
            let end = first + 2 * column.spans.len();
            self.join(joint.map_or(first, |j| j.1)..first, first..end);
            left = Some((column, first));
            first = end;
        }
        if let Some((_, begin)) = left {
            self.join(begin..first, first..first);
        }
    }

    /// Joins the borders that end and those that begin at a position.
    ///
    /// The borders from both sides cut that vertical into pieces with material on neither, one or both sides. Every border is
    /// the end of a piece with material on one side, so two and two follow one another, and of each two one comes in and one
    /// goes out.
    fn join(&mut self, mut left: std::ops::Range<Border>, mut right: std::ops::Range<Border>) {
        let mut pending: Option<(Border, bool)> = None;
        while !left.is_empty() || !right.is_empty() {
            let is_right = left.is_empty()
                || !right.is_empty() && self.lines[right.start].heights[0] < self.lines[left.start].heights[1];
            let Some(border) = (if is_right { &mut right } else { &mut left }).next() else { return };
            // Lower borders of the left side and upper ones of the right side come in.
            let comes_in = is_right != border.is_multiple_of(2);
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
            let side = self.lines[border];
            let (begin, end) = if border.is_multiple_of(2) { (0, 1) } else { (1, 0) };
            if !goes_on {
                push(ring, side.point(begin));
            }
            let next = self.next[border];
            // A line that goes on has no corner at its end.
            goes_on = next % 2 == border % 2 && side.line.joined(&self.lines[next].line).is_some();
            if !goes_on {
                push(ring, side.point(end));
            }
            border = next;
        }
        if goes_on {
            ring.remove(0);
        }
        close(ring);
    }
}

/// True if spans that meet at a position, given by their heights there, have material on both sides of it. As with any number of
/// spans, what ends comes before what begins at the same height.
fn hang_together([l0, l1]: [f64; 2], [r0, r1]: [f64; 2]) -> bool {
    if r0 < l0 { r1 >= l0 } else { r0 < l1 }
}

/// Adds the corners along borders that follow one another; a line that goes on has no corner at its end.
fn walk_side<'a>(sides: impl Iterator<Item = &'a Side>, [begin, end]: [usize; 2], ring: &mut Ring) {
    let mut sides = sides.peekable();
    let mut goes_on = false;
    while let Some(side) = sides.next() {
        if !goes_on {
            push(ring, side.point(begin));
        }
        goes_on = sides.peek().is_some_and(|next| side.line.joined(&next.line).is_some());
        if !goes_on {
            push(ring, side.point(end));
        }
    }
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
