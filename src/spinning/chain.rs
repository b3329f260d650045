//! Moved segments in a row, joined where the contour that they follow is hollow.

use super::offset::{Cut, Offset, SAME_MM};
use crate::geometry::{Contour, Point, Segment};

/// Moved segments from tip to base.
#[derive(Debug, Default)]
pub(super) struct Chain {
    segments: Vec<Segment>,
    /// Index of the segment that each follows.
    sources: Vec<usize>,
    /// Joints of which both sides were cut: the index of the segment behind each.
    cuts: Vec<usize>,
    /// Somewhere neighbours do not meet, so that the row crosses itself.
    crosses: bool,
}

impl Chain {
    /// Adds segments that begin where the last one ends.
    pub(super) fn append(&mut self, next: Vec<Segment>, source: usize) {
        self.sources.extend(std::iter::repeat_n(source, next.len()));
        self.segments.extend(next);
    }

    /// Adds `next`, cutting both sides where they cross. Where they do not meet a straight line stands between them until the
    /// row is finished.
    pub(super) fn join(&mut self, mut next: Vec<Segment>, source: usize) {
        let ends = self.segments.last().map(Segment::end).zip(next.first().map(Segment::start));
        let Some((end, start)) = ends.filter(|(end, start)| end.distance(*start) > SAME_MM) else {
            self.append(next, source);
            return;
        };
        if let Some((i, j, at)) = crossing(&self.segments, &next).or_else(|| prolonged_crossing(&self.segments, &next))
        {
            self.cut_behind(i, at);
            next.drain(..j);
            if let Some(first) = next.first_mut() {
                *first = with_ends(first, at, first.end());
            }
        } else {
            self.crosses = true;
            self.append(vec![Segment::line(end, start)], source);
        }
        self.append(next, source);
    }

    /// Ends the row with segment `i`, at `at`.
    fn cut_behind(&mut self, i: usize, at: Point) {
        self.segments.truncate(i + 1);
        self.sources.truncate(i + 1);
        if let Some(cut) = self.segments.last_mut() {
            *cut = with_ends(cut, cut.start(), at);
        }
        self.cuts.retain(|cut| *cut <= i);
        self.cuts.push(i + 1);
    }

    /// The row as a contour; loops where it crosses itself are left out.
    pub(super) fn finished(mut self) -> Offset {
        if self.crosses {
            self = self.without_loops();
        }
        let at_cut = |&index: &usize| {
            let before = index.checked_sub(1).and_then(|i| self.sources.get(i))?;
            let (at, behind) = (self.segments.get(index)?.start(), self.sources.get(index)?);
            Some(Cut { at, before: *before, behind: *behind })
        };
        let cuts = self.cuts.iter().filter_map(at_cut).collect();
        Offset { contour: Contour::new(self.segments), cuts }
    }

    /// From every segment on to the last one that crosses it.
    fn without_loops(self) -> Self {
        let mut kept = Self::default();
        let mut rest: Vec<(Segment, usize, bool)> = (0..)
            .zip(self.segments.iter().zip(&self.sources))
            .map(|(index, (segment, source))| (*segment, *source, self.cuts.contains(&index)))
            .collect();
        rest.reverse();
        while let Some((segment, source, was_cut)) = rest.pop() {
            if was_cut {
                kept.cuts.push(kept.segments.len());
            }
            // The last of the rest stands first; the very next one only touches.
            let far = rest.get(..rest.len().saturating_sub(1)).unwrap_or_default();
            let found = far.iter().enumerate().find_map(|(k, (other, ..))| Some((k, first_meeting(&segment, other)?)));
            let end = found.map_or(segment.end(), |(_, at)| at);
            kept.append(vec![with_ends(&segment, segment.start(), end)], source);
            if let Some((k, at)) = found {
                rest.truncate(k + 1);
                if let Some((other, _, cut)) = rest.last_mut() {
                    *other = with_ends(other, at, other.end());
                    *cut = true;
                }
            }
        }
        kept
    }
}

/// The last crossing of the first chain with the second.
fn crossing(first: &[Segment], second: &[Segment]) -> Option<(usize, usize, Point)> {
    first
        .iter()
        .enumerate()
        .rev()
        .find_map(|(i, a)| second.iter().enumerate().find_map(|(j, b)| Some((i, j, first_meeting(a, b)?))))
}

fn first_meeting(a: &Segment, b: &Segment) -> Option<Point> {
    a.intersection(b, SAME_MM).points().first().copied()
}

/// Where the neighbours at a hollow corner meet if one of them goes on: the wall changes there, so that one is further out
/// than the other and its cut lies before it begins. Both must keep their direction.
fn prolonged_crossing(first: &[Segment], second: &[Segment]) -> Option<(usize, usize, Point)> {
    let (a, b) = (first.last()?, second.first()?);
    let at = a.prolonged_meeting(b, a.end())?;
    let keeps = (at - a.start()).dot(&a.direction_at(0.0)) > 0.0 && (b.end() - at).dot(&b.direction_at(1.0)) > 0.0;
    keeps.then_some((first.len() - 1, 0, at))
}

/// The same segment between other points of it.
pub(super) const fn with_ends(segment: &Segment, start: Point, end: Point) -> Segment {
    match *segment {
        Segment::Line { .. } => Segment::Line { start, end },
        Segment::Arc { center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}
