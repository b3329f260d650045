//! Areas that a tool cannot reach.

use super::chain::{Chain, Run};
use super::left::{SPOKEN_OF_MM, height_over, places_under};
use super::tool::Cutter;
use super::work::Work;
use super::{PARABOLA_TOLERANCE_MM, order};
use crate::geometry::Point;
use crate::machine::{Machine, ToolKind, ToolOutline};
use crate::part::{self, PartContour, Setup};
use std::collections::BTreeMap;

/// How far the chords of an area's outline may leave its arcs, mm.
const OUTLINE_TOLERANCE_MM: f64 = 0.005;

/// An area between the finished contour and what a tool can leave of it.
#[derive(Debug, Clone, PartialEq)]
pub struct UnreachableArea {
    /// Turret station of the tool that cannot reach it; `None`: no tool of the machine can.
    pub tool: Option<u32>,
    /// Rows that it touches.
    pub sections: Vec<u32>,
    /// Outline, closed, part space of the set-up.
    pub outline: Vec<Point>,
    /// Largest way from the contour through the area into the open, mm.
    pub height_mm: f64,
}

/// Areas of a set-up's outside that its turning tools cannot reach: of every tool by station, and with `tool: None` what none of
/// them reaches. They lie under what a tool leaves where it goes all along its limit, the one that the planner keeps to; areas
/// less than 0.02 mm high are not reported.
#[must_use]
pub fn unreachable(setup: &Setup, tools: &BTreeMap<u32, ToolOutline>, machine: &Machine) -> Vec<UnreachableArea> {
    let contour = part::contour(&setup.profile, PARABOLA_TOLERANCE_MM);
    let turning = tools.iter().filter(|(_, tool)| tool.kind == ToolKind::Turning);
    let cutters: Vec<Cutter> =
        turning.filter_map(|(&station, outline)| order::cutter(station, outline, setup)).collect();
    if contour.contour.segments.is_empty() || cutters.is_empty() {
        return Vec::new();
    }
    let work = Work::new(setup, &contour, machine);
    let mut least = work.stock.chain();
    let mut areas = Vec::new();
    for cutter in &cutters {
        let left = left_by(cutter, &work);
        areas.extend(areas_under(&left, &work, &contour, Some(cutter.station)));
        least = least.min(&left);
    }
    areas.extend(areas_under(&least, &work, &contour, None));
    areas
}

/// What a tool leaves of the stock.
fn left_by(cutter: &Cutter, work: &Work) -> Chain {
    let seen = work.seen_by(cutter);
    let left = seen.stock.chain().min(&Work::left_by(&cutter.edge, &seen.limit(cutter, 0.0).chain));
    if cutter.turned { left.mirrored() } else { left }
}

/// The areas between what is left and the part, where it is machined.
fn areas_under(left: &Chain, work: &Work, contour: &PartContour, tool: Option<u32>) -> Vec<UnreachableArea> {
    let left = left.clipped(work.from_z, work.face_z);
    let runs = left.runs_over(&work.part, SPOKEN_OF_MM);
    let area = |run: &Run| {
        let (upper, places) = (left.clipped(run.z0, run.z1), places_under(run, contour).collect::<Vec<_>>());
        let height_mm = height(&upper, &places);
        let mut sections: Vec<u32> = places.iter().map(|(section, _)| *section).collect();
        sections.dedup();
        let mut outline = towards_chuck(&work.part.clipped(run.z0, run.z1));
        outline.reverse();
        outline.extend(towards_chuck(&upper));
        (height_mm > SPOKEN_OF_MM).then_some(UnreachableArea { tool, sections, outline, height_mm })
    };
    runs.iter().filter_map(area).collect()
}

/// Largest way into the open from some places, mm. It is no longer than the way straight up, so those are tried first from which
/// that is long.
fn height(upper: &Chain, places: &[(u32, Point)]) -> f64 {
    let mut by_rise: Vec<(f64, Point)> =
        places.iter().map(|&(_, p)| (upper.at(p.z).map_or(0.0, |r| r - p.r), p)).collect();
    by_rise.sort_by(|a, b| b.0.total_cmp(&a.0));
    by_rise.iter().fold(0.0, |most: f64, &(rise, p)| if rise > most { most.max(height_over(upper, p)) } else { most })
}

/// Points along a function from the right to the left.
fn towards_chuck(chain: &Chain) -> Vec<Point> {
    let segments = chain.pieces.iter().rev().map(super::piece::Piece::towards_chuck);
    segments.flat_map(|s| std::iter::once(s.start()).chain(s.polyline_points(OUTLINE_TOLERANCE_MM))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::TurnedPart;
    use crate::geometry::Bounds;
    use crate::machine::{Catalog, outlines};
    use crate::part::{Section, fixtures, setups};

    fn found(part: &TurnedPart) -> Vec<UnreachableArea> {
        let machine = fixtures::orac();
        let tools = outlines(&machine, &Catalog::shipped());
        let (setups, _) = setups(part, &machine);
        setups.iter().flat_map(|setup| unreachable(setup, &tools, &machine)).collect()
    }

    fn groove() -> TurnedPart {
        let rows = vec![
            Section::line(1, 0.0, 26.2, 10.0, 26.2),
            Section::line(2, 10.0, 20.0, 30.0, 20.0),
            Section::line(3, 30.0, 26.2, 40.0, 26.2),
        ];
        fixtures::part(40.0, rows)
    }

    /// The largest area of a tool.
    fn largest(areas: &[UnreachableArea], tool: Option<u32>) -> &UnreachableArea {
        areas.iter().filter(|a| a.tool == tool).max_by(|a, b| a.height_mm.total_cmp(&b.height_mm)).unwrap()
    }

    fn bounds(area: &UnreachableArea) -> Bounds {
        Bounds::around(area.outline.iter().copied()).unwrap()
    }

    #[test]
    fn the_right_hand_tool_leaves_its_flank_before_the_right_wall_and_the_left_one_before_the_left() {
        let areas = found(&groove());
        // 3.1 mm of wall, trailing edge at 52°: 3.1 / tan 52° = 2.42 mm, a little more for the nose.
        let right = bounds(largest(&areas, Some(1)));
        assert!((right.max.z - 30.0).abs() < 0.03 && (right.min.z - 27.5).abs() < 0.15, "{right:?}");
        let left = bounds(largest(&areas, Some(2)));
        assert!((left.min.z - 10.0).abs() < 0.03 && (left.max.z - 12.5).abs() < 0.15, "{left:?}");
        assert!(largest(&areas, Some(1)).sections.contains(&2));
    }

    #[test]
    fn both_tools_together_leave_only_the_nose_in_the_corners() {
        let areas = found(&groove());
        let both = areas.iter().filter(|a| a.tool.is_none());
        assert!(both.clone().count() > 0);
        // A nose of 0.2 mm leaves 0.2·(√2 − 1) = 0.083 mm in a corner, 0.2·(1 − 1/√2) = 0.059 mm from its walls.
        assert!(both.clone().all(|a| a.height_mm < 0.1), "{both:?}");
    }

    #[test]
    fn a_cylinder_of_the_bar_is_reached_everywhere() {
        assert!(found(&fixtures::part(40.0, vec![Section::line(1, 0.0, 26.2, 40.0, 26.2)])).is_empty());
    }

    #[test]
    fn queen_has_an_area_for_the_left_hand_tool_below_its_collar() {
        let areas = found(&fixtures::queen());
        let right = largest(&areas, Some(1));
        assert!(right.sections.contains(&5) || right.sections.contains(&4), "{right:?}");
        assert!(right.height_mm > 0.5);
    }

    #[test]
    fn without_tools_there_is_nothing_to_say() {
        let machine = fixtures::orac();
        let (setups, _) = setups(&groove(), &machine);
        assert!(unreachable(&setups[0], &BTreeMap::new(), &machine).is_empty());
    }
}
