//! The true outline of a tool: insert with nose arcs, and holder.

mod build;
mod holder;
mod insert;

#[cfg(test)]
mod properties;

use super::{Catalog, Hand, Machine, Tool, ToolMaterial};
use crate::geometry::{Contour, Point, Segment};
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
    /// What its edge is made of.
    #[serde(default)]
    pub edge: ToolMaterial,
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
    /// Of drills: depth of a hole in diameters from which on the drill is drawn out again and again to clear its chips; 0 where
    /// nothing is known, which stands for [`PECKS_FROM`](super::PECKS_FROM).
    #[serde(default)]
    pub pecks_from: f64,
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
    /// The tool's outline in tool space: closed, counter-clockwise, nose arcs exact. A tool with codes that are not
    /// understood, which no catalog holds, has none.
    #[must_use]
    pub fn outline(&self) -> ToolOutline {
        let built = ToolOutline { edge: self.edge, ..build::built(self).unwrap_or_default() };
        let holder = self.own_holder();
        if holder.is_empty() { built } else { ToolOutline { holder: Contour::polygon(&holder), ..built } }
    }

    /// The holder that the tool's file gives point by point or line by line.
    fn own_holder(&self) -> Vec<Point> {
        let lines = self.interference_lines.iter().flat_map(|&[z1, r1, z2, r2]| [[z1, r1], [z2, r2]]);
        let points = self.holder.iter().copied().chain(lines);
        let mut points: Vec<Point> = points.map(|[z, r]| Point::new(z, r)).collect();
        points.dedup();
        if points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        points
    }
}

impl ToolOutline {
    /// The tool for the other hand: mirrored at the programmed point along the spindle.
    #[must_use]
    pub(super) fn other_hand(&self) -> Self {
        let orientation = match self.orientation {
            1 => 2,
            2 => 1,
            3 => 4,
            4 => 3,
            5 => 7,
            7 => 5,
            other => other,
        };
        let nose_center = self.nose_center.mirrored_at_z(0.0);
        self.mapped(|s| s.mirrored_at_z(0.0), nose_center, orientation)
    }

    /// The tool upside down, as it works in a bore.
    #[must_use]
    pub fn upside_down(&self) -> Self {
        let orientation = match self.orientation {
            1 => 4,
            2 => 3,
            3 => 2,
            4 => 1,
            6 => 8,
            8 => 6,
            other => other,
        };
        let over = |p: Point| Point::new(p.z, -p.r);
        let segment = |s: &Segment| match *s {
            Segment::Line { start, end } => Segment::line(over(start), over(end)),
            Segment::Arc { start, end, center, ccw } => {
                Segment::Arc { start: over(start), end: over(end), center: over(center), ccw: !ccw }
            }
        };
        self.mapped(segment, over(self.nose_center), orientation)
    }

    /// A mirror image, again counter-clockwise.
    fn mapped(&self, map: impl Fn(&Segment) -> Segment, nose_center: Point, orientation: u8) -> Self {
        let mirrored = |contour: &Contour| Contour::new(contour.segments.iter().map(&map).collect()).reversed();
        Self {
            insert: mirrored(&self.insert),
            holder: mirrored(&self.holder),
            kind: self.kind,
            edge: self.edge,
            nose_radius: self.nose_radius,
            nose_center,
            orientation,
            cutting: self.cutting.iter().rev().copied().collect(),
            pecks_from: self.pecks_from,
        }
    }

    fn of_hand(self, hand: Hand) -> Self {
        match hand {
            Hand::Right => self,
            Hand::Left => self.other_hand(),
        }
    }
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
        assert_eq!(right.other_hand().insert, left.insert);
        let points = |c: &Contour| {
            let mut p: Vec<_> = c.segments.iter().map(Segment::start).map(|p| (p.z.to_bits(), p.r.to_bits())).collect();
            p.sort_unstable();
            p
        };
        assert_eq!(points(&right.other_hand().holder), points(&left.holder));
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
