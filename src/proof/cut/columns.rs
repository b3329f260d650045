//! A region as columns: stretches of z in which it is a stack of spans, each between two lines.
//!
//! Within a column nothing crosses, so what two regions share is found by comparing heights; no topology is ever walked while
//! cutting. The region may have holes, undercuts and any number of pieces.

use super::grid::{GridPoint, Window};
use super::line::Line;

/// Material between two lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Span {
    /// Its lower border.
    pub low: Line,
    /// Its upper border.
    pub high: Line,
}

impl Span {
    /// Both spans as one if they have the same borders.
    fn joined(&self, other: &Self) -> Option<Self> {
        Some(Self { low: self.low.joined(&other.low)?, high: self.high.joined(&other.high)? })
    }
}

/// One stretch of z.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Head {
    from: i32,
    to: i32,
    /// Index behind its last span.
    end: usize,
}

/// One column: a stretch of z with its spans from the lowest to the highest, at least one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Column<'a> {
    /// Where it begins.
    pub from: i32,
    /// Where it ends.
    pub to: i32,
    /// Its spans.
    pub spans: &'a [Span],
}

/// Columns in order of z; where there is none there is no material.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Columns {
    heads: Vec<Head>,
    spans: Vec<Span>,
}

impl Columns {
    /// No columns, with room for some of one span each.
    pub(super) fn with_capacity(count: usize) -> Self {
        Self { heads: Vec::with_capacity(count), spans: Vec::with_capacity(count) }
    }

    /// Number of columns.
    pub(super) fn len(&self) -> usize {
        self.heads.len()
    }

    /// Forgets all columns and keeps the room.
    pub(super) fn clear(&mut self) {
        self.heads.clear();
        self.spans.clear();
    }

    /// The column with a number.
    pub(super) fn get(&self, index: usize) -> Option<Column<'_>> {
        let head = self.heads.get(index)?;
        let begin = index.checked_sub(1).map_or(0, |before| self.heads[before].end);
        Some(Column { from: head.from, to: head.to, spans: &self.spans[begin..head.end] })
    }

    /// All columns in order.
    pub(super) fn iter(&self) -> impl Iterator<Item = Column<'_>> {
        self.between(0, self.len())
    }

    /// The columns from one number to before another.
    pub(super) fn between(&self, first: usize, end: usize) -> impl Iterator<Item = Column<'_>> {
        let mut begin = first.checked_sub(1).and_then(|before| self.heads.get(before)).map_or(0, |head| head.end);
        self.heads.get(first..end.min(self.len())).unwrap_or(&[]).iter().map(move |head| {
            let spans = &self.spans[begin..head.end];
            begin = head.end;
            Column { from: head.from, to: head.to, spans }
        })
    }

    /// Where the material begins and ends; `None` without any.
    pub(super) fn reach(&self) -> Option<(i32, i32)> {
        Some((self.heads.first()?.from, self.heads.last()?.to))
    }

    /// True if material lies in a rectangle, as far as columns tell: a span whose borders are slanted is taken as high as it is
    /// anywhere within the rectangle's width.
    pub(super) fn reach_into(&self, window: &Window) -> bool {
        let columns = self.between(self.first_beyond(window.min.x), self.first_from(window.max.x + 1));
        let (low, high) = (f64::from(window.min.y), f64::from(window.max.y));
        columns.into_iter().any(|column| {
            let (from, to) = (column.from.max(window.min.x), column.to.min(window.max.x));
            let meets = |span: &Span| {
                let ([l0, l1], [h0, h1]) = (span.low.over(from, to), span.high.over(from, to));
                l0.min(l1) <= high && h0.max(h1) >= low
            };
            column.spans.iter().any(meets)
        })
    }

    /// Number of the first column that reaches beyond a position.
    pub(super) fn first_beyond(&self, x: i32) -> usize {
        self.heads.partition_point(|head| head.to <= x)
    }

    /// Number of the first column that begins at a position or behind it.
    pub(super) fn first_from(&self, x: i32) -> usize {
        self.heads.partition_point(|head| head.from < x)
    }

    /// Adds columns of another region, from one number to before another, behind the last column.
    pub(super) fn copy(&mut self, other: &Self, first: usize, end: usize) {
        let Some(column) = other.get(first).filter(|_| first < end) else { return };
        self.push(column.from, column.to, column.spans);
        let begin = other.heads[first].end;
        let (rest, offset) = (&other.heads[first + 1..end], self.spans.len());
        let Some(last) = rest.last() else { return };
        self.spans.extend_from_slice(&other.spans[begin..last.end]);
        self.heads.extend(rest.iter().map(|head| Head { end: head.end - begin + offset, ..*head }));
    }

    /// Adds material behind the last column; a column that only continues it is joined to it.
    pub(super) fn push(&mut self, from: i32, to: i32, spans: &[Span]) {
        if from >= to || spans.is_empty() {
            return;
        }
        if !self.continued(from, to, spans) {
            self.spans.extend_from_slice(spans);
            self.heads.push(Head { from, to, end: self.spans.len() });
        }
    }

    /// Adds all columns of another region that lies behind this one.
    pub(super) fn append(&mut self, other: &Self) {
        self.copy(other, 0, other.len());
    }

    /// Lengthens the last column if the spans are its own.
    fn continued(&mut self, from: i32, to: i32, spans: &[Span]) -> bool {
        let begin = self.heads.len().checked_sub(2).map_or(0, |before| self.heads[before].end);
        let Some(last) = self.heads.last_mut().filter(|last| last.to == from) else { return false };
        let own = &mut self.spans[begin..];
        if let ([own], [span]) = (&mut *own, spans) {
            let Some(joined) = own.joined(span) else { return false };
            *own = joined;
        } else {
            if own.len() != spans.len() || own.iter().zip(spans).any(|(a, b)| a.joined(b).is_none()) {
                return false;
            }
            for (own, span) in own.iter_mut().zip(spans) {
                *own = own.joined(span).unwrap_or(*own);
            }
        }
        last.to = to;
        true
    }

    /// Area, mm².
    #[cfg(test)]
    pub(super) fn area_mm2(&self) -> f64 {
        let span = |column: &Column<'_>, span: &Span| {
            let (low, high) = (span.low.over(column.from, column.to), span.high.over(column.from, column.to));
            let width = f64::from(column.to) - f64::from(column.from);
            f64::midpoint((high[0] - low[0]).max(0.0), (high[1] - low[1]).max(0.0)) * width
        };
        let doubled: f64 = self.iter().map(|c| c.spans.iter().map(|s| span(&c, s)).sum::<f64>()).sum();
        doubled / super::grid::UNITS_PER_MM.powi(2)
    }

    /// The rectangle around the material; `None` without any.
    #[allow(clippy::cast_possible_truncation, reason = "heights lie on the grid")]
    pub(super) fn window(&self) -> Option<Window> {
        let (first, last) = (self.heads.first()?, self.heads.last()?);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for column in self.iter() {
            for span in column.spans {
                let (a, b) = (span.low.over(column.from, column.to), span.high.over(column.from, column.to));
                low = low.min(a[0]).min(a[1]);
                high = high.max(b[0]).max(b[1]);
            }
        }
        let min = GridPoint::new(first.from, low.floor() as i32);
        Some(Window { min, max: GridPoint::new(last.to, high.ceil() as i32) })
    }
}
