//! Springback: the angle to which a bend opens when it leaves its station, and the overbend that would make up for it.
//!
//! Guide values by the formula of the elastic, perfectly plastic strip: `Ri/Rf = 4X³ - 3X + 1` with `X = Ri·Y/(E·t)`. The
//! angle opens in the same ratio. They rank bends and stations; they do not predict an angle.

use super::bends::{BendState, Stage, bend_states};
use crate::document::{RollSet, StripMaterial};
use std::collections::BTreeMap;

/// Name of the formula, for people.
pub const METHOD: &str = "elastic, perfectly plastic strip";

/// From this `X = Ri·Y/(E·t)` on a bend stays elastic and opens altogether.
const ELASTIC: f64 = 0.5;

/// How far the search for an overbend halves its range: to far below what an angle can be measured to.
const HALVINGS: u32 = 60;

/// What a bend does when it leaves its station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springback {
    /// Id of the element.
    pub element: u32,
    /// Angle in the station, radians.
    pub angle_rad: f64,
    /// Angle after release, radians; 0 if the bend stays elastic.
    pub released_rad: f64,
    /// Angle whose release is the angle of the station, radians; `None` where the strip cannot be bent so far.
    pub overbent_rad: Option<f64>,
}

/// Part of its angle that a bend keeps, 0 to 1: `Ri/Rf`. 0 where it stays elastic.
#[must_use]
pub fn kept(inside_radius: f64, thickness: f64, material: &StripMaterial) -> f64 {
    let x = inside_radius * material.yield_strength_mpa / (material.youngs_modulus_gpa * 1000.0 * thickness);
    if x < ELASTIC { (4.0 * x.powi(3) - 3.0 * x + 1.0).clamp(0.0, 1.0) } else { 0.0 }
}

/// A bend after release. Its arc keeps its mean length.
#[must_use]
pub fn released(bend: &BendState, thickness: f64, material: &StripMaterial) -> BendState {
    bend.at_angle(bend.angle_rad * kept(bend.inside_radius, thickness, material), thickness)
}

/// All bends of a stage after release. The set is in mm.
#[must_use]
pub fn released_bends(set: &RollSet, stage: Stage) -> BTreeMap<u32, BendState> {
    let release = |bend: &BendState| released(bend, set.section.thickness, &set.strip);
    bend_states(set, stage).iter().map(|(&id, bend)| (id, release(bend))).collect()
}

/// What every bend that is bent at a stage does when it leaves it. The set is in mm.
#[must_use]
pub fn springback(set: &RollSet, stage: Stage) -> Vec<Springback> {
    let thickness = set.section.thickness;
    let of = |bend: &BendState| Springback {
        element: bend.element,
        angle_rad: bend.angle_rad,
        released_rad: released(bend, thickness, &set.strip).angle_rad,
        overbent_rad: overbent_rad(bend, thickness, &set.strip),
    };
    bend_states(set, stage).values().filter(|bend| bend.angle_rad != 0.0).map(of).collect()
}

/// The angle whose release is the angle of this bend, radians, its arc keeping its mean length.
#[must_use]
pub fn overbent_rad(bend: &BendState, thickness: f64, material: &StripMaterial) -> Option<f64> {
    let wanted = bend.angle_rad.abs();
    let after = |angle: f64| released(&bend.at_angle(angle, thickness), thickness, material).angle_rad;
    // Beyond this angle the inside radius would be negative.
    let (mut low, mut high) = (wanted, 2.0 * bend.arc / thickness);
    if !(high >= low && after(high) >= wanted) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if after(middle) < wanted { low = middle } else { high = middle }
    }
    Some(high.copysign(bend.angle_rad))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::bends::bend_state;
    use crate::rollform::fixtures::vee;

    fn steel(yield_strength_mpa: f64) -> StripMaterial {
        StripMaterial { yield_strength_mpa, ..StripMaterial::default() }
    }

    #[test]
    fn ratio_of_the_checked_cases() {
        let mild = kept(4.0, 2.0, &steel(250.0));
        assert!((mild - 0.99286).abs() < 0.000_005);
        assert!((4.0 / mild - 4.0288).abs() < 0.00005);
        assert!((90.0 * mild - 89.36).abs() < 0.005);
        assert!((kept(6.0, 1.6, &steel(697.0)) - 0.96265).abs() < 0.00002);
    }

    #[test]
    fn a_sharp_bend_keeps_its_angle_and_a_wide_one_loses_it() {
        assert_eq!(kept(0.0, 2.0, &steel(250.0)), 1.0);
        assert_eq!(kept(2000.0, 1.0, &steel(250.0)), 0.0);
        assert_eq!(kept(f64::INFINITY, 1.0, &steel(250.0)), 0.0);
    }

    #[test]
    fn release_of_the_overbend_is_the_wanted_angle() {
        for angle in [90.0, -90.0, 30.0] {
            let mut set = vee(&[angle]);
            set.strip = steel(500.0);
            let bend = bend_state(&set, Stage::Station(0), 2).unwrap();
            let overbent = overbent_rad(&bend, 1.0, &set.strip).unwrap();
            assert!(overbent.abs() > bend.angle_rad.abs() && overbent.signum() == bend.angle_rad.signum());
            let back = released(&bend.at_angle(overbent, 1.0), 1.0, &set.strip);
            assert!((back.angle_rad - bend.angle_rad).abs() < 1e-9);
        }
    }

    #[test]
    fn only_bent_bends_spring_back() {
        let set = vee(&[0.0, 45.0]);
        assert!(springback(&set, Stage::Station(0)).is_empty());
        let found = springback(&set, Stage::Station(1));
        assert_eq!(found.len(), 1);
        assert!(found[0].released_rad < 45.0_f64.to_radians());
        assert_eq!(released_bends(&set, Stage::Station(1))[&2].angle_rad, found[0].released_rad);
    }
}
