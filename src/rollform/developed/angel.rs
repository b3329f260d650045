//! Angel's formula (Wong 1983, eq. 2.2).

/// Bend allowance, mm: (0.01743 R + 0.0078 T)·A with the angle in degrees.
pub(super) fn allowance_mm(radius: f64, angle_deg: f64, thickness: f64) -> f64 {
    (0.01743 * radius + 0.0078 * thickness) * angle_deg
}

#[cfg(test)]
mod tests {
    #[test]
    fn square_bend_of_radius_4_in_2_mm() {
        assert!((super::allowance_mm(4.0, 90.0, 2.0) - 7.679).abs() < 0.0005);
    }
}
