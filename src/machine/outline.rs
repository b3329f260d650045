//! The true outline of a tool: insert with nose arcs, and holder.

use super::{Catalog, Hand, Machine, Tool, ToolOutline, ToolShape};
use crate::geometry::{Contour, Point, Segment, Vector};
use std::collections::BTreeMap;

/// The outline of every tool in the machine's turret, by station. A station whose tool is not in the catalog has none.
#[must_use]
pub fn outlines(machine: &Machine, catalog: &Catalog) -> BTreeMap<u32, ToolOutline> {
    let stations = machine.tools.iter();
    stations.filter_map(|t| Some((t.station, catalog.tool(&t.tool)?.outline()))).collect()
}

impl Tool {
    /// The tool's outline in tool space: closed, counter-clockwise, nose arcs exact.
    #[must_use]
    pub fn outline(&self) -> ToolOutline {
        let holder: Vec<Point> = self.holder.iter().map(|&[z, r]| Point::new(z, r)).collect();
        ToolOutline { insert: self.shape.insert(), holder: Contour::polygon(&holder) }
    }
}

impl ToolShape {
    fn insert(&self) -> Contour {
        match *self {
            Self::Turning { hand, nose_radius, corner_angle, approach_angle, edge_length } => {
                let right = right_hand_insert(nose_radius, corner_angle, approach_angle, edge_length);
                match hand {
                    Hand::Right => right,
                    Hand::Left => mirrored(&right),
                }
            }
            Self::Threading { nose_radius, corner_angle, edge_length } => {
                threading_insert(nose_radius, corner_angle, edge_length)
            }
            Self::Parting { width, nose_radius, depth } => parting_blade(width, nose_radius, depth),
        }
    }
}

/// A rhombic insert whose leading edge faces the chuck. The nose touches z = 0 and r = 0.
///
/// The leading edge stands at the approach angle to the direction of feed (−z); the trailing edge lies one corner angle
/// behind it.
fn right_hand_insert(nose_radius: f64, corner_angle: f64, approach_angle: f64, edge_length: f64) -> Contour {
    let leading_angle = (180.0 - approach_angle).to_radians();
    let trailing_angle = leading_angle - corner_angle.to_radians();
    let nose = Point::new(nose_radius, nose_radius);
    let (leading, trailing) = (direction(leading_angle), direction(trailing_angle));
    let corner = sharp_corner(nose, nose_radius, leading_angle, trailing_angle);
    let (leading_end, trailing_end) = (corner + leading * edge_length, corner + trailing * edge_length);
    let back = leading_end + trailing * edge_length;
    let mut segments = vec![nose_arc(nose, nose_radius, leading_angle, trailing_angle)];
    close_through(&mut segments, &[trailing_end, back, leading_end]);
    Contour::new(segments)
}

/// A triangular insert, symmetrical about the radial line through its lowest point, the origin.
fn threading_insert(nose_radius: f64, corner_angle: f64, edge_length: f64) -> Contour {
    let half = corner_angle.to_radians() / 2.0;
    let (left, right) = (std::f64::consts::FRAC_PI_2 + half, std::f64::consts::FRAC_PI_2 - half);
    let nose = Point::new(0.0, nose_radius);
    let corner = sharp_corner(nose, nose_radius, left, right);
    let mut segments = vec![nose_arc(nose, nose_radius, left, right)];
    close_through(&mut segments, &[corner + direction(right) * edge_length, corner + direction(left) * edge_length]);
    Contour::new(segments)
}

/// A blade from the origin to `width` and `depth` with two rounded corners at its edge.
fn parting_blade(width: f64, nose_radius: f64, depth: f64) -> Contour {
    let (left, right) = (Point::new(nose_radius, nose_radius), Point::new(width - nose_radius, nose_radius));
    let up = std::f64::consts::FRAC_PI_2;
    let mut segments = vec![nose_arc(left, nose_radius, up, 0.0)];
    let right_arc = nose_arc(right, nose_radius, std::f64::consts::PI, up);
    segments.push(Segment::line(segments[0].end(), right_arc.start()));
    segments.push(right_arc);
    close_through(&mut segments, &[Point::new(width, depth), Point::new(0.0, depth)]);
    Contour::new(segments)
}

/// The nose arc that joins an edge leaving at `left_angle` (on its left) to one leaving at `right_angle`, both measured
/// from +z and pointing away from the nose; counter-clockwise along the underside.
fn nose_arc(center: Point, radius: f64, left_angle: f64, right_angle: f64) -> Segment {
    let start = center + direction(left_angle + std::f64::consts::FRAC_PI_2) * radius;
    let end = center + direction(right_angle - std::f64::consts::FRAC_PI_2) * radius;
    Segment::Arc { start, end, center, ccw: true }
}

/// Where the two edges beside a nose would meet: `radius / sin(half the corner)` from the centre, against their bisector.
fn sharp_corner(center: Point, radius: f64, left_angle: f64, right_angle: f64) -> Point {
    let half = (left_angle - right_angle) / 2.0;
    center - direction(f64::midpoint(left_angle, right_angle)) * (radius / half.sin())
}

fn direction(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// Adds lines from the last segment through `points` back to the first segment.
fn close_through(segments: &mut Vec<Segment>, points: &[Point]) {
    let (Some(first), Some(last)) = (segments.first().map(Segment::start), segments.last().map(Segment::end)) else {
        return;
    };
    let mut from = last;
    for &to in points.iter().chain([&first]) {
        segments.push(Segment::line(from, to));
        from = to;
    }
}

/// The mirror image at z = 0, again counter-clockwise.
fn mirrored(contour: &Contour) -> Contour {
    Contour::new(contour.segments.iter().map(|s| s.mirrored_at_z(0.0)).collect::<Vec<_>>()).reversed()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Bounds;

    /// Largest arc deviation of the polygons that the tests look at, mm.
    const FINE: f64 = 1e-4;

    fn shipped(id: &str) -> ToolOutline {
        Catalog::shipped().tool(id).unwrap().outline()
    }

    fn area(points: &[Point]) -> f64 {
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).map(|(a, b)| a.z * b.r - b.z * a.r).sum::<f64>() / 2.0
    }

    fn assert_closed_and_counter_clockwise(contour: &Contour) {
        assert!(contour.largest_gap() < 1e-12);
        let (first, last) = (contour.segments.first().unwrap(), contour.segments.last().unwrap());
        assert!(first.start().distance(last.end()) < 1e-12);
        assert!(area(&contour.polyline(FINE)) > 0.0);
    }

    #[test]
    fn every_shipped_outline_is_closed_and_counter_clockwise() {
        let catalog = Catalog::shipped();
        let outlines = outlines(catalog.machine("orac").unwrap(), &catalog);
        assert_eq!(outlines.keys().copied().collect::<Vec<_>>(), [1, 2, 3, 4]);
        for outline in outlines.values() {
            assert_closed_and_counter_clockwise(&outline.insert);
            assert_closed_and_counter_clockwise(&outline.holder);
        }
    }

    #[test]
    fn noses_touch_the_axes_of_tool_space() {
        let bounds = |id| shipped(id).insert.bounds().unwrap();
        for id in ["orac-right", "orac-left", "orac-thread", "orac-part-off"] {
            assert!(bounds(id).min.r.abs() < 1e-12, "{id}: {:?}", bounds(id));
        }
        assert!(bounds("orac-right").min.z.abs() < 1e-12);
        assert!(bounds("orac-left").max.z.abs() < 1e-12);
        assert!(bounds("orac-part-off").min.z.abs() < 1e-12);
    }

    #[test]
    fn right_hand_insert_is_a_35_degree_rhombus_of_11_mm_at_93_degrees() {
        let insert = shipped("orac-right").insert;
        let [arc, trailing, .., leading] = insert.segments.as_slice() else { panic!("{insert:?}") };
        assert!((arc.radius().unwrap() - 0.2).abs() < 1e-12);
        assert!((arc.sweep().to_degrees() - 145.0).abs() < 1e-9);
        let angle = |s: &Segment| {
            let d = s.direction_at(0.5);
            d.y.atan2(d.x).to_degrees()
        };
        assert!((angle(&leading.reversed()) - 87.0).abs() < 1e-9);
        assert!((angle(trailing) - 52.0).abs() < 1e-9);
        assert!((insert.segments[2].length() - 11.0).abs() < 1e-9);
        // Edges join the nose without a kink.
        assert!((arc.direction_at(1.0) - trailing.direction_at(0.0)).norm() < 1e-9);
    }

    #[test]
    fn left_hand_tool_is_the_mirror_image() {
        let (right, left) = (shipped("orac-right"), shipped("orac-left"));
        assert_eq!(mirrored(&right.insert), left.insert);
        let points = |c: &Contour| {
            let mut p: Vec<_> = c.segments.iter().map(Segment::start).map(|p| (p.z.to_bits(), p.r.to_bits())).collect();
            p.sort_unstable();
            p
        };
        assert_eq!(points(&mirrored(&right.holder)), points(&left.holder));
    }

    /// Height of the wall that the right-hand tool must clear: the radius of a common bar, mm.
    const WALL: f64 = 13.0;

    #[test]
    fn right_hand_tool_clears_a_square_wall_and_a_45_degree_line() {
        let ToolOutline { insert, holder } = shipped("orac-right");
        for p in holder.polyline(FINE) {
            assert!(p.r > WALL || p.z > 0.5, "holder at {p:?} is too near the wall at z = 0");
            assert!(p.r > WALL || p.r - p.z > 0.5, "holder at {p:?} is too near the 45-degree line");
        }
        // The nose itself reaches beyond the line by its radius; the flank behind it does not.
        for p in insert.polyline(FINE) {
            assert!(p.z >= -1e-12);
            assert!(p.r > WALL || (p.z - p.r) / 2.0_f64.sqrt() <= 0.2 + 1e-9, "insert at {p:?}");
        }
    }

    #[test]
    fn parting_blade_is_3_mm_wide_and_reaches_the_centre_of_the_largest_bar() {
        let ToolOutline { insert, holder } = shipped("orac-part-off");
        let Bounds { min, max } = insert.bounds().unwrap();
        assert_eq!((min.z, max.z), (0.0, 3.0));
        assert!(max.r >= 20.0 && holder.bounds().unwrap().min.r >= 20.0);
    }
}
