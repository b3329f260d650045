//! The blank of a roll.

/// Standard diameters of roll blanks, mm (Wong 1983, 8.3.2).
const STANDARD_MM: [f64; 7] = [115.0, 130.0, 145.0, 160.0, 175.0, 190.0, 210.0];

/// Material that a blank has at least on the largest diameter, mm.
pub const BLANK_ALLOWANCE_MM: f64 = 10.0;

/// The standard blank for a roll: the next diameter that is [`BLANK_ALLOWANCE_MM`] above its largest one. Both in mm.
///
/// `None` above the largest standard diameter, where somebody has to be asked.
#[must_use]
pub fn standard_blank_mm(largest_diameter_mm: f64) -> Option<f64> {
    STANDARD_MM.into_iter().find(|&blank| blank >= largest_diameter_mm + BLANK_ALLOWANCE_MM)
}

/// What is left of a blank between two operations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Blank {
    /// Radius before the first operation, mm.
    pub first_radius: f64,
    /// Radius down to which roughing has cut all along the roll, mm.
    pub radius: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_next_standard_diameter_with_the_allowance_is_taken() {
        assert_eq!(standard_blank_mm(147.336), Some(160.0));
        assert_eq!(standard_blank_mm(150.0), Some(160.0));
        assert_eq!(standard_blank_mm(150.001), Some(175.0));
        assert_eq!(standard_blank_mm(20.0), Some(115.0));
        assert_eq!(standard_blank_mm(200.1), None);
        assert_eq!(standard_blank_mm(f64::NAN), None);
    }
}
