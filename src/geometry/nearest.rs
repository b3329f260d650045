//! The point of a segment or contour nearest to a point.

use super::{Contour, Point, Segment};

impl Segment {
    /// The point of the segment nearest to `p`. From the centre of an arc every point is as near; its start is returned.
    #[must_use]
    pub fn nearest_point(&self, p: Point) -> Point {
        match *self {
            Self::Line { start, end } => {
                let along = end - start;
                let length_squared = along.norm_squared();
                if length_squared <= 0.0 {
                    return start;
                }
                self.point_at((p - start).dot(&along) / length_squared)
            }
            Self::Arc { start, end, center, .. } => {
                let Some(outward) = (p - center).try_normalize(0.0) else { return start };
                let on_circle = center + outward * start.distance(center);
                if self.faces(on_circle) {
                    on_circle
                } else if p.distance(start) <= p.distance(end) {
                    start
                } else {
                    end
                }
            }
        }
    }

    /// Distance from `p` to the segment, mm.
    #[must_use]
    pub fn distance_to(&self, p: Point) -> f64 {
        self.nearest_point(p).distance(p)
    }
}

impl Contour {
    /// The point of the contour nearest to `p` and the index of its segment; `None` without segments.
    #[must_use]
    pub fn nearest_point(&self, p: Point) -> Option<(usize, Point)> {
        self.segments
            .iter()
            .map(|segment| segment.nearest_point(p))
            .enumerate()
            .min_by(|(_, a), (_, b)| a.distance(p).total_cmp(&b.distance(p)))
    }

    /// Distance from `p` to the contour, mm; infinite without segments.
    #[must_use]
    pub fn distance_to(&self, p: Point) -> f64 {
        self.nearest_point(p).map_or(f64::INFINITY, |(_, nearest)| nearest.distance(p))
    }
}
