//! The slides' travels, and how far a tool may pass the axis.

use super::ROUNDING;
use crate::geometry::{Bounds, Segment};
use crate::machine::Machine;
use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::report::FindingKind;

/// How far the tool may pass the axis, mm: a facing cut passes it by the nose radius and a little more.
const AXIS_OVERSHOOT_MM: f64 = 1.0;

/// The range of positions that the tool has covered, against the travels.
#[derive(Debug, Default)]
pub(in crate::proof) struct Travel {
    covered: Option<Bounds>,
}

impl Travel {
    /// Adds a path and compares the range with the travels.
    pub(in crate::proof) fn cover(&mut self, path: &Segment, machine: &Machine, place: Place, findings: &mut Findings) {
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

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::geometry::Point;
    use crate::proof::tests::machine;

    /// What is found along a chain of points as z and r; the test lathe has travels of 350 in z and 95 in x.
    fn rules(points: &[(f64, f64)]) -> usize {
        let points: Vec<Point> = points.iter().map(|&(z, r)| Point::new(z, r)).collect();
        let mut travel = Travel::default();
        found(|place, findings| {
            for ends in points.windows(2) {
                travel.cover(&Segment::line(ends[0], ends[1]), &machine(), place, findings);
            }
        })
        .len()
    }

    #[test]
    fn fires() {
        assert_eq!(rules(&[(0.0, 0.0), (200.0, 0.0), (-150.1, 0.0)]), 1);
        assert_eq!(rules(&[(0.0, 0.0), (0.0, 95.1)]), 1);
        assert_eq!(rules(&[(0.0, 5.0), (0.0, -1.1)]), 1);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(rules(&[(200.0, 94.0), (-150.0, -1.0), (200.0, 94.0)]), 0);
    }
}
