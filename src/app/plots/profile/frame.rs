//! What every piece of the profile plot needs in one frame.

use super::ProfileScene;
use crate::app::plots::canvas::{Rulers, Screen, grid_step};
use crate::app::plots::coordinates::Coordinates;
use crate::app::plots::lines::distance_to_polyline;
use crate::diagnostic::SectionTable;
use crate::geometry::{Point, Segment};
use crate::part::Section;
use egui::{Id, Pos2, Rect, Response};
use std::collections::HashMap;

/// The pointer is on a line within this distance, points.
const NEAR: f32 = 7.0;

/// One frame of the profile plot.
pub(super) struct Frame<'a> {
    /// What is shown.
    pub(super) scene: &'a ProfileScene<'a>,
    /// Transform of this frame.
    pub(super) screen: Screen,
    /// How positions are written.
    pub(super) coordinates: Coordinates,
    /// The canvas without its rulers.
    pub(super) free: Rect,
    /// Id that those of all handles follow from.
    pub(super) id: Id,
    /// Table and index of every row by its id.
    rows: HashMap<u32, (SectionTable, usize)>,
}

impl<'a> Frame<'a> {
    /// A frame of `scene` on the canvas `response`.
    pub(super) fn new(
        scene: &'a ProfileScene<'a>,
        screen: Screen,
        coordinates: Coordinates,
        response: &Response,
    ) -> Self {
        let tables = [SectionTable::Outside, SectionTable::Bore];
        let rows_of = |table| scene.part.table(table).iter().enumerate().map(move |(row, s)| (s.id, (table, row)));
        let rows = tables.into_iter().flat_map(rows_of).collect();
        Self { scene, screen, coordinates, free: Rulers::free(response.rect), id: response.id, rows }
    }
}

impl Frame<'_> {
    /// The row with this id.
    pub(super) fn section(&self, id: u32) -> Option<&Section> {
        let (table, row) = *self.rows.get(&id)?;
        self.scene.part.table(table).get(row)
    }

    /// True if the row is one of the bore.
    pub(super) fn is_of_bore(&self, id: u32) -> bool {
        self.rows.get(&id).is_some_and(|(table, _)| !table.is_outside())
    }

    /// `convex 6`, `bore line 2`: kind and row number.
    pub(super) fn section_name(&self, id: u32) -> String {
        let row = self.rows.get(&id).map_or(0, |(_, row)| row + 1);
        let of = if self.is_of_bore(id) { "bore " } else { "" };
        self.section(id).map_or_else(String::new, |s| format!("{of}{} {row}", s.kind.name()))
    }

    /// True if the row is selected or under the pointer.
    pub(super) fn is_lit(&self, id: u32) -> bool {
        self.scene.selected == Some(id) || self.scene.lit.contains(&id)
    }

    /// z and diameter at a position on the screen; the diameter is negative below the axis.
    pub(super) fn document_at(&self, pos: Pos2) -> (f64, f64) {
        let p = self.screen.point(pos);
        (self.coordinates.document_z(p.z), self.coordinates.diameter(p.r) * p.r.signum())
    }

    /// Step that drags snap to, in the document's unit.
    pub(super) fn snap_step(&self) -> f64 {
        grid_step(&self.screen, self.coordinates)
    }

    /// The segments of a row on the profile, its faces too.
    pub(super) fn segments_of(&self, id: u32) -> impl Iterator<Item = &Segment> {
        self.lines().filter(move |(_, s)| *s == id).map(|(segment, _)| segment)
    }

    /// The segments of outside and bore with their rows.
    fn lines(&self) -> impl Iterator<Item = (&Segment, u32)> {
        let (outside, bore) = (&self.scene.derived.contour, self.scene.derived.bore.as_ref().as_ref());
        let contours = std::iter::once(outside.as_ref()).chain(bore);
        contours.flat_map(|c| c.contour.segments.iter().zip(c.sections.iter().copied()))
    }

    /// The row whose line is at `pos`, or in whose body `pos` lies.
    pub(super) fn section_at(&self, pos: Pos2) -> Option<u32> {
        let p = self.screen.point(pos);
        let above = if p.r < 0.0 { Pos2::new(pos.x, self.screen.pos(Point::new(p.z, -p.r)).y) } else { pos };
        let nearest = self
            .lines()
            .map(|(segment, section)| (distance_to_polyline(above, &self.polyline(segment)), section))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        if nearest.0 <= NEAR { Some(nearest.1) } else { self.body_at(p) }
    }

    fn body_at(&self, p: Point) -> Option<u32> {
        let covers = |segment: &&Segment| {
            let bounds = segment.bounds();
            bounds.min.z <= p.z && p.z < bounds.max.z && p.r.abs() <= bounds.max.r
        };
        let inside = self.lines().filter(|(_, section)| self.is_of_bore(*section));
        let mut bodies = inside.chain(self.lines());
        bodies.find(|(segment, _)| covers(segment)).map(|(_, section)| section)
    }

    /// A segment on the screen.
    pub(super) fn polyline(&self, segment: &Segment) -> Vec<Pos2> {
        let start = self.screen.pos(segment.start());
        let rest = segment.polyline_points(self.screen.tolerance());
        std::iter::once(start).chain(rest.into_iter().map(|p| self.screen.pos(p))).collect()
    }
}
