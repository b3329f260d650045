//! The finished contour as lines and arcs: parabolas become pairs of tangent arcs.

use super::{Curve, Parabola, ParabolaAxis, PartContour, Profile};
use crate::geometry::{self, Contour, Segment, Vector};

/// A parabola is halved no further than this many times.
const DEEPEST: u32 = 16;

/// Points at which each pair of arcs is compared with its parabola.
const CHECKS: u32 = 16;

/// Share of the tolerance that may show at those points, so that it holds between them, too.
const SAFETY: f64 = 0.95;

/// The profile as lines and arcs. Lines and arcs stay as they are; a parabola becomes tangent-continuous arcs, none
/// further than `tolerance_mm` from it.
#[must_use]
pub fn contour(profile: &Profile, tolerance_mm: f64) -> PartContour {
    let mut segments = Vec::with_capacity(profile.pieces.len());
    let mut sections = Vec::with_capacity(profile.pieces.len());
    for piece in &profile.pieces {
        match &piece.curve {
            Curve::Segment(segment) => segments.push(*segment),
            Curve::Parabola(parabola) => arcs(parabola, tolerance_mm, &mut segments),
        }
        sections.resize(segments.len(), piece.section);
    }
    PartContour { contour: Contour::new(segments), sections }
}

/// Adds the arcs of a parabola.
fn arcs(parabola: &Parabola, tolerance: f64, out: &mut Vec<Segment>) {
    // Either side of the vertex the curvature only grows or only falls, as a biarc wants it.
    let middle = parabola.vertex_share();
    let stops = [Some(0.0), middle, Some(1.0)];
    let stops: Vec<f64> = stops.into_iter().flatten().collect();
    for (&t1, &t2) in stops.iter().zip(stops.iter().skip(1)) {
        halve(parabola, t1, t2, tolerance, DEEPEST, out);
    }
}

fn halve(parabola: &Parabola, t1: f64, t2: f64, tolerance: f64, depth: u32, out: &mut Vec<Segment>) {
    let pair = biarc(parabola, t1, t2);
    if depth == 0 || deviation(parabola, t1, t2, &pair) <= SAFETY * tolerance {
        out.extend(pair);
        return;
    }
    let middle = f64::midpoint(t1, t2);
    halve(parabola, t1, middle, tolerance, depth - 1, out);
    halve(parabola, middle, t2, tolerance, depth - 1, out);
}

/// Two arcs with the parabola's ends and directions at `t1` and `t2`, and the same direction where they meet.
fn biarc(parabola: &Parabola, t1: f64, t2: f64) -> [Segment; 2] {
    let (start, end) = (parabola.point_at(t1), parabola.point_at(t2));
    geometry::biarc(start, parabola.direction_at(t1), end, parabola.direction_at(t2))
}

/// Largest distance of the checked points of the parabola between `t1` and `t2` from the pair of arcs, mm.
fn deviation(parabola: &Parabola, t1: f64, t2: f64, pair: &[Segment; 2]) -> f64 {
    (1..CHECKS)
        .map(|k| parabola.point_at(t1 + (t2 - t1) * f64::from(k) / f64::from(CHECKS)))
        .map(|p| pair.iter().map(|segment| segment.distance_to(p)).fold(f64::INFINITY, f64::min))
        .fold(0.0, f64::max)
}

impl Parabola {
    /// Direction of travel at share `t`, unit length.
    fn direction_at(&self, t: f64) -> Vector {
        let (u1, v1) = self.axis.uv(self.start);
        let (u2, v2) = self.axis.uv(self.end);
        let du = u2 - u1;
        let dv = v2 - v1 + self.bulge() * (2.0 * t - 1.0);
        let direction = match self.axis {
            ParabolaAxis::AlongX => Vector::new(du, dv),
            ParabolaAxis::AlongZ => Vector::new(dv, du),
        };
        direction.normalize()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::part::{Piece, PieceRole};

    const TOLERANCE_MM: f64 = 0.002;

    fn made(parabola: Parabola) -> PartContour {
        let piece = Piece { curve: Curve::Parabola(parabola), section: 7, role: PieceRole::Surface };
        contour(&Profile { pieces: vec![piece] }, TOLERANCE_MM)
    }

    fn examples() -> [Parabola; 4] {
        let p = Point::new;
        [
            Parabola::through(p(5.0, 8.0), p(14.0, 5.0), ParabolaAxis::AlongX, -0.1, 10),
            Parabola::through(p(0.0, 2.0), p(10.0, 2.0), ParabolaAxis::AlongX, 3.0, 10),
            Parabola::through(p(0.0, 5.0), p(10.0, 0.0), ParabolaAxis::AlongZ, -0.4, 10),
            Parabola::through(p(0.0, 5.0), p(10.0, 0.0), ParabolaAxis::AlongZ, 0.399, 10),
        ]
    }

    #[test]
    fn arcs_stay_within_tolerance() {
        for parabola in examples() {
            let arcs = made(parabola).contour;
            for k in 0..=10_000 {
                let distance = arcs.distance_to(parabola.point_at(f64::from(k) / 10_000.0));
                assert!(distance <= TOLERANCE_MM, "{distance} mm at {k} of {parabola:?}");
            }
        }
    }

    #[test]
    fn arcs_are_connected_and_tangent() {
        for parabola in examples() {
            let made = made(parabola);
            assert!(made.contour.largest_gap() < 1e-12);
            assert_eq!(made.sections.len(), made.contour.segments.len());
            for pair in made.contour.segments.windows(2) {
                let kink = pair[0].direction_at(1.0) - pair[1].direction_at(0.0);
                assert!(kink.norm() < 1e-6, "{kink:?}");
            }
        }
    }

    #[test]
    fn few_arcs_are_enough() {
        let [gentle, ..] = examples();
        assert!(made(gentle).contour.segments.len() <= 16);
    }
}
