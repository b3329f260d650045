//! Areas that a tool cannot reach.

use super::sweep::Underside;
use super::{Piece, Profile, Setup, contour};
use crate::geometry::{Contour, Point, Segment};
use crate::machine::{Machine, ToolKind, ToolOutline};
use std::collections::BTreeMap;

/// An area between the finished contour and what a tool can leave of it.
#[derive(Debug, Clone, PartialEq)]
pub struct UnreachableArea {
    /// Turret station of the tool that cannot reach it; `None`: no tool of the machine can.
    pub tool: Option<u32>,
    /// Rows that it touches.
    pub sections: Vec<u32>,
    /// Outline, closed, part space of the set-up.
    pub outline: Vec<Point>,
    /// Greatest height above the contour, mm.
    pub height_mm: f64,
}

/// Areas that stand less than this above the contour are not reported, mm: twice the width of a cell.
pub const IGNORED_HEIGHT_MM: f64 = 0.02;

/// Width of a cell, mm.
const CELL_MM: f64 = 0.01;

/// More cells are not used; on very long parts they are wider instead.
const MOST_CELLS: f64 = 40_000.0;

/// Points on the upper edge of an area at which its height is measured.
const HEIGHT_SAMPLES: usize = 64;

/// Areas of a set-up that its turning tools cannot reach with their true outline, insert and holder: of every tool by
/// station, and with `tool: None` what none of them reaches.
///
/// A tool comes from outside, stays clear of the finished part, of the material left of what is machined and of the
/// chuck. Accurate to a cell of 0.01 mm, the width of which also is the error across steep walls.
#[must_use]
pub fn unreachable(setup: &Setup, tools: &BTreeMap<u32, ToolOutline>, machine: &Machine) -> Vec<UnreachableArea> {
    let turning: Vec<(u32, [Underside; 2])> = tools
        .iter()
        .filter(|(_, tool)| tool.kind == ToolKind::Turning)
        .map(|(&station, tool)| (station, [&tool.insert, &tool.holder].map(Underside::of)))
        .collect();
    let Some(grid) = Grid::new(setup, machine, room(&turning)).filter(|_| !turning.is_empty()) else {
        return Vec::new();
    };
    let finished = contour(&setup.profile, CELL_MM / 2.0).contour;
    let mut least: Vec<f64> = vec![f64::INFINITY; grid.surface.len()];
    let mut areas = Vec::new();
    for (station, undersides) in &turning {
        let left = grid.left_by(undersides, setup.bar_radius);
        least.iter_mut().zip(&left).for_each(|(least, left)| *least = least.min(*left));
        areas.extend(grid.areas(Some(*station), &left, setup, &finished));
    }
    areas.extend(grid.areas(None, &least, setup, &finished));
    areas
}

/// Room beside the machined part, mm, to the left and to the right: for every place where an insert cuts it, and to the left
/// for what the tool covers there. To the right there is only air.
fn room(turning: &[(u32, [Underside; 2])]) -> [f64; 2] {
    turning.iter().fold([0.0, 0.0], |[left, right]: [f64; 2], (_, [insert, holder])| {
        let [insert_left, insert_right] = insert.reach();
        [left.max(insert_right - insert_left.min(holder.reach()[0])), right.max(-insert_left)]
    })
}

/// The surface that tools must not touch, as a radius at every cell.
struct Grid {
    /// Position of the first cell, mm.
    start: f64,
    /// Width of a cell, mm.
    step: f64,
    surface: Vec<f64>,
}

impl Grid {
    /// The surface of a set-up with room on either side, mm.
    fn new(setup: &Setup, machine: &Machine, [left, right]: [f64; 2]) -> Option<Self> {
        let span = setup.length - setup.machined_from_z + left + right;
        let step = CELL_MM.max(span / MOST_CELLS);
        // A cell lies where machining begins, so that the others lie on even figures.
        let start = setup.machined_from_z - (left / step).ceil() * step;
        let count = index(span / step).filter(|_| span > 0.0)? + 3;
        let mut grid = Self { start, step, surface: vec![f64::NEG_INFINITY; count] };
        for piece in &setup.profile.pieces {
            grid.raise_to(piece.start().z, piece.end().z, |z| piece.curve.radius_at(z));
        }
        if !setup.turned_round {
            grid.raise_to(start, setup.machined_from_z - step, |_| setup.bar_radius);
        }
        grid.raise_to(start, setup.chuck_face_z, |_| machine.chuck.radius_mm);
        Some(grid)
    }

    fn z(&self, index: usize) -> f64 {
        self.start + self.step * index as f64
    }

    /// Raises the cells from `z1` to `z2` to at least `radius` of their position.
    fn raise_to(&mut self, z1: f64, z2: f64, radius: impl Fn(f64) -> f64) {
        let first = index(((z1 - self.start) / self.step - 1e-6).ceil().max(0.0)).unwrap_or(usize::MAX);
        let (start, step) = (self.start, self.step);
        for (i, cell) in self.surface.iter_mut().enumerate().skip(first) {
            let z = start + step * i as f64;
            if z > z2 + step * 1e-6 {
                break;
            }
            *cell = cell.max(radius(z));
        }
    }

    /// What a tool leaves of the bar: insert and holder stay clear of the surface, the insert cuts.
    fn left_by(&self, [insert, holder]: &[Underside; 2], bar_radius: f64) -> Vec<f64> {
        let mut positions = insert.lowest_positions(&self.surface, self.step);
        let of_holder = holder.lowest_positions(&self.surface, self.step);
        positions.iter_mut().zip(of_holder).for_each(|(p, h)| *p = p.max(h));
        let left = insert.left_by(&positions, self.step);
        left.into_iter().map(|r| r.min(bar_radius)).collect()
    }

    /// The areas between the surface and what is left, where it is machined.
    fn areas(&self, tool: Option<u32>, left: &[f64], setup: &Setup, finished: &Contour) -> Vec<UnreachableArea> {
        let mut areas = Vec::new();
        let mut run: Option<(usize, usize)> = None;
        for (i, &height) in left.iter().enumerate() {
            let machined = self.z(i) >= setup.machined_from_z && self.z(i) <= setup.length;
            if machined && self.stands_clear(i, height) {
                run = Some((run.map_or(i, |(first, _)| first), i));
            } else if let Some(run) = run.take() {
                areas.extend(self.area(tool, run, left, setup, finished));
            }
        }
        areas
    }

    /// True if a disc of [`IGNORED_HEIGHT_MM`] about the point at `height` over a cell is clear of the surface.
    fn stands_clear(&self, cell: usize, height: f64) -> bool {
        let radius = IGNORED_HEIGHT_MM.max(2.0 * self.step);
        (0..=2_usize).all(|away| {
            let lowest = height - (radius * radius - (self.step * away as f64).powi(2)).max(0.0).sqrt();
            let clear = |i: Option<usize>| i.and_then(|i| self.surface.get(i)).is_none_or(|&s| s < lowest);
            clear(cell.checked_sub(away)) && clear(cell.checked_add(away))
        })
    }

    /// The area over a run of cells, with one cell more on either side up to the contour.
    fn area(
        &self,
        tool: Option<u32>,
        (first, last): (usize, usize),
        left: &[f64],
        setup: &Setup,
        finished: &Contour,
    ) -> Option<UnreachableArea> {
        let cells = first.saturating_sub(1)..=(last + 1).min(left.len().saturating_sub(1));
        let points = |radii: &[f64]| -> Vec<Point> {
            let radius = |i: usize| radii.get(i).copied().filter(|r| r.is_finite());
            cells.clone().filter_map(|i| Some(Point::new(self.z(i), radius(i)?))).collect()
        };
        let (upper, lower) = (points(left), points(&self.surface));
        let stride = upper.len().div_ceil(HEIGHT_SAMPLES).max(1);
        // The contour is no further away than the surface below, but for the width of a cell.
        let most = if upper.len() == lower.len() {
            upper.iter().zip(&lower).map(|(u, l)| u.r - l.r).fold(0.0, f64::max) + 2.0 * self.step
        } else {
            f64::INFINITY
        };
        let height = |&p: &Point| distance_within(finished, p, most);
        let height_mm = upper.iter().step_by(stride).map(height).fold(0.0, f64::max);
        let mut outline = simplified(&lower, self.step);
        outline.extend(simplified(&upper, self.step).into_iter().rev());
        let sections = sections(&setup.profile, self.z(first), self.z(last));
        (height_mm >= IGNORED_HEIGHT_MM).then_some(UnreachableArea { tool, sections, outline, height_mm })
    }
}

/// Distance from a point to the part of a contour that lies within `reach` mm along z; `reach` if that is nearer. The contour
/// runs on along z.
fn distance_within(contour: &Contour, p: Point, reach: f64) -> f64 {
    let segments = &contour.segments;
    let first = segments.partition_point(|s| s.start().z.max(s.end().z) < p.z - reach);
    let near = segments.iter().skip(first).take_while(|s| s.start().z.min(s.end().z) <= p.z + reach);
    near.map(|s| s.distance_to(p)).fold(reach, f64::min)
}

/// A count as an index.
fn index(value: f64) -> Option<usize> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked to be within the largest grid")]
    (0.0..=2.0 * MOST_CELLS).contains(&value).then_some(value as usize)
}

/// Rows with a piece between two positions, each once.
fn sections(profile: &Profile, z1: f64, z2: f64) -> Vec<u32> {
    let here = |piece: &&Piece| piece.start().z <= z2 && piece.end().z >= z1;
    let mut sections: Vec<u32> = profile.pieces.iter().filter(here).map(|piece| piece.section).collect();
    sections.dedup();
    sections
}

/// The chain without the points that lie within `tolerance` mm of the chain without them (Douglas and Peucker, 1973).
fn simplified(points: &[Point], tolerance: f64) -> Vec<Point> {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return Vec::new() };
    let chord = Segment::line(first, last);
    let inner = points.iter().enumerate().skip(1).take(points.len().saturating_sub(2));
    let furthest = inner.map(|(i, &p)| (i, chord.distance_to(p))).max_by(|a, b| a.1.total_cmp(&b.1));
    match furthest.filter(|(_, distance)| *distance > tolerance) {
        Some((i, _)) => {
            let (before, after) = (points.get(..=i).unwrap_or_default(), points.get(i..).unwrap_or_default());
            let mut kept = simplified(before, tolerance);
            kept.pop();
            kept.extend(simplified(after, tolerance));
            kept
        }
        None => vec![first, last],
    }
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
