//! A turned body on paper: its outlines, its material, its edges.

use super::hatch::hatch;
use super::page::{Ink, Page, Pen};
use super::view::{View, below, mirrored};
use crate::geometry::{Point, Segment};

/// Smallest change of direction that is seen as an edge, radians (about 1 degree).
const EDGE_RAD: f64 = 0.018;
/// Least distance of two lines, mm on paper (ISO 128-20).
const LEAST_DISTANCE_MM: f64 = 0.7;
/// Distance of hatch lines, mm on paper.
const HATCH_MM: f64 = 2.5;
/// Two places closer than this are one, mm of the part.
const SAME_MM: f64 = 0.0005;

/// A body turned about the axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Body<'a> {
    /// Where it lies.
    pub(super) view: View,
    /// Outside from the clamped to the free end, mm of the part.
    pub(super) outside: &'a [Segment],
    /// Bore in the same order; empty without one.
    pub(super) bore: &'a [Segment],
    /// How outlines and edges are drawn.
    pub(super) pen: Pen,
}

impl Body<'_> {
    /// Fills the material of both halves.
    pub(super) fn fill(&self, page: &mut Page, ink: Ink) {
        let ring = self.material();
        let lower: Vec<Segment> = ring.iter().map(mirrored).collect();
        for half in [ring, lower] {
            page.area(self.view.segments(&half), ink, None);
        }
    }

    /// Hatches the material of the lower half.
    pub(super) fn hatch_lower(&self, page: &mut Page) {
        let lower: Vec<Segment> = self.material().iter().map(mirrored).collect();
        hatch(page, &[self.view.segments(&lower)], HATCH_MM);
    }

    /// Draws the outline of both halves and the faces of both ends.
    pub(super) fn outlines(&self, page: &mut Page) {
        let (Some(first), Some(last)) = (self.outside.first(), self.outside.last()) else { return };
        let (first, last) = (first.start(), last.end());
        page.path(self.view.segments(self.outside), self.pen);
        page.path(self.mirrored_on_paper(self.outside), self.pen);
        for end in [first, last] {
            if end.r > SAME_MM {
                page.line(self.view.place(end), self.view.place(below(end)), self.pen);
            }
        }
    }

    /// Draws the bore of the lower half with its edges, seen in the cut.
    pub(super) fn bore_lower(&self, page: &mut Page) {
        if self.bore.is_empty() {
            return;
        }
        page.path(self.mirrored_on_paper(self.bore), self.pen);
        for corner in self.shown(corners(self.bore)) {
            page.line(self.view.place(below(corner)), self.view.place(Point::new(corner.z, 0.0)), self.pen);
        }
    }

    /// Draws the bore of both halves with its edges, as in a full section.
    pub(super) fn bore_in_full(&self, page: &mut Page) {
        page.path(self.view.segments(self.bore), self.pen);
        page.path(self.mirrored_on_paper(self.bore), self.pen);
        for corner in self.shown(corners(self.bore)) {
            page.line(self.view.place(corner), self.view.place(below(corner)), self.pen);
        }
    }

    /// Draws the edges of the outside, seen from the side, and those at `more`; only above the axis in a half section.
    pub(super) fn edges(&self, page: &mut Page, more: &[Point]) {
        let mut all = corners(self.outside);
        all.extend(more);
        all.sort_by(|a, b| a.z.total_cmp(&b.z));
        for corner in self.shown(all) {
            let other = if self.bore.is_empty() { below(corner) } else { Point::new(corner.z, 0.0) };
            page.line(self.view.place(corner), self.view.place(other), self.pen);
        }
    }

    fn mirrored_on_paper(&self, segments: &[Segment]) -> Vec<Segment> {
        segments.iter().map(|s| self.view.segment(&mirrored(s))).collect()
    }

    /// The corners whose edges are far enough from each other on paper.
    fn shown(&self, corners: Vec<Point>) -> Vec<Point> {
        let mut kept: Vec<Point> = Vec::new();
        for corner in corners {
            let distance = kept.last().map_or(f64::INFINITY, |last| (corner.z - last.z).abs() * self.view.scale);
            if distance >= LEAST_DISTANCE_MM {
                kept.push(corner);
            }
        }
        kept
    }

    /// The ring around the material above the axis.
    fn material(&self) -> Vec<Segment> {
        let (Some(first), Some(last)) = (self.outside.first(), self.outside.last()) else { return Vec::new() };
        let (first, last) = (first.start(), last.end());
        let mut ring = self.outside.to_vec();
        let to = |ring: &mut Vec<Segment>, p: Point| {
            let from = ring.last().map_or(first, Segment::end);
            if from.distance(p) > 0.0 {
                ring.push(Segment::line(from, p));
            }
        };
        if let (Some(start), Some(end)) = (self.bore.first(), self.bore.last()) {
            to(&mut ring, end.end());
            ring.extend(self.bore.iter().rev().map(Segment::reversed));
            if start.start().z - first.z > SAME_MM {
                to(&mut ring, Point::new(first.z, 0.0));
            }
        } else {
            to(&mut ring, Point::new(last.z, 0.0));
            to(&mut ring, Point::new(first.z, 0.0));
        }
        to(&mut ring, first);
        ring
    }
}

/// The segments of the part itself, without what is cut away behind it when it is parted off.
pub(super) fn finished(segments: &[Segment]) -> Vec<Segment> {
    segments.iter().filter(|s| s.start().z.min(s.end().z) >= -SAME_MM).copied().collect()
}

/// The places where segments turn by more than what looks smooth.
fn corners(segments: &[Segment]) -> Vec<Point> {
    let turns = |pair: &&[Segment]| {
        let angle = pair[0].direction_at(1.0).angle(&pair[1].direction_at(0.0));
        angle > EDGE_RAD && pair[1].start().r > SAME_MM
    };
    segments.windows(2).filter(turns).map(|pair| pair[1].start()).collect()
}
