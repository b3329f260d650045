//! Limits of what a machine, tool or material file may say.

mod material;
mod tool;
mod words;

use super::{
    Chuck, Cost, DatumRule, Dialect, Limits, Machine, Motion, Outline, SpeedRule, Spindle, SpindleRange, TurretTool,
};
pub(super) use material::material;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;
pub(super) use tool::tool;

/// A value of a file that cannot be right.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// Keys from the item down to the value, joined by dots; an entry of a list is its index from 0.
    pub path: String,
    /// A sentence with the value and the limit.
    pub message: String,
}

/// Lengths on a lathe, mm. Wide enough for any lathe; catches slipped decimal points and wrong units.
const LENGTH_MM: RangeInclusive<f64> = 0.001..=10_000.0;
/// Coordinates of places on a lathe, mm.
const COORDINATE_MM: RangeInclusive<f64> = -10_000.0..=10_000.0;
/// Feeds, mm/min or in/min.
const FEED: RangeInclusive<f64> = 0.001..=100_000.0;
/// Spindle speeds, rev/min.
const SPEED_RPM: RangeInclusive<f64> = 1.0..=100_000.0;
/// Stations of a turret.
const STATIONS: RangeInclusive<u32> = 1..=99;
/// Blocks that hold a start, one move and an end.
const FEWEST_BLOCKS: usize = 8;

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

    /// A code such as `M08`: a capital letter and digits.
    fn code(&mut self, path: &str, code: &str) {
        let mut characters = code.chars();
        let letter = characters.next().is_some_and(|c| c.is_ascii_uppercase());
        if !letter || characters.as_str().is_empty() || !characters.all(|c| c.is_ascii_digit()) {
            self.fault(path, format!("The code is \"{code}\"; it must be a capital letter and digits, such as M08."));
        }
    }

    /// A closed outline of `[z, r]` points, counter-clockwise.
    fn outline(&mut self, path: &str, points: &[[f64; 2]]) {
        for (i, coordinate) in points.iter().enumerate().flat_map(|(i, p)| p.iter().map(move |c| (i, *c))) {
            self.range(&format!("{path}.{i}"), coordinate, -1000.0..=1000.0, "mm");
        }
        if points.len() < 3 {
            self.fault(path, format!("The outline has {} points; it needs at least 3.", points.len()));
            return;
        }
        let next = points.iter().cycle().skip(1);
        let area: f64 = points.iter().zip(next).map(|(a, b)| (a[0] * b[1] - b[0] * a[1]) / 2.0).sum();
        if area <= 0.0 {
            let message = format!("The outline encloses {area} mm²; counter-clockwise it encloses more than 0 mm².");
            self.fault(path, message);
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
    check.range("tool_change_s", machine.tool_change_s, 0.0..=3600.0, "s");
    limits(&mut check, &machine.limits);
    spindle(&mut check, &machine.spindle, &machine.limits);
    control(&mut check, machine);
    places(&mut check, machine);
    holding(&mut check, &machine.datum, &machine.chuck);
    for (key, message) in machine.serial.faults() {
        check.fault(&format!("serial.{key}"), message);
    }
    turret(&mut check, machine);
    check.0
}

/// What a control of this dialect needs and what it cannot have.
fn control(check: &mut Check, machine: &Machine) {
    if let Some(feed) = machine.rapid_feed_mm_per_min {
        check.range("rapid_feed_mm_per_min", feed, FEED, "mm/min");
    }
    if let Some(motion) = &machine.motion {
        motion_rates(check, motion);
    }
    if let Some(words) = &machine.words {
        words::words(check, words, &machine.spindle);
    }
    let is_orac = machine.dialect == Dialect::Orac;
    let needs = |key: &str| format!("A control of this dialect needs `{key}`, which is missing.");
    let has_no = |key: &str| format!("A control of this dialect has no `{key}`; take it out.");
    for (key, there) in [("words", machine.words.is_some()), ("motion", machine.motion.is_some())] {
        match (is_orac, there) {
            (true, true) => check.fault(key, has_no(key)),
            (false, false) => check.fault("dialect", needs(key)),
            _ => {}
        }
    }
    match (is_orac, machine.rapid_feed_mm_per_min.is_some()) {
        (true, false) => check.fault("dialect", needs("rapid_feed_mm_per_min")),
        (false, true) => check.fault("rapid_feed_mm_per_min", has_no("rapid_feed_mm_per_min")),
        _ => {}
    }
    if is_orac && machine.spindle.rpm_by_radius(0.0).is_none() {
        check.fault("spindle.speed", "The ORAC's speed follows the radius: `by` must be \"radius\".".to_owned());
    }
}

fn motion_rates(check: &mut Check, motion: &Motion) {
    check.range("motion.rapid_x_mm_per_min", motion.rapid_x_mm_per_min, FEED, "mm/min");
    check.range("motion.rapid_z_mm_per_min", motion.rapid_z_mm_per_min, FEED, "mm/min");
    check.range("motion.acceleration_mm_per_s2", motion.acceleration_mm_per_s2, 1.0..=100_000.0, "mm/s²");
}

/// Rest position, tailstock, mandrel and cost.
fn places(check: &mut Check, machine: &Machine) {
    if let Some(rest) = machine.rest {
        check.range("rest.z_mm", rest.z_mm, COORDINATE_MM, "mm");
        check.range("rest.diameter_mm", rest.diameter_mm, 0.0..=*LENGTH_MM.end(), "mm");
    }
    for (key, body) in [("tailstock", &machine.tailstock), ("mandrel", &machine.mandrel)] {
        if let Some(Outline { outline }) = body {
            check.outline(&format!("{key}.outline"), outline);
        }
    }
    if let Some(Cost { currency, machine_per_hour, setup }) = &machine.cost {
        check.text("cost.currency", currency);
        check.range("cost.machine_per_hour", *machine_per_hour, 0.0..=1e9, currency);
        check.range("cost.setup", *setup, 0.0..=1e9, currency);
    }
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

fn spindle(check: &mut Check, spindle: &Spindle, limits: &Limits) {
    if let SpeedRule::Radius { at_center_rpm, per_mm_radius_rpm } = spindle.speed {
        check.range("spindle.speed.at_center_rpm", at_center_rpm, SPEED_RPM, "rev/min");
        check.range("spindle.speed.per_mm_radius_rpm", per_mm_radius_rpm, 0.0..=10_000.0, "rev/min per mm");
    }
    check.range("spindle.min_rpm", spindle.min_rpm, 0.0..=limits.spindle_max_rpm, "rev/min");
    check.range("spindle.thread_feed_mm_per_min", spindle.thread_feed_mm_per_min, FEED, "mm/min");
    if let Some(power) = spindle.power_kw {
        check.range("spindle.power_kw", power, 0.01..=1000.0, "kW");
    }
    if let Some(rpm) = spindle.full_power_rpm {
        check.range("spindle.full_power_rpm", rpm, SPEED_RPM, "rev/min");
    }
    check.range("spindle.efficiency", spindle.efficiency, 0.1..=1.0, "");
    for (i, SpindleRange { code, min_rpm, max_rpm }) in spindle.ranges.iter().enumerate() {
        check.code(&format!("spindle.ranges.{i}.code"), code);
        check.range(&format!("spindle.ranges.{i}.max_rpm"), *max_rpm, SPEED_RPM, "rev/min");
        check.range(&format!("spindle.ranges.{i}.min_rpm"), *min_rpm, 0.0..=*max_rpm, "rev/min");
    }
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
        change_place(check, i, tool);
    }
    if machine.tools.is_empty() {
        check.fault("tools", "The turret holds 0 tools; it must hold at least 1.".to_owned());
    }
}

/// The offset of a turret tool and where it is changed.
fn change_place(check: &mut Check, i: usize, tool: &TurretTool) {
    let at = |key: &str| format!("tools.{i}.{key}");
    if let Some(offset) = tool.offset.filter(|o| !STATIONS.contains(o)) {
        let message = format!("The offset is {offset}; it must be {} to {}.", STATIONS.start(), STATIONS.end());
        check.fault(&at("offset"), message);
    }
    if let Some(z) = tool.change_z_mm {
        check.range(&at("change_z_mm"), z, COORDINATE_MM, "mm");
    }
    if let Some(diameter) = tool.change_diameter_mm {
        check.range(&at("change_diameter_mm"), diameter, 0.0..=*LENGTH_MM.end(), "mm");
    }
    if tool.change_z_mm.is_some() != tool.change_diameter_mm.is_some() {
        let message = "The change position needs both change_z_mm and change_diameter_mm; one is missing.".to_owned();
        check.fault(&at("station"), message);
    }
}
