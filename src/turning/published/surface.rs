//! The outside to be made, as a radius over z; faces are jumps between neighbouring spans.

use super::span::{SAME_MM, Span};
use crate::geometry::Segment;

/// Runs shorter than this are not cut, mm: half of the control's smallest step.
const SHORTEST_RUN_MM: f64 = 0.0005;

/// Jumps lower than this are no faces, mm: half of the control's smallest step.
const LOWEST_FACE_MM: f64 = 0.0005;

/// Spans in order of z without gaps.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Surface {
    pub(super) spans: Vec<Span>,
}

/// A stretch along z, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    pub(super) z0: f64,
    pub(super) z1: f64,
}

impl Surface {
    /// The surface of connected `segments` in order of z.
    pub(super) fn new(segments: &[Segment]) -> Self {
        Self { spans: segments.iter().filter_map(Span::of).collect() }
    }

    /// The surface `by` mm further out.
    pub(super) fn raised(&self, by: f64) -> Self {
        Self { spans: self.spans.iter().map(|s| s.raised(by)).collect() }
    }

    /// The surface seen from the other end: z becomes −z.
    pub(super) fn mirrored(&self) -> Self {
        Self { spans: self.spans.iter().rev().map(Span::mirrored).collect() }
    }

    /// The part between two positions.
    pub(super) fn clipped(&self, z0: f64, z1: f64) -> Self {
        Self { spans: self.spans.iter().filter_map(|s| s.clipped(z0, z1)).collect() }
    }

    /// Largest radius, mm; 0 without spans. Exact for lines, and for arcs at their ends and tops.
    pub(super) fn largest_radius(&self) -> f64 {
        self.spans.iter().map(|s| s.segment().bounds().max.r).fold(0.0, f64::max)
    }

    /// Where the surface is not above `level`, in order of z.
    pub(super) fn runs_below(&self, level: f64) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for span in &self.spans {
            let mut z0 = span.z0;
            for z1 in span.meets(0.0, level).into_iter().chain([span.z1]) {
                if span.at(f64::midpoint(z0, z1)) <= level + SAME_MM {
                    join(&mut runs, Run { z0, z1 });
                }
                z0 = z1;
            }
        }
        runs.retain(|r| r.z1 - r.z0 >= SHORTEST_RUN_MM);
        runs
    }

    /// The surface as segments from smaller to larger z, faces included.
    pub(super) fn segments(&self) -> Vec<Segment> {
        let mut segments: Vec<Segment> = Vec::new();
        for span in &self.spans {
            let next = span.segment();
            if let Some(last) = segments.last().map(Segment::end)
                && (last.r - next.start().r).abs() >= LOWEST_FACE_MM
            {
                segments.push(Segment::line(last, next.start()));
            }
            segments.push(next);
        }
        segments
    }
}

fn join(runs: &mut Vec<Run>, run: Run) {
    match runs.last_mut() {
        Some(last) if run.z0 - last.z1 <= SAME_MM => last.z1 = run.z1,
        _ => runs.push(run),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;

    /// A shaft of radius 5 with a collar of radius 8 from z 10 to 12.
    fn collar() -> Surface {
        let at = |z: f64, r: f64| Point::new(z, r);
        let corners = [at(0.0, 5.0), at(10.0, 5.0), at(10.0, 8.0), at(12.0, 8.0), at(12.0, 5.0), at(20.0, 5.0)];
        let segments: Vec<Segment> = corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
        Surface::new(&segments)
    }

    #[test]
    fn a_collar_splits_the_run_below_it() {
        let run = |z0, z1| Run { z0, z1 };
        assert_eq!(collar().runs_below(8.0), [run(0.0, 20.0)]);
        assert_eq!(collar().runs_below(6.0), [run(0.0, 10.0), run(12.0, 20.0)]);
        assert_eq!(collar().runs_below(4.0), []);
    }

    #[test]
    fn faces_come_back_as_lines() {
        let segments = collar().segments();
        assert_eq!(segments.len(), 5, "three cylinders and three faces");
        assert!(segments.windows(2).all(|w| w[0].end().distance(w[1].start()) < 1e-12));
    }
}
