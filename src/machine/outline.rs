//! The true outline of a tool: insert with nose arcs, and holder.

use super::{Catalog, Hand, Machine, Tool, ToolShape};
use crate::geometry::{Contour, Point, Segment, Vector};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The true outline of a tool in tool space, closed, counter-clockwise, mm, and what is to be known for cutting with it.
///
/// Tool space: the origin is the point that the program moves; `z` and `r` as in part space.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ToolOutline {
    /// The cutting insert or blade.
    pub insert: Contour,
    /// Everything else that moves with it and must touch nothing.
    pub holder: Contour,
    /// What the tool is for.
    #[serde(default)]
    pub kind: ToolKind,
    /// Nose radius, mm; 0 for a sharp corner.
    #[serde(default)]
    pub nose_radius: f64,
    /// Centre of the nose in tool space; of a blade the nose towards the chuck.
    #[serde(default)]
    pub nose_center: Point,
    /// Tip orientation 1 to 9 as controls number it for a turret behind the axis: where the programmed point lies, seen from
    /// the centre of the nose, with z to the right and r upwards. 1 right above, 2 left above, 3 left below, 4 right below,
    /// 5 left, 6 above, 7 right, 8 below, 9 at the centre itself.
    #[serde(default)]
    pub orientation: u8,
    /// For every segment of [`Self::insert`]: it is an edge that cuts.
    #[serde(default)]
    pub cutting: Vec<bool>,
}

/// What a tool is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ToolKind {
    /// Turning outside along the contour, with a pointed or a round insert.
    #[default]
    Turning,
    /// Grooving and parting off outside.
    Grooving,
    /// Threads outside.
    Threading,
    /// Turning a bore.
    Boring,
    /// Grooves in a bore.
    BoreGrooving,
    /// Threads in a bore.
    BoreThreading,
    /// Drilling on the axis.
    Drill,
}

impl ToolKind {
    /// Works in a bore or makes it.
    #[must_use]
    pub const fn is_inside(self) -> bool {
        matches!(self, Self::Boring | Self::BoreGrooving | Self::BoreThreading | Self::Drill)
    }

    /// Follows a contour: turning or boring.
    #[must_use]
    pub const fn follows_contours(self) -> bool {
        matches!(self, Self::Turning | Self::Boring)
    }
}

impl ToolOutline {
    /// Cuts while it travels along the contour towards the headstock.
    #[must_use]
    pub const fn cuts_towards_headstock(&self) -> bool {
        self.kind.follows_contours() && !matches!(self.orientation, 1 | 4 | 7)
    }

    /// Cuts while it travels along the contour away from the headstock.
    #[must_use]
    pub const fn cuts_away_from_headstock(&self) -> bool {
        self.kind.follows_contours() && !matches!(self.orientation, 2 | 3 | 5)
    }

    /// Cuts the free end's face while it travels towards the axis.
    #[must_use]
    pub const fn cuts_face(&self) -> bool {
        matches!(self.kind, ToolKind::Turning | ToolKind::Grooving) && matches!(self.orientation, 3 | 5 | 8 | 9)
    }

    /// Every edge that cuts.
    pub fn cutting_edges(&self) -> impl Iterator<Item = &Segment> {
        self.insert.segments.iter().zip(&self.cutting).filter(|(_, cuts)| **cuts).map(|(segment, _)| segment)
    }
}

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
        let insert = self.shape.insert();
        let (kind, orientation) = match self.shape {
            ToolShape::Turning { hand: Hand::Right, .. } => (ToolKind::Turning, 3),
            ToolShape::Turning { hand: Hand::Left, .. } => (ToolKind::Turning, 4),
            ToolShape::Threading { .. } => (ToolKind::Threading, 8),
            ToolShape::Parting { .. } => (ToolKind::Grooving, 3),
        };
        let (nose_radius, nose_center) = match insert.segments.first() {
            Some(&Segment::Arc { start, center, .. }) => (start.distance(center), center),
            _ => (0.0, Point::default()),
        };
        let cutting = cutting(&insert, kind);
        ToolOutline { insert, holder: Contour::polygon(&holder), kind, nose_radius, nose_center, orientation, cutting }
    }
}

/// The nose and the edges beside it; of a blade its front edge with both noses. The nose is the first segment.
fn cutting(insert: &Contour, kind: ToolKind) -> Vec<bool> {
    let count = insert.segments.len();
    let rounded = matches!(insert.segments.first(), Some(Segment::Arc { .. }));
    let front = match kind {
        ToolKind::Grooving if rounded => 3,
        ToolKind::Grooving => 1,
        _ => 2,
    };
    (0..count).map(|i| i < front || (kind != ToolKind::Grooving && i + 1 == count)).collect()
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
    if nose_radius == 0.0 {
        let corners = [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)];
        return Contour::polygon(&corners.map(|(z, r)| Point::new(z, r)));
    }
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
        let ToolOutline { insert, holder, .. } = shipped("orac-right");
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
        let ToolOutline { insert, holder, .. } = shipped("orac-part-off");
        let Bounds { min, max } = insert.bounds().unwrap();
        assert_eq!((min.z, max.z), (0.0, 3.0));
        assert!(max.r >= 20.0 && holder.bounds().unwrap().min.r >= 20.0);
    }
}
