//! Entities of a drawing to lines and arcs of the plane.

use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Point, Segment};
use crate::storage::export::BORE;
use ::dxf::Drawing;
use ::dxf::entities::{Arc, Circle, Entity, EntityType, Line, LwPolyline};
use std::f64::consts::PI;

/// Largest coordinate that is taken, in the document's unit; no lathe is that long.
const MOST: f64 = 100_000.0;

/// The lines and arcs of all entities in model space, multiplied by `scale`: those of the outside, and those on the layer
/// of the bore. What cannot be used is a diagnostic.
pub(super) fn segments(
    drawing: &Drawing,
    scale: f64,
    at: &Place,
    diagnostics: &mut Vec<Diagnostic>,
) -> [Vec<Segment>; 2] {
    let [mut outside, mut bore] = [Vec::new(), Vec::new()];
    for entity in drawing.entities().filter(|e| !e.common.is_in_paper_space) {
        match of_entity(entity, scale) {
            Ok(segments) if entity.common.layer.eq_ignore_ascii_case(BORE) => bore.extend(segments),
            Ok(segments) => outside.extend(segments),
            Err(problem) => {
                let message = format!("{} {problem}; it is left out.", described(entity));
                diagnostics.push(Diagnostic::warning("dxf-entity", at.clone(), message));
            }
        }
    }
    [outside, bore]
}

fn of_entity(entity: &Entity, scale: f64) -> Result<Vec<Segment>, String> {
    let segments = match &entity.specific {
        EntityType::Line(line) => of_line(line),
        EntityType::Arc(arc) => in_plane(&arc.normal).map(|turn| turned(turn, of_arc(arc)))?,
        EntityType::Circle(circle) => in_plane(&circle.normal).map(|turn| turned(turn, of_circle(circle)))?,
        EntityType::LwPolyline(line) => {
            in_plane(&line.extrusion_direction).map(|turn| turned(turn, of_polyline(line)))?
        }
        _ => return Err("is neither line, arc, circle nor light-weight polyline".to_owned()),
    };
    let segments: Vec<Segment> = segments.iter().map(|s| scaled(s, scale)).collect();
    match segments.iter().flat_map(coordinates).find(|value| value.is_nan() || value.abs() > MOST) {
        Some(value) => Err(format!("has the coordinate {value}, which is not a number up to {MOST}")),
        None => Ok(segments),
    }
}

/// Every coordinate that a segment is made of.
fn coordinates(segment: &Segment) -> Vec<f64> {
    let center = match segment {
        Segment::Line { .. } => None,
        Segment::Arc { center, .. } => Some(*center),
    };
    [Some(segment.start()), Some(segment.end()), center].into_iter().flatten().flat_map(|p| [p.z, p.r]).collect()
}

/// True if the plane is seen from behind; an error if it is not the xy plane at all.
fn in_plane(normal: &::dxf::Vector) -> Result<bool, String> {
    /// Sine of the largest tilt of a plane that still counts as the xy plane.
    const TILT: f64 = 1e-9;
    if normal.x.abs() > TILT || normal.y.abs() > TILT || normal.z == 0.0 {
        let message =
            format!("lies in the plane across ({}, {}, {}), not in the xy plane", normal.x, normal.y, normal.z);
        return Err(message);
    }
    Ok(normal.z < 0.0)
}

fn turned(turn: bool, segments: Vec<Segment>) -> Vec<Segment> {
    if turn { segments.iter().map(|s| s.mirrored_at_z(0.0)).collect() } else { segments }
}

fn of_line(line: &Line) -> Vec<Segment> {
    vec![Segment::line(Point::new(line.p1.x, line.p1.y), Point::new(line.p2.x, line.p2.y))]
}

fn of_arc(arc: &Arc) -> Vec<Segment> {
    let center = Point::new(arc.center.x, arc.center.y);
    let from = arc.start_angle.to_radians();
    let sweep = (arc.end_angle - arc.start_angle).rem_euclid(360.0).to_radians();
    if sweep == 0.0 { circle(center, arc.radius) } else { vec![arc_of(center, arc.radius, from, from + sweep)] }
}

fn of_circle(entity: &Circle) -> Vec<Segment> {
    circle(Point::new(entity.center.x, entity.center.y), entity.radius)
}

fn circle(center: Point, radius: f64) -> Vec<Segment> {
    vec![arc_of(center, radius, 0.0, PI), arc_of(center, radius, PI, 2.0 * PI)]
}

fn arc_of(center: Point, radius: f64, from: f64, to: f64) -> Segment {
    let at = |angle: f64| Point::new(center.z + radius * angle.cos(), center.r + radius * angle.sin());
    Segment::Arc { start: at(from), end: at(to), center, ccw: true }
}

fn of_polyline(polyline: &LwPolyline) -> Vec<Segment> {
    let points: Vec<(Point, f64)> = polyline.vertices.iter().map(|v| (Point::new(v.x, v.y), v.bulge)).collect();
    let closing = if polyline.is_closed() { points.first() } else { None };
    let ends = points.iter().skip(1).chain(closing);
    points.iter().zip(ends).map(|(&(start, bulge), &(end, _))| of_bulge(start, end, bulge)).collect()
}

/// The arc between two vertices of a polyline: its bulge is the tangent of a quarter of the angle that it sweeps, positive
/// counter-clockwise. The centre lies on the left of the chord at `chord/2 · (1 − bulge²) / (2·bulge)` from its middle.
fn of_bulge(start: Point, end: Point, bulge: f64) -> Segment {
    if bulge == 0.0 {
        return Segment::line(start, end);
    }
    let chord = end - start;
    let aside = (1.0 - bulge * bulge) / (4.0 * bulge);
    let center =
        Point::new(f64::midpoint(start.z, end.z) - chord.y * aside, f64::midpoint(start.r, end.r) + chord.x * aside);
    Segment::Arc { start, end, center, ccw: bulge > 0.0 }
}

fn scaled(segment: &Segment, scale: f64) -> Segment {
    let scaled = |p: Point| Point::new(p.z * scale, p.r * scale);
    match *segment {
        Segment::Line { start, end } => Segment::Line { start: scaled(start), end: scaled(end) },
        Segment::Arc { start, end, center, ccw } => {
            Segment::Arc { start: scaled(start), end: scaled(end), center: scaled(center), ccw }
        }
    }
}

/// Kind and values of an entity for messages.
fn described(entity: &Entity) -> String {
    let layer = &entity.common.layer;
    match &entity.specific {
        EntityType::Line(l) => {
            format!("The line from ({}, {}) to ({}, {}) on layer {layer}", l.p1.x, l.p1.y, l.p2.x, l.p2.y)
        }
        EntityType::Arc(a) => {
            format!("The arc about ({}, {}) with radius {} on layer {layer}", a.center.x, a.center.y, a.radius)
        }
        EntityType::Circle(c) => {
            format!("The circle about ({}, {}) with radius {} on layer {layer}", c.center.x, c.center.y, c.radius)
        }
        EntityType::LwPolyline(p) => format!("The polyline with {} vertices on layer {layer}", p.vertices.len()),
        other => {
            let name = format!("{other:?}");
            let kind: String = name.chars().take_while(char::is_ascii_alphanumeric).collect();
            format!("An entity of kind {kind} on layer {layer}")
        }
    }
}
