//! Limits of what a machine, tool or material file may say.

use super::{Chuck, DatumRule, Limits, Machine, Material, SerialProfile, SpindleRule, Tool, ToolShape};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// A value of a file that cannot be right.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Fault {
    /// Keys from the item down to the value, joined by dots; an entry of a list is its index from 0.
    pub(super) path: String,
    /// A sentence with the value and the limit.
    pub(super) message: String,
}

/// Lengths on a lathe, mm. Wide enough for any lathe; catches slipped decimal points and wrong units.
const LENGTH_MM: RangeInclusive<f64> = 0.001..=10_000.0;
/// Feeds, mm/min or in/min.
const FEED: RangeInclusive<f64> = 0.001..=100_000.0;
/// Spindle speeds, rev/min.
const SPEED_RPM: RangeInclusive<f64> = 1.0..=100_000.0;
/// Corners of inserts, degrees.
const CORNER_DEG: RangeInclusive<f64> = 5.0..=120.0;
/// Nose radii, mm.
const NOSE_MM: RangeInclusive<f64> = 0.001..=50.0;
/// Stations of a turret.
const STATIONS: RangeInclusive<u32> = 1..=99;
/// Speeds of a serial line, bits per second.
const BAUD: RangeInclusive<u32> = 50..=4_000_000;
/// Blocks that hold a start, one move and an end.
const FEWEST_BLOCKS: usize = 8;
/// The finest step that a slide can make is near this, in either unit.
const DEPTH: RangeInclusive<f64> = 0.0001..=100.0;

#[derive(Default)]
struct Check(Vec<Fault>);

impl Check {
    fn fault(&mut self, path: &str, message: String) {
        self.0.push(Fault { path: path.to_owned(), message });
    }

    fn range(&mut self, path: &str, value: f64, range: RangeInclusive<f64>, unit: &str) {
        if !range.contains(&value) {
            let (low, high) = range.into_inner();
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            self.fault(path, format!("The value is {value}{unit}; it must be {low} to {high}{unit}."));
        }
    }

    fn text(&mut self, path: &str, value: &str) {
        if value.trim().is_empty() {
            self.fault(path, format!("The text is \"{value}\"; it must not be empty."));
        }
    }

    fn ordered(&mut self, path: &str, low: f64, high: f64, unit: &str) {
        if low > high {
            self.fault(path, format!("The smallest value is {low} {unit}, above the largest, {high} {unit}."));
        }
    }
}

/// Everything that cannot be right in a machine, but for tools that it does not know.
pub(super) fn machine(machine: &Machine) -> Vec<Fault> {
    let mut check = Check::default();
    check.text("id", &machine.id);
    check.text("name", &machine.name);
    check.range("rapid_feed_mm_per_min", machine.rapid_feed_mm_per_min, FEED, "mm/min");
    check.range("tool_change_s", machine.tool_change_s, 0.0..=3600.0, "s");
    limits(&mut check, &machine.limits);
    spindle(&mut check, &machine.spindle);
    holding(&mut check, &machine.datum, &machine.chuck);
    serial(&mut check, &machine.serial);
    turret(&mut check, machine);
    check.0
}

fn limits(check: &mut Check, limits: &Limits) {
    for (path, value) in [
        ("limits.bar_diameter_mm", limits.bar_diameter_mm),
        ("limits.travel_x_mm", limits.travel_x_mm),
        ("limits.travel_z_mm", limits.travel_z_mm),
        ("limits.arc_radius_min_mm", limits.arc_radius_min_mm),
        ("limits.arc_radius_max_mm", limits.arc_radius_max_mm),
        ("limits.pitch_min_mm", limits.pitch_min_mm),
        ("limits.pitch_max_mm", limits.pitch_max_mm),
    ] {
        check.range(path, value, LENGTH_MM, "mm");
    }
    check.range("limits.taper_ratio", limits.taper_ratio, 1.0..=1e9, "");
    check.range("limits.feed_min_mm_per_min", limits.feed_min_mm_per_min, FEED, "mm/min");
    check.range("limits.feed_max_mm_per_min", limits.feed_max_mm_per_min, FEED, "mm/min");
    check.range("limits.spindle_max_rpm", limits.spindle_max_rpm, SPEED_RPM, "rev/min");
    check.ordered("limits.arc_radius_min_mm", limits.arc_radius_min_mm, limits.arc_radius_max_mm, "mm");
    check.ordered("limits.pitch_min_mm", limits.pitch_min_mm, limits.pitch_max_mm, "mm");
    check.ordered("limits.feed_min_mm_per_min", limits.feed_min_mm_per_min, limits.feed_max_mm_per_min, "mm/min");
    if limits.blocks_per_program < FEWEST_BLOCKS {
        let message = format!("The value is {}; it must be at least {FEWEST_BLOCKS}.", limits.blocks_per_program);
        check.fault("limits.blocks_per_program", message);
    }
}

fn spindle(check: &mut Check, rule: &SpindleRule) {
    check.range("spindle.at_center_rpm", rule.at_center_rpm, SPEED_RPM, "rev/min");
    check.range("spindle.per_mm_radius_rpm", rule.per_mm_radius_rpm, 0.0..=10_000.0, "rev/min per mm");
    check.range("spindle.thread_feed_mm_per_min", rule.thread_feed_mm_per_min, FEED, "mm/min");
}

fn holding(check: &mut Check, datum: &DatumRule, chuck: &Chuck) {
    check.range("datum.radial_clearance_mm", datum.radial_clearance_mm, LENGTH_MM, "mm");
    check.range("datum.axial_clearance_mm", datum.axial_clearance_mm, LENGTH_MM, "mm");
    check.range("chuck.radius_mm", chuck.radius_mm, LENGTH_MM, "mm");
    check.range("chuck.depth_mm", chuck.depth_mm, LENGTH_MM, "mm");
    check.range("chuck.gap_mm", chuck.gap_mm, LENGTH_MM, "mm");
    check.range("chuck.grip_mm", chuck.grip_mm, LENGTH_MM, "mm");
    check.range("chuck.automatic_grip_mm", chuck.automatic_grip_mm, LENGTH_MM, "mm");
}

fn serial(check: &mut Check, profile: &SerialProfile) {
    if !BAUD.contains(&profile.baud) {
        let message =
            format!("The speed is {} bits/s; it must be {} to {} bits/s.", profile.baud, BAUD.start(), BAUD.end());
        check.fault("serial.baud", message);
    }
    if !(7..=8).contains(&profile.data_bits) {
        check.fault("serial.data_bits", format!("The value is {} bits; it must be 7 or 8.", profile.data_bits));
    }
    if !(1..=2).contains(&profile.stop_bits) {
        check.fault("serial.stop_bits", format!("The value is {} bits; it must be 1 or 2.", profile.stop_bits));
    }
    for (path, byte) in [("serial.page_start", profile.page_start), ("serial.end", profile.end)] {
        if !byte.is_ascii_control() {
            check.fault(path, format!("The value is {byte}; it must be a control character, 0 to 31 or 127."));
        }
    }
    if profile.page_start == profile.end {
        check.fault("serial.end", format!("The value is {}, the same as page_start; they must differ.", profile.end));
    }
}

fn turret(check: &mut Check, machine: &Machine) {
    let mut seen = BTreeSet::new();
    for (i, tool) in machine.tools.iter().enumerate() {
        let station = tool.station;
        let path = format!("tools.{i}.station");
        if !STATIONS.contains(&station) {
            check.fault(
                &path,
                format!("The station is {station}; it must be {} to {}.", STATIONS.start(), STATIONS.end()),
            );
        }
        if !seen.insert(station) {
            check.fault(&path, format!("Station {station} holds two tools; a station holds one."));
        }
    }
    if machine.tools.is_empty() {
        check.fault("tools", "The turret holds 0 tools; it must hold at least 1.".to_owned());
    }
}

/// Everything that cannot be right in a tool.
pub(super) fn tool(tool: &Tool) -> Vec<Fault> {
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
            check.range("shape.nose_radius", nose_radius, NOSE_MM, "mm");
            check.range("shape.depth", depth, LENGTH_MM, "mm");
            let most = (width / 2.0).min(depth);
            if nose_radius > most {
                let message =
                    format!("The corner radius is {nose_radius} mm; the blade has room for {most} mm at most.");
                check.fault("shape.nose_radius", message);
            }
        }
    }
    holder(&mut check, &tool.holder);
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

fn holder(check: &mut Check, points: &[[f64; 2]]) {
    for (i, coordinate) in points.iter().enumerate().flat_map(|(i, p)| p.iter().map(move |c| (i, *c))) {
        check.range(&format!("holder.{i}"), coordinate, -1000.0..=1000.0, "mm");
    }
    if points.len() < 3 {
        check.fault("holder", format!("The outline has {} points; it needs at least 3.", points.len()));
        return;
    }
    let next = points.iter().cycle().skip(1);
    let area: f64 = points.iter().zip(next).map(|(a, b)| (a[0] * b[1] - b[0] * a[1]) / 2.0).sum();
    if area <= 0.0 {
        let message = format!("The outline encloses {area} mm²; counter-clockwise it encloses more than 0 mm².");
        check.fault("holder", message);
    }
}

/// Everything that cannot be right in a material.
pub(super) fn material(material: &Material) -> Vec<Fault> {
    let mut check = Check::default();
    check.text("name", &material.name);
    let unit = material.unit.symbol();
    for (path, feed) in [
        ("feed_travel", material.feed_travel),
        ("feed_cut", material.feed_cut),
        ("feed_part_off", material.feed_part_off),
    ] {
        check.range(path, feed, FEED, &format!("{unit}/min"));
    }
    for (path, depth) in [
        ("depth_rough", material.depth_rough),
        ("depth_finish", material.depth_finish),
        ("depth_thread", material.depth_thread),
    ] {
        check.range(path, depth, DEPTH, unit);
    }
    check.0
}
