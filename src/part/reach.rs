//! Areas that a tool cannot reach.

use crate::geometry::Point;

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
