//! A form-roll as a file: the E layout of the published roll design programs, and DXF.

use super::dxf;
use crate::diagnostic::Diagnostic;
use crate::geometry::{Contour, Segment};
use crate::part::PartContour;
use crate::rollform::roll::RollElement;
use crate::units::Unit;
use std::fmt::Write;

/// Lines within this of the vertical are vertical, mm: half the last figure.
const VERTICAL_MM: f64 = 0.0005;

/// The elements of a roll in the E layout, mm with three decimals: number, type (1 line, 2 arc), z and radius of start and end,
/// then A, B, C of A·z + B·r + C = 0 for a line or centre and radius for an arc, and the sense (0 line, 1
/// counter-clockwise, −1 clockwise). A line of zeros ends the list. [`import`](crate::storage::import) reads it back.
#[must_use]
pub fn e_layout(elements: &[RollElement]) -> String {
    let mut text = String::new();
    for (number, element) in (1_usize..).zip(elements) {
        row(&mut text, number, &element.segment);
    }
    let _ = write!(text, "{:4}{:4}", 0, 0);
    for _ in 0..7 {
        let _ = write!(text, "{:10.3}", 0.0);
    }
    let _ = writeln!(text, "{:4}", 0);
    text
}

fn row(text: &mut String, number: usize, segment: &Segment) {
    let (start, end) = (segment.start(), segment.end());
    let (kind, [a, b, c], sense) = match *segment {
        Segment::Line { .. } if (end.z - start.z).abs() <= VERTICAL_MM => (1, [1.0, 0.0, -start.z], 0),
        Segment::Line { .. } => {
            let slope = (end.r - start.r) / (end.z - start.z);
            (1, [-slope, 1.0, slope * start.z - start.r], 0)
        }
        Segment::Arc { center, ccw, .. } => (2, [center.z, center.r, start.distance(center)], if ccw { 1 } else { -1 }),
    };
    let _ = write!(text, "{number:4}{kind:4}");
    for value in [start.z, start.r, end.z, end.r, a, b, c] {
        let _ = write!(text, "{:10.3}", positive_zero(value));
    }
    let _ = writeln!(text, "{sense:4}");
}

/// A value that rounds to 0 without a sign.
fn positive_zero(value: f64) -> f64 {
    if value.abs() < 0.0005 { 0.0 } else { value }
}

/// The half section of a roll as DXF, with its bore.
///
/// # Errors
/// A diagnostic if the drawing cannot be written as text.
pub fn roll_dxf(elements: &[RollElement], bore_diameter_mm: f64, unit: Unit) -> Result<String, Diagnostic> {
    let surface = elements.get(1..elements.len().saturating_sub(1)).unwrap_or_default();
    let outside = of(surface.iter().map(|e| e.segment).collect());
    let ends = outside.contour.segments.first().zip(outside.contour.segments.last());
    let bore = ends.filter(|_| bore_diameter_mm > 0.0).map(|(first, last)| {
        let at = |z: f64| crate::geometry::Point::new(z, bore_diameter_mm / 2.0);
        of(vec![Segment::line(at(first.start().z), at(last.end().z))])
    });
    dxf(&outside, bore.as_ref(), unit)
}

fn of(segments: Vec<Segment>) -> PartContour {
    PartContour { contour: Contour::new(segments), sections: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::has_errors;
    use crate::document::{Content, RollKind};
    use crate::rollform::fixtures::published_rolls;

    #[test]
    fn what_is_written_is_read_back() {
        let design = crate::rollform::design("1470b", &published_rolls());
        for roll in design.rolls() {
            let text = e_layout(&roll.elements);
            let (document, said) = crate::storage::import::roll("E.txt", &text).unwrap();
            assert!(!has_errors(&said));
            let Content::TurnedPart(part) = &document.content else { unreachable!("a part") };
            assert_eq!(part.sections.len(), roll.elements.len(), "{}", roll.name);
            assert!((part.length - roll.part.length).abs() < 0.001);
        }
    }

    #[test]
    fn the_rows_have_the_published_form() {
        let design = crate::rollform::design("1470b", &published_rolls());
        let top = design.rolls().find(|r| r.roll.kind == RollKind::Top && r.roll.station == 2).unwrap();
        let text = e_layout(&top.elements);
        let first = "   1   1     0.000     0.000     0.000    65.669     1.000     0.000     0.000   0";
        assert_eq!(text.lines().next().unwrap(), first);
        let last = "   0   0     0.000     0.000     0.000     0.000     0.000     0.000     0.000   0";
        assert_eq!(text.lines().last().unwrap(), last);
        assert!(!text.contains("-0.000"));
    }
}
