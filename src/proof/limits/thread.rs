//! The ORAC's threading cycle: depth of a cut and diameters beside pitch and speed.

use super::pitch;
use crate::geometry::{Point, Segment};
use crate::machine::Machine;
use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::report::FindingKind;
use crate::proof::step::Thread;

/// Compares the cycle with the limits; false if it cannot be run at all.
pub(in crate::proof) fn check(thread: &Thread, machine: &Machine, place: Place, findings: &mut Findings) -> bool {
    let reach = Segment::line(thread.from, Point::new(thread.to_z, thread.base_radius));
    pitch::check(&reach, thread.pitch, thread.rpm, machine, place, findings);
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

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::proof::tests::machine;

    const GOOD: Thread = Thread {
        from: Point { z: 2.0, r: 8.0 },
        to_z: -10.0,
        outside_radius: 6.0,
        base_radius: 5.0,
        pitch: 1.75,
        depth: 0.1,
        tool: 3,
        rpm: 400.0,
    };

    fn found_in(thread: Thread) -> usize {
        found(|place, findings| check(&thread, &machine(), place, findings)).len()
    }

    #[test]
    fn fires() {
        assert_eq!(found_in(Thread { depth: 0.0, ..GOOD }), 1);
        assert_eq!(found_in(Thread { base_radius: 6.5, ..GOOD }), 1);
        assert_eq!(found_in(Thread { pitch: 4.0, rpm: 100.0, ..GOOD }), 1);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(found_in(GOOD), 0);
    }
}
