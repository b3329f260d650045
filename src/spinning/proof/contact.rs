//! No contact of the roller with what it must not touch.

use super::obstacles::{Obstacle, obstacles};
use super::{ShellProof, ShellProofInput, finding, shares, travelled};
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::spinning::roller;

/// Places of the roller further apart than this are not looked at, mm.
const APART_MM: f64 = 1.0;

/// Largest clearance that is told of, mm.
const FAR_MM: f64 = 1000.0;

/// The roller's body about its nose centre.
struct Body {
    outline: Contour,
    bounds: Bounds,
    nose: f64,
}

impl Body {
    fn new(input: &ShellProofInput) -> Option<Self> {
        let corners = roller::body(&input.shell.roller);
        let nose = input.shell.roller.nose_radius;
        let bounds = Bounds::around(corners.iter().copied())?
            .including(Point::new(-nose, -nose))
            .including(Point::new(nose, nose));
        Some(Self { outline: Contour::polygon(&corners), bounds, nose })
    }
}

/// Looks at every move.
pub(super) fn check(input: &ShellProofInput, found: &mut ShellProof) {
    let Some(body) = Body::new(input) else { return };
    let obstacles: Vec<(Obstacle, Contour, Option<Bounds>)> = obstacles(input)
        .into_iter()
        .map(|o| {
            let contour = Contour::polygon(&o.outline);
            let bounds = contour.bounds();
            (o, contour, bounds)
        })
        .collect();
    let mut clearance = FAR_MM;
    let mut wrong = Vec::new();
    for (_, at_move) in travelled(found) {
        for (obstacle, contour, bounds) in &obstacles {
            let Some(bounds) = bounds else { continue };
            let mut worst: Option<(f64, f64)> = None;
            for share in shares(&at_move.path, APART_MM) {
                let centre = at_move.path.point_at(share);
                let distance = distance(&body, centre, obstacle, contour, *bounds, clearance);
                clearance = clearance.min(distance.max(0.0));
                if distance <= 0.0 && worst.is_none_or(|(_, least)| distance < least) {
                    worst = Some((share, distance));
                }
            }
            if let Some((share, _)) = worst {
                let centre = at_move.path.point_at(share);
                let message = format!(
                    "The roller touches the {} with its nose centre at z {:.2}, r {:.2} mm; they must stay apart.",
                    obstacle.name,
                    centre.z - input.program_zero_z,
                    centre.r
                );
                wrong.push(finding(input, at_move, share, obstacle.kind, (0.0, 0.0), message));
            }
        }
    }
    found.clearance_mm = clearance;
    found.findings.extend(wrong);
}

/// Distance of the roller from an obstacle, mm; 0 or less where they touch. Further than `enough` it is only known to be so.
fn distance(body: &Body, centre: Point, obstacle: &Obstacle, contour: &Contour, bounds: Bounds, enough: f64) -> f64 {
    let by = centre - Point::default();
    let own = Bounds { min: body.bounds.min + by, max: body.bounds.max + by };
    let apart = box_gap(own, bounds);
    if apart > enough {
        return apart;
    }
    let nose = if obstacle.formed_on { f64::INFINITY } else { nose_distance(body, centre, contour) };
    let relative: Vec<Point> = obstacle.outline.iter().map(|p| *p - by).collect();
    nose.min(body_distance(&body.outline, &relative))
}

fn box_gap(a: Bounds, b: Bounds) -> f64 {
    let dz = (b.min.z - a.max.z).max(a.min.z - b.max.z).max(0.0);
    let dr = (b.min.r - a.max.r).max(a.min.r - b.max.r).max(0.0);
    dz.hypot(dr)
}

fn nose_distance(body: &Body, centre: Point, contour: &Contour) -> f64 {
    use crate::geometry::Location;
    let distance = contour.distance_to(centre);
    let inside = contour.locate(centre, 0.0) == Location::Inside;
    if inside { -distance } else { distance - body.nose }
}

/// Distance of the convex body from an outline about its nose centre; negative where they overlap.
fn body_distance(body: &Contour, outline: &[Point]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    let sides = outline.iter().zip(next).map(|(a, b)| Segment::line(*a, *b));
    let mut least = f64::INFINITY;
    for side in sides {
        least = least.min(side_distance(body, &side));
        if least < 0.0 {
            return least;
        }
    }
    least
}

/// Clips the side by the convex body: what is left lies within it.
fn side_distance(body: &Contour, side: &Segment) -> f64 {
    let (a, b) = (side.start(), side.end());
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for edge in &body.segments {
        let along = edge.end() - edge.start();
        // The body's corners run counter-clockwise: inside is to the left.
        let depth = |p: Point| along.perp(&(p - edge.start()));
        let (d0, d1) = (depth(a), depth(b));
        if d0 < 0.0 && d1 < 0.0 {
            return apart(body, side);
        }
        if (d0 < 0.0) != (d1 < 0.0) {
            let cross = d0 / (d0 - d1);
            if d0 < 0.0 {
                from = from.max(cross);
            } else {
                to = to.min(cross);
            }
        }
    }
    if from < to { -1.0 } else { apart(body, side) }
}

fn apart(body: &Contour, side: &Segment) -> f64 {
    let corners = body.segments.iter().map(|e| side.distance_to(e.start()));
    let ends = body.segments.iter().map(|e| e.distance_to(side.start()).min(e.distance_to(side.end())));
    corners.chain(ends).fold(f64::INFINITY, f64::min)
}
