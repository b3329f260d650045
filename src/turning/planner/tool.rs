//! A tool as the planner sees it: what it is for, what it touches with and what it leaves.

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
    /// Nose radius, mm.
    pub(super) nose: f64,
    /// Where the lowest stretch of the edge begins and ends, from the programmed point, mm.
    pub(super) bottom: (f64, f64),
    /// Where insert and holder begin and end, mm.
    pub(super) extent: (f64, f64),
    /// Insert and holder turned over, with the distance that the holder keeps.
    pub(super) body: Shape,
    /// The insert turned over.
    pub(super) insert: Shape,
    /// The insert with its radius turned over.
    pub(super) edge: Shape,
}

/// Distance that a holder, and an edge that cannot cut, keeps from the work, mm: holders are made to tenths.
pub(super) const HOLDER_CLEARANCE_MM: f64 = 0.1;

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
        Some(Self {
            station,
            r#use,
            nose: outline.nose_radius,
            bottom,
            extent: (whole.min.z, whole.max.z),
            body: insert.clone().and(grown(&outline.holder)).and(grown(&back(outline))),
            insert,
            edge: Shape::of([&outline.insert], Turn::Radius),
        })
    }

    /// How far the rounded edge lies beside the programmed point, mm.
    pub(super) fn contact(&self) -> (f64, f64) {
        (self.bottom.0 - self.nose, self.bottom.1 + self.nose)
    }
}

/// A contour turned over, with the distance that it keeps from the work.
fn grown(contour: &Contour) -> Shape {
    Shape::grown(contour, Turn::Both, HOLDER_CLEARANCE_MM)
}

/// The edges of the insert that cannot cut.
fn back(outline: &ToolOutline) -> Contour {
    let edges = outline.insert.segments.iter().zip(&outline.cutting);
    Contour::new(edges.filter(|(_, cuts)| !**cuts).map(|(segment, _)| *segment).collect())
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

    #[test]
    fn the_shipped_tools_are_known_by_their_kind_and_orientation() {
        let catalog = Catalog::shipped();
        let cutter = |id: &str| Cutter::new(1, &catalog.tool(id).unwrap().outline()).unwrap();
        assert_eq!(cutter("orac-right").r#use, Use::Right);
        assert_eq!(cutter("orac-left").r#use, Use::Left);
        assert_eq!(cutter("orac-thread").r#use, Use::Thread);
        assert_eq!(cutter("orac-part-off").r#use, Use::Blade { width: 3.0 });
        let right = cutter("orac-right");
        assert!((right.nose - 0.2).abs() < 1e-9 && (right.bottom.0 - 0.2).abs() < 1e-9);
        assert!(right.contact().0.abs() < 1e-9 && (right.contact().1 - 0.4).abs() < 1e-9);
    }
}
