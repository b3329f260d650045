//! What of a tool meets stock before an edge does when it travels towards the chuck.

use super::chain::Chain;
use super::outline::one_way;
use super::piece::{Piece, SAME_MM};
use super::shape::Shape;
use super::tool::edges;
use crate::geometry::{Contour, Point, Segment};
use crate::machine::ToolOutline;
use std::f64::consts::PI;

/// Pieces in which every side of a tool is looked at.
const PARTS: u32 = 16;

/// Sides whose ends lie nearer than this in z get this width, mm: a function of z needs one.
const LEAST_WIDTH_MM: f64 = 0.001;

/// What of holder and edges that cannot cut is not behind a cutting edge, turned over. A side counts from the first to the last
/// of its parts that are not.
pub(super) fn ahead(outline: &ToolOutline) -> Shape {
    let lead = Lead::of(outline);
    let back = edges(outline, false);
    let sides = outline.holder.segments.iter().chain(&back.segments);
    let open: Vec<Chain> = sides.flat_map(|side| lead.uncovered(side)).map(|(a, b)| turned_over(a, b)).collect();
    Shape::of_chain(&Chain::largest(&open))
}

/// A part of a side, turned over; an upright one counts with its lowest place.
fn turned_over(a: Point, b: Point) -> Chain {
    if (a.z - b.z).abs() > LEAST_WIDTH_MM {
        let (left, right) = if a.z > b.z { (a, b) } else { (b, a) };
        return Chain { pieces: vec![Piece::line(Point::new(-left.z, -left.r), Point::new(-right.z, -right.r))] };
    }
    let (z0, z1) = (a.z.min(b.z) - LEAST_WIDTH_MM, a.z.max(b.z) + LEAST_WIDTH_MM);
    Chain::level(-z1, -z0, -a.r.min(b.r))
}

/// The cutting edge that leads.
struct Lead {
    edges: Vec<Segment>,
}

impl Lead {
    fn of(outline: &ToolOutline) -> Self {
        let upright = |s: &Segment| one_way(&quarter_turned(s)).iter().map(quarter_turned_back).collect::<Vec<_>>();
        Self { edges: edges(outline, true).segments.iter().flat_map(upright).collect() }
    }

    /// The stretches of a side that are not behind an edge; a curved one in its parts.
    fn uncovered(&self, side: &Segment) -> Vec<(Point, Point)> {
        let at = |k: u32| side.point_at(f64::from(k) / f64::from(PARTS));
        let places: Vec<(Point, bool)> = (0..=PARTS).map(at).map(|p| (p, self.covers(p))).collect();
        let mut runs: Vec<(Point, Point)> = Vec::new();
        for (&(a, before), &(b, behind)) in places.iter().zip(places.iter().skip(1)) {
            if before && behind {
                continue;
            }
            match runs.last_mut() {
                Some(last) if matches!(side, Segment::Line { .. }) && last.1 == a => last.1 = b,
                _ => runs.push((a, b)),
            }
        }
        runs
    }

    /// True if an edge cuts on the left of a point, or at it.
    fn covers(&self, p: Point) -> bool {
        self.edges.iter().filter_map(|s| at_height(s, p.r)).any(|z| z <= p.z + SAME_MM.sqrt())
    }
}

/// Where a segment that does not turn back in r is at a height.
fn at_height(segment: &Segment, r: f64) -> Option<f64> {
    let (a, b) = (segment.start(), segment.end());
    if r < a.r.min(b.r) - SAME_MM.sqrt() || r > a.r.max(b.r) + SAME_MM.sqrt() {
        return None;
    }
    match *segment {
        Segment::Line { .. } if (a.r - b.r).abs() <= SAME_MM.sqrt() => Some(a.z.min(b.z)),
        Segment::Line { .. } => Some(a.z + (b.z - a.z) * ((r - a.r) / (b.r - a.r))),
        Segment::Arc { center, .. } => {
            let radius = a.distance(center);
            let away = (radius * radius - (r - center.r) * (r - center.r)).max(0.0).sqrt();
            let middle = segment.point_at(0.5);
            Some(if middle.z < center.z { center.z - away } else { center.z + away })
        }
    }
}

fn quarter_turned(segment: &Segment) -> Segment {
    mapped(segment, |p| Point::new(p.r, -p.z))
}

fn quarter_turned_back(segment: &Segment) -> Segment {
    mapped(segment, |p| Point::new(-p.r, p.z))
}

fn mapped(segment: &Segment, map: impl Fn(Point) -> Point) -> Segment {
    match *segment {
        Segment::Line { start, end } => Segment::line(map(start), map(end)),
        Segment::Arc { start, end, center, ccw } => {
            Segment::Arc { start: map(start), end: map(end), center: map(center), ccw }
        }
    }
}

/// Angle between the two straight edges that cut, radians; π without them.
pub(super) fn corner(cutting: &Contour) -> f64 {
    let mut lines = cutting.segments.iter().filter(|s| matches!(s, Segment::Line { .. }));
    let (Some(first), Some(last)) = (lines.next(), lines.next_back()) else { return PI };
    let (a, b) = (first.direction_at(0.0), -last.direction_at(0.0));
    a.dot(&b).clamp(-1.0, 1.0).acos()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    #[test]
    fn what_is_behind_the_edge_is_not_ahead() {
        let tool = Catalog::shipped().tool("orac-right").unwrap().outline();
        let lead = Lead::of(&tool);
        assert!(lead.covers(Point::new(0.6, 2.5)) && lead.covers(Point::new(1.05, 10.0)));
        assert!(!lead.covers(Point::new(2.0, 13.0)), "above the edge");
        assert!(!lead.covers(Point::new(-1.0, 5.0)), "in front of it");
        let shape = ahead(&tool);
        assert!(shape.top(f64::NEG_INFINITY) < -10.0, "{}", shape.top(f64::NEG_INFINITY));
    }

    #[test]
    fn a_level_side_counts_with_its_place() {
        let p = Point::new;
        assert_eq!(at_height(&Segment::line(p(1.0, 2.0), p(-3.0, 2.0)), 2.0), Some(-3.0));
        assert_eq!(turned_over(p(1.0, 5.0), p(1.0, 9.0)).pieces, [Piece::level(-1.001, -0.999, -5.0)]);
    }
}
