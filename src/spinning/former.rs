//! The former's contour as lines and arcs, from its tip towards the chuck.
//!
//! Part space with z = 0 at the chuck's face: the cylinder behind the contour lies from 0 to the base length, the tip is the
//! point of the contour furthest from the chuck.

use super::fit;
use crate::document::TurnedPart;
use crate::document::{Former, FormerShape};
use crate::geometry::{Contour, Point, Segment, Vector};
use crate::machine::Machine;
use crate::part::{self, Section, SectionKind};
use crate::spinning::limits::LARGEST_FIGURE;

/// Distance that lines and arcs may keep from a parabola or ellipse, mm.
pub const CONTOUR_TOLERANCE_MM: f64 = 0.0005;

/// The contour from tip to base, lengths in mm; `None` where the figures describe none, which the rules report.
#[must_use]
pub fn contour(former: &Former) -> Option<Contour> {
    let usable = |value: f64| value.is_finite() && value.abs() <= LARGEST_FIGURE;
    if !usable(former.base_length) || !former.shape.figures().iter().all(|(_, value)| usable(*value)) {
        return None;
    }
    let segments = match former.shape {
        FormerShape::Cone { half_angle_deg, tip_diameter, length } => {
            cone(half_angle_deg.to_radians(), tip_diameter / 2.0, length)?
        }
        FormerShape::Parabola { constant, tip_diameter, length } => parabola(constant, tip_diameter / 2.0, length)?,
        FormerShape::Dish { focal_length, tip_diameter, rim_diameter } => {
            dish(focal_length, tip_diameter / 2.0, rim_diameter / 2.0)?
        }
        FormerShape::Ellipse { semi_axis, diameter, tip_diameter, length } => {
            ellipse(semi_axis, diameter / 2.0, tip_diameter / 2.0, length)?
        }
        FormerShape::Sections { ref sections } => of_sections(sections)?,
    };
    // So far the tip is at 0 and z falls; now the base comes to its place.
    let base = segments.last()?.end().z;
    let to_base = Vector::new(former.base_length - base, 0.0);
    let moved: Vec<Segment> = segments.iter().map(|s| s.translated(to_base)).collect();
    moved.iter().all(|s| s.start().is_finite() && s.end().is_finite()).then(|| Contour::new(moved))
}

fn cone(half_angle: f64, tip: f64, length: f64) -> Option<Vec<Segment>> {
    let possible = half_angle > 0.0 && half_angle < std::f64::consts::FRAC_PI_2 && tip > 0.0 && length > 0.0;
    let base = tip + length * half_angle.tan();
    (possible && base <= LARGEST_FIGURE).then(|| vec![Segment::line(Point::new(0.0, tip), Point::new(-length, base))])
}

/// Travel x from the tip, rise x²/c: direction (−1, 2x/c).
fn parabola(constant: f64, tip: f64, length: f64) -> Option<Vec<Segment>> {
    let curve = |x: f64| (Point::new(-x, tip + x * x / constant), Vector::new(-1.0, 2.0 * x / constant).normalize());
    let possible = constant > 0.0 && tip > 0.0 && length > 0.0 && length * length / constant <= LARGEST_FIGURE;
    possible.then(|| fit::arcs(&curve, 0.0, length, CONTOUR_TOLERANCE_MM))
}

/// Depth r²/(4f) from the vertex: direction (−r/(2f), 1) by r.
fn dish(focus: f64, tip: f64, rim: f64) -> Option<Vec<Segment>> {
    let depth = |r: f64| r * r / (4.0 * focus);
    let curve = |r: f64| (Point::new(depth(tip) - depth(r), r), Vector::new(-r / (2.0 * focus), 1.0).normalize());
    let possible = focus > 0.0 && tip > 0.0 && rim > tip && depth(rim) <= LARGEST_FIGURE;
    possible.then(|| fit::arcs(&curve, tip, rim, CONTOUR_TOLERANCE_MM))
}

/// By the angle θ from the pole: z = a cos θ, r = b sin θ.
fn ellipse(along: f64, across: f64, tip: f64, length: f64) -> Option<Vec<Segment>> {
    if !(along > 0.0 && across > 0.0 && tip > 0.0 && tip < across && length > 0.0) {
        return None;
    }
    let from = (tip / across).asin();
    let start = along * from.cos();
    let end = start - length;
    if end < 0.0 {
        return None;
    }
    let to = (end / along).acos();
    if (along - across).abs() <= CONTOUR_TOLERANCE_MM / 10.0 {
        let center = Point::new(-start, 0.0);
        let at = |angle: f64| center + Vector::new(angle.cos(), angle.sin()) * across;
        return Some(vec![Segment::Arc { start: at(from), end: at(to), center, ccw: true }]);
    }
    let curve = |t: f64| {
        let direction = Vector::new(-along * t.sin(), across * t.cos()).normalize();
        (Point::new(along * t.cos() - start, across * t.sin()), direction)
    };
    Some(fit::arcs(&curve, from, to, CONTOUR_TOLERANCE_MM))
}

/// The table's profile from its free end back to its clamped end.
fn of_sections(sections: &[Section]) -> Option<Vec<Segment>> {
    /// Rows that end and begin further apart leave a step, mm.
    const STEP_MM: f64 = 1e-6;
    // A thread would be turned into the former; nothing can be formed over it.
    if sections.iter().any(|s| matches!(s.kind, SectionKind::Thread { .. })) {
        return None;
    }
    let profile = part::Profile {
        pieces: sections
            .iter()
            .map(|section| {
                let curve = part::row_curve(section)?;
                Some(part::Piece { curve, section: section.id, role: part::PieceRole::Surface })
            })
            .collect::<Option<_>>()?,
    };
    let contour = part::contour(&profile, CONTOUR_TOLERANCE_MM).contour;
    if contour.segments.is_empty() || contour.largest_gap() > STEP_MM {
        return None;
    }
    let tip = contour.segments.last()?.end();
    Some(contour.reversed().segments.iter().map(|s| s.translated(Vector::new(-tip.z, 0.0))).collect())
}

/// The former as a part to be turned from bar, in mm, from the clamped end: base cylinder, contour, flat tip.
#[must_use]
pub fn as_turned_part(former: &Former, machine: &Machine, material: &str) -> Option<TurnedPart> {
    /// Bar beyond the largest diameter, mm.
    const BAR_ALLOWANCE_MM: f64 = 2.0;
    /// Deviation that the proof allows on a former, mm.
    const FORM_TOLERANCE_MM: f64 = 0.05;
    let contour = contour(former)?;
    let bounds = contour.bounds()?;
    let base_diameter = 2.0 * contour.segments.last()?.end().r;
    let mut sections = Vec::new();
    if former.base_length > 0.0 {
        sections.push(Section::line(1, 0.0, base_diameter, former.base_length, base_diameter));
    }
    for segment in contour.reversed().segments {
        sections.push(row(u32::try_from(sections.len() + 1).ok()?, &segment));
    }
    Some(TurnedPart {
        machine: machine.id.clone(),
        material: material.to_owned(),
        bar_diameter: (2.0 * bounds.max.r + BAR_ALLOWANCE_MM).ceil(),
        length: bounds.max.z,
        generator: crate::document::Generator::Planned { separate_programs: false },
        form_tolerance: FORM_TOLERANCE_MM,
        sections,
        ..TurnedPart::default()
    })
}

fn row(id: u32, segment: &Segment) -> Section {
    let (a, b) = (segment.start(), segment.end());
    let kind = match segment {
        Segment::Line { .. } => SectionKind::Line,
        Segment::Arc { ccw: true, .. } => SectionKind::Concave { radius: segment.radius().unwrap_or_default() },
        Segment::Arc { ccw: false, .. } => SectionKind::Convex { radius: segment.radius().unwrap_or_default() },
    };
    Section { kind, ..Section::line(id, a.z, 2.0 * a.r, b.z, 2.0 * b.r) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    fn former(shape: FormerShape) -> Former {
        Former { shape, base_length: 20.0 }
    }

    fn shapes() -> Vec<FormerShape> {
        vec![
            FormerShape::Cone { half_angle_deg: 30.0, tip_diameter: 40.0, length: 50.0 },
            FormerShape::Parabola { constant: 273.8, tip_diameter: 40.0, length: 70.0 },
            FormerShape::Dish { focal_length: 60.0, tip_diameter: 30.0, rim_diameter: 180.0 },
            FormerShape::Ellipse { semi_axis: 50.0, diameter: 100.0, tip_diameter: 30.0, length: 30.0 },
            FormerShape::Ellipse { semi_axis: 30.0, diameter: 100.0, tip_diameter: 30.0, length: 15.0 },
        ]
    }

    #[test]
    fn contours_run_from_tip_to_base() {
        for shape in shapes() {
            let contour = contour(&former(shape.clone())).unwrap();
            let (first, last) = (contour.segments[0].start(), contour.segments.last().unwrap().end());
            assert!((last.z - 20.0).abs() < 1e-9 && first.z > last.z && last.r > first.r, "{shape:?}");
            assert!(contour.largest_gap() < 1e-9, "{shape:?}");
        }
    }

    #[test]
    fn curves_follow_their_equations() {
        let parabola = contour(&former(shapes()[1].clone())).unwrap();
        let dish = contour(&former(shapes()[2].clone())).unwrap();
        let ellipse = contour(&former(shapes()[4].clone())).unwrap();
        let vertex = dish.segments[0].start().z + 15.0 * 15.0 / 240.0;
        let start = 30.0 * (1.0 - 0.09_f64).sqrt();
        let pole = ellipse.segments[0].start().z - start;
        for k in 0..=100 {
            let share = f64::from(k) / 100.0;
            let x = 70.0 * share;
            assert!(parabola.distance_to(Point::new(90.0 - x, 20.0 + x * x / 273.8)) < CONTOUR_TOLERANCE_MM);
            let r = 15.0 + 75.0 * share;
            assert!(dish.distance_to(Point::new(vertex - r * r / 240.0, r)) < CONTOUR_TOLERANCE_MM);
            let z = start - 15.0 * share;
            let r = 50.0 * (1.0 - (z / 30.0).powi(2)).sqrt();
            assert!(ellipse.distance_to(Point::new(pole + z, r)) < CONTOUR_TOLERANCE_MM);
        }
    }

    #[test]
    fn a_table_of_sections_gives_the_contour_of_its_part() {
        let rows = vec![Section::line(1, 0.0, 100.0, 30.0, 40.0)];
        let contour = contour(&former(FormerShape::Sections { sections: rows })).unwrap();
        assert_eq!(contour.segments, [Segment::line(Point::new(50.0, 20.0), Point::new(20.0, 50.0))]);
        let apart = vec![Section::line(1, 0.0, 100.0, 30.0, 60.0), Section::line(2, 30.0, 40.0, 40.0, 20.0)];
        assert_eq!(super::contour(&former(FormerShape::Sections { sections: apart })), None);
    }

    #[test]
    fn impossible_figures_give_none() {
        for shape in [
            FormerShape::Cone { half_angle_deg: f64::NAN, tip_diameter: 40.0, length: 50.0 },
            FormerShape::Cone { half_angle_deg: 90.0, tip_diameter: 40.0, length: 50.0 },
            FormerShape::Cone { half_angle_deg: 30.0, tip_diameter: 0.0, length: 50.0 },
            FormerShape::Parabola { constant: -1.0, tip_diameter: 40.0, length: 70.0 },
            FormerShape::Dish { focal_length: 60.0, tip_diameter: 30.0, rim_diameter: 20.0 },
            FormerShape::Ellipse { semi_axis: 50.0, diameter: 100.0, tip_diameter: 30.0, length: 60.0 },
            FormerShape::Sections { sections: Vec::new() },
        ] {
            assert_eq!(contour(&former(shape.clone())), None, "{shape:?}");
        }
    }

    #[test]
    fn a_former_becomes_a_part_without_mistakes() {
        let catalog = Catalog::shipped();
        let machine = catalog.machine("linuxcnc").unwrap();
        for shape in shapes() {
            let part = as_turned_part(&former(shape.clone()), machine, "C45").unwrap();
            let said = part::check(&part, crate::units::Unit::Mm, machine);
            assert!(!crate::diagnostic::has_errors(&said), "{shape:?}: {said:?}");
            assert!(part.sections.len() >= 2);
        }
    }
}
