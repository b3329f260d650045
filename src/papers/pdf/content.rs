//! What stands on one page of a PDF file, in mm from its lower left corner.

use super::embedded::EmbeddedFont;
use super::{BOLD, POINTS_PER_MM, REGULAR, single};
use crate::geometry::{Contour, Point, Segment};
use crate::papers::font;
use crate::papers::page::{Align, Ink, Item, Page, Pen};
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Str};

/// Largest sweep of one Bézier curve, radians: a sixteenth of a turn stays within 1e-6 of its radius.
const LARGEST_SWEEP: f64 = std::f64::consts::FRAC_PI_8;

/// The operators that draw `page`; the glyphs of its texts are noted in the fonts.
pub(super) fn content(page: &Page, regular: &mut EmbeddedFont, bold: &mut EmbeddedFont) -> Vec<u8> {
    let mut content = Content::new();
    content.transform([single(POINTS_PER_MM), 0.0, 0.0, single(POINTS_PER_MM), 0.0, 0.0]);
    content.set_line_cap(LineCapStyle::RoundCap).set_line_join(LineJoinStyle::RoundJoin);
    for item in &page.items {
        match item {
            Item::Path { path, pen, fill } => draw(&mut content, path, *pen, *fill),
            Item::Text { bold: is_bold, text, .. } => {
                let codes = if *is_bold { bold.encode(text) } else { regular.encode(text) };
                write(&mut content, item, &codes);
            }
        }
    }
    content.finish().into_vec()
}

fn draw(content: &mut Content, path: &Contour, pen: Option<Pen>, fill: Option<Ink>) {
    let Some(first) = path.segments.first().map(Segment::start) else { return };
    if let Some(pen) = pen {
        let [r, g, b] = color(pen.ink);
        let dashes = pen.stroke.dashes_mm().iter().map(|mm| single(*mm));
        content.set_stroke_rgb(r, g, b).set_line_width(single(pen.width_mm)).set_dash_pattern(dashes, 0.0);
    }
    if let Some([r, g, b]) = fill.map(color) {
        content.set_fill_rgb(r, g, b);
    }
    content.move_to(single(first.z), single(first.r));
    path.segments.iter().for_each(|segment| continue_to_end(content, segment));
    if path.segments.last().is_some_and(|s| s.end() == first) {
        content.close_path();
    }
    match (pen, fill) {
        (Some(_), Some(_)) => content.fill_even_odd_and_stroke(),
        (Some(_), None) => content.stroke(),
        (None, Some(_)) => content.fill_even_odd(),
        (None, None) => content.end_path(),
    };
}

fn continue_to_end(content: &mut Content, segment: &Segment) {
    let Segment::Arc { start, center, .. } = *segment else {
        content.line_to(single(segment.end().z), single(segment.end().r));
        return;
    };
    let (radius, sweep) = (start.distance(center), segment.sweep());
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 16 in a turn")]
    let count = (sweep.abs() / LARGEST_SWEEP).ceil().max(1.0) as u32;
    // The handles of a curve through an arc of angle a are 4/3·tan(a/4) of the radius long.
    let handle = 4.0 / 3.0 * (sweep.abs() / f64::from(count) / 4.0).tan() * radius;
    for k in 0..count {
        let (from, to) = (f64::from(k) / f64::from(count), f64::from(k + 1) / f64::from(count));
        let (a, b) = (segment.point_at(from), segment.point_at(to));
        let first = a + segment.direction_at(from) * handle;
        let second = b - segment.direction_at(to) * handle;
        let [x1, y1, x2, y2, x, y] = [first.z, first.r, second.z, second.r, b.z, b.r].map(single);
        content.cubic_to(x1, y1, x2, y2, x, y);
    }
}

fn write(content: &mut Content, item: &Item, codes: &[u8]) {
    let Item::Text { at, height_mm, align, upright, bold, ink, text } = item else { return };
    let width = font::width_mm(text, *height_mm, *bold);
    let back = match align {
        Align::Start => 0.0,
        Align::Middle => width / 2.0,
        Align::End => width,
    };
    let start = if *upright { Point::new(at.z, at.r - back) } else { Point::new(at.z - back, at.r) };
    let (x, y) = (single(start.z), single(start.r));
    let matrix = if *upright { [0.0, 1.0, -1.0, 0.0, x, y] } else { [1.0, 0.0, 0.0, 1.0, x, y] };
    let [r, g, b] = color(*ink);
    content.set_fill_rgb(r, g, b).begin_text();
    content.set_font(if *bold { BOLD } else { REGULAR }, single(height_mm / font::CAPITAL));
    content.set_text_matrix(matrix).show(Str(codes)).end_text();
}

fn color(ink: Ink) -> [f32; 3] {
    ink.rgb().map(|part| f32::from(part) / 255.0)
}
