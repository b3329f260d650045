//! A chain of segments.

use super::{Bounds, Point, Segment};
use serde::{Deserialize, Serialize};

/// Segments that follow one another, open or closed.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Contour {
    /// The segments in order; each starts where the one before ends.
    pub segments: Vec<Segment>,
}

impl Contour {
    /// A contour of the given segments.
    #[must_use]
    pub const fn new(segments: Vec<Segment>) -> Self {
        Self { segments }
    }

    /// The closed polygon through `points`.
    #[must_use]
    pub fn polygon(points: &[Point]) -> Self {
        let next = points.iter().cycle().skip(1);
        Self::new(points.iter().zip(next).map(|(&a, &b)| Segment::line(a, b)).collect())
    }

    /// Largest distance between the end of a segment and the start of the next, mm.
    #[must_use]
    pub fn largest_gap(&self) -> f64 {
        self.segments.windows(2).map(|w| w[0].end().distance(w[1].start())).fold(0.0, f64::max)
    }

    /// The contour from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self::new(self.segments.iter().rev().map(Segment::reversed).collect())
    }

    /// Length along all segments, mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.segments.iter().map(Segment::length).sum()
    }

    /// The smallest rectangle around all segments; `None` without any.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        self.segments.iter().map(Segment::bounds).reduce(Bounds::union)
    }

    /// Points along the contour, start included, no chord further than `tolerance` mm from its arc.
    #[must_use]
    pub fn polyline(&self, tolerance: f64) -> Vec<Point> {
        let first = self.segments.first().map(Segment::start);
        first.into_iter().chain(self.segments.iter().flat_map(|s| s.polyline_points(tolerance))).collect()
    }
}
