//! A tool as the planner sees it: what it is for, what it touches with and what it leaves.

use super::guard;
use super::outline::Turn;
use super::shape::Shape;
use crate::geometry::{Contour, Segment};
use crate::machine::{ToolKind, ToolOutline};

/// What a tool is for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Use {
    /// Turning, the body of the insert on the side away from the chuck.
    Right,
    /// Turning, the body of the insert on the side of the chuck.
    Left,
    /// Plunging with an edge of this width, mm.
    Blade {
        /// Width of the edge.
        width: f64,
    },
    /// Threads.
    Thread,
}

/// A tool in its station.
#[derive(Debug, Clone)]
pub(super) struct Cutter {
    pub(super) station: u32,
    pub(super) r#use: Use,
    /// True if z is turned round: a tool that cuts away from the headstock is planned like one that cuts towards it, seen
    /// from the other end.
    pub(super) turned: bool,
    /// Nose radius, mm.
    pub(super) nose: f64,
    /// Where the lowest stretch of the edge begins and ends, from the programmed point, mm.
    pub(super) bottom: (f64, f64),
    /// Where insert and holder begin and end, with the distance that they keep, mm.
    pub(super) extent: (f64, f64),
    /// Lowest place of the insert over the programmed point, mm: 0, but negative for drills.
    pub(super) low: f64,
    /// Insert and holder turned over, with the distance that the holder keeps.
    pub(super) body: Shape,
    /// The insert turned over.
    pub(super) insert: Shape,
    /// The insert with its radius turned over.
    pub(super) edge: Shape,
    /// The upper side of the insert.
    pub(super) top: Shape,
    /// The upper side of insert and holder.
    pub(super) whole: Shape,
    /// The lower side of insert and holder, with the radius turned over.
    pub(super) below: Shape,
    /// The edges that cut with their radius turned over.
    pub(super) cutting: Shape,
    /// Holder and edges that cannot cut turned over, with the distance that they keep.
    pub(super) guard: Shape,
    /// What of them meets stock before an edge does when the tool travels towards the chuck, turned over.
    pub(super) ahead: Shape,
    /// Lowest places of `guard` and `ahead` over the programmed point, mm.
    pub(super) guard_low: f64,
    pub(super) ahead_low: f64,
    /// How deep the tool may cut, mm: the height of its edge over the nose; infinite without a side that cannot cut.
    pub(super) reach: f64,
    /// True if the edge leaves a square shoulder where the tool stops.
    pub(super) square: bool,
    /// Angle between the edges beside the nose, radians; π of a disc.
    pub(super) corner: f64,
}

/// Distance that a holder keeps from the work, mm: holders are made to tenths.
pub(super) const HOLDER_CLEARANCE_MM: f64 = 0.1;

/// Distance that an edge that cannot cut keeps from the work, mm: inserts are made to hundredths.
const BACK_CLEARANCE_MM: f64 = 0.01;

/// An edge that cannot cut counts from where it has fallen back behind the one that cuts by the distance that it keeps; this is
/// the longest way to there, mm, that of an edge which leans by 2 degrees only.
const BEHIND_EDGE_MM: f64 = 0.3;

/// How much further than just behind a cutting edge it is: the end of that edge cuts, too. What stock the part that does not count
/// may meet grows with the square of this: 0.0005 mm² where the outline turns by 20 degrees, as at the blunt corners of a trigon.
const WELL_BEHIND: f64 = 2.5;

/// Edges that rise less than this over their length lie level, mm.
const LEVEL_MM: f64 = 1e-6;

impl Cutter {
    /// The tool of a station; `None` if it has no outline or works inside.
    pub(super) fn new(station: u32, outline: &ToolOutline) -> Option<Self> {
        let bounds = outline.insert.bounds()?;
        let whole = outline.holder.bounds().map_or(bounds, |h| h.union(bounds));
        let bottom = bottom(&outline.insert, bounds.min.r)?;
        let r#use = match outline.kind {
            ToolKind::Turning if outline.cuts_towards_headstock() => Use::Right,
            ToolKind::Turning => Use::Left,
            ToolKind::Grooving => Use::Blade { width: bounds.max.z - bounds.min.z },
            ToolKind::Threading => Use::Thread,
            ToolKind::Boring | ToolKind::BoreGrooving | ToolKind::BoreThreading | ToolKind::Drill => return None,
        };
        let insert = Shape::of([&outline.insert], Turn::Both);
        let back = Shape::grown(&behind(outline), Turn::Both, BACK_CLEARANCE_MM);
        let guard = Shape::grown(&outline.holder, Turn::Both, HOLDER_CLEARANCE_MM).and(back);
        let ahead = guard::ahead(outline);
        let cutting = edges(outline, true);
        let square = cutting.bounds().is_none_or(|b| b.min.z >= bottom.0 - outline.nose_radius - LEVEL_MM);
        Some(Self {
            station,
            r#use,
            turned: false,
            nose: outline.nose_radius,
            bottom,
            extent: (whole.min.z - HOLDER_CLEARANCE_MM, whole.max.z + HOLDER_CLEARANCE_MM),
            low: bounds.min.r,
            body: insert.clone().and(guard.clone()),
            insert,
            edge: Shape::of([&outline.insert], Turn::Radius),
            top: Shape::of([&outline.insert], Turn::None),
            whole: Shape::of([&outline.insert, &outline.holder], Turn::None),
            below: Shape::of([&outline.insert, &outline.holder], Turn::Radius),
            cutting: Shape::of([&cutting], Turn::Radius),
            guard_low: -guard.top(f64::NEG_INFINITY),
            ahead_low: -ahead.top(f64::NEG_INFINITY),
            guard,
            // A sleeve far behind does not matter.
            reach: -ahead.top(-bounds.max.z),
            ahead,
            square,
            corner: guard::corner(&cutting),
        })
    }

    /// The tool seen from the other end of the machine.
    pub(super) fn turned(station: u32, outline: &ToolOutline) -> Option<Self> {
        let orientation = match outline.orientation {
            1 => 2,
            2 => 1,
            3 => 4,
            4 => 3,
            5 => 7,
            7 => 5,
            other => other,
        };
        let seen = ToolOutline {
            insert: turned_round(&outline.insert),
            holder: turned_round(&outline.holder),
            nose_center: outline.nose_center.mirrored_at_z(0.0),
            orientation,
            cutting: outline.cutting.iter().rev().copied().collect(),
            ..outline.clone()
        };
        Some(Self { turned: true, ..Self::new(station, &seen)? })
    }

    /// How far the rounded edge lies beside the programmed point, mm.
    pub(super) fn contact(&self) -> (f64, f64) {
        (self.bottom.0 - self.nose, self.bottom.1 + self.nose)
    }
}

/// The contour with z turned round, again counter-clockwise.
fn turned_round(contour: &Contour) -> Contour {
    Contour::new(contour.segments.iter().rev().map(|s| s.mirrored_at_z(0.0).reversed()).collect())
}

/// The edges that cannot cut, from where they have fallen back behind those that cut.
fn behind(outline: &ToolOutline) -> Contour {
    let segments = &outline.insert.segments;
    let count = segments.len().max(1);
    let cuts = |k: usize| outline.cutting.get(k % count).copied().unwrap_or(false);
    let at = |k: usize| segments.get(k % count);
    let fallen = |a: &Segment, b: &Segment| {
        let turn = a.direction_at(1.0).perp(&b.direction_at(0.0)).abs();
        (WELL_BEHIND * BACK_CLEARANCE_MM / turn).min(BEHIND_EDGE_MM)
    };
    let back = segments.iter().enumerate().filter(|&(k, _)| !cuts(k)).map(|(k, s)| {
        let before = at(k + count - 1).filter(|_| cuts(k + count - 1)).map_or(0.0, |a| fallen(a, s));
        let after = at(k + 1).filter(|_| cuts(k + 1)).map_or(0.0, |b| fallen(s, b));
        let (from, to) = (before / s.length(), 1.0 - after / s.length());
        match *s {
            Segment::Line { .. } if from < to => Segment::line(s.point_at(from), s.point_at(to)),
            _ => *s,
        }
    });
    Contour::new(back.collect())
}

/// The edges of the insert that cut, or those that cannot.
pub(super) fn edges(outline: &ToolOutline, that_cut: bool) -> Contour {
    let edges = outline.insert.segments.iter().zip(&outline.cutting);
    Contour::new(edges.filter(|(_, cuts)| **cuts == that_cut).map(|(segment, _)| *segment).collect())
}

/// Where the outline is lowest.
fn bottom(insert: &Contour, lowest: f64) -> Option<(f64, f64)> {
    let low = insert.segments.iter().filter(|s| s.bounds().min.r <= lowest + LEVEL_MM);
    let ends = low.map(|s| match *s {
        Segment::Arc { center, .. } => (center.z, center.z),
        Segment::Line { start, end } => match (start.r <= lowest + LEVEL_MM, end.r <= lowest + LEVEL_MM) {
            (true, false) => (start.z, start.z),
            (false, true) => (end.z, end.z),
            _ => (start.z.min(end.z), start.z.max(end.z)),
        },
    });
    ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    fn cutter(id: &str) -> Cutter {
        Cutter::new(1, &Catalog::shipped().tool(id).unwrap().outline()).unwrap()
    }

    #[test]
    fn the_shipped_tools_are_known_by_their_kind_and_orientation() {
        assert_eq!(cutter("orac-right").r#use, Use::Right);
        assert_eq!(cutter("orac-left").r#use, Use::Left);
        assert_eq!(cutter("orac-thread").r#use, Use::Thread);
        assert_eq!(cutter("orac-part-off").r#use, Use::Blade { width: 3.0 });
        let right = cutter("orac-right");
        assert!((right.nose - 0.2).abs() < 1e-9 && (right.bottom.0 - 0.2).abs() < 1e-9);
        assert!(right.contact().0.abs() < 1e-9 && (right.contact().1 - 0.4).abs() < 1e-9);
    }

    #[test]
    fn a_tool_reaches_as_deep_as_its_edge_is_high() {
        let right = cutter("orac-right");
        assert!((10.0..=11.0).contains(&right.reach) && right.square, "{}", right.reach);
        assert!((right.corner.to_degrees() - 35.0).abs() < 1e-6, "{}", right.corner.to_degrees());
        let button = cutter("6t-button-5");
        assert!((button.reach - 2.5).abs() < 0.01, "{}", button.reach);
        let blade = cutter("orac-part-off");
        assert!((blade.reach - 0.1).abs() < 0.02, "its sides do not cut: {}", blade.reach);
        assert!(!cutter("6t-copy-70").square);
    }

    #[test]
    fn a_left_hand_tool_seen_from_the_other_end_is_a_right_hand_one() {
        let left = Cutter::turned(1, &Catalog::shipped().tool("orac-left").unwrap().outline()).unwrap();
        let right = cutter("orac-right");
        assert!(left.turned && left.r#use == Use::Right);
        assert!((left.reach - right.reach).abs() < 1e-9 && (left.bottom.0 - right.bottom.0).abs() < 1e-9);
    }
}
