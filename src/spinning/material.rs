//! What materials bear.

/// Limits of one material in flow-turning and spinning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpinningMaterial {
    /// Name as in documents.
    pub name: &'static str,
    /// Largest reduction of the wall in one go without annealing, a share.
    pub max_reduction: f64,
}

/// Largest ratio of a blank's diameter to the finished one for one pass of conventional spinning: guide value from
/// workshop practice.
pub const SPINNING_RATIO_PER_PASS: f64 = 1.6;

/// Largest reduction that is possible at all (Mohamad 1988, section 1.2: "up to 80 %").
pub const LARGEST_REDUCTION: f64 = 0.8;

/// Reductions of cones after R. L. Kegg's tests as handbooks list them, quoted from memory: guide values. Pure aluminium,
/// copper and brass are workshop practice.
const MATERIALS: [SpinningMaterial; 12] = [
    SpinningMaterial { name: "ALUMINIUM", max_reduction: 0.75 },
    SpinningMaterial { name: "EN AW-6061", max_reduction: 0.75 },
    SpinningMaterial { name: "EN AW-5086", max_reduction: 0.65 },
    SpinningMaterial { name: "EN AW-2024", max_reduction: 0.50 },
    SpinningMaterial { name: "EN AW-7075", max_reduction: 0.65 },
    SpinningMaterial { name: "COPPER", max_reduction: 0.70 },
    SpinningMaterial { name: "BRASS", max_reduction: 0.60 },
    SpinningMaterial { name: "S235JR", max_reduction: 0.70 },
    SpinningMaterial { name: "42CrMo4", max_reduction: 0.75 },
    SpinningMaterial { name: "X5CrNi18-10", max_reduction: 0.75 },
    SpinningMaterial { name: "X155CrVMo12-1", max_reduction: 0.50 },
    SpinningMaterial { name: "Ti-6Al-4V HOT", max_reduction: 0.55 },
];

/// All materials with known limits.
#[must_use]
pub const fn materials() -> &'static [SpinningMaterial] {
    &MATERIALS
}

/// The limits of a material by name, without regard to case.
#[must_use]
pub fn material(name: &str) -> Option<&'static SpinningMaterial> {
    MATERIALS.iter().find(|m| m.name.eq_ignore_ascii_case(name.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_in_any_case_and_no_limit_is_beyond_the_possible() {
        assert_eq!(material(" aluminium ").map(|m| m.name), Some("ALUMINIUM"));
        assert_eq!(material("CHEESE"), None);
        assert!(materials().iter().all(|m| m.max_reduction > 0.0 && m.max_reduction <= LARGEST_REDUCTION));
    }
}
