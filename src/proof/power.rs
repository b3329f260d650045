//! Whether the spindle has the power that a cut needs.
//!
//! `Pc = kc · a · f · vc / 60 000` kW with the specific force kc in N/mm², the chip's section a·f in mm² as it was really cut,
//! and the cutting speed vc in m/min at the radius of the cut (see [`crate::machine::Chip`]). It is a mean over the block: what is
//! cut at its beginning and end alone is shared out over its length.

use super::findings::{Breach, Findings, Place};
use super::record::Played;
use super::report::FindingKind;
use crate::machine::{Chip, Machine, Material};
use std::f64::consts::TAU;

/// Compares a cut's power with that of the spindle at its speed. `section_mm2` is the chip's section.
pub(super) fn check(
    material: &Material,
    machine: &Machine,
    played: &Played,
    section_mm2: f64,
    place: Place,
    findings: &mut Findings,
) {
    if played.rpm <= 0.0 || played.feed <= 0.0 || section_mm2 <= 0.0 {
        return;
    }
    let feed = played.feed / played.rpm;
    let chip = Chip { depth_mm: section_mm2 / feed, feed_mm_per_rev: feed, approach_deg: 90.0 };
    let at = played.path.point_at(0.5);
    let speed = TAU * at.r.abs() * played.rpm / 1000.0;
    let (needed, given) = (material.cutting_power_kw(chip, speed), machine.spindle.power_at_kw(played.rpm));
    let Some((needed, given)) = needed.zip(given).filter(|(needed, given)| needed > given) else { return };
    let message = format!(
        "The cut needs {needed:.2} kW in {} ({:.2} mm deep, {feed:.3} mm/rev, {speed:.0} m/min); the spindle gives {given:.2} kW at {:.0} rev/min.",
        material.name, chip.depth_mm, played.rpm
    );
    findings.add(place, Breach::error("power", FindingKind::Power, needed, given, message).at(at));
}

#[cfg(test)]
mod tests {
    use super::super::report::Motion;
    use super::super::tests::word_lathe;
    use super::*;
    use crate::geometry::{Point, Segment};
    use crate::machine::Catalog;

    #[test]
    fn a_heavy_cut_is_too_much_and_a_light_one_is_not() {
        let catalog = Catalog::shipped();
        let forced = |m: &&Material| m.specific_cutting_force_n_per_mm2.is_some_and(|kc| kc > 1400.0);
        let material = catalog.materials.iter().find(forced).unwrap();
        let path = Segment::line(Point::new(0.0, 50.0), Point::new(-50.0, 50.0));
        // 200 m/min at radius 50 and 0.4 mm/rev.
        let rpm = 200_000.0 / (TAU * 50.0);
        let played = Played { path, motion: Motion::Feed, tool: 1, feed: 0.4 * rpm, rpm, lasts_s: 1.0 };
        let found = |section: f64| {
            let mut findings = Findings::default();
            check(material, &word_lathe(), &played, section, Place { program: 0, block: 1 }, &mut findings);
            findings.in_order(&["TEST".to_owned()])
        };
        assert!(found(0.4).is_empty());
        let heavy = &found(8.0)[0];
        assert!(heavy.kind == FindingKind::Power && heavy.value > heavy.limit, "{heavy:?}");
    }
}
