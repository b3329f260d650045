//! The outline of the forming roller about the centre of its nose.

use crate::document::Roller;
use crate::geometry::{Point, Vector};

/// The body of the roller without its nose: a convex outline about the nose's centre, mm.
///
/// From the nose its flanks open to the full width, then it stays as wide up to its diameter.
#[must_use]
pub fn body(roller_mm: &Roller) -> Vec<Point> {
    let swivel = roller_mm.swivel_deg.to_radians();
    let flank = roller_mm.flank_deg.to_radians();
    let plane = Vector::new(swivel.sin(), swivel.cos());
    let side = Vector::new(swivel.cos(), -swivel.sin());
    let nose = roller_mm.nose_radius;
    let half_width = (roller_mm.width / 2.0).max(nose);
    // Where the flank touches the nose, seen from its centre: across the flank's direction.
    let (touch_side, touch_up) = (nose * flank.cos(), -nose * flank.sin());
    let rise = (half_width - touch_side) / flank.tan().max(1e-6) + touch_up;
    let top = (roller_mm.diameter - nose).max(rise);
    let at = |across: f64, up: f64| Point::default() + side * across + plane * up;
    let half = [(touch_side, touch_up), (half_width, rise.min(top)), (half_width, top)];
    let right = half.iter().map(|&(x, y)| at(x, y));
    let left = half.iter().rev().map(|&(x, y)| at(-x, y));
    right.chain(left).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spinning::Shell;

    #[test]
    fn the_flanks_touch_the_nose() {
        let roller = Shell::default().roller;
        let body = body(&roller);
        assert_eq!(body.len(), 6);
        for corner in [body[0], body[5]] {
            assert!((corner.distance(Point::default()) - roller.nose_radius).abs() < 1e-9);
        }
        // Tangent: the flank is square to the radius where it begins.
        assert!((body[1] - body[0]).dot(&(body[0] - Point::default())).abs() < 1e-9);
        let widest = body[2].distance(body[3]);
        assert!((widest - roller.width).abs() < 1e-9);
    }
}
