//! The points between the elements of a roll profile.

use super::element::{Element, Shape};
use super::{COMPUTED_DECIMALS, SAME_PLACE_MM, rounded};
use crate::diagnostic::{Diagnostic, Severity};
use crate::geometry::{Point, Segment};
use crate::textfile::line_place;

/// A line and an arc that turn by less than this at a hollow corner graze each other, degrees: 0.001 mm in the figures
/// then moves their crossing by more than 0.01 mm, and it is the crossing that a tool follows there.
const GRAZING_DEG: f64 = 5.7;

/// Below this turn they join smoothly, and their crossing has no place of its own, degrees.
const TANGENT_DEG: f64 = 0.5;

/// A crossing further than this from the published corner is another one, mm.
const NEAR_MM: f64 = 0.05;

/// The start of the first element and the end of every element, as rows of a section table need them.
///
/// An element starts where the one before it ends. Lines that run along the spindle by no more than rounding are walls. At a
/// grazing corner the published figures of line and circle miss the published corner by up to 0.02 mm; the corner is put
/// where they cross, and a remark says so. (A bulging corner is not moved: there a tool turns about the corner itself.)
pub(super) fn nodes(file: &str, elements: &[Element], diagnostics: &mut Vec<Diagnostic>) -> Vec<Point> {
    let mut nodes: Vec<Point> = elements.first().map(|e| e.start).into_iter().collect();
    for element in elements {
        let start = nodes.last().copied().unwrap_or(element.start);
        let is_wall = element.shape == Shape::Line && (element.end.z - start.z).abs() <= SAME_PLACE_MM;
        nodes.push(if is_wall { Point::new(start.z, element.end.r) } else { element.end });
    }
    let published: Vec<Segment> = elements
        .iter()
        .zip(nodes.iter().zip(nodes.iter().skip(1)))
        .map(|(element, (&start, &end))| segment(element, start, end))
        .collect();
    let corners = elements.iter().zip(&published).zip(elements.iter().zip(&published).skip(1));
    for ((before, after), node) in corners.zip(nodes.iter_mut().skip(1)) {
        if let Some(crossing) = grazing(before, after, *node) {
            let crossing = Point::new(rounded(crossing.z, COMPUTED_DECIMALS), rounded(crossing.r, COMPUTED_DECIMALS));
            diagnostics.push(moved(file, before.0, *node, crossing));
            *node = crossing;
        }
    }
    nodes
}

fn segment(element: &Element, start: Point, end: Point) -> Segment {
    match element.shape {
        Shape::Line => Segment::Line { start, end },
        Shape::Arc { center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

/// The crossing of a line and an arc's published circle at a grazing hollow corner.
fn grazing(before: (&Element, &Segment), after: (&Element, &Segment), corner: Point) -> Option<Point> {
    let (a, b) = (before.1.direction_at(1.0), after.1.direction_at(0.0));
    let turn = a.perp(&b).atan2(a.dot(&b)).to_degrees();
    if !(TANGENT_DEG..GRAZING_DEG).contains(&turn) {
        return None;
    }
    let (line, arc) = match (before.0.shape, after.0.shape) {
        (Shape::Line, Shape::Arc { .. }) => (before.1, after.0),
        (Shape::Arc { .. }, Shape::Line) => (after.1, before.0),
        _ => return None,
    };
    let Shape::Arc { center, radius, ccw } = arc.shape else { return None };
    let outward = (corner - center).try_normalize(0.0)?;
    let circle = Segment::Arc { start: center + outward * radius, end: arc.end, center, ccw };
    circle.prolonged_meeting(line, corner).filter(|crossing| crossing.distance(corner) <= NEAR_MM)
}

fn moved(file: &str, element: &Element, from: Point, to: Point) -> Diagnostic {
    let message = format!(
        "Elements {} and {} meet at so small an angle that the figures do not fix their corner: it is put {:.4} mm from the \
         published one, at z {:.4} mm, radius {:.4} mm, where line and circle cross.",
        element.number,
        element.number + 1,
        from.distance(to),
        to.z,
        to.r
    );
    Diagnostic::new(Severity::Info, "roll-corner", line_place(file, element.line, None), message)
}

/// The radius of the arc between two points whose centre is nearest to `center`, mm: centres of arcs between them lie on
/// the line square to their chord through its middle.
///
/// A quarter whose legs differ by rounding gets the radius with which it ends square to the spindle, chord² / (2 · width),
/// for a row cannot run back under itself.
pub(super) fn fitted_radius(start: Point, end: Point, center: Point) -> f64 {
    let along = end - start;
    let middle = Point::new(f64::midpoint(start.z, end.z), f64::midpoint(start.r, end.r));
    let height = along.perp(&(center - middle)) / along.norm();
    let nearest = (along.norm() / 2.0).hypot(height);
    let square = along.norm_squared() / (2.0 * along.x.abs());
    if (nearest..=nearest + SAME_PLACE_MM).contains(&square) { square } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_radius_fits_the_centre() {
        let radius = fitted_radius(Point::new(0.0, 4.0), Point::new(4.0, 0.0), Point::new(0.001, 0.001));
        assert!((radius - 4.0_f64.hypot(0.0) + 0.001 * 0.707).abs() < 0.001, "{radius}");
    }

    #[test]
    fn a_quarter_with_uneven_legs_ends_square_to_the_spindle() {
        let radius = fitted_radius(Point::new(0.0, 63.014), Point::new(2.0, 65.015), Point::new(1.999, 63.014));
        assert!((radius - 2.001).abs() < 1e-6, "{radius}");
    }

    #[test]
    fn walls_do_not_run_back_and_ends_are_kept() {
        let line = |number, start, end| Element { number, line: 1, start, end, shape: Shape::Line };
        let p = Point::new;
        let elements = [
            line(1, p(0.0, 5.0), p(10.0, 5.0)),
            line(2, p(10.001, 5.0), p(9.999, 8.0)),
            line(3, p(9.998, 8.0), p(20.0, 8.0)),
        ];
        let nodes = nodes("E", &elements, &mut Vec::new());
        assert_eq!(nodes, [p(0.0, 5.0), p(10.0, 5.0), p(10.0, 8.0), p(20.0, 8.0)]);
    }
}
