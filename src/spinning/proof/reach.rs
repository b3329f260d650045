//! Along the whole former the roller passes where it forms the wall, but for hollows that its nose does not reach into.

use super::gap::{Former, box_distance, over};
use super::{ShellProof, ShellProofInput, shares};
use crate::diagnostic::Severity;
use crate::geometry::{Bounds, Point};
use crate::proof::{Finding, FindingKind, Move};
use crate::spinning::{law, offset};

/// Places along the former at which the finished gap is measured are this far apart at most, mm.
const STATION_MM: f64 = 0.5;

/// A nose that would be nearer to another place of the former than the wall there by more than this does not reach, mm:
/// rounding of the measurement.
const ROUNDING_MM: f64 = 1e-6;

/// A place of the former and how far it is from being formed, mm.
type Worst = Option<(f64, Point)>;

/// Looks along the former after all moves.
pub(super) fn check(input: &ShellProofInput, found: &mut ShellProof, former: &Former<'_>) {
    let (missed, spanned) = along(input, found, former);
    found.widest_mm = missed.map_or(0.0, |(off, _)| off);
    found.spanned_mm = spanned.map_or(0.0, |(off, _)| off);
    let (nose, tolerance) = (input.shell.roller.nose_radius, input.shell.gap_tolerance);
    let said = [
        missed.map(|(off, at)| {
            let message = format!(
                "The roller passes {off:.3} mm off the place where it forms the wall; the tolerance is {tolerance:.3} mm."
            );
            (Severity::Error, off, at, message)
        }),
        spanned.map(|(off, at)| {
            let message = format!(
                "A nose of {nose:.3} mm does not reach into the hollow of the former at z {:.2} mm: the shell stands off \
                 it by {off:.3} mm; the tolerance is {tolerance:.3} mm.",
                at.z - input.program_zero_z
            );
            (Severity::Warning, off, at, message)
        }),
    ];
    let program = input.programs.last().map_or_else(String::new, |p| p.name.clone());
    let block = found.moves.last().map_or(1, |m| m.block);
    let told = said.into_iter().flatten().filter(|(_, off, ..)| *off > tolerance);
    found.findings.extend(told.map(|(severity, value, at, message)| Finding {
        severity,
        kind: FindingKind::Leftover,
        program: program.clone(),
        block,
        at: Some(at),
        value,
        limit: tolerance,
        message,
    }));
}

/// The worst place that the roller could form and did not, and the worst of those that it cannot reach.
fn along(input: &ShellProofInput, found: &ShellProof, former: &Former<'_>) -> (Worst, Worst) {
    let nose = input.shell.roller.nose_radius;
    let wall_at = |angle: f64| law::wall(input.shell.forming, input.shape.thickness, angle);
    let paths: Vec<(&Move, Bounds)> = super::travelled(found).map(|(_, m)| (m, m.path.bounds())).collect();
    let (mut missed, mut spanned): (Worst, Worst) = (None, None);
    for segment in &input.shape.former.segments {
        for share in shares(segment, STATION_MM) {
            let at = segment.point_at(share);
            let angle = offset::half_angle(segment.direction_at(share));
            let centre = at + offset::outward(angle) * (nose + wall_at(angle));
            let Some(nearest) = nearest(&paths, centre) else { continue };
            let off = nearest.distance(centre);
            let small = off <= input.shell.gap_tolerance;
            if small || over(input, former, centre).is_none_or(|over| over > -ROUNDING_MM) {
                worse(&mut missed, off, at);
            } else {
                worse(&mut spanned, stands_off(&paths, at, nose, &wall_at), at);
            }
        }
    }
    (missed, spanned)
}

/// Distance of the shell's inside from a place that the roller does not reach, mm.
fn stands_off(paths: &[(&Move, Bounds)], at: Point, nose: f64, wall_at: &dyn Fn(f64) -> f64) -> f64 {
    let Some(centre) = nearest(paths, at) else { return f64::INFINITY };
    let away = centre - at;
    away.norm() - nose - wall_at(away.x.atan2(away.y))
}

fn worse(worst: &mut Worst, off: f64, at: Point) {
    if worst.is_none_or(|(most, _)| off > most) {
        *worst = Some((off, at));
    }
}

/// The point of all paths that is nearest to `p`.
fn nearest(paths: &[(&Move, Bounds)], p: Point) -> Option<Point> {
    let mut best: Option<(f64, Point)> = None;
    for (m, bounds) in paths {
        if best.is_some_and(|(least, _)| box_distance(bounds, p) >= least) {
            continue;
        }
        let at = m.path.nearest_point(p);
        let distance = at.distance(p);
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, at));
        }
    }
    best.map(|(_, at)| at)
}
