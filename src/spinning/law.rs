//! The laws of the process: sine law, constant volume, reduction.
//!
//! Sources: Mohamad 1988, sections 1.1 and 1.2 (sine law, elements keep their radius, volume stays the same).

use crate::document::Forming;
use std::f64::consts::{FRAC_PI_2, PI};

/// Wall thickness where the wall stands at `half_angle` (radians) to the axis: `t = t0 · sin α` by the sine law, `t0` in
/// conventional spinning. A wall that turns back has none.
#[must_use]
pub fn wall(forming: Forming, blank_thickness: f64, half_angle: f64) -> f64 {
    match forming {
        Forming::Shear => blank_thickness * half_angle.sin().max(0.0),
        Forming::Spinning => blank_thickness,
    }
}

/// Reduction of the wall as a share of the blank's thickness: `1 − t/t0`.
#[must_use]
pub fn reduction(wall: f64, blank_thickness: f64) -> f64 {
    if blank_thickness > 0.0 { 1.0 - wall / blank_thickness } else { 0.0 }
}

/// Angle of the wall to the axis after pass `pass` of `passes`, radians, where the finished one is `half_angle`.
///
/// Flow-turning: every pass reduces by the same share, `sin αₖ = (sin α)^(k/n)`. Spinning: the wall turns by equal angles.
#[must_use]
pub fn angle_after(forming: Forming, half_angle: f64, pass: u32, passes: u32) -> f64 {
    let share = f64::from(pass) / f64::from(passes.max(1));
    match forming {
        Forming::Shear => half_angle.sin().max(0.0).powf(share).asin(),
        Forming::Spinning => FRAC_PI_2 + (half_angle - FRAC_PI_2) * share,
    }
}

/// Radius of the disc of `thickness` with this volume, mm.
#[must_use]
pub fn disc_radius(volume: f64, thickness: f64) -> f64 {
    (volume / (PI * thickness)).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thirty_degree_cone_halves_the_wall() {
        let t = wall(Forming::Shear, 1.6, 30.0_f64.to_radians());
        assert!((t - 0.8).abs() < 1e-12);
        assert!((reduction(t, 1.6) - 0.5).abs() < 1e-12);
        assert!((wall(Forming::Spinning, 1.6, 0.5) - 1.6).abs() < 1e-12);
        assert_eq!(wall(Forming::Shear, 1.6, -0.1), 0.0);
    }

    #[test]
    fn two_passes_share_the_reduction() {
        let ten = 10.0_f64.to_radians();
        let first = angle_after(Forming::Shear, ten, 1, 2);
        let share = |thick: f64, thin: f64| 1.0 - thin / thick;
        assert!((share(1.0, first.sin()) - share(first.sin(), ten.sin())).abs() < 1e-12);
        assert!((angle_after(Forming::Shear, ten, 2, 2) - ten).abs() < 1e-12);
        assert!((angle_after(Forming::Spinning, 0.0, 1, 2).to_degrees() - 45.0).abs() < 1e-9);
    }
}
