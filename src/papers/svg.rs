//! A page as an SVG file.

use super::font;
use super::page::{Align, Ink, Item, Page, Pen};
use crate::geometry::{Contour, Segment};
use crate::units::trimmed;
use std::fmt::Write;

/// The page true to size in mm. Arcs stay arcs; texts name Inter and fall back to any sans-serif type.
#[must_use]
pub fn svg(page: &Page) -> String {
    let (w, h) = (number(page.width_mm), number(page.height_mm));
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" \
         height=\"{h}mm\" viewBox=\"0 0 {w} {h}\" font-family=\"Inter, sans-serif\">\n<title>{}</title>\n\
         <rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n",
        escaped(&page.title)
    );
    for item in &page.items {
        match item {
            Item::Path { path, pen, fill } => add_path(&mut out, path, *pen, *fill, page.height_mm),
            Item::Text { .. } => add_text(&mut out, item, page.height_mm),
        }
    }
    out + "</svg>\n"
}

fn add_path(out: &mut String, path: &Contour, pen: Option<Pen>, fill: Option<Ink>, height: f64) {
    let Some(first) = path.segments.first().map(Segment::start) else { return };
    let mut data = format!("M{} {}", number(first.z), number(height - first.r));
    for segment in &path.segments {
        let end = segment.end();
        let to = format!("{} {}", number(end.z), number(height - end.r));
        // Writing to a String cannot fail.
        let _ = match *segment {
            Segment::Line { .. } => write!(data, "L{to}"),
            Segment::Arc { start, center, ccw, .. } => {
                let radius = number(start.distance(center));
                let large = u8::from(segment.sweep().abs() > std::f64::consts::PI);
                // Downwards is positive in the file, so that a turn to the left is one to the right there.
                write!(data, "A{radius} {radius} 0 {large} {} {to}", u8::from(!ccw))
            }
        };
    }
    let fill = fill.map_or("none".to_owned(), color);
    let stroke = pen.map_or(String::new(), |pen| {
        let dashes: Vec<String> = pen.stroke.dashes_mm().iter().map(|d| number(*d)).collect();
        let dashes =
            if dashes.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", dashes.join(" ")) };
        let (ink, width) = (color(pen.ink), number(pen.width_mm));
        format!(" stroke=\"{ink}\" stroke-width=\"{width}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{dashes}")
    });
    let _ = writeln!(out, "<path d=\"{data}\" fill=\"{fill}\" fill-rule=\"evenodd\"{stroke}/>");
}

fn add_text(out: &mut String, item: &Item, height: f64) {
    let Item::Text { at, height_mm, align, upright, bold, ink, text } = item else { return };
    let anchor = match align {
        Align::Start => "start",
        Align::Middle => "middle",
        Align::End => "end",
    };
    let (x, y) = (number(at.z), number(height - at.r));
    let turn = if *upright { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
    let weight = if *bold { " font-weight=\"600\"" } else { "" };
    let (size, ink, text) = (number(height_mm / font::CAPITAL), color(*ink), escaped(text));
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{ink}\"{weight}{turn}>{text}</text>"
    );
}

fn color(ink: Ink) -> String {
    let [r, g, b] = ink.rgb();
    format!("#{r:02x}{g:02x}{b:02x}")
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
    use crate::geometry::Point;

    #[test]
    fn arcs_turn_over_with_the_page_and_names_are_escaped() {
        let mut page = Page::new(40.0, 30.0, "A & B");
        let p = Point::new;
        page.path(
            vec![Segment::Arc { start: p(10.0, 0.0), end: p(5.0, 5.0), center: p(5.0, 0.0), ccw: true }],
            Pen::EDGE,
        );
        page.upright_text(p(1.0, 2.0), 2.5, Align::Middle, "<1>");
        let text = svg(&page);
        assert!(text.contains("M10 30A5 5 0 0 0 5 25"), "{text}");
        assert!(text.contains("<title>A &amp; B</title>") && text.contains("&lt;1&gt;"), "{text}");
        assert!(text.contains("rotate(-90 1 28)"), "{text}");
    }
}
