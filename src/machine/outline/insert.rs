//! Outlines of inserts and blades in tool space, right-hand and outside; counter-clockwise, the nose first.

use super::{ToolKind, ToolOutline};
use crate::geometry::{Contour, Point, Segment, Vector};
use crate::machine::iso::InsertForm;
use std::f64::consts::{FRAC_PI_2, PI};

/// Length of a thread's point along its flanks, mm; behind it the insert keeps the triangle's angle.
const THREAD_POINT_MM: f64 = 2.0;
/// Angle by which the sides of a blade's insert lean inwards, degrees, so that only its front cuts.
const BLADE_RELIEF_DEG: f64 = 2.0;
/// Depth of the insert of a narrow blade, mm.
const LEAST_BLADE_INSERT_MM: f64 = 2.0;

/// An insert as a polygon about its sharp tip, which is the origin.
pub(super) struct Polygon {
    /// Corners, counter-clockwise, the tip first.
    pub(super) corners: Vec<Point>,
    /// Radius of the rounded corners, known once the insert is placed.
    pub(super) nose_radius: f64,
    /// Corners that are rounded like the tip.
    pub(super) rounded: Vec<bool>,
    /// Index of the corner at the far end of the trailing side, where the holder may come out under the insert.
    pub(super) trailing_end: usize,
    /// The same on the leading side.
    pub(super) leading_end: usize,
}

/// The polygon of a form with its tip at the origin and its bisector at `bisector` radians from z; a disc has none.
pub(super) fn polygon(form: InsertForm, bisector: f64) -> Option<Polygon> {
    Some(match form {
        InsertForm::Rhombus { corner_deg, inscribed } => {
            let corner = corner_deg.to_radians();
            let mut rhombus = rhombus(corner, inscribed / corner.sin(), bisector);
            rhombus.rounded = vec![true; 4];
            rhombus
        }
        InsertForm::Triangle { inscribed } => {
            let mut triangle = triangle(PI / 3.0, inscribed * 3.0_f64.sqrt(), bisector);
            triangle.rounded = vec![true; 3];
            triangle
        }
        InsertForm::Trigon { inscribed } => trigon(inscribed, bisector),
        InsertForm::ThreadPoint { point_deg, inscribed } => {
            thread_point(point_deg.to_radians(), inscribed * 3.0_f64.sqrt(), bisector)
        }
        InsertForm::Round { .. } => return None,
    })
}

/// Four equal edges about a corner; only the tip is rounded.
pub(super) fn rhombus(corner: f64, edge: f64, bisector: f64) -> Polygon {
    let (trailing, leading) = (direction(bisector - corner / 2.0) * edge, direction(bisector + corner / 2.0) * edge);
    let tip = Point::default();
    Polygon {
        corners: vec![tip, tip + trailing, tip + trailing + leading, tip + leading],
        nose_radius: 0.0,
        rounded: vec![true, false, false, false],
        trailing_end: 1,
        leading_end: 3,
    }
}

/// Two equal edges about a corner and a third between their ends; only the tip is rounded.
pub(super) fn triangle(corner: f64, edge: f64, bisector: f64) -> Polygon {
    let (trailing, leading) = (direction(bisector - corner / 2.0) * edge, direction(bisector + corner / 2.0) * edge);
    let tip = Point::default();
    Polygon {
        corners: vec![tip, tip + trailing, tip + leading],
        nose_radius: 0.0,
        rounded: vec![true, false, false],
        trailing_end: 1,
        leading_end: 2,
    }
}

/// All six edges touch the inscribed circle: the 80° corners lie at d/2 / sin 40° from its centre, the 160° ones at
/// d/2 / sin 80°.
fn trigon(inscribed: f64, bisector: f64) -> Polygon {
    let (sharp, blunt) = (inscribed / 2.0 / 40_f64.to_radians().sin(), inscribed / 2.0 / 80_f64.to_radians().sin());
    let center = Point::default() + direction(bisector) * sharp;
    let corner = |k: u32| {
        let out = if k.is_multiple_of(2) { sharp } else { blunt };
        center + direction(bisector + PI + f64::from(k) * PI / 3.0) * out
    };
    let mut corners: Vec<Point> = (0..6).map(corner).collect();
    // The tip is the origin but for a rounding of the sum.
    if let Some(tip) = corners.first_mut() {
        *tip = Point::default();
    }
    Polygon { corners, nose_radius: 0.0, rounded: [true, false].repeat(3), trailing_end: 2, leading_end: 4 }
}

fn thread_point(point: f64, edge: f64, bisector: f64) -> Polygon {
    let body = PI / 3.0;
    if (point - body).abs() < 1e-9 {
        return triangle(body, edge, bisector);
    }
    let flank = |side: f64| Point::default() + direction(bisector + side * point / 2.0) * THREAD_POINT_MM;
    let end = |side: f64| flank(side) + direction(bisector + side * body / 2.0) * (edge - THREAD_POINT_MM);
    Polygon {
        corners: vec![Point::default(), flank(-1.0), end(-1.0), end(1.0), flank(1.0)],
        nose_radius: 0.0,
        rounded: vec![true, false, false, false, false],
        trailing_end: 2,
        leading_end: 3,
    }
}

impl Polygon {
    fn moved(mut self, by: Vector) -> Self {
        self.corners.iter_mut().for_each(|corner| *corner = *corner + by);
        self
    }
}

/// The outline of a pointed insert, and its polygon, moved so that the nose touches the axes of tool space as its
/// orientation says: 3 (left below) or 8 (below).
pub(super) fn pointed(polygon: Polygon, nose_radius: f64, orientation: u8, kind: ToolKind) -> (ToolOutline, Polygon) {
    let nose_z = if orientation == 8 { 0.0 } else { nose_radius };
    let nose_center = Point::new(nose_z, nose_radius);
    let at = |i: usize| polygon.corners.get(i).copied().unwrap_or_default();
    let center = fillet_center(at(polygon.corners.len().saturating_sub(1)), at(0), at(1), nose_radius);
    let polygon = Polygon { nose_radius, ..polygon.moved(nose_center - center) };
    let segments = rounded(&polygon.corners, &polygon.rounded, nose_radius);
    let count = segments.len();
    let nose = usize::from(nose_radius > 0.0);
    let cutting = (0..count).map(|i| i <= nose || i + 1 == count).collect();
    let insert = Contour::new(segments);
    let outline =
        ToolOutline { insert, kind, nose_radius, nose_center, orientation, cutting, ..ToolOutline::default() };
    (outline, polygon)
}

/// A disc that cuts with its lower half.
pub(super) fn round(diameter: f64, orientation: u8) -> ToolOutline {
    let radius = diameter / 2.0;
    let center = Point::new(if orientation == 8 { 0.0 } else { radius }, radius);
    let side = |sign: f64| center + Vector::new(sign * radius, 0.0);
    let half = |from: f64| Segment::Arc { start: side(from), end: side(-from), center, ccw: true };
    ToolOutline {
        insert: Contour::new(vec![half(-1.0), half(1.0)]),
        kind: ToolKind::Turning,
        nose_radius: radius,
        nose_center: center,
        orientation,
        cutting: vec![true, false],
        ..ToolOutline::default()
    }
}

/// A blade from the origin to `width` and `depth` whose front edge cuts; its sides lean inwards by `relief_deg`.
pub(super) fn blade(width: f64, nose_radius: f64, depth: f64, relief_deg: f64) -> ToolOutline {
    let lean = (depth * relief_deg.to_radians().tan()).min(width / 4.0);
    let side = Point::new(lean, depth);
    // The sharp corners stand out a little, so that the noses touch the sides of the cut.
    let out = if nose_radius > 0.0 {
        fillet_center(side, Point::default(), Point::new(width, 0.0), nose_radius).z - nose_radius
    } else {
        0.0
    };
    let corners = [(-out, 0.0), (width + out, 0.0), (width + out - lean, depth), (lean - out, depth)];
    let corners = corners.map(|(z, r)| Point::new(z, r));
    let segments = rounded(&corners, &[true, true, false, false], nose_radius);
    let count = segments.len();
    let front = if nose_radius > 0.0 { 3 } else { 1 };
    let nose_center = match segments.first() {
        Some(&Segment::Arc { center, .. }) => center,
        _ => Point::default(),
    };
    ToolOutline {
        insert: Contour::new(segments),
        kind: ToolKind::Grooving,
        nose_radius,
        nose_center,
        orientation: 3,
        cutting: (0..count).map(|i| i < front).collect(),
        ..ToolOutline::default()
    }
}

/// The insert of a blade with a holder of its own: as deep as it is wide and at least [`LEAST_BLADE_INSERT_MM`].
pub(super) fn blade_insert(width: f64, nose_radius: f64, depth: f64) -> ToolOutline {
    blade(width, nose_radius, width.max(LEAST_BLADE_INSERT_MM).min(depth), BLADE_RELIEF_DEG)
}

/// A drill whose tip is the origin and whose body lies along z.
pub(super) fn drill(diameter: f64, point_angle: f64, length: f64) -> ToolOutline {
    let radius = diameter / 2.0;
    let shoulder = radius / (point_angle.to_radians() / 2.0).tan();
    let corners = [(0.0, 0.0), (shoulder, -radius), (length, -radius), (length, radius), (shoulder, radius)];
    let insert = Contour::polygon(&corners.map(|(z, r)| Point::new(z, r)));
    let cutting = vec![true, false, false, false, true];
    ToolOutline { insert, kind: ToolKind::Drill, orientation: 5, cutting, ..ToolOutline::default() }
}

/// The closed polygon, counter-clockwise, with the chosen corners rounded; the first corner's arc comes first.
pub(super) fn rounded(corners: &[Point], chosen: &[bool], radius: f64) -> Vec<Segment> {
    let count = corners.len();
    let at = |i: usize| corners.get(i % count.max(1)).copied().unwrap_or_default();
    let mut segments = Vec::new();
    let mut ends: Vec<(Point, Point)> = Vec::new();
    for i in 0..count {
        let (before, corner, after) = (at(i + count - 1), at(i), at(i + 1));
        if radius > 0.0 && chosen.get(i).copied().unwrap_or(false) {
            let center = fillet_center(before, corner, after, radius);
            let (start, end) = (foot(center, before, corner), foot(center, corner, after));
            ends.push((start, end));
        } else {
            ends.push((corner, corner));
        }
    }
    for (i, &(start, end)) in ends.iter().enumerate() {
        if start != end {
            let center = fillet_center(at(i + count - 1), at(i), at(i + 1), radius);
            segments.push(Segment::Arc { start, end, center, ccw: true });
        }
        let next = ends.get((i + 1) % count).map_or(end, |next| next.0);
        segments.push(Segment::line(end, next));
    }
    segments
}

/// Centre of the arc that rounds a convex corner: `radius / sin(half the corner)` from it on the bisector.
fn fillet_center(before: Point, corner: Point, after: Point, radius: f64) -> Point {
    let (back, forth) = (unit(before - corner), unit(after - corner));
    let half = back.dot(&forth).clamp(-1.0, 1.0).acos() / 2.0;
    corner + unit(back + forth) * (radius / half.sin())
}

/// The point of the line through `a` and `b` nearest to `p`.
fn foot(p: Point, a: Point, b: Point) -> Point {
    let along = unit(b - a);
    a + along * (p - a).dot(&along)
}

pub(super) fn unit(v: Vector) -> Vector {
    v.try_normalize(0.0).unwrap_or_default()
}

pub(super) fn direction(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// Bisector of an insert whose leading edge stands at the approach angle to the direction of feed, −z.
pub(super) fn bisector(approach_deg: f64, corner_deg: f64) -> f64 {
    (180.0 - approach_deg - corner_deg / 2.0).to_radians()
}

/// Bisector of an insert that points straight at the work.
pub(super) const STRAIGHT: f64 = FRAC_PI_2;
