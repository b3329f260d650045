//! A page as a DXF drawing in mm.

use super::page::{Align, Ink, Item, Page, Pen, Stroke};
use super::view::View;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Point, Segment};
use ::dxf::entities::{Arc, Entity, EntityType, Line, Text};
use ::dxf::enums::{AcadVersion, HorizontalTextJustification, Units};
use ::dxf::tables::Layer;
use ::dxf::{Color, Drawing};

/// The page as a drawing: edges on layer `EDGES`, axes on `CENTRE`, dimensions and frame on `THIN`, texts on `TEXT`; arcs
/// stay arcs, areas stay empty.
///
/// A page that shows a part to scale is written so that the part has its true size, with position 0 on the axis at the
/// origin, frame and texts in proportion; any other page is in mm of paper.
///
/// # Errors
/// A diagnostic if the drawing cannot be written as text.
pub fn dxf(page: &Page) -> Result<String, Diagnostic> {
    let mut drawing = Drawing::new();
    // The oldest version whose header names the unit.
    drawing.header.version = AcadVersion::R2000;
    drawing.header.default_drawing_units = Units::Millimeters;
    for (name, color) in [("EDGES", 7), ("CENTRE", 1), ("THIN", 8), ("TEXT", 7)] {
        drawing.add_layer(Layer { name: name.to_owned(), color: Color::from_index(color), ..Layer::default() });
    }
    let on_paper = View { origin: Point::new(0.0, 0.0), scale: 1.0 };
    let view = page.part.unwrap_or(on_paper);
    for item in &page.items {
        match item {
            Item::Path { path, pen: Some(pen), .. } => {
                path.segments.iter().for_each(|s| add(&mut drawing, layer(*pen), segment(s, &view)));
            }
            Item::Path { pen: None, .. } => {}
            Item::Text { .. } => add(&mut drawing, "TEXT", text(item, &view)),
        }
    }
    let mut bytes = Vec::new();
    let written = drawing.save(&mut bytes).map_err(|e| e.to_string());
    written.and_then(|()| String::from_utf8(bytes).map_err(|e| e.to_string())).map_err(|e| {
        Diagnostic::error("dxf-unwritable", Place::Document, format!("The drawing cannot be written as DXF: {e}."))
    })
}

fn layer(pen: Pen) -> &'static str {
    match pen.stroke {
        Stroke::Centre => "CENTRE",
        _ if pen.width_mm >= Pen::EDGE.width_mm && pen.ink == Ink::Black => "EDGES",
        _ => "THIN",
    }
}

fn point(p: Point, view: &View) -> ::dxf::Point {
    let p = view.part_point(p);
    ::dxf::Point::new(p.z, p.r, 0.0)
}

fn segment(segment: &Segment, view: &View) -> EntityType {
    match *segment {
        Segment::Line { start, end } => EntityType::Line(Line::new(point(start, view), point(end, view))),
        Segment::Arc { start, end, center, ccw } => {
            let angle = |p: Point| (p.r - center.r).atan2(p.z - center.z).to_degrees().rem_euclid(360.0);
            // Arcs of a drawing always run counter-clockwise.
            let (from, to) = if ccw { (start, end) } else { (end, start) };
            let radius = start.distance(center) / view.scale;
            EntityType::Arc(Arc::new(point(center, view), radius, angle(from), angle(to)))
        }
    }
}

fn text(item: &Item, view: &View) -> EntityType {
    let Item::Text { at, height_mm, align, upright, text, .. } = item else {
        return EntityType::Text(Text::default());
    };
    EntityType::Text(Text {
        location: point(*at, view),
        second_alignment_point: point(*at, view),
        text_height: *height_mm / view.scale,
        value: in_words_of_the_format(text),
        rotation: if *upright { 90.0 } else { 0.0 },
        horizontal_text_justification: match align {
            Align::Start => HorizontalTextJustification::Left,
            Align::Middle => HorizontalTextJustification::Center,
            Align::End => HorizontalTextJustification::Right,
        },
        ..Text::default()
    })
}

/// Signs that the format has codes for, and the nearest plain one for those that old readers do not know.
fn in_words_of_the_format(text: &str) -> String {
    text.replace('Ø', "%%c")
        .replace('°', "%%d")
        .replace('±', "%%p")
        .replace('×', "x")
        .replace('²', "2")
        .replace('…', "...")
}

fn add(drawing: &mut Drawing, layer: &str, specific: EntityType) {
    let mut entity = Entity::new(specific);
    layer.clone_into(&mut entity.common.layer);
    drawing.add_entity(entity);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_arcs_and_texts_come_back_from_the_file() {
        let p = Point::new;
        let mut page = Page::new(100.0, 100.0, "");
        let quarter = Segment::Arc { start: p(20.0, 10.0), end: p(10.0, 20.0), center: p(10.0, 10.0), ccw: true };
        page.path(vec![Segment::line(p(0.0, 10.0), p(20.0, 10.0)), quarter], Pen::EDGE);
        page.text(p(5.0, 5.0), 3.0, Align::Middle, "Ø 20 ± 0.1, 2 × 45°");
        let file = dxf(&page).unwrap();
        let drawing = Drawing::load(&mut file.as_bytes()).unwrap();
        let entities: Vec<&Entity> = drawing.entities().collect();
        assert_eq!(entities.len(), 3);
        let EntityType::Arc(arc) = &entities[1].specific else { panic!("an arc") };
        assert!((arc.radius - 10.0).abs() < 1e-9 && (arc.end_angle - 90.0).abs() < 1e-9);
        let EntityType::Text(text) = &entities[2].specific else { panic!("a text") };
        assert_eq!(text.value, "%%c 20 %%p 0.1, 2 x 45%%d");
    }
}
