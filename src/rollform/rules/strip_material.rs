//! Strain and springback divide by the stiffness of the material and the mass by its density.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};

/// Figures of the material that are not greater than 0, and a negative least radius.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let material = &subject.set.strip;
    let report = |what: &str, value: f64, unit: &str, limit: &str| {
        let message = format!("The {what} of {} is {value} {unit}; it must be {limit}.", material.name);
        Diagnostic::error("strip-material", Place::Document, message)
    };
    let positive = [
        ("yield strength", material.yield_strength_mpa, "MPa"),
        ("modulus of elasticity", material.youngs_modulus_gpa, "GPa"),
        ("density", material.density_g_per_cm3, "g/cm³"),
    ];
    let bad = positive.into_iter().filter(|&(_, value, _)| value <= 0.0);
    let mut found: Vec<Diagnostic> =
        bad.map(|(what, value, unit)| report(what, value, unit, "greater than 0")).collect();
    if material.least_radius_per_thickness < 0.0 {
        found.push(report("least radius", material.least_radius_per_thickness, "thicknesses", "at least 0"));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_for_every_figure() {
        let mut set = vee(&[90.0]);
        assert!(found(check, &set).is_empty());
        set.strip.yield_strength_mpa = 0.0;
        set.strip.youngs_modulus_gpa = -1.0;
        set.strip.density_g_per_cm3 = 0.0;
        set.strip.least_radius_per_thickness = -0.5;
        assert_eq!(found(check, &set).len(), 4);
    }
}
