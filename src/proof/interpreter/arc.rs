//! Arcs: centre by I and K or by R.

use super::block::Taken;
use super::{Run, SAME_MM};
use crate::cancel::Cancelled;
use crate::geometry::{Point, Segment, Vector};
use crate::machine::ArcCenter;
use crate::proof::findings::Breach;
use crate::proof::report::FindingKind;
use std::f64::consts::{FRAC_PI_2, PI};

/// Radii of an arc's start and end may differ by this much, mm. The published 6T listing, which was cut, has 0.016.
const RADIUS_TOLERANCE_MM: f64 = 0.02;
/// An arc may pass a quadrant's border by this angle, radians, when rounding has moved its centre.
const QUADRANT_TOLERANCE: f64 = 0.05;

impl Run<'_, '_> {
    /// Drives along the arc that the block says.
    pub(super) fn arc(&mut self, ccw: bool, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let from = self.here();
        let to = self.target(words);
        let center = match words.take('R') {
            Some(radius) => {
                let radius = self.mm(radius);
                self.center_by_radius(from, to, radius, ccw)
            }
            None => self.center_by_offsets(from, to, ccw, words),
        };
        let Some(center) = center else { return self.go(Segment::line(from, to), false) };
        let path = Segment::Arc { start: from, end: to, center, ccw };
        self.check_quadrant(&path);
        self.go(path, false)
    }

    fn impossible(&mut self, value: f64, limit: f64, message: String) -> Option<Point> {
        let at = self.here() + Vector::new(self.control.zero_z, 0.0);
        self.find(Breach::error("arc impossible", FindingKind::OutsideLimits, value, limit, message).at(at));
        None
    }

    /// The centre of an arc of at most half a turn, or of more with a negative radius.
    fn center_by_radius(&mut self, from: Point, to: Point, radius: f64, ccw: bool) -> Option<Point> {
        let chord = to - from;
        let half = chord.norm() / 2.0;
        if half <= SAME_MM || radius == 0.0 || half > radius.abs() + RADIUS_TOLERANCE_MM / 2.0 {
            let message = format!(
                "No arc of radius {radius:.3} mm joins two points {:.3} mm apart; the distance must be above 0 and at most {:.3} mm.",
                2.0 * half,
                2.0 * radius.abs()
            );
            return self.impossible(2.0 * half, 2.0 * radius.abs(), message);
        }
        let height = (radius * radius - half * half).max(0.0).sqrt();
        let left = Vector::new(-chord.y, chord.x) / (2.0 * half);
        let side = if ccw == (radius > 0.0) { height } else { -height };
        Some(from + chord / 2.0 + left * side)
    }

    fn center_by_offsets(&mut self, from: Point, to: Point, ccw: bool, words: &mut Taken<'_>) -> Option<Point> {
        let (i, k) = (words.take('I'), words.take('K'));
        if i.is_none() && k.is_none() {
            let message = "The arc has neither I and K nor R; the control cannot know its centre.".to_owned();
            return self.impossible(0.0, 1.0, message);
        }
        let i = i.map_or(0.0, |i| self.radial(i));
        let k = k.map_or(0.0, |k| self.mm(k));
        let origin = if self.state.arc_center == ArcCenter::Absolute { Point::default() } else { from };
        let signs: &[(f64, f64)] = if self.control.words.arc_center_signed {
            &[(1.0, 1.0)]
        } else {
            &[(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)]
        };
        let miss = |c: &Point| (from.distance(*c) - to.distance(*c)).abs();
        let within = |c: &Point| quarter_or_less(&Segment::Arc { start: from, end: to, center: *c, ccw });
        let given = signs.iter().map(|(a, b)| origin + Vector::new(b * k, a * i));
        // Without signs the centre is the one for which the arc stays within a quadrant.
        let center = given.min_by(|a, b| {
            let key = |c: &Point| (signs.len() > 1 && !within(c), miss(c));
            key(a).0.cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1))
        })?;
        let (first, last) = (from.distance(center), to.distance(center));
        if miss(&center) > RADIUS_TOLERANCE_MM || first <= SAME_MM || from.distance(to) <= SAME_MM {
            let message = format!(
                "The centre of the arc is {first:.3} mm from its start and {last:.3} mm from its end; {RADIUS_TOLERANCE_MM} mm of \
                 difference are allowed, and start and end must differ."
            );
            self.impossible(miss(&center), RADIUS_TOLERANCE_MM, message);
        }
        on_bisector(from, to, center)
    }

    /// Some controls cannot pass from one quadrant to the next in one block.
    fn check_quadrant(&mut self, path: &Segment) {
        if !self.control.machine.limits.arc_one_quadrant || quarter_or_less(path) {
            return;
        }
        let degrees = path.sweep().abs().to_degrees();
        let message = format!(
            "The arc of {degrees:.1} degrees passes from one quadrant to the next; the control takes one quadrant a block."
        );
        self.limit_error("quadrant", degrees, 90.0, message);
    }
}

/// The point with the same distance from both ends that is nearest to `center`; rounding of words moves it by a thousandth.
fn on_bisector(from: Point, to: Point, center: Point) -> Option<Point> {
    let chord = (to - from).try_normalize(0.0)?;
    let middle = from + (to - from) / 2.0;
    Some(center - chord * (center - middle).dot(&chord))
}

/// True if an arc stays between two axes through its centre.
fn quarter_or_less(path: &Segment) -> bool {
    let Segment::Arc { start, center, .. } = *path else { return true };
    let sweep = path.sweep();
    if sweep.abs() > FRAC_PI_2 + QUADRANT_TOLERANCE {
        return false;
    }
    let first = (start - center).y.atan2((start - center).x) + PI;
    // Borders strictly within the arc, less the tolerance at either end.
    let (low, high) = if sweep > 0.0 { (first, first + sweep) } else { (first + sweep, first) };
    let border = ((low + QUADRANT_TOLERANCE) / FRAC_PI_2).ceil() * FRAC_PI_2;
    border > high - QUADRANT_TOLERANCE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrants_are_told_apart() {
        let arc = |from: f64, to: f64, ccw| {
            let at = |degrees: f64| Point::new(degrees.to_radians().cos(), degrees.to_radians().sin());
            Segment::Arc { start: at(from), end: at(to), center: Point::default(), ccw }
        };
        for (from, to, ccw, within) in [
            (0.0, 90.0, true, true),
            (90.0, 0.0, false, true),
            (10.0, 80.0, true, true),
            (45.0, 135.0, true, false),
            (170.0, 260.0, true, false),
            (270.0, 180.0, false, true),
            (-1.0, 89.0, true, true),
            (0.0, 180.0, true, false),
        ] {
            assert_eq!(quarter_or_less(&arc(from, to, ccw)), within, "{from} {to}");
        }
    }
}
