//! Power of a cut and of a spindle, and the feed that both allow.
//!
//! Formulae: chip thickness h = f · sin κ, width b = a / sin κ with depth a, feed f and approach angle κ; specific force
//! kc = kc1.1 · h^−mc (Kienzle, 1952); force Fc = kc · b · h = kc · a · f; power Pc = Fc · vc. The spindle gives its rated power
//! from `full_power_rpm`, below it a constant torque, so that the power grows with the speed; `efficiency` of it reaches the
//! cut (MTIRA turning processor, 1977, rule of the speed at which full power is reached).

use super::{Material, Spindle};

/// A chip, as depth, feed and approach angle make it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chip {
    /// Depth of cut on the radius (of a blade or drill the width of its edge), mm.
    pub depth_mm: f64,
    /// Feed, mm per turn.
    pub feed_mm_per_rev: f64,
    /// Angle between cutting edge and direction of feed, degrees; 90 is on the safe side by no more than the nose.
    pub approach_deg: f64,
}

impl Material {
    /// Specific cutting force, N/mm², for a chip thickness in mm; `None` if the table does not give it.
    #[must_use]
    pub fn specific_force(&self, chip_thickness_mm: f64) -> Option<f64> {
        let force = self.specific_cutting_force_n_per_mm2?;
        Some(force * chip_thickness_mm.max(f64::MIN_POSITIVE).powf(-self.mc.unwrap_or(0.0)))
    }

    /// Power that a cut takes at a cutting speed in m/min, kW; `None` if the table does not give the specific force.
    ///
    /// `Pc = kc · a · f · vc / 60 000`, with kc in N/mm², a and f in mm, vc in m/min.
    #[must_use]
    pub fn cutting_power_kw(&self, chip: Chip, speed_m_per_min: f64) -> Option<f64> {
        let thickness = chip.feed_mm_per_rev * chip.approach_deg.to_radians().sin();
        let force = self.specific_force(thickness)? * chip.depth_mm * chip.feed_mm_per_rev;
        Some(force * speed_m_per_min / 60_000.0)
    }
}

impl Spindle {
    /// Power at the cut that the spindle can give at `rpm`, kW; `None` if its power is not known.
    #[must_use]
    pub fn power_at_kw(&self, rpm: f64) -> Option<f64> {
        let share = self.full_power_rpm.map_or(1.0, |full| (rpm / full).clamp(0.0, 1.0));
        Some(self.power_kw? * self.efficiency * share)
    }

    /// The feed in mm per turn that the spindle's power allows for a chip at `rpm`: that of the chip, or less.
    ///
    /// The power goes with `f^(1 − mc)`; where it does not suffice, `f' = f · (P available / P needed)^(1 / (1 − mc))`.
    /// Unchanged where power or specific force is not known.
    #[must_use]
    pub fn feed_within_power(&self, material: &Material, chip: Chip, speed_m_per_min: f64, rpm: f64) -> f64 {
        let feed = chip.feed_mm_per_rev;
        let needed = material.cutting_power_kw(chip, speed_m_per_min);
        let (Some(available), Some(needed)) = (self.power_at_kw(rpm), needed) else { return feed };
        if needed <= available {
            return feed;
        }
        feed * (available / needed).powf(1.0 / (1.0 - material.mc.unwrap_or(0.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Catalog, CuttingOperation, ToolMaterial};
    use crate::units::Unit;

    fn c45() -> Material {
        Catalog::shipped().material("C45", Unit::Mm).unwrap().clone()
    }

    const CHIP: Chip = Chip { depth_mm: 3.0, feed_mm_per_rev: 0.3, approach_deg: 90.0 };

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9 * b.abs().max(1.0)
    }

    #[test]
    fn power_is_force_times_speed() {
        // 2220 N/mm² · 0.3^−0.14 = 2627.6 N/mm²; · 3 mm · 0.3 mm = 2364.8 N; · 200 m/min = 7.88 kW.
        let power = c45().cutting_power_kw(CHIP, 200.0).unwrap();
        assert!((power - 7.883).abs() < 0.001, "{power}");
        // A thinner chip at 45° has a higher specific force.
        let flat = Chip { approach_deg: 45.0, ..CHIP };
        assert!(c45().cutting_power_kw(flat, 200.0).unwrap() > power);
    }

    #[test]
    fn the_spindle_gives_full_power_from_its_speed_on() {
        let catalog = Catalog::shipped();
        let spindle = &catalog.machine("fanuc-0i").unwrap().spindle;
        assert!(close(spindle.power_at_kw(1150.0).unwrap(), 15.0 * 0.85));
        assert!(close(spindle.power_at_kw(4000.0).unwrap(), 15.0 * 0.85));
        assert!(close(spindle.power_at_kw(575.0).unwrap(), 15.0 * 0.85 / 2.0));
        assert_eq!(catalog.machine("orac").unwrap().spindle.power_at_kw(1000.0), None);
    }

    #[test]
    fn the_reduced_feed_takes_exactly_the_power_that_is_there() {
        let catalog = Catalog::shipped();
        let spindle = &catalog.machine("linuxcnc").unwrap().spindle;
        // 4 kW · 0.8 at 400 of 700 rev/min.
        let available = 4.0 * 0.8 * 400.0 / 700.0;
        let feed = spindle.feed_within_power(&c45(), CHIP, 200.0, 400.0);
        let power = c45().cutting_power_kw(Chip { feed_mm_per_rev: feed, ..CHIP }, 200.0).unwrap();
        assert!(feed < CHIP.feed_mm_per_rev && close(power, available), "{feed} {power}");
        let light = Chip { depth_mm: 0.2, ..CHIP };
        assert_eq!(spindle.feed_within_power(&c45(), light, 200.0, 400.0), light.feed_mm_per_rev);
        let orac = &catalog.machine("orac").unwrap().spindle;
        assert_eq!(orac.feed_within_power(&c45(), CHIP, 200.0, 400.0), CHIP.feed_mm_per_rev);
    }

    #[test]
    fn every_shipped_material_has_data_for_every_operation_and_a_force() {
        use CuttingOperation::{BoreFinish, BoreRough, Drill, Face, Finish, Groove, PartOff, Rough, Thread};
        for material in Catalog::shipped().materials {
            for tool in [ToolMaterial::Carbide, ToolMaterial::Hss] {
                for operation in [Rough, Finish, Face, Groove, PartOff, Drill, BoreRough, BoreFinish, Thread] {
                    let data = material.cutting(operation, tool);
                    assert!(data.is_some_and(|d| d.speed_m_per_min > 0.0), "{} {operation:?}", material.name);
                }
            }
            assert!(material.cutting_power_kw(CHIP, 100.0).is_some_and(|p| p > 0.0), "{}", material.name);
        }
    }
}
