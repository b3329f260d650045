//! The sectorial coordinate along a mean line, and from it shear centre and warping constant.

use super::Moments;
use super::quadrature::{Sample, samples};
use crate::geometry::{Contour, Point, Segment, Vector};

/// What follows from the sectorial coordinate.
pub(super) struct Sectorial {
    pub(super) shear_centre: Point,
    /// Warping constant, mm⁶.
    pub(super) warping: f64,
}

/// Shear centre and warping constant of a mean line with these area moments.
pub(super) fn of(mean_line: &Contour, thickness: f64, moments: &Moments) -> Sectorial {
    let shear_centre = shear_centre(mean_line, thickness, moments);
    let omega = Omega::about(shear_centre, mean_line);
    let warping = omega.places.iter().map(|(s, w)| thickness * w * w * s.ds).sum();
    Sectorial { shear_centre, warping }
}

/// `xs = (Iyω·Iy - Ixω·Ixy)/D`, `ys = -(Ixω·Ix - Iyω·Ixy)/D` with `D = Ix·Iy - Ixy²`.
fn shear_centre(mean_line: &Contour, thickness: f64, moments: &Moments) -> Point {
    let Moments { centroid, ix, iy, ixy, .. } = *moments;
    let omega = Omega::about(centroid, mean_line);
    let moment: Vector = omega.places.iter().map(|(s, w)| (s.point - centroid) * (w * s.ds * thickness)).sum();
    let determinant = ix * iy - ixy * ixy;
    let x = (moment.y * iy - moment.x * ixy) / determinant;
    let y = -(moment.x * ix - moment.y * ixy) / determinant;
    centroid + Vector::new(x, y)
}

/// The sectorial coordinate at the places of a mean line, mm², with a mean of 0.
struct Omega {
    places: Vec<(Sample, f64)>,
}

impl Omega {
    fn about(pole: Point, mean_line: &Contour) -> Self {
        let mut places = Vec::new();
        let mut before = 0.0;
        for segment in &mean_line.segments {
            let swept = Swept::of(segment, pole);
            places.extend(samples(segment).map(|s| (s, before + swept.until(s.along, &s))));
            before += swept.whole(segment);
        }
        let weight: f64 = places.iter().map(|(s, _)| s.ds).sum();
        let mean = places.iter().map(|(s, w)| w * s.ds).sum::<f64>() / weight;
        for (_, w) in &mut places {
            *w -= mean;
        }
        Self { places }
    }
}

/// Twice the area that the ray from the pole sweeps along a segment.
enum Swept {
    /// Distance of the line from the pole, mm.
    Line(f64),
    /// `ω(s) = s/κ + d × (p(s) - p(0))` with the centre `d` from the pole and the curvature κ.
    Arc { centre: Vector, start: Point, curvature_radius: f64 },
}

impl Swept {
    fn of(segment: &Segment, pole: Point) -> Self {
        match *segment {
            Segment::Line { start, .. } => Self::Line((start - pole).perp(&segment.direction_at(0.0))),
            Segment::Arc { start, center, ccw, .. } => {
                let radius = start.distance(center);
                Self::Arc { centre: center - pole, start, curvature_radius: if ccw { radius } else { -radius } }
            }
        }
    }

    fn until(&self, along: f64, sample: &Sample) -> f64 {
        self.at(along, sample.point)
    }

    fn whole(&self, segment: &Segment) -> f64 {
        self.at(segment.length(), segment.end())
    }

    fn at(&self, along: f64, point: Point) -> f64 {
        match *self {
            Self::Line(distance) => distance * along,
            Self::Arc { centre, start, curvature_radius } => along * curvature_radius + centre.perp(&(point - start)),
        }
    }
}
