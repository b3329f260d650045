//! Limits of what a tool may be.

use super::{Check, Fault, LENGTH_MM};
use crate::machine::{Tool, ToolShape};
use std::ops::RangeInclusive;

/// Corners of inserts, degrees.
const CORNER_DEG: RangeInclusive<f64> = 5.0..=120.0;
/// Nose radii, mm.
const NOSE_MM: RangeInclusive<f64> = 0.001..=50.0;

/// Everything that cannot be right in a tool.
pub(in crate::machine) fn tool(tool: &Tool) -> Vec<Fault> {
    let mut check = Check::default();
    check.text("id", &tool.id);
    check.text("name", &tool.name);
    match tool.shape {
        ToolShape::Turning { nose_radius, corner_angle, approach_angle, edge_length, .. } => {
            pointed(&mut check, nose_radius, corner_angle, edge_length);
            check.range("shape.approach_angle", approach_angle, 30.0..=120.0, "degrees");
            if approach_angle + corner_angle >= 180.0 {
                let message = format!(
                    "The approach angle {approach_angle} and the corner angle {corner_angle} add up to {} degrees; \
                     the trailing edge needs less than 180 degrees.",
                    approach_angle + corner_angle
                );
                check.fault("shape.approach_angle", message);
            }
        }
        ToolShape::Threading { nose_radius, corner_angle, edge_length } => {
            pointed(&mut check, nose_radius, corner_angle, edge_length);
        }
        ToolShape::Parting { width, nose_radius, depth } => {
            check.range("shape.width", width, LENGTH_MM, "mm");
            check.range("shape.nose_radius", nose_radius, 0.0..=*NOSE_MM.end(), "mm");
            check.range("shape.depth", depth, LENGTH_MM, "mm");
            let most = (width / 2.0).min(depth);
            if nose_radius > most {
                let message =
                    format!("The corner radius is {nose_radius} mm; the blade has room for {most} mm at most.");
                check.fault("shape.nose_radius", message);
            }
        }
    }
    check.outline("holder", &tool.holder);
    check.0
}

fn pointed(check: &mut Check, nose_radius: f64, corner_angle: f64, edge_length: f64) {
    check.range("shape.nose_radius", nose_radius, NOSE_MM, "mm");
    check.range("shape.corner_angle", corner_angle, CORNER_DEG, "degrees");
    check.range("shape.edge_length", edge_length, LENGTH_MM, "mm");
    // The nose meets the edge at radius / tan(half the corner) from the sharp corner.
    let shortest = nose_radius / (corner_angle.to_radians() / 2.0).tan();
    if edge_length <= shortest {
        let message = format!("The edge is {edge_length} mm long; the nose alone needs more than {shortest:.3} mm.");
        check.fault("shape.edge_length", message);
    }
}
