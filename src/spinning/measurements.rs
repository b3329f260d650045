//! The measurements published with the controller: set angle against measured angle and reduction.

use std::sync::LazyLock;

/// One sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement {
    /// Its number.
    pub sample: u32,
    /// Half angle that was set, degrees.
    pub set_deg: f64,
    /// Half angle that was measured, mean of two sides, degrees.
    pub measured_deg: f64,
    /// Reduction of the wall, a share; `None` where the published figures contradict one another.
    pub reduction: Option<f64>,
}

/// Samples whose published figures agree with one another (Mohamad 1988, appendices 4 and 5), formed over one former of 30°.
#[must_use]
pub fn published() -> &'static [Measurement] {
    static ALL: LazyLock<Vec<Measurement>> =
        LazyLock::new(|| read(include_str!("../../assets/flow/measurements-1988.csv")));
    &ALL
}

/// Rows that are not of the form are left out.
fn read(text: &str) -> Vec<Measurement> {
    text.lines()
        .skip(1)
        .filter_map(|line| {
            let mut cells = line.split(',');
            Some(Measurement {
                sample: cells.next()?.parse().ok()?,
                set_deg: cells.next()?.parse().ok()?,
                measured_deg: cells.next()?.parse().ok()?,
                reduction: cells.next()?.parse::<f64>().ok().map(|percent| percent / 100.0),
            })
        })
        .collect()
}

/// Mean of the measured angles of all samples with this set angle, degrees, and how many there are.
#[must_use]
pub fn mean_angle(set_deg: f64) -> Option<(f64, usize)> {
    let of: Vec<f64> = published().iter().filter(|m| m.set_deg == set_deg).map(|m| m.measured_deg).collect();
    (!of.is_empty()).then(|| (of.iter().sum::<f64>() / of.len() as f64, of.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_means_come_out() {
        for (set, mean, count) in [(30.0, 33.681, 35), (35.0, 36.062, 36), (40.0, 41.197, 54), (45.0, 45.939, 34)] {
            let (own, n) = mean_angle(set).unwrap();
            let reductions: Vec<f64> =
                published().iter().filter(|m| m.set_deg == set).filter_map(|m| m.reduction).collect();
            let reduction = 100.0 * reductions.iter().sum::<f64>() / reductions.len() as f64;
            let law = 100.0 * (1.0 - set.to_radians().sin());
            println!(
                "set {set}°: measured {own:.3}° ({n} samples), reduction {reduction:.2} % ({}), by the sine law {law:.2} %",
                reductions.len()
            );
            assert!((own - mean).abs() < 0.002 && n == count, "{set}: {own} of {n}");
        }
        assert_eq!(mean_angle(31.0), None);
        assert!(published().iter().filter(|m| m.reduction.is_some()).count() > 120);
    }
}
