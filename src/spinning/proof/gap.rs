//! The gap between roller and former is never less than the wall of the shell.

use super::{ShellProof, ShellProofInput, finding, reach, shares, travelled};
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::proof::{Finding, FindingKind};
use crate::spinning::{law, offset};

/// Places of the roller further apart than this are not looked at, mm.
const APART_MM: f64 = 0.25;

/// The former's contour with boxes, so that a far segment is not measured.
pub(super) struct Former<'a> {
    contour: &'a Contour,
    boxes: Vec<Bounds>,
}

impl<'a> Former<'a> {
    fn new(contour: &'a Contour) -> Self {
        Self { contour, boxes: contour.segments.iter().map(Segment::bounds).collect() }
    }

    /// Nearest point of the former, its distance, and the segment that it is on.
    fn nearest(&self, p: Point) -> Option<(f64, Point, &'a Segment)> {
        let mut best: Option<(f64, Point, &Segment)> = None;
        for (segment, bounds) in self.contour.segments.iter().zip(&self.boxes) {
            if best.is_some_and(|(least, ..)| box_distance(bounds, p) >= least) {
                continue;
            }
            let nearest = segment.nearest_point(p);
            let distance = nearest.distance(p);
            if best.is_none_or(|(least, ..)| distance < least) {
                best = Some((distance, nearest, segment));
            }
        }
        best
    }
}

pub(super) fn box_distance(b: &Bounds, p: Point) -> f64 {
    let dz = (b.min.z - p.z).max(p.z - b.max.z).max(0.0);
    let dr = (b.min.r - p.r).max(p.r - b.max.r).max(0.0);
    dz.hypot(dr)
}

/// Looks at every move, and then along the former.
pub(super) fn check(input: &ShellProofInput, found: &mut ShellProof) {
    let former = Former::new(&input.shape.former);
    let (tightest, wrong) = tightest(input, found, &former);
    found.tightest_mm = tightest;
    found.findings.extend(wrong);
    reach::check(input, found, &former);
}

/// Smallest gap less the wall, and the worst place of every block where it is under the tolerance.
fn tightest(input: &ShellProofInput, found: &ShellProof, former: &Former<'_>) -> (f64, Vec<Finding>) {
    let tolerance = input.shell.gap_tolerance;
    let mut least = f64::INFINITY;
    let mut wrong = Vec::new();
    for (_, at_move) in travelled(found) {
        let mut worst: Option<(f64, f64, f64)> = None;
        for share in shares(&at_move.path, APART_MM) {
            let centre = at_move.path.point_at(share);
            let Some((distance, _, segment)) = former.nearest(centre) else { continue };
            let gap = signed(input, centre, distance) - input.shell.roller.nose_radius;
            let over = gap - wall_at(input, segment, centre);
            least = least.min(over);
            if over < -tolerance && worst.is_none_or(|(_, least, _)| over < least) {
                worst = Some((share, over, gap));
            }
        }
        if let Some((share, over, gap)) = worst {
            let message = format!(
                "The gap between roller and former is {gap:.3} mm; the wall there is {:.3} mm, the tolerance {tolerance:.3} mm.",
                gap - over
            );
            wrong.push(finding(input, at_move, share, FindingKind::Gouge, (-over, tolerance), message));
        }
    }
    (least, wrong)
}

/// The gap of a roller with its nose centre here, less the wall that belongs there, mm.
pub(super) fn over(input: &ShellProofInput, former: &Former<'_>, centre: Point) -> Option<f64> {
    let (distance, _, segment) = former.nearest(centre)?;
    Some(signed(input, centre, distance) - input.shell.roller.nose_radius - wall_at(input, segment, centre))
}

/// The distance from the former, negative inside it.
fn signed(input: &ShellProofInput, centre: Point, distance: f64) -> f64 {
    let (tip, base) = (input.shape.tip(), input.shape.base());
    let inside = centre.z <= tip.z && (centre.z < base.z && centre.r < base.r || is_under(input, centre));
    if inside { -distance } else { distance }
}

/// True if the contour passes above the point.
fn is_under(input: &ShellProofInput, p: Point) -> bool {
    input
        .shape
        .former
        .segments
        .iter()
        .filter(|s| s.end().z <= p.z && p.z <= s.start().z)
        .any(|s| crate::part::Curve::Segment(s.reversed()).radius_at(p.z) > p.r)
}

/// The wall by the angle of the former at the point nearest to the roller: at a corner that of the direction to it.
fn wall_at(input: &ShellProofInput, segment: &Segment, centre: Point) -> f64 {
    let nearest = segment.nearest_point(centre);
    let away = centre - nearest;
    let angle =
        away.try_normalize(1e-9).map_or_else(|| offset::half_angle(segment.direction_at(0.0)), |n| n.x.atan2(n.y));
    law::wall(input.shell.forming, input.shape.thickness, angle)
}
