//! From one row of the table to its exact curve, or to the reason why it has none.

use super::{Curve, Parabola, ParabolaAxis, Section, SectionKind};
use crate::geometry::{Point, Segment};

/// Two positions or radii closer than this are the same, mm. Rows carry three or four decimals; less is rounding.
pub(super) const SAME_PLACE_MM: f64 = 1e-6;

/// Figures beyond this are refused, mm: no lathe is as long, and the arithmetic keeps its last 1e-9 mm.
pub(super) const LARGEST_FIGURE_MM: f64 = 1e6;

/// How far an arc or parabola may run past its vertical tangent and still be taken to end there, mm: the table's
/// last figure.
const TABLE_FIGURE_MM: f64 = 1e-3;

/// Why a row has no curve of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ShapeFault {
    /// A figure is not a number, infinite or beyond [`LARGEST_FIGURE_MM`].
    Unusable,
    /// The second position is not beyond the first one, and the row is no wall either.
    Order,
    /// A diameter is negative.
    NegativeDiameter,
    /// The radius is zero or negative.
    ArcWithoutRadius,
    /// The chord between the ends is longer than the arc's diameter.
    ArcImpossible {
        /// Length of the chord, mm.
        chord: f64,
    },
    /// The arc runs past its vertical tangent and back under itself.
    ArcUndercut {
        /// How far it overhangs, along the spindle, mm.
        overhang: f64,
    },
    /// The curve dips below the axis.
    BelowAxis {
        /// Lowest radius, mm.
        lowest: f64,
    },
    /// Two points of a parabola have the same position (radius with the axis along z), so none passes through them.
    ParabolaWithoutPoints,
    /// The three points of a parabola lie on a line.
    ParabolaStraight,
    /// The vertex of a parabola along z lies between its ends, so that it turns back along the spindle.
    ParabolaTurnsBack {
        /// Radius of the vertex, mm.
        vertex: f64,
    },
}

impl ShapeFault {
    /// True if a straight line between the row's ends can stand in for it.
    pub(super) const fn keeps_ends(self) -> bool {
        !matches!(self, Self::Unusable | Self::Order | Self::NegativeDiameter)
    }
}

/// The two ends of a row (of a thread: of its outside cylinder), mm.
pub(super) fn ends(section: &Section) -> (Point, Point) {
    let d2 = if matches!(section.kind, SectionKind::Thread { .. }) { section.d1 } else { section.d2 };
    (Point::new(section.z1, section.d1 / 2.0), Point::new(section.z2, d2 / 2.0))
}

/// True if `value` can be calculated with.
pub(super) fn is_usable(value: f64) -> bool {
    value.is_finite() && value.abs() <= LARGEST_FIGURE_MM
}

/// The exact curve of one row of the table, lengths in mm; `None` if it has none, which [`check()`](super::check()) reports.
#[must_use]
pub fn row_curve(section_mm: &Section) -> Option<Curve> {
    curve(section_mm).ok()
}

/// Why a row in mm has no curve; `None` if it has one.
#[must_use]
pub(crate) fn row_fault(section_mm: &Section) -> Option<ShapeFault> {
    curve(section_mm).err()
}

/// True for a line square to the spindle: a wall from one diameter to another at one position.
pub(super) fn is_face_row(section: &Section) -> bool {
    section.kind == SectionKind::Line
        && (section.z2 - section.z1).abs() <= SAME_PLACE_MM
        && (section.d2 - section.d1).abs() > SAME_PLACE_MM
}

/// The exact curve of a row in mm, from its first to its second position.
pub(super) fn curve(section: &Section) -> Result<Curve, ShapeFault> {
    let (start, end) = ends(section);
    if ![section.z1, section.d1, section.z2, section.d2].into_iter().all(is_usable) {
        return Err(ShapeFault::Unusable);
    }
    let face = is_face_row(section);
    if end.z - start.z <= SAME_PLACE_MM && !face {
        return Err(ShapeFault::Order);
    }
    if section.d1 < 0.0 || section.d2 < 0.0 {
        return Err(ShapeFault::NegativeDiameter);
    }
    if face {
        return Ok(Curve::line(start, Point::new(start.z, end.r)));
    }
    let curve = match section.kind {
        SectionKind::Line | SectionKind::Thread { .. } => Curve::line(start, end),
        SectionKind::Concave { radius } => Curve::Segment(arc(start, end, radius, true)?),
        SectionKind::Convex { radius } => Curve::Segment(arc(start, end, radius, false)?),
        SectionKind::ParabolaAlongZ { z3, d3, chords } => {
            parabola(start, end, Point::new(z3, d3 / 2.0), ParabolaAxis::AlongZ, chords)?
        }
        SectionKind::ParabolaAlongX { z3, d3, chords } => {
            parabola(start, end, Point::new(z3, d3 / 2.0), ParabolaAxis::AlongX, chords)?
        }
    };
    let lowest = curve.bounds().min.r;
    if lowest < -SAME_PLACE_MM { Err(ShapeFault::BelowAxis { lowest }) } else { Ok(curve) }
}

/// The arc of at most half a turn between two points, its centre above the chord (`concave`) or below it.
fn arc(start: Point, end: Point, radius: f64, concave: bool) -> Result<Segment, ShapeFault> {
    if !is_usable(radius) {
        return Err(ShapeFault::Unusable);
    }
    if radius <= 0.0 {
        return Err(ShapeFault::ArcWithoutRadius);
    }
    let along = end - start;
    let chord = along.norm();
    if chord > 2.0 * radius + SAME_PLACE_MM {
        return Err(ShapeFault::ArcImpossible { chord });
    }
    let side = if concave { 1.0 } else { -1.0 };
    let height = (radius * radius - chord * chord / 4.0).max(0.0).sqrt() * side / chord;
    let center =
        Point::new(f64::midpoint(start.z, end.z) - along.y * height, f64::midpoint(start.r, end.r) + along.x * height);
    let past = |p: Point| (p.r - center.r) * side;
    let worst = if past(start) > past(end) { start } else { end };
    let center = match past(worst) {
        past if past <= 0.0 => center,
        past if past <= TABLE_FIGURE_MM => vertical_tangent_center(worst, if worst == start { end } else { start }),
        _ => {
            let overhang = radius - (worst.z - center.z).abs();
            return Err(ShapeFault::ArcUndercut { overhang });
        }
    };
    Ok(Segment::Arc { start, end, center, ccw: concave })
}

/// Centre of the circle through both points whose tangent at `vertical` is square to the spindle.
fn vertical_tangent_center(vertical: Point, other: Point) -> Point {
    let to_other = other - vertical;
    Point::new(vertical.z + to_other.norm_squared() / (2.0 * to_other.x), vertical.r)
}

/// The parabola through three points, from the first to the second (divided differences).
fn parabola(start: Point, end: Point, third: Point, axis: ParabolaAxis, chords: u32) -> Result<Curve, ShapeFault> {
    if !is_usable(third.z) || !is_usable(third.r) {
        return Err(ShapeFault::Unusable);
    }
    let ((u1, v1), (u2, v2), (u3, v3)) = (axis.uv(start), axis.uv(end), axis.uv(third));
    if [u2 - u1, u3 - u1, u3 - u2].iter().any(|d| d.abs() <= SAME_PLACE_MM) {
        return Err(ShapeFault::ParabolaWithoutPoints);
    }
    let a = ((v3 - v1) / (u3 - u1) - (v2 - v1) / (u2 - u1)) / (u3 - u2);
    let bulge = a * (u2 - u1).powi(2);
    if bulge.abs() <= SAME_PLACE_MM {
        return Err(ShapeFault::ParabolaStraight);
    }
    let rise = end.z - start.z;
    let a = match axis {
        ParabolaAxis::AlongZ if bulge.abs() > rise + TABLE_FIGURE_MM => {
            let share = 0.5 - 0.5 * rise / bulge;
            return Err(ShapeFault::ParabolaTurnsBack { vertex: u1 + (u2 - u1) * share });
        }
        ParabolaAxis::AlongZ => bulge.clamp(-rise, rise) / (u2 - u1).powi(2),
        ParabolaAxis::AlongX => a,
    };
    Ok(Curve::Parabola(Parabola::through(start, end, axis, a, chords)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section(d1: f64, z2: f64, d2: f64, kind: SectionKind) -> Section {
        Section { id: 1, z1: 0.0, d1, z2, d2, kind }
    }

    #[test]
    fn convex_quarter_has_its_centre_on_the_axis() {
        let Ok(Curve::Segment(Segment::Arc { center, ccw, .. })) =
            curve(&section(12.0, 6.0, 0.0, SectionKind::Convex { radius: 6.0 }))
        else {
            panic!("an arc")
        };
        assert!(center.distance(Point::new(0.0, 0.0)) < 1e-9);
        assert!(!ccw);
    }

    #[test]
    fn concave_arc_lies_below_its_chord() {
        let arc = curve(&section(10.0, 10.0, 10.0, SectionKind::Concave { radius: 10.0 })).unwrap();
        assert!((arc.radius_at(5.0) - (5.0 + 75.0_f64.sqrt() - 10.0)).abs() < 1e-12);
    }

    #[test]
    fn an_arc_a_rounding_past_vertical_is_taken_as_vertical() {
        let arc = curve(&section(11.9995, 6.0, 0.0, SectionKind::Convex { radius: 6.0 })).unwrap();
        assert!(arc.bounds().max.z <= 6.0 && arc.bounds().min.z >= 0.0);
    }

    #[test]
    fn a_line_at_one_position_is_a_wall() {
        let wall = curve(&section(20.0, 1e-9, 12.0, SectionKind::Line)).unwrap();
        assert_eq!((wall.start(), wall.end()), (Point::new(0.0, 10.0), Point::new(0.0, 6.0)));
    }

    #[test]
    fn faults_name_their_reason() {
        let of = |s: Section| curve(&s).unwrap_err();
        assert_eq!(of(section(f64::NAN, 1.0, 1.0, SectionKind::Line)), ShapeFault::Unusable);
        assert_eq!(of(section(1.0, 0.0, 1.0, SectionKind::Line)), ShapeFault::Order);
        assert_eq!(of(section(1.0, 0.0, 4.0, SectionKind::Convex { radius: 3.0 })), ShapeFault::Order);
        assert_eq!(of(section(-1.0, 1.0, 1.0, SectionKind::Line)), ShapeFault::NegativeDiameter);
        let concave = |radius| SectionKind::Concave { radius };
        assert_eq!(of(section(10.0, 10.0, 10.0, concave(4.0))), ShapeFault::ArcImpossible { chord: 10.0 });
        assert_eq!(of(section(10.0, 10.0, 10.0, concave(0.0))), ShapeFault::ArcWithoutRadius);
        assert!(matches!(of(section(2.0, 10.0, 2.0, concave(5.1))), ShapeFault::BelowAxis { .. }));
        assert!(matches!(of(section(20.0, 1.0, 2.0, concave(6.0))), ShapeFault::ArcUndercut { .. }));
        let along_z = |z3, d3| SectionKind::ParabolaAlongZ { z3, d3, chords: 10 };
        assert_eq!(of(section(10.0, 5.0, 10.0, along_z(8.0, 4.0))), ShapeFault::ParabolaWithoutPoints);
        assert_eq!(of(section(10.0, 5.0, 0.0, along_z(2.5, 5.0))), ShapeFault::ParabolaStraight);
        assert!(matches!(of(section(10.0, 2.0, 0.0, along_z(9.0, 5.0))), ShapeFault::ParabolaTurnsBack { .. }));
    }

    #[test]
    fn parabola_passes_through_its_third_point() {
        let row = section(16.0, 9.0, 10.0, SectionKind::ParabolaAlongX { z3: 3.0, d3: 17.0, chords: 10 });
        assert!((curve(&row).unwrap().radius_at(3.0) - 8.5).abs() < 1e-12);
    }

    #[test]
    fn nose_of_a_parabola_along_z_ends_square_to_the_axis() {
        let row = section(10.0, 10.0, 0.0, SectionKind::ParabolaAlongZ { z3: 0.0, d3: -10.0, chords: 10 });
        let nose = curve(&row).unwrap();
        assert!((nose.radius_at(7.5) - 2.5).abs() < 1e-9);
    }
}
