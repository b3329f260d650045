//! One instruction made ready: area, offset contour, tool, cutting data and blank.

use super::area::{Area, Direction};
use super::blank::Blank;
use super::fault::Fault;
use super::offset::offset;
use super::tool::CycleTool;
use crate::document::Instruction;
use crate::geometry::{Point, Segment};
use crate::part::Section;
use crate::turning::{Cut, CutMove};

/// Distance in front of the area at which the tool stops coming at rapid, along the spindle, mm.
const APPROACH_Z_MM: f64 = 5.0;

/// Height above the blank at which it does so, mm.
const APPROACH_R_MM: f64 = 10.0;

/// Everything that a cycle needs to know. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Job<'a> {
    /// What is asked for.
    pub instruction: &'a Instruction,
    /// The elements to be cut.
    pub area: Area,
    /// The way of the nose's centre along them.
    pub contour: Vec<Segment>,
    /// The tool.
    pub tool: CycleTool,
    /// Feed and speed.
    pub cut: Cut,
    /// What is left of the blank.
    pub blank: Blank,
}

impl<'a> Job<'a> {
    /// `rows_mm` is the section table.
    pub(super) fn new(
        instruction: &'a Instruction,
        rows_mm: &[Section],
        tool: CycleTool,
        cut: Cut,
        blank: Blank,
    ) -> Result<Self, Fault> {
        let area = Area::of(rows_mm, instruction.from, instruction.to)?;
        let contour = offset(&area.elements, instruction.stock_left + tool.nose_radius, area.direction)?;
        Ok(Self { instruction, area, contour, tool, cut, blank })
    }

    pub(super) const fn direction(&self) -> Direction {
        self.area.direction
    }

    /// +1 or −1: the direction of cutting along the spindle.
    pub(super) const fn sign(&self) -> f64 {
        self.area.direction.sign()
    }

    /// Where the tool stops coming at rapid: in front of the area and above the blank. The programmed point goes there,
    /// whatever the tool.
    pub(super) fn approach(&self) -> Point {
        Point::new(self.area.z_start - APPROACH_Z_MM * self.sign(), self.blank.radius + APPROACH_R_MM)
    }

    /// Where the tool draws back to behind the area, likewise.
    pub(super) fn retreat(&self) -> Point {
        Point::new(self.area.z_end + APPROACH_Z_MM * self.sign(), self.blank.first_radius + APPROACH_R_MM)
    }

    /// No moves yet.
    pub(super) const fn moves(&self) -> Moves {
        Moves { tool: self.tool, cut: self.cut, made: Vec::new() }
    }
}

/// Moves of one tool.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Moves {
    tool: CycleTool,
    cut: Cut,
    made: Vec<CutMove>,
}

impl Moves {
    /// At rapid with the programmed point to `to`.
    pub(super) fn rapid(&mut self, to: Point) {
        self.made.push(CutMove::Rapid { to });
    }

    /// At feed with the programmed point to `to`.
    pub(super) fn line(&mut self, to: Point) {
        self.made.push(CutMove::Line { to, cut: self.cut });
    }

    /// At feed with the centre of the nose to `center`.
    pub(super) fn nose_to(&mut self, center: Point) {
        self.line(self.tool.tip(center));
    }

    /// At feed with the centre of the nose along `way`, from where it is.
    pub(super) fn follow(&mut self, way: &[Segment]) {
        for segment in way {
            match *segment {
                Segment::Line { end, .. } => self.nose_to(end),
                Segment::Arc { end, center, ccw, .. } => {
                    let (to, center) = (self.tool.tip(end), self.tool.tip(center));
                    self.made.push(CutMove::Arc { to, center, ccw, cut: self.cut });
                }
            }
        }
    }

    /// The moves in order.
    pub(super) fn into_moves(self) -> Vec<CutMove> {
        self.made
    }
}
