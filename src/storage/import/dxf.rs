//! A turned profile from a DXF drawing: x along the spindle, y the radius.

use super::{Imported, dxf_profile, dxf_segments};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::Document;
use crate::part::Section;
use crate::textfile::{file_place, line_place};
use crate::units::Unit;
use ::dxf::enums::Units;
use ::dxf::{Drawing, DxfError};
use std::io::Cursor;
use std::path::Path;

/// Ends of lines and arcs that are nearer than this belong together, mm: what drawing programs leave of rounding, and far
/// below what a lathe can make.
pub(super) const JOIN_MM: f64 = 0.001;

/// Reads a profile of lines, arcs, circles and light-weight polylines; `file` is its name for messages and `name` becomes
/// the document's name.
///
/// A half section above the centre line, a half below it or a full section will do: the upper half counts. The smallest x
/// becomes the clamped end. What lies on a layer `BORE` becomes the bore. Faces are implied by the table and may be drawn or not. Arcs are divided at quadrants.
/// A drawing in inches gives a document in inches, any other unit one in mm; a drawing without unit is taken as mm.
///
/// # Errors
/// Diagnostics with the values if the file cannot be read or holds no profile. Gaps, overhangs and entities that cannot be
/// used are diagnostics beside the document.
pub fn dxf(
    file: &str,
    name: &str,
    bytes: &[u8],
    machine: &str,
) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let at = file_place(Path::new(file));
    let drawing = load(file, bytes).map_err(|d| vec![d])?;
    let mut diagnostics = Vec::new();
    let (unit, scale) = unit_of(&drawing, &at, &mut diagnostics).map_err(|d| vec![d])?;
    let [segments, inside] = dxf_segments::segments(&drawing, scale, &at, &mut diagnostics);
    let tolerance = JOIN_MM / unit.in_mm();
    let origin = dxf_profile::origin(&segments, tolerance);
    let sections = dxf_profile::rows(&segments, origin, 1, tolerance, unit, &at, &mut diagnostics);
    let first_id = u32::try_from(sections.len()).unwrap_or(u32::MAX).saturating_add(1);
    let bore = dxf_profile::rows(&inside, origin, first_id, tolerance, unit, &at, &mut diagnostics);
    let bore = bore.iter().map(Section::seen_from_inside).collect();
    if sections.is_empty() {
        let message = format!("The drawing has {} lines and arcs, none of which forms a profile.", segments.len());
        diagnostics.push(
            Diagnostic::error("dxf-no-profile", at, message).with_hint(
                "Draw the profile with x along the spindle and y as the radius, y = 0 being the centre line.",
            ),
        );
        return Err(diagnostics);
    }
    let document = Imported::of_rows(name.to_owned(), unit, machine, [sections, bore]).document(file)?;
    Ok((document, diagnostics))
}

pub(super) fn load(file: &str, bytes: &[u8]) -> Result<Drawing, Diagnostic> {
    let lines = bytes.split(|&b| b == b'\n').count();
    // The reader takes any beginning of a file for a whole one, so the end is looked for here.
    let tail = bytes.get(bytes.len().saturating_sub(64)..).unwrap_or_default();
    if !tail.windows(3).any(|w| w == b"EOF") {
        let message = format!("The file ends in line {lines} without the mark EOF; the rest is missing.");
        return Err(Diagnostic::error("dxf-truncated", line_place(file, lines, None), message));
    }
    check_pairs(file, bytes)?;
    Drawing::load(&mut Cursor::new(bytes)).map_err(|e| {
        let at = line_of(&e).map_or_else(|| file_place(Path::new(file)), |line| line_place(file, line, None));
        let line = line_of(&e).and_then(|l| bytes.split(|&b| b == b'\n').nth(l - 1)).unwrap_or_default();
        let shown: String = String::from_utf8_lossy(line).trim().chars().take(60).collect();
        Diagnostic::error("dxf-unreadable", at, format!("The drawing cannot be read: {e}. The line reads `{shown}`."))
    })
}

/// Finds the first line of a text drawing that is not the number that it must be. The reader itself would stop there and
/// complain about what follows.
fn check_pairs(file: &str, bytes: &[u8]) -> Result<(), Diagnostic> {
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Ok(());
    }
    let text = String::from_utf8_lossy(bytes);
    let refused = |line: usize, found: &str, needed: &str| {
        let shown: String = found.trim().chars().take(60).collect();
        let message = format!("The line reads `{shown}` where {needed} is needed.");
        Err(Diagnostic::error("dxf-number", line_place(file, line, None), message))
    };
    let lines: Vec<&str> = text.lines().collect();
    for (line, pair) in (1..).step_by(2).zip(lines.chunks(2)) {
        let [code, value] = pair else { break };
        let Ok(code) = code.trim().parse::<i32>() else { return refused(line, code, "a group code, a whole number,") };
        // Group codes of coordinates, lengths, angles and other figures, by the DXF reference.
        let is_figure = matches!(code, 10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059);
        if is_figure && !value.trim().parse::<f64>().is_ok_and(f64::is_finite) {
            return refused(line + 1, value, &format!("a finite number (group code {code})"));
        }
    }
    Ok(())
}

/// The line that an error is about, from 1, where the reader says so.
fn line_of(error: &DxfError) -> Option<usize> {
    match error {
        DxfError::ParseFloatError(_, line)
        | DxfError::ParseIntError(_, line)
        | DxfError::ParseError(line)
        | DxfError::UnexpectedCode(_, line)
        | DxfError::UnexpectedByte(_, line)
        | DxfError::UnexpectedEnumValue(line)
        | DxfError::ExpectedTableType(line)
        | DxfError::WrongValueType(line) => Some((*line).max(1)),
        DxfError::UnexpectedCodePair(pair, _) => Some(pair.offset.max(1)),
        _ => None,
    }
}

/// The document's unit, and how many of it one unit of the drawing is.
pub(super) fn unit_of(
    drawing: &Drawing,
    at: &Place,
    diagnostics: &mut Vec<Diagnostic>,
) -> Result<(Unit, f64), Diagnostic> {
    Ok(match drawing.header.default_drawing_units {
        Units::Inches | Units::USSurveyInch => (Unit::Inch, 1.0),
        Units::Feet => (Unit::Inch, 12.0),
        Units::Mils => (Unit::Inch, 0.001),
        Units::Millimeters => (Unit::Mm, 1.0),
        Units::Centimeters => (Unit::Mm, 10.0),
        Units::Decimeters => (Unit::Mm, 100.0),
        Units::Meters => (Unit::Mm, 1000.0),
        Units::Microns => (Unit::Mm, 0.001),
        Units::Unitless => {
            let message = "The drawing names no unit ($INSUNITS is 0 or missing); it is taken as mm.";
            diagnostics.push(Diagnostic::warning("dxf-no-unit", at.clone(), message));
            (Unit::Mm, 1.0)
        }
        other => {
            let message = format!("The drawing's unit is {other:?} ($INSUNITS {}); use mm or inches.", other as i16);
            return Err(Diagnostic::error("dxf-unit", at.clone(), message));
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Content;
    use crate::geometry::{Contour, Point, Segment};
    use crate::part::{PartContour, SectionKind};
    use crate::storage::export;
    use ::dxf::LwPolylineVertex;
    use ::dxf::entities::{Circle, Entity, EntityType, Line, LwPolyline};

    fn p(z: f64, r: f64) -> Point {
        Point::new(z, r)
    }

    /// Cylinder, hollow, face, bulge, taper: a bit of everything, one quadrant an arc.
    fn sample() -> PartContour {
        let arc = |start, end, center, ccw| Segment::Arc { start, end, center, ccw };
        let segments = vec![
            Segment::line(p(0.0, 10.0), p(3.0, 10.0)),
            arc(p(3.0, 10.0), p(13.0, 5.0), p(13.0, 17.5), true),
            Segment::line(p(13.0, 5.0), p(19.0, 5.0)),
            Segment::line(p(19.0, 5.0), p(19.0, 12.0)),
            arc(p(19.0, 12.0), p(24.0, 13.0), p(24.0, 0.0), false),
            Segment::line(p(24.0, 13.0), p(30.0, 12.5)),
        ];
        let sections = vec![1, 2, 3, 4, 4, 5];
        PartContour { contour: Contour::new(segments), sections }
    }

    fn import(bytes: &[u8]) -> (Unit, Vec<Section>, Vec<Diagnostic>) {
        let (document, diagnostics) = dxf("a.dxf", "A", bytes, "orac").unwrap();
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        (document.unit, part.sections, diagnostics)
    }

    /// A drawing in mm of the given entities.
    fn drawing(entities: Vec<EntityType>) -> Vec<u8> {
        let mut drawing = Drawing::new();
        drawing.header.version = ::dxf::enums::AcadVersion::R2000;
        drawing.header.default_drawing_units = Units::Millimeters;
        for entity in entities {
            drawing.add_entity(Entity::new(entity));
        }
        let mut bytes = Vec::new();
        drawing.save(&mut bytes).unwrap();
        bytes
    }

    fn line(x1: f64, y1: f64, x2: f64, y2: f64) -> EntityType {
        EntityType::Line(Line::new(::dxf::Point::new(x1, y1, 0.0), ::dxf::Point::new(x2, y2, 0.0)))
    }

    fn polyline(vertices: &[(f64, f64, f64)], closed: bool) -> EntityType {
        let vertices = vertices.iter().map(|&(x, y, bulge)| LwPolylineVertex { x, y, bulge, ..Default::default() });
        let mut polyline = LwPolyline { vertices: vertices.collect(), ..Default::default() };
        polyline.set_is_closed(closed);
        EntityType::LwPolyline(polyline)
    }

    fn assert_near(a: &Section, b: &Section) {
        let radius = |s: &Section| match s.kind {
            SectionKind::Concave { radius } => -radius,
            SectionKind::Convex { radius } => radius,
            _ => 0.0,
        };
        for (a, b) in [(a.z1, b.z1), (a.d1, b.d1), (a.z2, b.z2), (a.d2, b.d2), (radius(a), radius(b))] {
            assert!((a - b).abs() < 1e-6, "{a} is not {b}");
        }
    }

    #[test]
    fn an_exported_profile_comes_back_within_a_nanometre_in_both_units() {
        let expected = [
            Section::line(1, 0.0, 20.0, 3.0, 20.0),
            Section { kind: SectionKind::Concave { radius: 12.5 }, ..Section::line(2, 3.0, 20.0, 13.0, 10.0) },
            Section::line(3, 13.0, 10.0, 19.0, 10.0),
            Section { kind: SectionKind::Convex { radius: 13.0 }, ..Section::line(4, 19.0, 24.0, 24.0, 26.0) },
            Section::line(5, 24.0, 26.0, 30.0, 25.0),
        ];
        for unit in [Unit::Mm, Unit::Inch] {
            let text = export::dxf(&sample(), None, unit).unwrap();
            let (found, sections, diagnostics) = import(text.as_bytes());
            assert_eq!((found, diagnostics), (unit, vec![]));
            assert_eq!(sections.len(), expected.len());
            for (section, expected) in sections.iter().zip(&expected) {
                assert_near(&section.scaled(unit.in_mm()), expected);
            }
        }
    }

    #[test]
    fn a_bore_comes_back_from_its_layer_with_hollows_on_their_side() {
        let arc = Segment::Arc { start: p(12.0, 3.0), end: p(16.0, 7.0), center: p(12.0, 7.0), ccw: true };
        let inside = vec![
            Segment::line(p(4.0, 0.0), p(4.0, 3.0)),
            Segment::line(p(4.0, 3.0), p(12.0, 3.0)),
            arc,
            Segment::line(p(16.0, 7.0), p(30.0, 7.0)),
        ];
        let bore = PartContour { contour: Contour::new(inside), sections: vec![6, 6, 7, 8] };
        let text = export::dxf(&sample(), Some(&bore), Unit::Mm).unwrap();
        let (document, diagnostics) = dxf("a.dxf", "A", text.as_bytes(), "orac").unwrap();
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        assert_eq!((diagnostics, part.sections.len(), part.bore.len()), (vec![], 5, 3));
        assert_near(&part.bore[0], &Section::line(6, 4.0, 6.0, 12.0, 6.0));
        let bulge = Section { kind: SectionKind::Convex { radius: 4.0 }, ..Section::line(7, 12.0, 6.0, 16.0, 14.0) };
        assert_near(&part.bore[1], &bulge);
    }

    #[test]
    fn a_full_section_of_polylines_is_cut_at_axis_and_quadrants() {
        // A ball of radius 10 on a stick, drawn round about: down along the stick's lower side and back.
        let ball = (5.0_f64 / 10.0).asin();
        let stick_end = 10.0 - 10.0 * ball.cos();
        let bulge = ((2.0 * std::f64::consts::PI - 2.0 * ball) / 4.0).tan();
        let bytes = drawing(vec![polyline(
            &[(-20.0, 5.0, 0.0), (-20.0, -5.0, 0.0), (stick_end, -5.0, bulge), (stick_end, 5.0, 0.0)],
            true,
        )]);
        let (_, sections, diagnostics) = import(&bytes);
        assert_eq!(diagnostics, []);
        let kinds: Vec<bool> = sections.iter().map(|s| matches!(s.kind, SectionKind::Convex { .. })).collect();
        assert_eq!(kinds, [false, true, true]);
        let convex = SectionKind::Convex { radius: 10.0 };
        let top = Section { kind: convex.clone(), ..Section::line(2, 20.0 + stick_end, 10.0, 30.0, 20.0) };
        assert_near(&sections[1], &top);
        assert_near(&sections[2], &Section { kind: convex, ..Section::line(3, 30.0, 20.0, 40.0, 0.0) });
    }

    #[test]
    fn a_lower_half_in_any_order_and_direction_is_turned_up() {
        let bytes = drawing(vec![line(20.0, -4.0, 5.0, -5.0), line(0.0, 0.0, 20.0, 0.0), line(0.0, -5.0, 5.0, -5.0)]);
        let (_, sections, diagnostics) = import(&bytes);
        assert_eq!(diagnostics, []);
        assert_eq!(sections, [Section::line(1, 0.0, 10.0, 5.0, 10.0), Section::line(2, 5.0, 10.0, 20.0, 8.0)]);
    }

    #[test]
    fn gaps_steps_overhangs_and_foreign_entities_are_reported_with_their_values() {
        let codes = |entities: Vec<EntityType>, words: &[&str]| {
            let (_, sections, diagnostics) = import(&drawing(entities));
            let text: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
            for word in words {
                assert!(text.iter().any(|t| t.contains(word)), "{word}: {text:#?}");
            }
            (sections.len(), diagnostics.into_iter().map(|d| d.code).collect::<Vec<_>>())
        };
        let first = || line(0.0, 5.0, 10.0, 5.0);
        let gap = codes(vec![first(), line(10.25, 5.0, 20.0, 5.0)], &["gap of 0.250 mm", "x 10.250"]);
        assert_eq!(gap, (2, vec!["dxf-gap".to_owned()]));
        let step = codes(vec![first(), line(10.0, 5.5, 20.0, 5.0)], &["by 0.500 mm"]);
        assert_eq!(step, (2, vec!["dxf-step".to_owned()]));
        let face = codes(vec![first(), line(10.0, 0.0, 10.0, 6.0), line(10.0, 5.5, 20.0, 5.0)], &[]);
        assert_eq!(face, (2, vec![]));
        let bore = codes(vec![first(), line(2.0, 3.0, 10.0, 3.0)], &["y 3.000", "8.000 mm"]);
        assert_eq!(bore, (1, vec!["dxf-overhang".to_owned()]));
        let twice = codes(vec![first(), first()], &[]);
        assert_eq!(twice, (1, vec![]));
        let circle = Circle { radius: 1e6, ..Circle::default() };
        let huge = codes(vec![first(), EntityType::Circle(circle)], &["radius 1000000", "up to 100000"]);
        assert_eq!(huge, (1, vec!["dxf-entity".to_owned()]));
        let text = codes(vec![first(), EntityType::Text(::dxf::entities::Text::default())], &["kind Text"]);
        assert_eq!(text, (1, vec!["dxf-entity".to_owned()]));
    }

    #[test]
    fn a_drawing_without_profile_unit_or_end_is_refused_or_says_so() {
        let refused = |bytes: &[u8]| dxf("a.dxf", "A", bytes, "orac").unwrap_err().pop().unwrap();
        assert_eq!(refused(&drawing(vec![])).code, "dxf-no-profile");
        assert_eq!(refused(&drawing(vec![line(0.0, 0.0, 9.0, 0.0)])).code, "dxf-no-profile");
        let whole = drawing(vec![line(0.0, 5.0, 10.0, 5.0)]);
        let text = String::from_utf8(whole.clone()).unwrap();
        assert_eq!(refused(&whole[..whole.len() - 20]).code, "dxf-truncated");
        let light_years = text.replacen("$INSUNITS\r\n 70\r\n     4", "$INSUNITS\r\n 70\r\n    20", 1);
        assert_ne!(light_years, text);
        assert!(refused(light_years.as_bytes()).message.contains("20"));
        let none = text.replacen("$INSUNITS\r\n 70\r\n     4", "$INSUNITS\r\n 70\r\n     0", 1);
        assert_eq!(import(none.as_bytes()).2[0].code, "dxf-no-unit");
        let bad = text.replacen(" 10\r\n0.0\r\n", " 10\r\n0.x\r\n", 1);
        assert!(refused(bad.as_bytes()).message.contains("0.x"), "{}", refused(bad.as_bytes()));
    }
}
