//! Radius of an arc.

use super::ROUNDING;
use crate::geometry::Segment;
use crate::machine::Machine;
use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::report::FindingKind;

/// Compares an arc's radius with those that the control takes.
pub(super) fn check(path: &Segment, machine: &Machine, place: Place, findings: &mut Findings) {
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

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::geometry::Point;
    use crate::proof::tests::machine;

    /// The test lathe turns radii of 2 to 3000 mm.
    fn fires_at(radius: f64) -> bool {
        let (start, end) = (Point::new(radius, 0.0), Point::new(0.0, radius));
        let arc = Segment::Arc { start, end, center: Point::default(), ccw: true };
        !found(|place, findings| check(&arc, &machine(), place, findings)).is_empty()
    }

    #[test]
    fn fires() {
        assert!(fires_at(1.998) && fires_at(3000.1));
    }

    #[test]
    fn does_not_fire() {
        assert!(!fires_at(2.0) && !fires_at(3000.0));
    }
}
