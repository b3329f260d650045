//! What the cycles know of a tool.

use super::area::Direction;
use super::fault::Fault;
use crate::geometry::{Point, Vector};
use crate::machine::{ToolKind, ToolOutline};

/// A tool in its station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CycleTool {
    /// Turret station.
    pub station: u32,
    /// Nose radius, mm; 0 for a blade, whose corners count as sharp.
    pub nose_radius: f64,
    /// From the programmed point to the centre of the nose, mm.
    pub nose: Vector,
    /// Width of a blade, mm; `None` for a turning tool.
    pub blade_width: Option<f64>,
    /// The only direction in which its edge cuts, if it has only one.
    pub cuts_only: Option<Direction>,
}

impl CycleTool {
    /// The tool of a station from its outline. The programmed point of a blade is its corner towards the chuck.
    pub(super) fn new(station: u32, outline: &ToolOutline) -> Result<Self, Fault> {
        match outline.kind {
            ToolKind::Turning => Ok(Self {
                station,
                nose_radius: outline.nose_radius,
                nose: outline.nose_center - Point::default(),
                blade_width: None,
                cuts_only: match (outline.cuts_towards_headstock(), outline.cuts_away_from_headstock()) {
                    (true, false) => Some(Direction::TowardsClampedEnd),
                    (false, true) => Some(Direction::TowardsFreeEnd),
                    _ => None,
                },
            }),
            ToolKind::Grooving => {
                let width = outline.insert.bounds().map_or(0.0, |b| b.max.z - b.min.z);
                Ok(Self {
                    station,
                    nose_radius: 0.0,
                    nose: Vector::default(),
                    blade_width: Some(width),
                    cuts_only: None,
                })
            }
            _ => Err(Fault::new(
                "tool-unfit",
                format!("The tool in station {station} neither turns nor grooves outside."),
                "Choose a turning tool or a blade.",
            )),
        }
    }

    /// The programmed point for a centre of the nose.
    pub(super) fn tip(&self, center: Point) -> Point {
        center - self.nose
    }
}
