//! A cross-section from a DXF drawing: its mid-line, or its closed outline, from which the thickness is recognised.
//!
//! x runs across the strip, y upwards. Lines and arcs become elements from left to right; a section that is its own mirror
//! image becomes a symmetrical one, from the middle of its middle line outwards.

use super::{checked, section};
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::document::{Content, CrossSection, DevelopedWidth, Document, Element, ElementKind, FORMAT_VERSION, Origin};
use crate::geometry::{Contour, Point, Segment};
use crate::storage::import::{dxf, dxf_segments, name_of};
use crate::textfile::file_place;
use crate::units::Unit;
use std::path::Path;

/// Lengths and radii that differ by less are alike, mm.
const ALIKE_MM: f64 = 0.005;
/// Directions that differ by less are one, radians.
const ALIKE_RAD: f64 = 0.002;

/// How thick the strip of a mid-line is. An outline has its own thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MidLineThickness {
    /// Not known: a mid-line is refused.
    Unknown,
    /// As said by who draws, in the unit of the drawing.
    OfDrawing(f64),
    /// To begin with this one, mm; that it is no more than taken is said.
    TakenMm(f64),
}

/// Reads a cross-section; `file` is its name for messages. A mid-line needs its `thickness`.
///
/// # Errors
/// Diagnostics with the values if the file cannot be read, or its lines and arcs are neither a mid-line nor an outline.
pub fn roll_section_dxf(
    file: &str,
    bytes: &[u8],
    thickness: MidLineThickness,
) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let at = file_place(Path::new(file));
    let drawing = dxf::load(file, bytes).map_err(|d| vec![d])?;
    let mut diagnostics = Vec::new();
    let (unit, scale) = dxf::unit_of(&drawing, &at, &mut diagnostics).map_err(|d| vec![d])?;
    let [segments, _] = dxf_segments::segments(&drawing, scale * unit.in_mm(), &at, &mut diagnostics);
    let chain = chain(&segments, &at).map_err(|d| vec![d])?;
    let found = if chain.closed {
        of_outline(&chain.segments, &at)
    } else {
        let thickness = match thickness {
            MidLineThickness::Unknown => None,
            MidLineThickness::OfDrawing(thickness) => Some(thickness * unit.in_mm()),
            MidLineThickness::TakenMm(thickness) => {
                diagnostics.push(taken(thickness / unit.in_mm(), unit, &at));
                Some(thickness)
            }
        };
        let thickness = thickness.filter(|t| *t > 0.0);
        thickness.ok_or_else(|| no_thickness(&at)).and_then(|t| of_line(&chain.segments, t, t / 2.0, &at))
    };
    let section = found.map_err(|d| vec![d])?;
    let set = section::set(section).scaled(1.0 / unit.in_mm());
    let name = name_of(Path::new(file));
    let document = Document { turnwright: FORMAT_VERSION, name, unit, content: Content::RollSet(set) };
    checked(file, (document, diagnostics))
}

/// Segments that follow one another.
struct Chain {
    segments: Vec<Segment>,
    closed: bool,
}

/// All segments as one chain, beginning at its left end.
fn chain(segments: &[Segment], at: &Place) -> Result<Chain, Diagnostic> {
    let mut left: Vec<Segment> = segments.iter().filter(|s| s.length() > dxf::JOIN_MM).copied().collect();
    let meets = |p: Point, q: Point| p.distance(q) <= 2.0 * dxf::JOIN_MM;
    let is_free =
        |p: Point, all: &[Segment]| all.iter().flat_map(|s| [s.start(), s.end()]).filter(|q| meets(p, *q)).count() == 1;
    let ends: Vec<Point> = left.iter().flat_map(|s| [s.start(), s.end()]).filter(|p| is_free(*p, &left)).collect();
    let first = ends.iter().min_by(|a, b| a.z.total_cmp(&b.z)).copied();
    let Some(begin) = first.or_else(|| left.first().map(Segment::start)) else {
        return Err(unusable(at, "The drawing has 0 lines and arcs; a section needs at least 1."));
    };
    let (mut tip, mut ordered) = (begin, Vec::with_capacity(left.len()));
    while let Some(index) = left.iter().position(|s| meets(s.start(), tip) || meets(s.end(), tip)) {
        let next = left.swap_remove(index);
        let next = if meets(next.start(), tip) { next } else { next.reversed() };
        tip = next.end();
        ordered.push(next);
    }
    if !left.is_empty() {
        let message = format!(
            "{} of {} lines and arcs are not connected with the others; a section is one chain.",
            left.len(),
            left.len() + ordered.len()
        );
        return Err(unusable(at, &message));
    }
    Ok(Chain { closed: ordered.len() > 1 && meets(tip, begin), segments: ordered })
}

/// The section between the two ends of a closed outline.
fn of_outline(ring: &[Segment], at: &Place) -> Result<CrossSection, Diagnostic> {
    let ring = if area(ring) < 0.0 { Contour::new(ring.to_vec()).reversed().segments } else { ring.to_vec() };
    let ends = ends(&ring).ok_or_else(|| {
        let message = "The outline has no two straight ends of one length, square to the faces beside them.";
        unusable(at, message).with_hint("Draw the outline with its two ends, or the mid-line with --thickness.")
    })?;
    let thickness = ring.get(ends[0]).map_or(0.0, Segment::length);
    let between = |from: usize, to: usize| -> Vec<Segment> {
        ring.iter().cycle().skip(from + 1).take((to + ring.len() - from) % ring.len() - 1).copied().collect()
    };
    // Both run with the material on their left; the bottom face is the one that runs to the right.
    let faces = [between(ends[0], ends[1]), between(ends[1], ends[0])];
    let run = |face: &[Segment]| face.first().zip(face.last()).map_or(0.0, |(a, b)| b.end().z - a.start().z);
    let [one, other] = faces;
    let bottom = if run(&one) >= run(&other) { one } else { other };
    of_line(&bottom, thickness, 0.0, at)
}

/// Twice the area that a ring runs around counter-clockwise, by its chords.
fn area(ring: &[Segment]) -> f64 {
    let points: Vec<Point> = Contour::new(ring.to_vec()).polyline(ALIKE_MM);
    points.windows(2).map(|w| w[0].z * w[1].r - w[1].z * w[0].r).sum()
}

/// The two ends of an outline: the shortest pair of lines of one length that are square to their neighbours, turning the
/// same way at both.
fn ends(ring: &[Segment]) -> Option<[usize; 2]> {
    let count = ring.len();
    let square = |a: &Segment, b: &Segment| {
        let (from, to) = (a.direction_at(1.0), b.direction_at(0.0));
        from.dot(&to).abs() < ALIKE_RAD && from.perp(&to) > 0.0
    };
    let is_end = |index: &usize| {
        let around = (ring.get((index + count - 1) % count), ring.get(*index), ring.get((index + 1) % count));
        let (Some(before), Some(end), Some(after)) = around else { return false };
        end.radius().is_none() && square(before, end) && square(end, after)
    };
    let mut found: Vec<(usize, f64)> =
        (0..count).filter(is_end).filter_map(|i| Some((i, ring.get(i)?.length()))).collect();
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    let pair = found.windows(2).find(|w| (w[0].1 - w[1].1).abs() < ALIKE_MM)?;
    let (a, b) = (pair.first()?.0, pair.last()?.0);
    Some([a.min(b), a.max(b)])
}

/// The section of a line that runs to the right, `above` mm above its bottom face.
fn of_line(line: &[Segment], thickness: f64, above: f64, at: &Place) -> Result<CrossSection, Diagnostic> {
    let mut kinds: Vec<ElementKind> = Vec::new();
    let mut heading: Option<f64> = None;
    for segment in line {
        let (from, sweep) = (segment.direction_at(0.0), segment.sweep());
        let direction = from.y.atan2(from.x);
        if let Some(before) = heading {
            let corner = wrapped(direction - before);
            if corner.abs() > ALIKE_RAD {
                kinds.push(bend(0.0, corner, thickness, above, at)?);
            }
        }
        let kind = match segment.radius() {
            None => ElementKind::Line { length: segment.length() },
            Some(radius) => bend(radius, sweep, thickness, above, at)?,
        };
        match kinds.last_mut().and_then(|last| Some((joined(last, &kind)?, last))) {
            Some((whole, last)) => *last = whole,
            None => kinds.push(kind),
        }
        heading = Some(direction + sweep);
    }
    let slope = line.first().map_or(0.0, |s| s.direction_at(0.0).y.atan2(s.direction_at(0.0).x));
    Ok(made(&kinds, thickness, slope))
}

/// Two pieces that go on in one another as one element: drawings divide lines at the middle and arcs at quadrants.
fn joined(a: &ElementKind, b: &ElementKind) -> Option<ElementKind> {
    match (*a, *b) {
        (ElementKind::Line { length: a }, ElementKind::Line { length: b }) => Some(ElementKind::Line { length: a + b }),
        (
            ElementKind::Bend { inside_radius: r, angle_deg: a },
            ElementKind::Bend { inside_radius: s, angle_deg: b },
        ) if (r - s).abs() < ALIKE_MM && a * b > 0.0 => {
            Some(ElementKind::Bend { inside_radius: r, angle_deg: tidy(a + b) })
        }
        _ => None,
    }
}

/// A bend whose line has this radius; upwards its centre lies above the strip, so that the line is nearer to the outside.
fn bend(radius: f64, sweep: f64, thickness: f64, above: f64, at: &Place) -> Result<ElementKind, Diagnostic> {
    let to_inside = if sweep > 0.0 { thickness - above } else { above };
    let inside_radius = radius - to_inside;
    if inside_radius < -ALIKE_MM {
        let message = format!(
            "A bend of {:.1}° has the radius {radius:.3} mm; with the thickness of {thickness:.3} mm it needs at least {to_inside:.3} mm.",
            sweep.to_degrees()
        );
        return Err(unusable(at, &message).with_hint("Draw an arc in every corner."));
    }
    Ok(ElementKind::Bend { inside_radius: tidy(inside_radius.max(0.0)), angle_deg: tidy(sweep.to_degrees()) })
}

/// A figure without what drawing programs leave of rounding: 1e-6.
fn tidy(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn wrapped(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    (angle + PI).rem_euclid(TAU) - PI
}

/// The elements as a section: symmetrical if they are their own mirror image about a middle line.
fn made(kinds: &[ElementKind], thickness: f64, slope: f64) -> CrossSection {
    let half = kinds.len() / 2;
    let mirrored = kinds.len() % 2 == 1 && kinds.iter().zip(kinds.iter().rev()).take(half).all(|(a, b)| alike(a, b));
    let middle = kinds.get(half).copied();
    let (origin, kinds, slope) = match middle {
        Some(ElementKind::Line { length }) if mirrored && kinds.len() > 1 => {
            let first = ElementKind::Line { length: tidy(length / 2.0) };
            (Origin::Symmetrical, std::iter::once(first).chain(kinds.iter().skip(half + 1).copied()).collect(), 0.0)
        }
        _ => (Origin::LeftToRight, kinds.to_vec(), tidy(slope.to_degrees())),
    };
    CrossSection {
        thickness: tidy(thickness),
        origin,
        first_angle_deg: slope,
        developed_width: DevelopedWidth::MeanLine,
        elements: (1..).zip(kinds).map(|(id, kind)| Element { id, kind: tidied(kind) }).collect(),
        other_side: Vec::new(),
    }
}

fn tidied(kind: ElementKind) -> ElementKind {
    match kind {
        ElementKind::Line { length } => ElementKind::Line { length: tidy(length) },
        bend @ ElementKind::Bend { .. } => bend,
    }
}

fn alike(a: &ElementKind, b: &ElementKind) -> bool {
    match (*a, *b) {
        (ElementKind::Line { length: a }, ElementKind::Line { length: b }) => (a - b).abs() < ALIKE_MM,
        (
            ElementKind::Bend { inside_radius: r, angle_deg: a },
            ElementKind::Bend { inside_radius: s, angle_deg: b },
        ) => (r - s).abs() < ALIKE_MM && (a - b).abs() < ALIKE_RAD.to_degrees(),
        _ => false,
    }
}

fn unusable(at: &Place, message: &str) -> Diagnostic {
    Diagnostic::error("dxf-no-section", at.clone(), message)
}

fn taken(thickness: f64, unit: Unit, at: &Place) -> Diagnostic {
    let message = format!(
        "A mid-line does not say how thick the strip is; {thickness:.unit$} {} are taken.",
        unit.symbol(),
        unit = unit.decimals()
    );
    Diagnostic::new(Severity::Info, "dxf-thickness-taken", at.clone(), message).with_hint("Enter the thickness.")
}

fn no_thickness(at: &Place) -> Diagnostic {
    unusable(at, "The drawing is an open line and has no thickness; a mid-line needs one greater than 0.")
        .with_hint("Give the thickness, or draw the closed outline.")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::RollSet;
    use crate::rollform::bends::Stage;
    use crate::rollform::fixtures::{bend as bent, line, set};
    use crate::rollform::strip::Strip;
    use ::dxf::Drawing;
    use ::dxf::entities::{Arc, Entity, EntityType, Line};

    /// The drawing of segments, in any order and direction.
    fn drawn(segments: &[Segment]) -> Vec<u8> {
        let mut drawing = Drawing::new();
        let point = |p: Point| ::dxf::Point::new(p.z, p.r, 0.0);
        for (k, segment) in segments.iter().enumerate().rev() {
            let segment = if k % 2 == 0 { *segment } else { segment.reversed() };
            let entity = match segment {
                Segment::Line { start, end } => EntityType::Line(Line::new(point(start), point(end))),
                Segment::Arc { start, end, center, ccw } => {
                    let angle = |p: Point| (p - center).y.atan2((p - center).x).to_degrees();
                    let (from, to) = if ccw { (start, end) } else { (end, start) };
                    EntityType::Arc(Arc::new(point(center), start.distance(center), angle(from), angle(to)))
                }
            };
            drawing.add_entity(Entity::new(entity));
        }
        let mut bytes = Vec::new();
        drawing.save(&mut bytes).unwrap();
        bytes
    }

    fn read(segments: &[Segment], thickness: Option<f64>) -> Result<CrossSection, Vec<Diagnostic>> {
        let thickness = thickness.map_or(MidLineThickness::Unknown, MidLineThickness::OfDrawing);
        roll_section_dxf("hat.dxf", &drawn(segments), thickness).map(|(document, _)| {
            let Content::RollSet(RollSet { section, .. }) = document.content else { panic!("no set") };
            section
        })
    }

    fn hat() -> RollSet {
        let elements = vec![line(1, 15.0), bent(2, 2.0, -70.0), line(3, 20.0), bent(4, 3.0, 70.0), line(5, 12.0)];
        set(1.5, Origin::Symmetrical, elements, Vec::new())
    }

    fn same(found: &CrossSection, wanted: &CrossSection) {
        assert_eq!((found.origin, found.elements.len()), (wanted.origin, wanted.elements.len()), "{found:?}");
        assert!((found.thickness - wanted.thickness).abs() < 1e-5);
        assert!((found.first_angle_deg - wanted.first_angle_deg).abs() < 1e-4);
        assert!(found.elements.iter().zip(&wanted.elements).all(|(a, b)| alike(&a.kind, &b.kind)), "{found:?}");
    }

    #[test]
    fn mid_line_and_outline_give_the_section_back() {
        let hat = hat();
        let strip = Strip::at(&hat, Stage::Finished);
        same(&read(&strip.mean().segments, Some(1.5)).unwrap(), &hat.section);
        same(&read(&strip.outline().segments, None).unwrap(), &hat.section);
    }

    #[test]
    fn unsymmetrical_section_is_read_from_left_to_right() {
        let elements = vec![line(1, 10.0), bent(2, 0.0, 90.0), line(3, 30.0), bent(4, 2.0, 60.0), line(5, 25.0)];
        let mut one = set(1.0, Origin::LeftToRight, elements, Vec::new());
        one.section.first_angle_deg = -90.0;
        let strip = Strip::at(&one, Stage::Finished);
        same(&read(&strip.mean().segments, Some(1.0)).unwrap(), &one.section);
        same(&read(&strip.outline().segments, None).unwrap(), &one.section);
    }

    /// A thickness that is only taken is mm in drawings of any unit, and told for a mid-line; an outline has its own, and nothing is
    /// told.
    #[test]
    fn only_a_mid_line_is_said_to_have_no_thickness() {
        let strip = Strip::at(&hat(), Stage::Finished);
        let read = |segments: &[Segment]| {
            roll_section_dxf("hat.dxf", &drawn(segments), MidLineThickness::TakenMm(1.5)).map(|(_, said)| said).unwrap()
        };
        let told =
            |said: &[Diagnostic]| said.iter().filter(|d| d.code == "dxf-thickness-taken").cloned().collect::<Vec<_>>();
        let [of_line] = <[Diagnostic; 1]>::try_from(told(&read(&strip.mean().segments))).unwrap();
        assert!(of_line.message.contains("1.500 mm"), "{}", of_line.message);
        assert_eq!(told(&read(&strip.outline().segments)), []);
        let inches = |text: Vec<u8>| {
            let text = String::from_utf8(text).unwrap();
            let mut drawing = Drawing::load(&mut text.as_bytes()).unwrap();
            drawing.header.version = ::dxf::enums::AcadVersion::R2000;
            drawing.header.default_drawing_units = ::dxf::enums::Units::Inches;
            let mut bytes = Vec::new();
            drawing.save(&mut bytes).unwrap();
            bytes
        };
        let bytes = inches(drawn(&strip.mean().segments));
        let (document, _) = roll_section_dxf("hat.dxf", &bytes, MidLineThickness::TakenMm(2.54)).unwrap();
        let Content::RollSet(set) = &document.content else { panic!("no set") };
        assert!((set.section.thickness - 0.1).abs() < 1e-9 && document.unit == Unit::Inch, "{:?}", set.section);
    }

    #[test]
    fn drawings_that_are_no_section_are_refused_with_their_reason() {
        let strip = Strip::at(&hat(), Stage::Finished);
        let said = |segments: &[Segment], thickness| read(segments, thickness).unwrap_err()[0].message.clone();
        assert!(said(&strip.mean().segments, None).contains("no thickness"));
        assert!(said(&strip.mean().segments, Some(6.0)).contains("needs at least 3.000 mm"));
        assert!(said(&[], Some(1.0)).contains("0 lines"));
        let mut gap = strip.mean().segments;
        gap.remove(2);
        assert!(said(&gap, Some(1.5)).contains("not connected"));
        let square = Contour::polygon(&[(0.0, 0.0), (9.0, 0.0), (8.0, 5.0)].map(|(z, r)| Point::new(z, r)));
        assert!(said(&square.segments, None).contains("no two straight ends"));
    }
}
