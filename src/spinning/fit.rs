//! Lines and arcs in place of a smooth curve.

use crate::geometry::{Point, Segment, Vector, biarc};

/// A curve is halved no further than this many times.
const DEEPEST: u32 = 14;

/// Points at which each pair of arcs is compared with its curve.
const CHECKS: u32 = 8;

/// Share of the tolerance that may show at those points, so that it holds between them, too.
const SAFETY: f64 = 0.9;

/// Point and direction of travel of unit length at a parameter.
pub(super) type Curve<'a> = &'a dyn Fn(f64) -> (Point, Vector);

/// Tangent arcs from parameter `from` to `to`, none further than `tolerance` mm from the curve.
pub(super) fn arcs(curve: Curve<'_>, from: f64, to: f64, tolerance: f64) -> Vec<Segment> {
    let mut out = Vec::new();
    halve(curve, from, to, tolerance, DEEPEST, &mut out);
    out
}

fn halve(curve: Curve<'_>, from: f64, to: f64, tolerance: f64, depth: u32, out: &mut Vec<Segment>) {
    let ((start, a), (end, b)) = (curve(from), curve(to));
    let pair = biarc(start, a, end, b);
    if depth == 0 || deviation(curve, from, to, &pair) <= SAFETY * tolerance {
        out.extend(pair.into_iter().filter(|s| s.length() > 0.0));
        return;
    }
    let middle = f64::midpoint(from, to);
    halve(curve, from, middle, tolerance, depth - 1, out);
    halve(curve, middle, to, tolerance, depth - 1, out);
}

/// Largest distance of the checked points of the curve from the pair of arcs, mm; infinite where the pair is none.
fn deviation(curve: Curve<'_>, from: f64, to: f64, pair: &[Segment; 2]) -> f64 {
    let whole = pair.iter().all(|s| s.start().is_finite() && s.end().is_finite());
    let worst = (1..CHECKS)
        .map(|k| curve(from + (to - from) * f64::from(k) / f64::from(CHECKS)).0)
        .map(|p| pair.iter().map(|segment| segment.distance_to(p)).fold(f64::INFINITY, f64::min))
        .fold(0.0, f64::max);
    if whole { worst } else { f64::INFINITY }
}
