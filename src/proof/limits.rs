//! What the machine cannot exceed: travels, feed, speed, radius, taper and pitch.

use super::findings::{Breach, Findings, Place};
use super::report::FindingKind;
use super::step::{Drive, Thread};
use crate::geometry::{Bounds, Point, Segment};
use crate::machine::Machine;

/// How far the tool may pass the axis, mm: a facing cut passes it by the nose radius and a little more.
const AXIS_OVERSHOOT_MM: f64 = 1.0;
/// Programs are rounded to 0.001; a limit is passed only by more than this, mm or mm/min.
const ROUNDING: f64 = 0.001;
/// A leg of a taper shorter than this, mm, is none: it is below the resolution of the control.
const NO_LEG_MM: f64 = 0.000_5;

/// The range of positions that the tool has covered, against the travels.
#[derive(Debug, Default)]
pub(super) struct Travel {
    covered: Option<Bounds>,
}

impl Travel {
    /// Adds a path and compares the range with the travels.
    pub(super) fn cover(&mut self, path: &Segment, machine: &Machine, place: Place, findings: &mut Findings) {
        let path = path.bounds();
        let covered = self.covered.map_or(path, |c| c.union(path));
        let (z, x) = (covered.max.z - covered.min.z, covered.max.r - covered.min.r);
        if self.covered != Some(covered) {
            let limits = &machine.limits;
            let mut check = |rule, name, range: f64, travel: f64| {
                if range > travel + ROUNDING {
                    let message =
                        format!("The program needs {range:.3} mm of travel in {name}; the machine has {travel:.0} mm.");
                    let breach = Breach::error(rule, FindingKind::OverTravel, range, travel, message);
                    findings.add(place, breach.at(path.max));
                }
            };
            check("travel z", "z", z, limits.travel_z_mm);
            check("travel x", "x", x, limits.travel_x_mm);
        }
        if path.min.r < -AXIS_OVERSHOOT_MM - ROUNDING {
            let message = format!(
                "The tool goes to x {:.3} mm, past the axis; at most {AXIS_OVERSHOOT_MM:.1} mm past it is allowed.",
                path.min.r
            );
            let breach = Breach::error("axis", FindingKind::OverTravel, path.min.r, -AXIS_OVERSHOOT_MM, message);
            findings.add(place, breach.at(path.min));
        }
        self.covered = Some(covered);
    }
}

/// Compares a move with the limits of feed, speed, radius and taper. With constant cutting speed the fastest place of the path
/// counts, which is the one nearest to the axis.
pub(super) fn check_move(path: &Segment, drive: &Drive, machine: &Machine, place: Place, findings: &mut Findings) {
    let bounds = path.bounds();
    let nearest =
        if bounds.min.r <= 0.0 && bounds.max.r >= 0.0 { 0.0 } else { bounds.min.r.abs().min(bounds.max.r.abs()) };
    check_speed(drive.speed.rpm_at(nearest), machine, place, findings);
    if !drive.rapid {
        check_feed(path, drive.feed_at(nearest), machine, place, findings);
    }
    match path {
        Segment::Arc { .. } => check_radius(path, machine, place, findings),
        Segment::Line { start, end } => check_taper(*start, *end, machine.limits.taper_ratio, place, findings),
    }
}

fn check_feed(path: &Segment, feed: f64, machine: &Machine, place: Place, findings: &mut Findings) {
    let limits = &machine.limits;
    let mut breach = |rule, value, limit, message| {
        let breach = Breach::error(rule, FindingKind::OutsideLimits, value, limit, message);
        findings.add(place, breach.at(path.end()));
    };
    let (low, high) = (limits.feed_min_mm_per_min, limits.feed_max_mm_per_min);
    if feed <= 0.0 {
        breach(
            "no feed",
            feed,
            low,
            format!("The feed is {feed:.0} mm/min; the tool would not move. At least {low:.0} is needed."),
        );
    } else if feed < low - ROUNDING {
        let message = format!("The feed is {feed:.1} mm/min; the machine's lowest is given as about {low:.0} mm/min.");
        findings.add(place, Breach::error("low feed", FindingKind::OutsideLimits, feed, low, message).into_warning());
    } else if feed > high + ROUNDING {
        breach("feed", feed, high, format!("The feed is {feed:.0} mm/min; the machine's highest is {high:.0} mm/min."));
    }
}

fn check_speed(rpm: f64, machine: &Machine, place: Place, findings: &mut Findings) {
    let highest = machine.limits.spindle_max_rpm;
    if rpm < 0.0 || rpm > highest + ROUNDING {
        let message = format!("The spindle speed is {rpm:.0} rev/min; 0 to {highest:.0} rev/min is possible.");
        findings.add(place, Breach::error("speed", FindingKind::OutsideLimits, rpm, highest, message));
    }
}

fn check_radius(path: &Segment, machine: &Machine, place: Place, findings: &mut Findings) {
    let limits = &machine.limits;
    let radius = path.radius().unwrap_or(0.0);
    let limit = radius.clamp(limits.arc_radius_min_mm, limits.arc_radius_max_mm);
    if (radius - limit).abs() > ROUNDING {
        let message = format!(
            "The arc's radius is {radius:.3} mm; the control takes {:.0} to {:.0} mm.",
            limits.arc_radius_min_mm, limits.arc_radius_max_mm
        );
        let breach = Breach::error("radius", FindingKind::OutsideLimits, radius, limit, message);
        findings.add(place, breach.at(path.end()));
    }
}

fn check_taper(start: Point, end: Point, ratio_limit: f64, place: Place, findings: &mut Findings) {
    let (dz, dr) = ((end.z - start.z).abs(), (end.r - start.r).abs());
    let (long, short) = (dz.max(dr), dz.min(dr));
    if short > NO_LEG_MM && long >= ratio_limit * short {
        let ratio = long / short;
        let message = format!(
            "The taper moves {dr:.3} mm in x and {dz:.3} mm in z, {ratio:.1} to 1; the control takes less than {ratio_limit:.0} to 1."
        );
        let breach = Breach::error("taper", FindingKind::OutsideLimits, ratio, ratio_limit, message);
        // A warning only: of the ten chords that the published MASTER part asks for, the one at the crown is 23.7 to 1.
        findings.add(place, breach.into_warning().at(end));
    }
}

/// Compares a threading pass with the limits of pitch, feed and speed.
pub(super) fn check_pass(
    path: &Segment,
    lead: f64,
    rpm: f64,
    machine: &Machine,
    place: Place,
    findings: &mut Findings,
) {
    let limits = &machine.limits;
    let mut breach = |rule, value, limit, message| {
        let breach = Breach::error(rule, FindingKind::OutsideLimits, value, limit, message);
        findings.add(place, breach.at(path.start()));
    };
    let pitch_limit = lead.clamp(limits.pitch_min_mm, limits.pitch_max_mm);
    if (lead - pitch_limit).abs() > ROUNDING {
        let (low, high) = (limits.pitch_min_mm, limits.pitch_max_mm);
        let message = format!("The thread's pitch is {lead:.3} mm; the control takes {low:.2} to {high:.2} mm.");
        breach("pitch", lead, pitch_limit, message);
    }
    let (feed, highest) = (lead * rpm, limits.feed_max_mm_per_min);
    if feed > highest + ROUNDING {
        let message = format!(
            "Pitch {lead:.3} mm at {rpm:.0} rev/min is a feed of {feed:.0} mm/min; the machine's highest is {highest:.0} mm/min."
        );
        breach("thread feed", feed, highest, message);
    }
    if rpm <= 0.0 {
        breach("thread speed", rpm, 1.0, "A thread cannot be cut with the spindle at rest (0 rev/min).".to_owned());
    }
    check_speed(rpm, machine, place, findings);
}

/// Compares the ORAC's threading cycle with the limits; false if it cannot be run at all.
pub(super) fn check_thread(thread: &Thread, machine: &Machine, place: Place, findings: &mut Findings) -> bool {
    let reach = Segment::line(thread.from, Point::new(thread.to_z, thread.base_radius));
    check_pass(&reach, thread.pitch, thread.rpm, machine, place, findings);
    let mut breach = |rule, value, limit, message| {
        let breach = Breach::error(rule, FindingKind::OutsideLimits, value, limit, message);
        findings.add(place, breach.at(thread.from));
    };
    if thread.depth <= 0.0 {
        let message = format!("The depth of one threading cut is {:.3} mm; it must be above 0.", thread.depth);
        breach("thread depth", thread.depth, 0.0, message);
    }
    if thread.base_radius >= thread.outside_radius || thread.base_radius < 0.0 {
        let message = format!(
            "The thread's base diameter {:.3} mm must be below its outside diameter {:.3} mm.",
            2.0 * thread.base_radius,
            2.0 * thread.outside_radius
        );
        breach("thread diameters", 2.0 * thread.base_radius, 2.0 * thread.outside_radius, message);
    }
    thread.rpm > 0.0 && thread.pitch > 0.0
}
