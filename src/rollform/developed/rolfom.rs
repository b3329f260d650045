//! The published table of ROLFOM (Wong 1983, Table 2.1): the share of the thickness by the angle of the bend.

/// Distance of the neutral line from the inside as a part of the thickness: 0.3 up to 80°, 0.4 up to 100°, 0.5 above.
pub(super) fn factor(angle_deg: f64) -> f64 {
    match angle_deg {
        a if a <= 80.0 => 0.3,
        a if a <= 100.0 => 0.4,
        _ => 0.5,
    }
}

#[cfg(test)]
mod tests {
    use super::factor;

    #[test]
    fn steps_belong_to_the_smaller_share() {
        assert_eq!([10.0, 80.0, 80.01, 100.0, 100.01, 180.0].map(factor), [0.3, 0.3, 0.4, 0.4, 0.5, 0.5]);
    }
}
