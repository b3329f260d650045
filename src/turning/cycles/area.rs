//! The machining area of an instruction: a run of elements of the contour, in the direction of cutting.

use super::fault::Fault;
use crate::geometry::{Point, Segment};
use crate::part::{Piece, PieceRole, Profile, Section, contour, row_curve};

/// How far tangent arcs may lie from a parabola that a cycle follows, mm.
const PARABOLA_TOLERANCE_MM: f64 = 5e-4;

/// Elements whose ends are further apart than this do not follow one another, mm. Below it the figures of published
/// profiles differ by rounding, and an element starts where the one before it ends.
const JOINED_MM: f64 = 0.01;

/// Two lines whose directions differ by less than this are one line, degrees. Of the published joints 0.028° is merged
/// and 0.036° is not.
const ONE_LINE_DEG: f64 = 0.03;

/// Elements shorter than this have no direction and are passed over, mm.
const NO_LENGTH_MM: f64 = 1e-9;

/// Which way along the spindle an area is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    /// Right to left: the last element first.
    TowardsClampedEnd,
    /// Left to right.
    TowardsFreeEnd,
}

impl Direction {
    /// +1 with growing z, −1 with falling z.
    pub(super) const fn sign(self) -> f64 {
        match self {
            Self::TowardsClampedEnd => -1.0,
            Self::TowardsFreeEnd => 1.0,
        }
    }
}

/// The elements of one machining area.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Area {
    /// The elements in the order and direction of cutting, each starting where the one before ends.
    pub elements: Vec<Segment>,
    /// Which way they run.
    pub direction: Direction,
    /// Position where the first element starts, mm.
    pub z_start: f64,
    /// Position where the last element ends, mm.
    pub z_end: f64,
}

impl Area {
    /// The elements from row `from` to row `to` (ids) of a table in mm, both included.
    pub(super) fn of(rows: &[Section], from: u32, to: u32) -> Result<Self, Fault> {
        let (first, last) = (position(rows, from)?, position(rows, to)?);
        let direction = if first > last { Direction::TowardsClampedEnd } else { Direction::TowardsFreeEnd };
        let in_order = rows.get(first.min(last)..=first.max(last)).unwrap_or_default();
        let mut elements = joined(in_order)?;
        if direction == Direction::TowardsClampedEnd {
            elements = elements.iter().rev().map(Segment::reversed).collect();
        }
        let elements = merged(elements);
        let (Some(start), Some(end)) = (elements.first(), elements.last()) else {
            return Err(Fault::new("area-empty", "The area has no length.", "Choose other elements."));
        };
        let (z_start, z_end) = (start.start().z, end.end().z);
        Ok(Self { elements, direction, z_start, z_end })
    }
}

fn position(rows: &[Section], id: u32) -> Result<usize, Fault> {
    rows.iter().position(|row| row.id == id).ok_or_else(|| {
        let message = format!("There is no element with id {id} in the section table of {} rows.", rows.len());
        Fault::new("unknown-element", message, "Choose a first and a last element that exist.")
    })
}

/// The lines and arcs of consecutive rows, each starting where the one before ends.
fn joined(rows: &[Section]) -> Result<Vec<Segment>, Fault> {
    let mut segments: Vec<Segment> = Vec::with_capacity(rows.len());
    for row in rows {
        let curve = row_curve(row).ok_or_else(|| {
            let message = format!("The element with id {} has no shape that can be cut.", row.id);
            Fault::new("element-without-shape", message, "Correct the row; the checks of the table say why.")
        })?;
        let piece = Piece { curve, section: row.id, role: PieceRole::Surface };
        let made = contour(&Profile { pieces: vec![piece] }, PARABOLA_TOLERANCE_MM).contour.segments;
        for segment in made.into_iter().filter(|s| s.length() > NO_LENGTH_MM) {
            let start = segments.last().map_or(segment.start(), Segment::end);
            let gap = start.distance(segment.start());
            if gap > JOINED_MM {
                let message = format!(
                    "The element with id {} starts {gap:.3} mm from the end of the one before it; at most \
                     {JOINED_MM} mm are bridged.",
                    row.id
                );
                return Err(Fault::new("elements-apart", message, "Begin the row where the one before it ends."));
            }
            segments.push(starting_at(&segment, start));
        }
    }
    Ok(segments)
}

/// The segment with another start close to its own.
fn starting_at(segment: &Segment, start: Point) -> Segment {
    match *segment {
        Segment::Line { end, .. } => Segment::Line { start, end },
        Segment::Arc { end, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

/// The elements with nearly parallel lines made one.
fn merged(elements: Vec<Segment>) -> Vec<Segment> {
    let mut kept: Vec<Segment> = Vec::with_capacity(elements.len());
    for element in elements {
        match (kept.last_mut(), element) {
            (Some(Segment::Line { end, start }), Segment::Line { end: to, .. })
                if turn_deg(&Segment::line(*start, *end), &element).abs() < ONE_LINE_DEG =>
            {
                *end = to;
            }
            _ => kept.push(element),
        }
    }
    kept
}

/// Angle by which the direction turns from the end of one element to the start of the next, degrees, counter-clockwise.
pub(super) fn turn_deg(before: &Segment, after: &Segment) -> f64 {
    let (a, b) = (before.direction_at(1.0), after.direction_at(0.0));
    a.perp(&b).atan2(a.dot(&b)).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::SectionKind;

    fn rows() -> Vec<Section> {
        vec![
            Section::line(7, 0.0, 20.0, 10.0, 20.0),
            Section::line(3, 10.0, 20.0, 20.0, 20.002),
            Section::line(9, 20.0, 20.002, 20.0, 30.0),
            Section { kind: SectionKind::Convex { radius: 5.0 }, ..Section::line(4, 20.001, 30.0, 25.0, 40.0) },
        ]
    }

    #[test]
    fn an_area_runs_as_its_rows_stand_in_the_table_and_nearly_parallel_lines_are_one() {
        let area = Area::of(&rows(), 7, 9).unwrap();
        assert_eq!((area.direction, area.elements.len()), (Direction::TowardsFreeEnd, 2));
        assert_eq!((area.z_start, area.z_end), (0.0, 20.0));
    }

    #[test]
    fn an_area_towards_the_clamped_end_is_run_backwards_and_closes_roundings() {
        let area = Area::of(&rows(), 4, 7).unwrap();
        assert_eq!((area.direction, area.z_start, area.z_end), (Direction::TowardsClampedEnd, 25.0, 0.0));
        assert!(area.elements.windows(2).all(|w| w[0].end() == w[1].start()));
    }

    #[test]
    fn unknown_shapeless_and_distant_elements_are_refused() {
        let code = |rows: &[Section], from, to| Area::of(rows, from, to).unwrap_err().code;
        assert_eq!(code(&rows(), 7, 8), "unknown-element");
        let mut bad = rows();
        bad[3].d2 = 400.0;
        assert_eq!(code(&bad, 7, 4), "element-without-shape");
        bad[1].z1 = 10.5;
        assert_eq!(code(&bad, 7, 9), "elements-apart");
    }
}
