//! A profile as an SVG drawing to scale.

use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::part::PartContour;
use crate::units::trimmed;
use std::fmt::Write;

/// Paper around the part, mm.
const MARGIN_MM: f64 = 10.0;
/// Length by which the centre line sticks out of the part, mm.
const CENTRE_LINE_BEYOND_MM: f64 = 5.0;
/// Smallest change of direction that is drawn as an edge, radians (about 1 degree).
const EDGE_RAD: f64 = 0.018;

/// The part on white paper, true to scale in mm: the outline with both halves, the edges, the bore as hidden lines, and the
/// centre line. `name` is its title. Arcs stay arcs. Without any segment the drawing is empty.
#[must_use]
pub fn svg(contour: &PartContour, bore: Option<&PartContour>, name: &str) -> String {
    let contour = &contour.contour;
    let Bounds { min, max } = contour.bounds().unwrap_or(Bounds { min: Point::default(), max: Point::default() });
    let (left, top) = (min.z - MARGIN_MM, -max.r - MARGIN_MM);
    let (width, height) = (max.z - min.z + 2.0 * MARGIN_MM, 2.0 * (max.r + MARGIN_MM));
    let (from, to) = (min.z - CENTRE_LINE_BEYOND_MM, max.z + CENTRE_LINE_BEYOND_MM);
    format!(
        r##"<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{w}mm" height="{h}mm" viewBox="{l} {t} {w} {h}">
<title>{title}</title>
<rect x="{l}" y="{t}" width="{w}" height="{h}" fill="#ffffff"/>
<g fill="none" stroke="#1f2933" stroke-linecap="round" stroke-linejoin="round">
<path id="outline" d="{outline}" fill="#dce6f1" stroke-width="0.5"/>
<path id="edges" d="{edges}" stroke-width="0.25"/>
<path id="bore" d="{bore}" stroke-width="0.25" stroke-dasharray="2 1"/>
<path id="centre-line" d="M{from} 0H{to}" stroke-width="0.18" stroke-dasharray="6 1 1 1"/>
</g>
</svg>
"##,
        w = number(width),
        h = number(height),
        l = number(left),
        t = number(top),
        title = escaped(name),
        outline = outline(contour),
        edges = edges(contour),
        bore = bore.map(|bore| hidden(&bore.contour)).unwrap_or_default(),
        from = number(from),
        to = number(to),
    )
}

/// Upper half from left to right, lower half back; y grows downwards on paper.
fn outline(contour: &Contour) -> String {
    let Some(first) = contour.segments.first() else { return String::new() };
    let mut path = format!("M{} {}", number(first.start().z), number(-first.start().r));
    for segment in &contour.segments {
        add(&mut path, segment, 1.0);
    }
    let back = contour.reversed();
    if let Some(end) = back.segments.first().map(Segment::start) {
        add(&mut path, &Segment::line(Point::new(end.z, -end.r), end), -1.0);
    }
    for segment in &back.segments {
        add(&mut path, segment, -1.0);
    }
    path + "Z"
}

/// The bore in both halves, with a line across wherever its radius steps.
fn hidden(bore: &Contour) -> String {
    let Some(first) = bore.segments.first().map(Segment::start) else { return String::new() };
    let mut path = String::new();
    for side in [1.0, -1.0] {
        // Writing to a String cannot fail.
        let _ = write!(path, "M{} {}", number(first.z), number(-side * first.r));
        for segment in &bore.segments {
            add(&mut path, segment, side);
        }
    }
    path + &edges(bore)
}

/// Adds a segment; `side` is 1 for the upper half and −1 for its mirror image.
fn add(path: &mut String, segment: &Segment, side: f64) {
    let end = segment.end();
    let to = format!("{} {}", number(end.z), number(-side * end.r));
    // Writing to a String cannot fail.
    let _ = match segment {
        Segment::Line { .. } => write!(path, "L{to}"),
        Segment::Arc { start, center, ccw, .. } => {
            let radius = number(start.distance(*center));
            let large = u8::from(segment.sweep().abs() > std::f64::consts::PI);
            let clockwise_on_paper = u8::from(*ccw != (side > 0.0));
            write!(path, "A{radius} {radius} 0 {large} {clockwise_on_paper} {to}")
        }
    };
}

/// A line across the part wherever the profile changes direction, and at its ends.
fn edges(contour: &Contour) -> String {
    let joints = contour.segments.windows(2).filter_map(|pair| {
        let turn = pair[0].direction_at(1.0).angle(&pair[1].direction_at(0.0));
        (turn > EDGE_RAD).then(|| pair[1].start())
    });
    let mut path = String::new();
    for p in joints.filter(|p| p.r > 0.0) {
        // Writing to a String cannot fail.
        let _ = write!(path, "M{} {}V{}", number(p.z), number(-p.r), number(p.r));
    }
    path
}

/// Up to four decimals (0.1 µm).
fn number(value: f64) -> String {
    trimmed(value, 4)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dome_on_a_cylinder_is_drawn_to_scale_with_arcs() {
        let p = Point::new;
        let dome = Segment::Arc { start: p(10.0, 5.0), end: p(15.0, 0.0), center: p(10.0, 0.0), ccw: false };
        let contour = Contour::new(vec![Segment::line(p(0.0, 5.0), p(10.0, 5.0)), dome]);
        let text = svg(&PartContour { contour, sections: vec![1, 2] }, None, "A & B");
        assert!(text.contains(r#"width="35mm" height="30mm" viewBox="-10 -15 35 30""#), "{text}");
        assert!(text.contains("<title>A &amp; B</title>"));
        let outline = r#"d="M0 -5L10 -5A5 5 0 0 1 15 0L15 0A5 5 0 0 1 10 5L0 5Z""#;
        assert!(text.contains(outline), "{text}");
        assert!(text.contains(r#"id="edges" d="""#), "a tangent joint is no edge: {text}");
    }

    #[test]
    fn a_shoulder_is_an_edge_and_an_empty_profile_an_empty_drawing() {
        let p = Point::new;
        let contour = Contour::polygon(&[p(0.0, 5.0), p(10.0, 5.0), p(10.0, 4.0)]);
        let text =
            svg(&PartContour { contour: Contour::new(contour.segments[..2].to_vec()), sections: vec![1, 2] }, None, "");
        assert!(text.contains("M10 -5V5"), "{text}");
        assert!(svg(&PartContour::default(), None, "").contains("<svg"));
    }
}
