//! Feed of a cut: there must be one, and the slides must be able to run it.

use super::ROUNDING;
use crate::geometry::Segment;
use crate::machine::Machine;
use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::report::FindingKind;

/// Compares a feed in mm/min with the machine's range.
pub(super) fn check(path: &Segment, feed: f64, machine: &Machine, place: Place, findings: &mut Findings) {
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

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::diagnostic::Severity;
    use crate::geometry::Point;
    use crate::proof::tests::machine;

    /// The test lathe feeds 30 to 1200 mm/min.
    fn severity(feed: f64) -> Option<Severity> {
        let path = Segment::line(Point::new(0.0, 0.0), Point::new(-1.0, 0.0));
        found(|place, findings| check(&path, feed, &machine(), place, findings)).first().map(|f| f.severity)
    }

    #[test]
    fn fires() {
        assert_eq!([0.0, 1200.1].map(severity), [Some(Severity::Error); 2]);
        assert_eq!(severity(29.9), Some(Severity::Warning));
    }

    #[test]
    fn does_not_fire() {
        assert_eq!([30.0, 80.0, 1200.0].map(severity), [None; 3]);
    }
}
