//! No contact of the roller with what it must not touch.

use super::obstacles::{Obstacle, obstacles};
use super::route::{Prepared, squared_gap};
use super::{ShellProof, ShellProofInput, finding, shares, travelled};
use crate::geometry::{Bounds, Contour, Location, Point, Vector};
use crate::proof::{Finding, Move};
use crate::spinning::roller;

/// Places of the roller further apart than this are not looked at, mm.
const APART_MM: f64 = 1.0;

/// Largest clearance that is told of, mm.
const FAR_MM: f64 = 1000.0;

/// The roller's body about its nose centre.
struct Body {
    /// Corners of the convex outline, counter-clockwise.
    corners: Vec<Point>,
    /// Its edges: a direction out of the body, of unit length, and how far out the edge lies.
    edges: Vec<(Vector, f64)>,
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
        let edge = |(start, end): (Point, Point)| {
            let along = (end - start).try_normalize(0.0)?;
            let out = Vector::new(along.y, -along.x);
            Some((out, out.dot(&(start - Point::default()))))
        };
        let edges = rounds(&corners).filter_map(edge).collect();
        Some(Self { corners, edges, bounds, nose })
    }

    /// Box of the roller with its nose centre at a place.
    fn bounds_at(&self, centre: Point) -> Bounds {
        let by = centre - Point::default();
        Bounds { min: self.bounds.min + by, max: self.bounds.max + by }
    }

    /// How a side about the nose centre lies to the body.
    fn side(&self, a: Point, b: Point) -> Side {
        let (mut from, mut to, mut apart) = (0.0_f64, 1.0_f64, f64::NEG_INFINITY);
        for (out, edge) in &self.edges {
            let d0 = out.x * a.z + out.y * a.r - edge;
            let d1 = out.x * b.z + out.y * b.r - edge;
            apart = apart.max(d0.min(d1));
            // What is within the body is clipped by every edge of it.
            if (d0 > 0.0) != (d1 > 0.0) {
                let cross = d0 / (d0 - d1);
                if d0 > 0.0 {
                    from = from.max(cross);
                } else {
                    to = to.min(cross);
                }
            }
        }
        if apart > 0.0 {
            Side::Beyond(apart)
        } else if from < to {
            Side::Crosses
        } else {
            Side::Beyond(0.0)
        }
    }

    /// Square of the distance of the body from a side about the nose centre that does not cross it, mm²: it is that of a
    /// corner of either.
    fn squared_distance(&self, a: Point, b: Point) -> f64 {
        let of_corners = self.corners.iter().map(|p| squared_to_side(*p, a, b));
        let of_ends = rounds(&self.corners)
            .map(|(start, end)| squared_to_side(a, start, end).min(squared_to_side(b, start, end)));
        of_corners.chain(of_ends).fold(f64::INFINITY, f64::min)
    }
}

/// How a side lies to the body.
enum Side {
    /// A part of it lies within.
    Crosses,
    /// It lies outside, at least so far beyond an edge, mm.
    Beyond(f64),
}

/// Every corner with the next.
fn rounds(corners: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// Something that must not be touched, with what is asked of it at every place.
struct Thing {
    obstacle: Obstacle,
    contour: Contour,
    bounds: Bounds,
    /// Its sides, each with its box.
    sides: Vec<(Point, Point, Bounds)>,
}

impl Thing {
    fn new(obstacle: Obstacle) -> Option<Self> {
        let contour = Contour::polygon(&obstacle.outline);
        let bounds = contour.bounds()?;
        let next = obstacle.outline.iter().cycle().skip(1);
        let side = |(a, b): (&Point, &Point)| Some((*a, *b, Bounds::around([*a, *b])?));
        let sides = obstacle.outline.iter().zip(next).filter_map(side).collect();
        Some(Self { obstacle, contour, bounds, sides })
    }
}

/// Looks at every move.
pub(super) fn check(input: &ShellProofInput, found: &mut ShellProof) {
    let Some(body) = Body::new(input) else { return };
    let things: Vec<Thing> = obstacles(input).into_iter().filter_map(Thing::new).collect();
    let mut clearance = FAR_MM;
    let mut wrong = Vec::new();
    for (_, at_move) in travelled(found) {
        wrong.extend(touched_by(input, at_move, &body, &things, &mut clearance));
    }
    found.clearance_mm = clearance;
    found.findings.extend(wrong);
}

/// Looks along a move: the worst place of it at every thing that is touched.
fn touched_by(
    input: &ShellProofInput,
    at_move: &Move,
    body: &Body,
    things: &[Thing],
    clearance: &mut f64,
) -> Vec<Finding> {
    let path = Prepared::new(&at_move.path);
    let mut worst: Vec<Option<(f64, f64)>> = vec![None; things.len()];
    for share in shares(&at_move.path, APART_MM) {
        let centre = path.point_at(share);
        let bounds = body.bounds_at(centre);
        for (thing, worst) in things.iter().zip(&mut worst) {
            let near = squared_box_gap(&bounds, &thing.bounds) <= *clearance * *clearance;
            let Some(distance) = near.then(|| distance(body, centre, &bounds, thing, *clearance)).flatten() else {
                continue;
            };
            *clearance = clearance.min(distance.max(0.0));
            if distance <= 0.0 && worst.is_none_or(|(_, least)| distance < least) {
                *worst = Some((share, distance));
            }
        }
    }
    let touched = things.iter().zip(worst).filter_map(|(thing, worst)| Some((&thing.obstacle, worst?.0)));
    touched.map(|(obstacle, share)| told(input, at_move, obstacle, share)).collect()
}

fn told(input: &ShellProofInput, at_move: &Move, obstacle: &Obstacle, share: f64) -> Finding {
    let centre = at_move.path.point_at(share);
    let message = format!(
        "The roller touches the {} with its nose centre at z {:.2}, r {:.2} mm; they must stay apart.",
        obstacle.name,
        centre.z - input.program_zero_z,
        centre.r
    );
    finding(input, at_move, share, obstacle.kind, (0.0, 0.0), message)
}

/// Distance of the roller from a thing, mm; 0 or less where they touch; `None` if it is more than `enough`.
fn distance(body: &Body, centre: Point, bounds: &Bounds, thing: &Thing, enough: f64) -> Option<f64> {
    let of_nose = if thing.obstacle.formed_on { None } else { nose_distance(body, centre, thing, enough) };
    let of_body = body_distance(body, centre, bounds, thing, enough);
    match (of_nose, of_body) {
        (Some(nose), Some(body)) => Some(nose.min(body)),
        (one, other) => one.or(other),
    }
}

fn squared_box_gap(a: &Bounds, b: &Bounds) -> f64 {
    let dz = (b.min.z - a.max.z).max(a.min.z - b.max.z).max(0.0);
    let dr = (b.min.r - a.max.r).max(a.min.r - b.max.r).max(0.0);
    dz * dz + dr * dr
}

fn nose_distance(body: &Body, centre: Point, thing: &Thing, enough: f64) -> Option<f64> {
    let far = enough + body.nose;
    let from_box = squared_gap(&thing.bounds, centre);
    if from_box > far * far {
        return None;
    }
    let distance = thing.contour.distance_to(centre);
    let inside = from_box <= 0.0 && thing.contour.locate(centre, 0.0) == Location::Inside;
    Some(if inside { -distance } else { distance - body.nose })
}

/// Distance of the convex body from a thing; negative where they overlap.
fn body_distance(body: &Body, centre: Point, bounds: &Bounds, thing: &Thing, enough: f64) -> Option<f64> {
    let mut least = enough * enough;
    let mut found = None;
    for (a, b, around) in &thing.sides {
        if squared_box_gap(bounds, around) > least {
            continue;
        }
        let (a, b) = (Point::new(a.z - centre.z, a.r - centre.r), Point::new(b.z - centre.z, b.r - centre.r));
        match body.side(a, b) {
            Side::Crosses => return Some(-1.0),
            Side::Beyond(apart) if apart * apart > least => {}
            Side::Beyond(_) => {
                let squared = body.squared_distance(a, b);
                if squared <= least {
                    (least, found) = (squared, Some(squared));
                }
            }
        }
    }
    found.map(f64::sqrt)
}

fn squared_to_side(p: Point, a: Point, b: Point) -> f64 {
    let (z, r, pz, pr) = (b.z - a.z, b.r - a.r, p.z - a.z, p.r - a.r);
    let length = z * z + r * r;
    let share = if length > 0.0 { ((pz * z + pr * r) / length).clamp(0.0, 1.0) } else { 0.0 };
    let (dz, dr) = (pz - z * share, pr - r * share);
    dz * dz + dr * dr
}
