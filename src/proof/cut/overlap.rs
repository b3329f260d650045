//! What two regions share, and what the one keeps without the other.

use super::columns::{Column, Columns, Span};
use super::grid::{Ring, TOUCH};
use super::line::Line;
use super::outline::Walk;

/// Buffers of the comparison.
#[derive(Debug, Default)]
pub(super) struct Overlap {
    /// What the two regions share.
    pub shared: Columns,
    /// What the first one keeps; only with [`Overlap::subtract`].
    pub left: Columns,
    crossings: Vec<i32>,
    stack: Vec<Span>,
    common: Vec<Span>,
    found: bool,
    walk: Walk,
}

impl Overlap {
    /// The outlines of what is shared.
    pub(super) fn outlines(&mut self) -> Vec<Ring> {
        self.walk.rings(&self.shared)
    }

    /// Adds what `region` shares with `cut` to `shared`, and what it keeps to `left`; true if they share anything.
    pub(super) fn subtract(&mut self, region: &Columns, cut: &Columns) -> bool {
        self.found = false;
        self.compare(region, cut, true);
        self.found
    }

    /// Adds what `region` shares with `cut` to `shared`.
    pub(super) fn share(&mut self, region: &Columns, cut: &Columns) {
        self.compare(region, cut, false);
    }

    fn compare(&mut self, region: &Columns, cut: &Columns, keep: bool) {
        let Some((begin, end)) = cut.reach() else { return };
        let touched = region.first_beyond(begin)..region.first_from(end).max(region.first_beyond(begin));
        if keep {
            self.left.copy(region, 0, touched.start);
        }
        let mut first = region.get(touched.start).map_or(0, |column| cut.first_beyond(column.from));
        for column in region.between(touched.start, touched.end) {
            let mut from = column.from;
            while let Some(over) = cut.get(first).filter(|over| over.from < column.to) {
                if over.to > from {
                    self.keep(from, over.from, column.spans, keep);
                    from = from.max(over.from);
                    let to = over.to.min(column.to);
                    self.stretch(from, to, &column, &over, keep);
                    from = to;
                }
                if over.to > column.to {
                    break;
                }
                first += 1;
            }
            self.keep(from, column.to, column.spans, keep);
        }
        if keep {
            self.left.copy(region, touched.end, region.len());
        }
    }

    fn keep(&mut self, from: i32, to: i32, spans: &[Span], keep: bool) {
        if keep {
            self.left.push(from, to, spans);
        }
    }

    /// Compares two columns over a stretch that both cover.
    fn stretch(&mut self, from: i32, to: i32, column: &Column<'_>, over: &Column<'_>, keep: bool) {
        let apart = |s: &Span, c: &Span| {
            s.high.lies_below(&c.low, from, to)
                || c.high.lies_below(&s.low, from, to)
                || thickness(&s.low, &c.high, from, to) <= TOUCH
                || thickness(&c.low, &s.high, from, to) <= TOUCH
        };
        if column.spans.iter().all(|s| over.spans.iter().all(|c| apart(s, c))) {
            return self.keep(from, to, column.spans, keep);
        }
        let mut crossings = std::mem::take(&mut self.crossings);
        crossings.clear();
        for s in column.spans {
            for c in over.spans {
                let pairs = [(&s.low, &c.low), (&s.low, &c.high), (&s.high, &c.low), (&s.high, &c.high)];
                crossings.extend(pairs.into_iter().filter_map(|(l, m)| crossing(l, m, from, to)));
            }
        }
        crossings.sort_unstable();
        let mut begin = from;
        for &end in crossings.iter().chain([&to]) {
            if end > begin {
                self.ordered(begin, end, column.spans, over.spans, keep);
                begin = end;
            }
        }
        self.crossings = crossings;
    }

    /// Compares spans over a stretch in which no two of their borders cross.
    fn ordered(&mut self, from: i32, to: i32, spans: &[Span], over: &[Span], keep: bool) {
        self.stack.clear();
        self.common.clear();
        let higher = |l: Line, m: Line| middle(&l, from, to) > middle(&m, from, to);
        // Beside a rounded crossing of steep lines one end alone may seem thick, so the middle decides.
        let thick = |low: &Line, high: &Line| {
            thickness(low, high, from, to) > TOUCH && middle(high, from, to) > middle(low, from, to)
        };
        for span in spans {
            // What is left of the span above what was taken already.
            let mut rest = Some(*span);
            for c in over {
                let Some(s) = rest else { break };
                let low = if higher(c.low, s.low) { c.low } else { s.low };
                let high = if higher(s.high, c.high) { c.high } else { s.high };
                if !thick(&low, &high) {
                    continue;
                }
                self.common.push(Span { low, high });
                if low != s.low && thick(&s.low, &low) {
                    self.stack.push(Span { low: s.low, high: low });
                }
                rest = (high != s.high && thick(&high, &s.high)).then_some(Span { low: high, high: s.high });
            }
            self.stack.extend(rest);
        }
        self.found |= !self.common.is_empty();
        self.shared.push(from, to, &self.common);
        if keep {
            self.left.push(from, to, &self.stack);
        }
    }
}

/// Greatest height of one line above another over a stretch.
fn thickness(low: &Line, high: &Line, from: i32, to: i32) -> f64 {
    let ([l0, l1], [h0, h1]) = (low.over(from, to), high.over(from, to));
    (h0 - l0).max(h1 - l1)
}

/// Twice the mean height over a stretch.
pub(super) fn middle(line: &Line, from: i32, to: i32) -> f64 {
    let [a, b] = line.over(from, to);
    a + b
}

/// The grid position strictly inside a stretch next to the crossing of two lines; lines that only touch do not cross.
pub(super) fn crossing(l: &Line, m: &Line, from: i32, to: i32) -> Option<i32> {
    if l == m {
        return None;
    }
    let ([l0, l1], [m0, m1]) = (l.over(from, to), m.over(from, to));
    let (d0, d1) = (l0 - m0, l1 - m1);
    if d0 * d1 >= 0.0 || d0.abs().max(d1.abs()) <= TOUCH {
        return None;
    }
    let at = f64::from(from) + d0 / (d0 - d1) * (f64::from(to) - f64::from(from));
    #[allow(clippy::cast_possible_truncation, reason = "between two positions of the grid")]
    let at = at.round() as i32;
    (from < at && at < to).then_some(at)
}
