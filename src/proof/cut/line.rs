//! The carrier of an edge: a line over z through two points of the grid.

use super::grid::{GridPoint, turn};

/// A line through two points of the grid, the first one at the smaller z.
///
/// Edges keep the points that first defined them however often they are cut short, so that nothing drifts and what is on one
/// line can be told exactly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Line {
    /// The point at the smaller z.
    pub a: GridPoint,
    /// The point at the larger z.
    pub b: GridPoint,
}

impl Line {
    /// The line through two points; `None` if it is vertical.
    pub(super) fn through(p: GridPoint, q: GridPoint) -> Option<Self> {
        match p.x.cmp(&q.x) {
            std::cmp::Ordering::Less => Some(Self { a: p, b: q }),
            std::cmp::Ordering::Greater => Some(Self { a: q, b: p }),
            std::cmp::Ordering::Equal => None,
        }
    }

    /// Height at a position, grid units.
    pub(super) fn at(&self, x: i32) -> f64 {
        // Lines are asked for at their points more often than not, and a division takes its time.
        if x == self.a.x || self.a.y == self.b.y {
            return f64::from(self.a.y);
        }
        if x == self.b.x {
            return f64::from(self.b.y);
        }
        let rise = f64::from(self.b.y) - f64::from(self.a.y);
        let run = f64::from(self.b.x) - f64::from(self.a.x);
        f64::from(self.a.y) + rise * ((f64::from(x) - f64::from(self.a.x)) / run)
    }

    /// Heights at both ends of a stretch.
    pub(super) fn over(&self, from: i32, to: i32) -> [f64; 2] {
        [self.at(from), self.at(to)]
    }

    /// True if over a stretch it is surely nowhere higher than another line: a test without a division, for lines whose points
    /// lie outside the stretch.
    pub(super) fn lies_below(&self, other: &Self, from: i32, to: i32) -> bool {
        let spans = |line: &Self| line.a.x <= from && to <= line.b.x;
        self.a.y.max(self.b.y) <= other.a.y.min(other.b.y) && spans(self) && spans(other)
    }

    /// The longer of two carriers if they are of one line. Exact.
    pub(super) fn joined(&self, other: &Self) -> Option<Self> {
        if self == other {
            return Some(*self);
        }
        // Most lines that are asked for follow one another at a corner, so that the far point tells.
        let straight = turn(self.a, self.b, other.b) == 0 && turn(self.a, self.b, other.a) == 0;
        let length = |line: &Self| i64::from(line.b.x) - i64::from(line.a.x);
        straight.then(|| if length(self) >= length(other) { *self } else { *other })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_joined_only_if_they_are_one() {
        let line =
            |a: (i32, i32), b: (i32, i32)| Line::through(GridPoint::new(a.0, a.1), GridPoint::new(b.0, b.1)).unwrap();
        let long = line((300, 100), (0, 0));
        assert_eq!(line((300, 100), (600, 200)).joined(&long), Some(line((300, 100), (600, 200))));
        assert_eq!(line((300, 100), (450, 150)).joined(&long), Some(long));
        assert_eq!(line((300, 100), (600, 201)).joined(&long), None);
        assert!((long.at(150) - 50.0).abs() < 1e-9);
        assert_eq!(Line::through(GridPoint::new(1, 0), GridPoint::new(1, 5)), None);
    }

    #[test]
    fn a_line_lies_below_another_only_between_its_points() {
        let line = |a: i32, b: i32, y: i32| Line::through(GridPoint::new(a, 0), GridPoint::new(b, y)).unwrap();
        let high = Line::through(GridPoint::new(0, 100), GridPoint::new(900, 100)).unwrap();
        assert!(line(0, 600, 100).lies_below(&high, 0, 600) && line(0, 600, 100).lies_below(&high, 100, 500));
        // Beyond its points it rises above.
        assert!(!line(0, 600, 100).lies_below(&high, 0, 700) && !line(0, 600, 101).lies_below(&high, 0, 600));
    }
}
