//! Bent more sharply than its material bears, the outside of a bend cracks.

use super::subject::Subject;
use crate::diagnostic::Diagnostic;

/// Bends with a smaller inside radius than the material bears.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let (material, thickness) = (&subject.set.strip, subject.set.section.thickness);
    let least = material.least_radius_per_thickness * thickness;
    let sharp = subject.bends().filter(|&(_, radius, _)| (0.0..least).contains(&radius));
    sharp
        .map(|(id, radius, _)| {
            let message = format!(
                "The inside radius is {}; {} bears {} ({} thicknesses).",
                subject.length(radius),
                material.name,
                subject.length(least),
                material.least_radius_per_thickness
            );
            Diagnostic::warning("least-radius", subject.element(id), message)
                .with_hint("Use a larger radius, or a material that bears it.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_below_the_radius_of_the_material() {
        let mut set = vee(&[90.0]);
        set.strip.least_radius_per_thickness = 2.0;
        assert!(found(check, &set).is_empty());
        set.strip.least_radius_per_thickness = 2.5;
        let found = found(check, &set);
        assert!(found[0].message.contains("2.000 mm") && found[0].message.contains("2.500 mm"), "{found:?}");
    }
}
