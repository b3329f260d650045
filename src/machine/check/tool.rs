//! Limits of what a tool may be.

use super::{Check, Fault, LENGTH_MM};
use crate::machine::iso::IsoTool;
use crate::machine::{Tool, ToolShape};
use std::ops::RangeInclusive;

/// Corners of inserts, degrees.
const CORNER_DEG: RangeInclusive<f64> = 5.0..=120.0;
/// Nose radii, mm.
const NOSE_MM: RangeInclusive<f64> = 0.001..=50.0;
/// Nose radii of tools whose corners may be sharp, mm.
const NOSE_OR_SHARP_MM: RangeInclusive<f64> = 0.0..=50.0;
/// Angle between an insert's cutting edge and the direction of feed, degrees.
const APPROACH_DEG: RangeInclusive<f64> = 30.0..=120.0;
/// Tip orientations.
const ORIENTATIONS: RangeInclusive<u8> = 1..=9;

/// Everything that cannot be right in a tool.
pub(in crate::machine) fn tool(tool: &Tool) -> Vec<Fault> {
    let mut check = Check::default();
    check.text("id", &tool.id);
    check.text("name", &tool.name);
    shape(&mut check, &tool.shape);
    holder(&mut check, tool);
    check.0
}

fn shape(check: &mut Check, shape: &ToolShape) {
    match *shape {
        ToolShape::Iso { ref insert, ref holder } => {
            if let Err((key, message)) = IsoTool::read(insert, holder) {
                check.fault(&format!("shape.{key}"), message);
            }
        }
        ToolShape::Turning { nose_radius, corner_angle, approach_angle, edge_length, .. }
        | ToolShape::Boring { nose_radius, corner_angle, approach_angle, edge_length, .. } => {
            pointed(check, nose_radius, corner_angle, edge_length);
            approach(check, approach_angle, corner_angle);
        }
        ToolShape::Copying { nose_radius, corner_angle, edge_length }
        | ToolShape::Threading { nose_radius, corner_angle, edge_length, .. } => {
            pointed(check, nose_radius, corner_angle, edge_length);
        }
        ToolShape::Button { diameter } => check.range("shape.diameter", diameter, 0.1..=100.0, "mm"),
        ToolShape::Parting { width, nose_radius, depth, .. } => blade(check, width, nose_radius, depth),
        ToolShape::Drill { diameter, point_angle, length, pecks_from } => {
            drill(check, diameter, point_angle, length);
            check.range("shape.pecks_from", pecks_from, 0.1..=1000.0, "diameters");
        }
        ToolShape::Outline { orientation, nose_radius, ref corners, ref cuts, .. } => {
            free(check, orientation, nose_radius, corners, cuts);
        }
        ToolShape::Interference { nose_radius, width, angle, margin, .. } => {
            check.range("shape.width", width, LENGTH_MM, "mm");
            check.range("shape.angle", angle, 5.0..=85.0, "degrees");
            check.range("shape.margin", margin, 0.0..=100.0, "mm");
            // The nose fills the corner of 90° less the flank's angle up to radius / tan(half of it).
            let room = width * ((90.0 - angle).to_radians() / 2.0).tan() * angle.to_radians().tan().min(1.0);
            check.range("shape.nose_radius", nose_radius, 0.001..=room.max(0.001), "mm");
        }
    }
}

fn approach(check: &mut Check, approach_angle: f64, corner_angle: f64) {
    check.range("shape.approach_angle", approach_angle, APPROACH_DEG, "degrees");
    let sum = approach_angle + corner_angle;
    if sum >= 180.0 {
        let message = format!(
            "The approach angle {approach_angle} and the corner angle {corner_angle} add up to {sum} degrees; the \
             trailing edge needs less than 180 degrees."
        );
        check.fault("shape.approach_angle", message);
    }
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

fn blade(check: &mut Check, width: f64, nose_radius: f64, depth: f64) {
    check.range("shape.width", width, LENGTH_MM, "mm");
    check.range("shape.nose_radius", nose_radius, NOSE_OR_SHARP_MM, "mm");
    check.range("shape.depth", depth, LENGTH_MM, "mm");
    let most = (width / 2.0).min(depth);
    if nose_radius > most {
        let message = format!("The corner radius is {nose_radius} mm; the blade has room for {most} mm at most.");
        check.fault("shape.nose_radius", message);
    }
}

fn drill(check: &mut Check, diameter: f64, point_angle: f64, length: f64) {
    check.range("shape.diameter", diameter, 0.1..=200.0, "mm");
    check.range("shape.point_angle", point_angle, 60.0..=179.0, "degrees");
    check.range("shape.length", length, LENGTH_MM, "mm");
    let point = diameter / 2.0 / (point_angle.to_radians() / 2.0).tan();
    if length <= point {
        check.fault("shape.length", format!("The drill is {length} mm long; its point alone takes {point:.3} mm."));
    }
}

fn free(check: &mut Check, orientation: u8, nose_radius: f64, corners: &[[f64; 2]], cuts: &[usize]) {
    if !ORIENTATIONS.contains(&orientation) {
        check.fault("shape.orientation", format!("The orientation is {orientation}; it must be 1 to 9."));
    }
    check.range("shape.nose_radius", nose_radius, NOSE_OR_SHARP_MM, "mm");
    check.outline("shape.corners", corners);
    for cut in cuts.iter().filter(|&&cut| cut >= corners.len()) {
        let message = format!("Edge {cut} cuts; the outline has edges 0 to {}.", corners.len().saturating_sub(1));
        check.fault("shape.cuts", message);
    }
    let [Some(tip), Some(next), Some(last)] = [corners.first(), corners.get(1), corners.last()] else { return };
    let to = |p: &[f64; 2]| (p[0] - tip[0], p[1] - tip[1]);
    let (a, b) = (to(next), to(last));
    let corner = (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1);
    if corner <= 0.0 {
        check.fault("shape.corners", "The first corner is the tip; it must point outwards.".to_owned());
        return;
    }
    let room = a.0.hypot(a.1).min(b.0.hypot(b.1)) * (corner / 2.0).tan();
    if nose_radius >= room {
        let message = format!("The nose radius is {nose_radius} mm; the edges beside it leave room for {room:.3} mm.");
        check.fault("shape.nose_radius", message);
    }
}

/// A holder must be known in exactly one way.
fn holder(check: &mut Check, tool: &Tool) {
    if !tool.holder.is_empty() {
        check.outline("holder", &tool.holder);
    }
    for (i, line) in tool.interference_lines.iter().enumerate() {
        for &coordinate in line {
            check.range(&format!("interference_lines.{i}"), coordinate, -1000.0..=1000.0, "mm");
        }
    }
    if !tool.interference_lines.is_empty() {
        let ends = tool.interference_lines.iter().flat_map(|&[z1, r1, z2, r2]| [[z1, r1], [z2, r2]]);
        check.outline("interference_lines", &ends.collect::<Vec<_>>());
    }
    if let Some(shank) = tool.shank {
        check.range("shank.width", shank.width, 1.0..=200.0, "mm");
        check.range("shank.length", shank.length, LENGTH_MM, "mm");
    }
    let given = [!tool.holder.is_empty(), !tool.interference_lines.is_empty(), tool.shank.is_some()];
    let count = given.iter().filter(|given| **given).count();
    let brings_its_own =
        matches!(tool.shape, ToolShape::Iso { .. } | ToolShape::Drill { .. } | ToolShape::Interference { .. });
    let takes_shank = !matches!(tool.shape, ToolShape::Outline { .. }) && !brings_its_own;
    let message = if count > 1 {
        "The holder is given more than once; give one of `holder`, `interference_lines` and `shank`."
    } else if count == 0 && !brings_its_own {
        "The holder is missing; give one of `holder`, `interference_lines` and `shank`."
    } else if tool.shank.is_some() && !takes_shank {
        "This kind of tool takes no `shank`; leave it out or give `holder`."
    } else {
        return;
    };
    check.fault(if tool.shank.is_some() { "shank" } else { "id" }, message.to_owned());
}
