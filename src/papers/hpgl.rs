//! A page for a pen plotter: HP-GL as the HP 7470 and its successors read it.

use super::page::{Align, Ink, Item, Page, Pen, Stroke};
use crate::geometry::{Contour, Point, Segment};
use std::fmt::Write;

/// Plotter units in a mm.
const UNITS_PER_MM: f64 = 40.0;
/// Width of a plotter's character as a share of its height, with the space behind it.
const CHARACTER_WIDTH: f64 = 0.67;
/// Character that ends a label.
const END_OF_LABEL: char = '\u{3}';

/// The page in HP-GL. Pen 1 draws edges, pen 2 everything thin, pen 3 remarks and pen 4 what is wrong; areas stay empty.
#[must_use]
pub fn hpgl(page: &Page) -> String {
    let mut out = "IN;\n".to_owned();
    let mut pen_in_hand = 0;
    for item in &page.items {
        match item {
            Item::Path { path, pen: Some(pen), .. } => {
                choose(&mut out, &mut pen_in_hand, number_of(*pen));
                line_type(&mut out, pen.stroke);
                draw(&mut out, path);
            }
            Item::Path { pen: None, .. } => {}
            Item::Text { at, height_mm, align, upright, ink, text, .. } => {
                choose(&mut out, &mut pen_in_hand, number_of(Pen { ink: *ink, ..Pen::THIN }));
                label(&mut out, *at, *height_mm, *align, *upright, text);
            }
        }
    }
    out + "PU;SP0;\n"
}

const fn number_of(pen: Pen) -> u32 {
    match pen.ink {
        Ink::Red => 4,
        Ink::Grey | Ink::Pale | Ink::Sand | Ink::Green => 3,
        Ink::Black if pen.width_mm < Pen::EDGE.width_mm => 2,
        Ink::Black => 1,
    }
}

fn choose(out: &mut String, in_hand: &mut u32, pen: u32) {
    if *in_hand != pen {
        *in_hand = pen;
        // Writing to a String cannot fail.
        let _ = writeln!(out, "SP{pen};");
    }
}

fn line_type(out: &mut String, stroke: Stroke) {
    out.push_str(match stroke {
        Stroke::Solid => "LT;",
        Stroke::Dashed => "LT2,1;",
        Stroke::Centre => "LT4,2;",
    });
}

fn draw(out: &mut String, path: &Contour) {
    let Some(first) = path.segments.first().map(Segment::start) else { return };
    let _ = write!(out, "PU{};PD", place(first));
    for segment in &path.segments {
        let _ = match *segment {
            Segment::Line { end, .. } => write!(out, ";PA{}", place(end)),
            Segment::Arc { start, end, center, ccw } => {
                // The angle between the places as the plotter knows them; then to the very end, or faults would add up.
                let [start, end, middle] = [start, end, center].map(rounded);
                let sweep = Segment::Arc { start, end, center: middle, ccw }.sweep().to_degrees();
                write!(out, ";AA{},{sweep:.3};PA{}", place(center), place(end))
            }
        };
    }
    out.push_str(";PU;\n");
}

fn label(out: &mut String, at: Point, height_mm: f64, align: Align, upright: bool, text: &str) {
    let text = plain(text);
    let length = text.chars().map(|_| CHARACTER_WIDTH * height_mm).sum::<f64>();
    let back = match align {
        Align::Start => 0.0,
        Align::Middle => length / 2.0,
        Align::End => length,
    };
    let start = if upright { Point::new(at.z, at.r - back) } else { Point::new(at.z - back, at.r) };
    let direction = if upright { "DI0,1" } else { "DI1,0" };
    // Sizes are in cm; the width of the character itself is two thirds of its place.
    let (width, height) = (CHARACTER_WIDTH * height_mm / 1.5 / 10.0, height_mm / 10.0);
    let _ = writeln!(out, "PU{};{direction};SI{width:.3},{height:.3};LB{text}{END_OF_LABEL}", place(start));
}

/// A text in the plotter's own characters, and the nearest to those that it does not have.
fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            'Ø' | '⌀' | 'ø' => plain.push('D'),
            '×' => plain.push('x'),
            '–' | '—' | '−' => plain.push('-'),
            '²' => plain.push('2'),
            '…' => plain.push_str("..."),
            '°' => plain.push_str(" deg"),
            '±' => plain.push_str("+-"),
            c if c.is_control() => {}
            c if c.is_ascii() => plain.push(c),
            _ => plain.push('?'),
        }
    }
    plain
}

fn place(p: Point) -> String {
    format!("{:.0},{:.0}", (p.z * UNITS_PER_MM).round() + 0.0, (p.r * UNITS_PER_MM).round() + 0.0)
}

/// The nearest place that the plotter knows, mm.
fn rounded(p: Point) -> Point {
    Point::new((p.z * UNITS_PER_MM).round() / UNITS_PER_MM, (p.r * UNITS_PER_MM).round() / UNITS_PER_MM)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_arcs_and_labels_are_plotted_in_units_of_a_fortieth_mm() {
        let p = Point::new;
        let mut page = Page::new(100.0, 100.0, "");
        let quarter = Segment::Arc { start: p(20.0, 10.0), end: p(10.0, 20.0), center: p(10.0, 10.0), ccw: true };
        page.path(vec![Segment::line(p(0.0, 10.0), p(20.0, 10.0)), quarter], Pen::EDGE);
        page.text(p(5.0, 5.0), 3.0, Align::Start, "Ø 20 ± 0.1, 2 × 45°");
        let text = hpgl(&page);
        assert!(text.contains("PU0,400;PD;PA800,400;AA400,400,90.000;PA400,800;PU;"), "{text}");
        assert!(text.contains("LBD 20 +- 0.1, 2 x 45 deg\u{3}"), "{text}");
        assert!(text.starts_with("IN;\nSP1;") && text.ends_with("PU;SP0;\n"), "{text}");
    }
}
