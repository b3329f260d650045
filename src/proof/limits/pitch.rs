//! A threading pass: its pitch, the feed that pitch and speed make, and that the spindle turns.

use super::{ROUNDING, speed};
use crate::geometry::Segment;
use crate::machine::Machine;
use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::report::FindingKind;

/// Compares a threading pass with the limits of pitch, feed and speed.
pub(in crate::proof) fn check(
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
    speed::check(rpm, machine, place, findings);
}

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::geometry::Point;
    use crate::proof::tests::machine;

    /// The test lathe cuts pitches of 0.35 to 3.5 mm and feeds up to 1200 mm/min.
    fn found_at(pitch: f64, rpm: f64) -> usize {
        let path = Segment::line(Point::default(), Point::new(-10.0, 0.0));
        found(|place, findings| check(&path, pitch, rpm, &machine(), place, findings)).len()
    }

    #[test]
    fn fires() {
        assert_eq!([(0.34, 400.0), (3.6, 300.0), (1.5, 801.0), (1.5, 0.0)].map(|(p, n)| found_at(p, n)), [1; 4]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!([(0.35, 400.0), (3.5, 300.0), (1.5, 800.0)].map(|(p, n)| found_at(p, n)), [0; 3]);
    }
}
