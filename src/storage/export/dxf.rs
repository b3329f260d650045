//! A profile as a DXF drawing.

use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Point, Segment};
use crate::part::PartContour;
use crate::units::Unit;
use ::dxf::entities::{Arc, Entity, EntityType, Line};
use ::dxf::enums::{AcadVersion, Units};
use ::dxf::tables::Layer;
use ::dxf::{Color, Drawing};

const PROFILE: &str = "PROFILE";
/// Layer of the inside; an import takes what lies on it for the bore.
pub(in crate::storage) const BORE: &str = "BORE";
const CENTRE_LINE: &str = "CENTRE_LINE";
/// Length by which the centre line sticks out of the part, mm.
const CENTRE_LINE_BEYOND_MM: f64 = 5.0;

/// The upper half of the profile with its end faces on layer `PROFILE`, the bore on layer `BORE` and the centre line on
/// layer `CENTRE_LINE`; x along the spindle from the clamped end, y the radius, in `unit`. Arcs stay arcs.
///
/// # Errors
/// A diagnostic if the drawing cannot be written as text.
pub fn dxf(contour: &PartContour, bore: Option<&PartContour>, unit: Unit) -> Result<String, Diagnostic> {
    let mut drawing = empty(unit, &[(PROFILE, 7), (BORE, 7), (CENTRE_LINE, 1)]);
    let scale = 1.0 / unit.in_mm();
    for segment in &contour.contour.segments {
        add(&mut drawing, PROFILE, segment, scale);
    }
    let inside = bore.map(|b| b.contour.segments.as_slice()).unwrap_or_default();
    for segment in inside {
        add(&mut drawing, BORE, segment, scale);
    }
    let first = (contour.contour.segments.first().map(Segment::start), inside.first().map(Segment::start));
    let last = (contour.contour.segments.last().map(Segment::end), inside.last().map(Segment::end));
    for (end, bore_end) in [first, last] {
        let Some(end) = end else { continue };
        let from = bore_end.filter(|p| p.z == end.z).map_or(0.0, |p| p.r);
        if end.r > from {
            add(&mut drawing, PROFILE, &Segment::line(Point::new(end.z, from), end), scale);
        }
    }
    if let Some(bounds) = contour.contour.bounds() {
        let from = Point::new(bounds.min.z - CENTRE_LINE_BEYOND_MM, 0.0);
        let to = Point::new(bounds.max.z + CENTRE_LINE_BEYOND_MM, 0.0);
        add(&mut drawing, CENTRE_LINE, &Segment::line(from, to), scale);
    }
    text_of(&drawing)
}

/// A drawing without entities, with layers by name and colour.
pub(super) fn empty(unit: Unit, layers: &[(&str, u8)]) -> Drawing {
    let mut drawing = Drawing::new();
    // The oldest version whose header names the unit.
    drawing.header.version = AcadVersion::R2000;
    drawing.header.default_drawing_units = match unit {
        Unit::Mm => Units::Millimeters,
        Unit::Inch => Units::Inches,
    };
    for &(name, color) in layers {
        drawing.add_layer(Layer { name: name.to_owned(), color: Color::from_index(color), ..Layer::default() });
    }
    drawing
}

/// A drawing as text.
pub(super) fn text_of(drawing: &Drawing) -> Result<String, Diagnostic> {
    let mut bytes = Vec::new();
    let written = drawing.save(&mut bytes).map_err(|e| e.to_string());
    written.and_then(|()| String::from_utf8(bytes).map_err(|e| e.to_string())).map_err(|e| {
        Diagnostic::error("dxf-unwritable", Place::Document, format!("The drawing cannot be written as DXF: {e}."))
    })
}

pub(super) fn add(drawing: &mut Drawing, layer: &str, segment: &Segment, scale: f64) {
    let point = |p: Point| ::dxf::Point::new(p.z * scale, p.r * scale, 0.0);
    let specific = match *segment {
        Segment::Line { start, end } => EntityType::Line(Line::new(point(start), point(end))),
        Segment::Arc { start, end, center, ccw } => {
            let angle = |p: Point| (p.r - center.r).atan2(p.z - center.z).to_degrees().rem_euclid(360.0);
            // Arcs of a drawing always run counter-clockwise.
            let (from, to) = if ccw { (start, end) } else { (end, start) };
            let radius = start.distance(center) * scale;
            EntityType::Arc(Arc::new(point(center), radius, angle(from), angle(to)))
        }
    };
    let mut entity = Entity::new(specific);
    layer.clone_into(&mut entity.common.layer);
    drawing.add_entity(entity);
}
