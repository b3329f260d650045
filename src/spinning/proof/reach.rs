//! Along the whole former the roller passes where it forms the wall, but for hollows that its nose does not reach into.

use super::gap::{Former, over};
use super::route::Route;
use super::{ShellProof, ShellProofInput, shares};
use crate::diagnostic::Severity;
use crate::document::Forming;
use crate::geometry::{Point, Segment, Vector};
use crate::proof::{Finding, FindingKind};
use crate::spinning::{law, offset};

/// Places along the former at which the finished gap is measured are this far apart at most, mm.
const STATION_MM: f64 = 0.5;

/// A nose that would be nearer to another place of the former than the wall there by more than this does not reach, mm:
/// rounding of the measurement.
const ROUNDING_MM: f64 = 1e-6;

/// Sides that turn outwards by less than this make no hollow corner, radians.
const HOLLOW_RAD: f64 = 1e-6;

/// A place of the former and how far it is from being formed, mm.
type Worst = Option<(f64, Point)>;

/// Looks along the former after all moves.
pub(super) fn check(input: &ShellProofInput, found: &mut ShellProof, former: &Former) {
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
fn along(input: &ShellProofInput, found: &ShellProof, former: &Former) -> (Worst, Worst) {
    let nose = input.shell.roller.nose_radius;
    let wall_at = |angle: f64| law::wall(input.shell.forming, input.shape.thickness, angle);
    let paths = Route::new(super::travelled(found).map(|(_, m)| &m.path));
    let mut hint = 0;
    let (mut missed, mut spanned): (Worst, Worst) = (None, None);
    for segment in &input.shape.former.segments {
        for share in shares(segment, STATION_MM) {
            let at = segment.point_at(share);
            let angle = offset::half_angle(segment.direction_at(share));
            let centre = at + offset::outward(angle) * (nose + wall_at(angle));
            let Some(off) = paths.nearest(centre, &mut hint).map(|nearest| nearest.distance) else { continue };
            let small = off <= input.shell.gap_tolerance;
            if small || reaches(input, former, centre) {
                worse(&mut missed, off, at);
            } else {
                worse(&mut spanned, stands_off(input, &paths, at), at);
            }
        }
    }
    (missed, spanned)
}

/// True if the nose keeps the wall of every side of the former here: at the nearest place, and wherever it is straight above
/// one.
fn reaches(input: &ShellProofInput, former: &Former, centre: Point) -> bool {
    let nose = input.shell.roller.nose_radius;
    let keeps = |segment: &Segment| {
        let foot = segment.nearest_point(centre);
        let at_an_end = foot.distance(segment.start()).min(foot.distance(segment.end())) < ROUNDING_MM;
        let away = centre - foot;
        let wall = law::wall(input.shell.forming, input.shape.thickness, away.x.atan2(away.y));
        at_an_end || away.norm() - nose - wall > -ROUNDING_MM
    };
    let segments = &input.shape.former.segments;
    over(input, former, centre).is_none_or(|over| over > -ROUNDING_MM)
        && segments.iter().all(keeps)
        && segments.windows(2).all(|pair| clears_corner(input, pair, centre))
}

/// True if the nose keeps the walls of both sides of a hollow corner, prolonged beyond it: where they differ, the nose meets
/// the thicker one before it stands above it.
fn clears_corner(input: &ShellProofInput, pair: &[Segment], centre: Point) -> bool {
    let [a, b] = pair else { return true };
    let (before, behind) = (offset::half_angle(a.direction_at(1.0)), offset::half_angle(b.direction_at(0.0)));
    let clears = |side: &Segment, angle: f64| {
        let ends_here = side.nearest_point(centre).distance(a.end()) < ROUNDING_MM;
        let wall = law::wall(input.shell.forming, input.shape.thickness, angle);
        let height = (centre - a.end()).dot(&offset::outward(angle));
        !ends_here || height - input.shell.roller.nose_radius - wall > -ROUNDING_MM
    };
    behind - before < HOLLOW_RAD || (clears(a, before) && clears(b, behind))
}

/// Distance of the shell's inside from a place that the roller does not reach, mm: the nose's own surface, in flow-turning
/// shifted along the axis by the blank's thickness, in spinning a wall further in.
fn stands_off(input: &ShellProofInput, paths: &Route, at: Point) -> f64 {
    let (nose, thickness) = (input.shell.roller.nose_radius, input.shape.thickness);
    let (outside, wall) = match input.shell.forming {
        Forming::Shear => (at + Vector::new(thickness, 0.0), 0.0),
        Forming::Spinning => (at, thickness),
    };
    paths.nearest(outside, &mut 0).map_or(f64::INFINITY, |nearest| nearest.distance - nose - wall)
}

fn worse(worst: &mut Worst, off: f64, at: Point) {
    if worst.is_none_or(|(most, _)| off > most) {
        *worst = Some((off, at));
    }
}
