//! From which side the work is cut: from outside, or from inside a bore.
//!
//! A bore is planned as if it were an outside: its radius is counted from a line that lies beyond the bar, so that the wall of
//! the bore is a surface which tools meet from above, the axis lies above everything, and a boring bar is a turning tool.

use crate::geometry::{Contour, Point, Segment};
use crate::machine::{ToolKind, ToolOutline};
use crate::part::ThreadSpec;
use crate::turning::{CutMove, Operation, OperationKind, Recipe, RecipeKind, ThreadRecipe};

/// How the planner's radii relate to those of the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Side {
    /// They are the same.
    Outside,
    /// They count from the line at this radius of the part towards the axis, mm.
    Inside {
        /// Radius of that line, beyond the bar.
        from: f64,
    },
}

impl Side {
    /// Radius of the part for a radius of the planner, mm, and the other way round.
    pub(super) fn radius(self, r: f64) -> f64 {
        match self {
            Self::Outside => r,
            Self::Inside { from } => from - r,
        }
    }

    /// Point of the part for a point of the planner, and the other way round.
    pub(super) fn point(self, p: Point) -> Point {
        Point::new(p.z, self.radius(p.r))
    }

    /// The segment on the other's radii.
    pub(super) fn segment(self, segment: &Segment) -> Segment {
        match *segment {
            Segment::Line { start, end } => Segment::line(self.point(start), self.point(end)),
            Segment::Arc { start, end, center, ccw } => Segment::Arc {
                start: self.point(start),
                end: self.point(end),
                center: self.point(center),
                ccw: ccw == (self == Self::Outside),
            },
        }
    }

    /// A closed, counter-clockwise contour on the other's radii, again counter-clockwise.
    pub(super) fn contour(self, contour: &Contour) -> Contour {
        let turned = Contour::new(contour.segments.iter().map(|s| self.segment(s)).collect());
        if self == Self::Outside { turned } else { turned.reversed() }
    }

    /// What a kind of operation is called on this side.
    pub(super) const fn kind(self, kind: OperationKind) -> OperationKind {
        match (self, kind) {
            (Self::Inside { .. }, OperationKind::RoughRight | OperationKind::RoughLeft) => OperationKind::RoughBore,
            (Self::Inside { .. }, OperationKind::FinishRight | OperationKind::FinishLeft) => OperationKind::FinishBore,
            (Self::Inside { .. }, OperationKind::Thread) => OperationKind::ThreadBore,
            _ => kind,
        }
    }

    /// A tool as the planner meets it on this side; `None` if it does not work there. Drills count as tools for bores.
    pub(super) fn tool(self, outline: &ToolOutline) -> Option<ToolOutline> {
        if outline.kind.is_inside() == (self == Self::Outside) {
            return None;
        }
        let kind = match outline.kind {
            ToolKind::Boring | ToolKind::Drill => ToolKind::Turning,
            ToolKind::BoreGrooving => ToolKind::Grooving,
            ToolKind::BoreThreading => ToolKind::Threading,
            outside => return Some(ToolOutline { kind: outside, ..outline.clone() }),
        };
        Some(ToolOutline { kind, ..outline.upside_down() })
    }

    /// A thread on the planner's radii.
    pub(super) fn thread(self, spec: &ThreadSpec) -> ThreadSpec {
        let (crest_radius, base_radius) = (self.radius(spec.crest_radius), self.radius(spec.base_radius));
        ThreadSpec { crest_radius, base_radius, ..*spec }
    }

    /// An operation on the part's radii.
    pub(super) fn operation(self, operation: Operation) -> Operation {
        let moves = operation.moves.into_iter().map(|m| self.cut_move(m)).collect();
        let recipes = operation.recipes.into_iter().map(|r| self.recipe(r)).collect();
        Operation { moves, recipes, change: operation.change.map(|p| self.point(p)), ..operation }
    }

    fn recipe(self, recipe: Recipe) -> Recipe {
        let kind = match recipe.kind {
            RecipeKind::Thread(thread) => RecipeKind::Thread(ThreadRecipe {
                crest_radius: self.radius(thread.crest_radius),
                root_radius: self.radius(thread.root_radius),
                ..thread
            }),
            other => other,
        };
        Recipe { kind, ..recipe }
    }

    fn cut_move(self, cut_move: CutMove) -> CutMove {
        match cut_move {
            CutMove::Rapid { to } => CutMove::Rapid { to: self.point(to) },
            CutMove::Line { to, cut } => CutMove::Line { to: self.point(to), cut },
            CutMove::Arc { to, center, ccw, cut } => CutMove::Arc {
                to: self.point(to),
                center: self.point(center),
                ccw: ccw == (self == Self::Outside),
                cut,
            },
            CutMove::Thread { to_z, outside_radius, base_radius, pitch, depth_per_cut, rpm } => CutMove::Thread {
                to_z,
                outside_radius: self.radius(outside_radius),
                base_radius: self.radius(base_radius),
                pitch,
                depth_per_cut,
                rpm,
            },
            CutMove::ThreadPass { to, lead, start_deg, rpm } => {
                CutMove::ThreadPass { to: self.point(to), lead, start_deg, rpm }
            }
            CutMove::Dwell { seconds } => CutMove::Dwell { seconds },
            CutMove::Repeat { count, step, body } => {
                let step = if self == Self::Outside { step } else { crate::geometry::Vector::new(step.x, -step.y) };
                CutMove::Repeat { count, step, body: body.into_iter().map(|m| self.cut_move(m)).collect() }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    #[test]
    fn a_boring_bar_seen_from_inside_is_a_right_hand_turning_tool() {
        let catalog = Catalog::shipped();
        let bar = catalog.tool("bore-sclcr-ccmt-08").unwrap().outline();
        let inside = Side::Inside { from: 100.0 };
        let seen = inside.tool(&bar).unwrap();
        assert_eq!((seen.kind, seen.orientation), (ToolKind::Turning, 3));
        assert!(seen.insert.bounds().unwrap().min.r.abs() < 1e-12);
        assert!(inside.tool(&catalog.tool("svjbr-vbmt-04").unwrap().outline()).is_none());
        assert!(Side::Outside.tool(&bar).is_none());
    }

    #[test]
    fn moves_come_back_as_they_were_seen() {
        let inside = Side::Inside { from: 100.0 };
        let p = Point::new(3.0, 86.0);
        assert_eq!(inside.point(p), Point::new(3.0, 14.0));
        let arc = Segment::Arc { start: p, end: Point::new(2.0, 87.0), center: Point::new(2.0, 86.0), ccw: true };
        assert_eq!(inside.segment(&inside.segment(&arc)), arc);
        assert!(matches!(inside.segment(&arc), Segment::Arc { ccw: false, .. }));
    }
}
