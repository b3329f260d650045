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
    slabs: [Vec<Slab>; 2],
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
        let near = region.first_beyond(begin)..region.first_from(end);
        let mut first = region.get(near.start).map_or(0, |column| cut.first_beyond(column.from));
        // Columns before this one are in `left`, as far as they are kept.
        let mut kept = 0;
        for (index, column) in (near.start..).zip(region.between(near.start, near.end)) {
            if let Some(next) = passed_by(&column, cut, first) {
                first = next;
                continue;
            }
            if keep {
                self.left.copy(region, kept, index);
                kept = index + 1;
            }
            first = self.compare_column(&column, cut, first, keep);
        }
        if keep {
            self.left.copy(region, kept, region.len());
        }
    }

    /// Compares a column with what lies over it, from one number on; returns the number to begin at for the next column.
    fn compare_column(&mut self, column: &Column<'_>, cut: &Columns, mut first: usize, keep: bool) -> usize {
        // Up to `from` it is compared, up to `kept` it is in `left`, as far as it is kept.
        let (mut from, mut kept) = (column.from, column.from);
        while let Some(over) = cut.get(first).filter(|over| over.from < column.to) {
            if over.to > from {
                let (begin, to) = (from.max(over.from), over.to.min(column.to));
                if !all_clear(column, &over, begin, to) {
                    self.keep(kept, begin, column.spans, keep);
                    self.stretch(begin, to, column, &over, keep);
                    kept = to;
                }
                from = to;
            }
            if over.to > column.to {
                break;
            }
            first += 1;
        }
        self.keep(kept, column.to, column.spans, keep);
        first
    }

    fn keep(&mut self, from: i32, to: i32, spans: &[Span], keep: bool) {
        if keep {
            self.left.push(from, to, spans);
        }
    }

    /// Compares two columns over a stretch that both cover and where they may meet.
    fn stretch(&mut self, from: i32, to: i32, column: &Column<'_>, over: &Column<'_>, keep: bool) {
        if let ([span], [other]) = (column.spans, over.spans) {
            return self.pair(from, to, span, other, keep);
        }
        let [mut spans, mut others] = std::mem::take(&mut self.slabs);
        Slab::fill(&mut spans, column.spans, from, to);
        Slab::fill(&mut others, over.spans, from, to);
        if spans.iter().all(|s| others.iter().all(|c| s.is_apart(c))) {
            self.keep(from, to, column.spans, keep);
        } else if self.find_crossings(&spans, &others, from, to) {
            let crossings = std::mem::take(&mut self.crossings);
            let mut begin = from;
            for &end in crossings.iter().chain([&to]) {
                if end > begin {
                    Slab::fill(&mut spans, column.spans, begin, end);
                    Slab::fill(&mut others, over.spans, begin, end);
                    self.ordered(begin, end, &spans, &others, keep);
                    begin = end;
                }
            }
            self.crossings = crossings;
        } else {
            self.ordered(from, to, &spans, &others, keep);
        }
        self.slabs = [spans, others];
    }

    /// Compares one span with one other over a stretch: what nearly all stretches are.
    fn pair(&mut self, from: i32, to: i32, span: &Span, other: &Span, keep: bool) {
        // What is cut lies mostly below what cuts, so two borders tell most of the time.
        let (high, low) = (Border::over(span.high, from, to), Border::over(other.low, from, to));
        if (Slab { low, high }).is_touch() {
            return self.keep(from, to, std::slice::from_ref(span), keep);
        }
        let s = Slab { low: Border::over(span.low, from, to), high };
        let c = Slab { low, high: Border::over(other.high, from, to) };
        if (Slab { low: s.low, high: c.high }).is_touch() {
            self.keep(from, to, std::slice::from_ref(span), keep);
        } else if self.find_crossings(&[s], &[c], from, to) {
            let crossings = std::mem::take(&mut self.crossings);
            let mut begin = from;
            for &end in crossings.iter().chain([&to]) {
                if end > begin {
                    self.ordered_pair(begin, end, Slab::of(span, begin, end), Slab::of(other, begin, end), keep);
                    begin = end;
                }
            }
            self.crossings = crossings;
        } else {
            self.ordered_pair(from, to, s, c, keep);
        }
    }

    /// As [`Self::ordered`] for one span and one other.
    fn ordered_pair(&mut self, from: i32, to: i32, s: Slab, c: Slab, keep: bool) {
        let Some(Parted { below, shared, above }) = s.parted_by(&c) else {
            return self.keep(from, to, &[s.span()], keep);
        };
        self.found = true;
        self.shared.push(from, to, &[shared.span()]);
        if keep {
            match (below, above) {
                (Some(below), Some(above)) => self.left.push(from, to, &[below.span(), above.span()]),
                (Some(one), None) | (None, Some(one)) => self.left.push(from, to, &[one.span()]),
                (None, None) => {}
            }
        }
    }

    /// Notes where borders of spans and others cross; true if any do.
    fn find_crossings(&mut self, spans: &[Slab], others: &[Slab], from: i32, to: i32) -> bool {
        self.crossings.clear();
        for s in spans {
            for c in others {
                let pairs = [(&s.low, &c.low), (&s.low, &c.high), (&s.high, &c.low), (&s.high, &c.high)];
                self.crossings.extend(pairs.into_iter().filter_map(|(l, m)| l.crossing(m, from, to)));
            }
        }
        self.crossings.sort_unstable();
        !self.crossings.is_empty()
    }

    /// Compares spans over a stretch in which no two of their borders cross.
    fn ordered(&mut self, from: i32, to: i32, spans: &[Slab], over: &[Slab], keep: bool) {
        self.stack.clear();
        self.common.clear();
        for span in spans {
            // What is left of the span above what was taken already.
            let mut rest = Some(*span);
            for c in over {
                let Some(parted) = rest.map(|s| s.parted_by(c)) else { break };
                let Some(Parted { below, shared, above }) = parted else { continue };
                self.common.push(shared.span());
                self.stack.extend(below.map(|s| s.span()));
                rest = above;
            }
            self.stack.extend(rest.map(|s| s.span()));
        }
        self.found |= !self.common.is_empty();
        self.shared.push(from, to, &self.common);
        if keep {
            self.left.push(from, to, &self.stack);
        }
    }
}

/// True if two columns surely do not meet over a stretch: a test without a division.
fn all_clear(column: &Column<'_>, over: &Column<'_>, from: i32, to: i32) -> bool {
    let clear = |s: &Span, c: &Span| s.high.lies_below(&c.low, from, to) || c.high.lies_below(&s.low, from, to);
    column.spans.iter().all(|s| over.spans.iter().all(|c| clear(s, c)))
}

/// If nothing of `cut` from a number on meets a column, as far as can be told at once: the number to begin at for the next column.
fn passed_by(column: &Column<'_>, cut: &Columns, mut first: usize) -> Option<usize> {
    while let Some(over) = cut.get(first).filter(|over| over.from < column.to) {
        let (from, to) = (over.from.max(column.from), over.to.min(column.to));
        if from < to && !all_clear(column, &over, from, to) {
            return None;
        }
        if over.to > column.to {
            break;
        }
        first += 1;
    }
    Some(first)
}

/// A border and its heights at both ends of the stretch that is looked at, so that each is computed once.
#[derive(Debug, Clone, Copy)]
pub(super) struct Border {
    /// Its carrier.
    pub line: Line,
    at: [f64; 2],
}

impl Border {
    /// The border over a stretch.
    pub(super) fn over(line: Line, from: i32, to: i32) -> Self {
        Self { line, at: line.over(from, to) }
    }

    /// True if it lies higher in the mean.
    pub(super) fn is_above(&self, other: &Self) -> bool {
        self.at[0] + self.at[1] > other.at[0] + other.at[1]
    }

    /// The grid position strictly inside the stretch next to the crossing of two borders; those that only touch do not cross.
    pub(super) fn crossing(&self, other: &Self, from: i32, to: i32) -> Option<i32> {
        let (d0, d1) = (self.at[0] - other.at[0], self.at[1] - other.at[1]);
        if d0 * d1 >= 0.0 || d0.abs().max(d1.abs()) <= TOUCH || self.line == other.line {
            return None;
        }
        let at = f64::from(from) + d0 / (d0 - d1) * (f64::from(to) - f64::from(from));
        #[allow(clippy::cast_possible_truncation, reason = "between two positions of the grid")]
        let at = at.round() as i32;
        (from < at && at < to).then_some(at)
    }
}

/// A span and the heights of its borders at both ends of the stretch that is looked at.
#[derive(Debug, Clone, Copy)]
struct Slab {
    low: Border,
    high: Border,
}

/// A slab parted by another one.
struct Parted {
    below: Option<Slab>,
    shared: Slab,
    above: Option<Slab>,
}

impl Slab {
    fn of(span: &Span, from: i32, to: i32) -> Self {
        Self { low: Border::over(span.low, from, to), high: Border::over(span.high, from, to) }
    }

    /// Puts spans over a stretch in the place of what a buffer holds.
    fn fill(buffer: &mut Vec<Self>, spans: &[Span], from: i32, to: i32) {
        buffer.clear();
        buffer.extend(spans.iter().map(|span| Self::of(span, from, to)));
    }

    /// What it shares with another one and what lies below and above that; `None` if they share nothing. No borders cross.
    fn parted_by(&self, other: &Self) -> Option<Parted> {
        let low = if other.low.is_above(&self.low) { other.low } else { self.low };
        let high = if self.high.is_above(&other.high) { other.high } else { self.high };
        let shared = Self { low, high };
        let below = Self { low: self.low, high: low };
        let above = Self { low: high, high: self.high };
        shared.is_thick().then(|| Parted {
            below: (low.line != self.low.line && below.is_thick()).then_some(below),
            shared,
            above: (high.line != self.high.line && above.is_thick()).then_some(above),
        })
    }

    fn span(&self) -> Span {
        Span { low: self.low.line, high: self.high.line }
    }

    /// True if its upper border lies nowhere higher above its lower one than a touch.
    fn is_touch(&self) -> bool {
        (self.high.at[0] - self.low.at[0]).max(self.high.at[1] - self.low.at[1]) <= TOUCH
    }

    /// True if it is more than a touch. Beside a rounded crossing of steep lines one end alone may seem thick, so the middle
    /// decides.
    fn is_thick(&self) -> bool {
        !self.is_touch() && self.high.is_above(&self.low)
    }

    /// True if two spans touch at most.
    fn is_apart(&self, other: &Self) -> bool {
        let between = |low: Border, high: Border| Self { low, high };
        between(self.low, other.high).is_touch() || between(other.low, self.high).is_touch()
    }
}

/// Twice the mean height over a stretch.
pub(super) fn middle(line: &Line, from: i32, to: i32) -> f64 {
    let [a, b] = line.over(from, to);
    a + b
}

/// As [`Border::crossing`], of two lines.
pub(super) fn crossing(l: &Line, m: &Line, from: i32, to: i32) -> Option<i32> {
    Border::over(*l, from, to).crossing(&Border::over(*m, from, to), from, to)
}
