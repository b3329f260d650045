//! Sequences of angles from flat to finished, by name.

use std::f64::consts::FRAC_PI_2;

/// How the angle of a bend grows from station to station.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sequence {
    /// The same step at every station.
    EvenAngles,
    /// The same rise of the leg's end at every station, as in the forming-angle method.
    EvenHeight,
    /// The same step of the leg's projection on the base at every station.
    EvenProjection,
    /// `cos θ = 1 + (1 - cos θ0)·(2x³ - 3x²)`: small steps at the beginning and at the end. A guide value.
    #[default]
    CosineCubic,
}

impl Sequence {
    /// All sequences in the order of a list.
    pub const ALL: [Self; 4] = [Self::CosineCubic, Self::EvenAngles, Self::EvenHeight, Self::EvenProjection];

    /// Name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::EvenAngles => "even angles",
            Self::EvenHeight => "even height",
            Self::EvenProjection => "even projection",
            Self::CosineCubic => "cosine cubic",
        }
    }

    /// The angle at a part of the way, 0 to 1, to a finished angle of at most half a turn, radians. A larger finished angle
    /// grows evenly: the other rules look at the leg's end, which would come round again.
    #[must_use]
    pub fn angle_rad(self, finished_rad: f64, part: f64) -> f64 {
        let (whole, x) = (finished_rad.abs(), part.clamp(0.0, 1.0));
        let share_of_cosine = |share: f64| (1.0 - (1.0 - whole.cos()) * share).clamp(-1.0, 1.0).acos();
        let angle = match self {
            _ if x == 1.0 || whole > std::f64::consts::PI => whole * x,
            Self::EvenAngles => whole * x,
            Self::EvenHeight => at_rise(rise(whole) * x),
            Self::EvenProjection => share_of_cosine(x),
            Self::CosineCubic => share_of_cosine(3.0 * x * x - 2.0 * x.powi(3)),
        };
        angle.copysign(finished_rad)
    }
}

/// Way up and, beyond a right angle, down again of a leg of length 1.
fn rise(angle: f64) -> f64 {
    if angle <= FRAC_PI_2 { angle.sin() } else { 2.0 - angle.sin() }
}

fn at_rise(rise: f64) -> f64 {
    if rise <= 1.0 { rise.clamp(0.0, 1.0).asin() } else { FRAC_PI_2 + (2.0 - rise).clamp(0.0, 1.0).acos() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn degrees(sequence: Sequence, finished_deg: f64, count: u32) -> Vec<f64> {
        let at = |i| sequence.angle_rad(finished_deg.to_radians(), f64::from(i) / f64::from(count)).to_degrees();
        (1..=count).map(at).collect()
    }

    #[test]
    fn cosine_cubic_of_a_right_angle_in_six_stations() {
        let wanted = [22.2, 42.2, 60.0, 75.0, 85.8, 90.0];
        for (angle, wanted) in degrees(Sequence::CosineCubic, 90.0, 6).into_iter().zip(wanted) {
            assert!((angle - wanted).abs() < 0.05, "{angle} {wanted}");
        }
    }

    #[test]
    fn even_height_rises_evenly() {
        let heights: Vec<f64> = degrees(Sequence::EvenHeight, 90.0, 4).iter().map(|a| a.to_radians().sin()).collect();
        for (height, wanted) in heights.iter().zip([0.25, 0.5, 0.75, 1.0]) {
            assert!((height - wanted).abs() < 1e-12);
        }
    }

    #[test]
    fn every_sequence_grows_to_the_finished_angle_and_not_beyond() {
        for sequence in Sequence::ALL {
            for finished in [5.0, 90.0, 135.0, 180.0, 200.0, -90.0, -180.0] {
                let angles = degrees(sequence, finished, 7);
                let sizes: Vec<f64> = angles.iter().map(|a| a.abs()).collect();
                assert!(sizes.is_sorted() && sizes[0] > 0.0, "{sequence:?} {angles:?}");
                assert!((angles[6] - finished).abs() < 1e-9);
                assert!(angles.iter().all(|a| a.signum() == finished.signum()));
            }
        }
    }
}
