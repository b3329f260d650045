//! The gap between roller and former is never less than the wall of the shell.

use super::route::{Prepared, Route, squared_gap};
use super::{ShellProof, ShellProofInput, finding, reach, shares, travelled};
use crate::geometry::{Bounds, Point, Segment, Vector};
use crate::proof::{Finding, FindingKind, Motion, Move};
use crate::spinning::{law, offset};

/// Places of the roller further apart than this are not looked at, mm.
const APART_MM: f64 = 0.25;

/// The former's contour.
pub(super) struct Former {
    route: Route,
    /// Everything of the former lies in it, whatever is behind and below it, too.
    body: Bounds,
}

/// A place of the former seen from the nose's centre.
struct Seen<'a> {
    distance: f64,
    away: Vector,
    segment: &'a Segment,
}

impl Former {
    fn new(input: &ShellProofInput) -> Self {
        let contour = &input.shape.former;
        let most = contour.bounds().map_or(0.0, |b| b.max.r);
        let max = Point::new(input.shape.tip().z, most);
        let body = Bounds { min: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY), max };
        Self { route: Route::new(contour.segments.iter()), body }
    }

    fn seen_from(&self, centre: Point, hint: &mut usize) -> Option<Seen<'_>> {
        let nearest = self.route.nearest(centre, hint)?;
        let segment = self.route.segment(nearest.piece)?;
        Some(Seen { distance: nearest.distance, away: centre - nearest.at, segment })
    }
}

/// Looks at every move, and then along the former.
pub(super) fn check(input: &ShellProofInput, found: &mut ShellProof) {
    let former = Former::new(input);
    let (tightest, wrong) = tightest(input, found, &former);
    found.tightest_mm = tightest;
    found.findings.extend(wrong);
    reach::check(input, found, &former);
}

/// Smallest gap less the wall, and the worst place of every block where it is under the tolerance.
///
/// Feeds come first: beside the tightest place of theirs most of the way of a rapid is far enough away not to be measured.
fn tightest(input: &ShellProofInput, found: &ShellProof, former: &Former) -> (f64, Vec<Finding>) {
    let mut least = f64::INFINITY;
    let mut wrong: Vec<(usize, Finding)> = Vec::new();
    let feeds = travelled(found).filter(|(_, m)| m.motion == Motion::Feed);
    let others = travelled(found).filter(|(_, m)| m.motion != Motion::Feed);
    for (index, at_move) in feeds.chain(others) {
        let said = tightest_of_move(input, at_move, former, &mut least);
        wrong.extend(said.map(|finding| (index, finding)));
    }
    wrong.sort_by_key(|(index, _)| *index);
    (least, wrong.into_iter().map(|(_, finding)| finding).collect())
}

/// Looks along a move; the worst place of it, where it is under the tolerance.
fn tightest_of_move(input: &ShellProofInput, at_move: &Move, former: &Former, least: &mut f64) -> Option<Finding> {
    let tolerance = input.shell.gap_tolerance;
    // No wall is thicker than the blank.
    let thickest = input.shell.roller.nose_radius + input.shape.thickness;
    let path = Prepared::new(&at_move.path);
    let mut worst: Option<(f64, f64, f64)> = None;
    let mut hint = 0;
    for share in shares(&at_move.path, APART_MM) {
        let centre = path.point_at(share);
        let far = thickest + least.max(0.0);
        if squared_gap(&former.body, centre) > far * far {
            continue;
        }
        let Some((over, gap)) = measured(input, former, centre, &mut hint) else { continue };
        *least = least.min(over);
        if over < -tolerance && worst.is_none_or(|(_, least, _)| over < least) {
            worst = Some((share, over, gap));
        }
    }
    worst.map(|(share, over, gap)| {
        let message = format!(
            "The gap between roller and former is {gap:.3} mm; the wall there is {:.3} mm, the tolerance {tolerance:.3} mm.",
            gap - over
        );
        finding(input, at_move, share, FindingKind::Gouge, (-over, tolerance), message)
    })
}

/// The gap of a roller with its nose centre here, less the wall that belongs there, and the gap, mm.
fn measured(input: &ShellProofInput, former: &Former, centre: Point, hint: &mut usize) -> Option<(f64, f64)> {
    let seen = former.seen_from(centre, hint)?;
    let gap = signed(input, centre, seen.distance) - input.shell.roller.nose_radius;
    Some((gap - wall_at(input, &seen), gap))
}

/// The gap of a roller with its nose centre here, less the wall that belongs there, mm.
pub(super) fn over(input: &ShellProofInput, former: &Former, centre: Point) -> Option<f64> {
    measured(input, former, centre, &mut 0).map(|(over, _)| over)
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
fn wall_at(input: &ShellProofInput, seen: &Seen<'_>) -> f64 {
    let angle = seen
        .away
        .try_normalize(1e-9)
        .map_or_else(|| offset::half_angle(seen.segment.direction_at(0.0)), |n| n.x.atan2(n.y));
    law::wall(input.shell.forming, input.shape.thickness, angle)
}
