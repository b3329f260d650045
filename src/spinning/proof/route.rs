//! Segments prepared for many measurements: what does not change from place to place is worked out once.

use crate::geometry::{Bounds, Point, Segment, Vector};
use std::f64::consts::PI;

/// A segment with its box and, of an arc, its circle.
pub(super) struct Prepared {
    segment: Segment,
    bounds: Bounds,
    circle: Option<Circle>,
}

/// The circle of an arc, seen from its centre.
struct Circle {
    center: Point,
    radius: f64,
    /// To start, middle and end.
    from: Vector,
    middle: Vector,
    to: Vector,
    /// Angle of the start and, signed, from there to the end, radians.
    angle: f64,
    sweep: f64,
}

impl Circle {
    fn of(segment: &Segment) -> Option<Self> {
        let Segment::Arc { start, end, center, .. } = *segment else { return None };
        let (from, radius, sweep) = (start - center, start.distance(center), segment.sweep());
        let angle = from.y.atan2(from.x);
        let (sin, cos) = (angle + sweep / 2.0).sin_cos();
        Some(Self { center, radius, from, middle: Vector::new(cos, sin), to: end - center, angle, sweep })
    }

    /// True if the arc passes in this direction from its centre.
    fn faces(&self, direction: Vector) -> bool {
        let side = self.sweep.signum();
        let (behind_start, before_end) = (side * self.from.perp(&direction), side * direction.perp(&self.to));
        if self.sweep.abs() <= PI {
            behind_start >= 0.0 && before_end >= 0.0 && self.middle.dot(&direction) >= 0.0
        } else {
            behind_start >= 0.0 || before_end >= 0.0
        }
    }

    fn at(&self, share: f64) -> Point {
        let (sin, cos) = (self.angle + self.sweep * share).sin_cos();
        self.center + Vector::new(cos, sin) * self.radius
    }
}

impl Prepared {
    pub(super) fn new(segment: &Segment) -> Self {
        Self { segment: *segment, bounds: segment.bounds(), circle: Circle::of(segment) }
    }

    /// The segment itself.
    pub(super) const fn segment(&self) -> &Segment {
        &self.segment
    }

    /// The place at a share of its length; the ends are returned exactly.
    pub(super) fn point_at(&self, share: f64) -> Point {
        match &self.circle {
            Some(circle) if share > 0.0 && share < 1.0 => circle.at(share),
            _ => self.segment.point_at(share),
        }
    }

    /// The point nearest to `p`.
    pub(super) fn nearest(&self, p: Point) -> Point {
        let Some(circle) = &self.circle else { return self.segment.nearest_point(p) };
        let direction = p - circle.center;
        let far = direction.norm();
        let (start, end) = (self.segment.start(), self.segment.end());
        if far <= 0.0 {
            return start;
        }
        if circle.faces(direction) {
            return circle.center + direction * (circle.radius / far);
        }
        if (p - start).norm_squared() <= (p - end).norm_squared() { start } else { end }
    }
}

/// Segments of which the nearest one is asked for.
pub(super) struct Route {
    pieces: Vec<Prepared>,
}

/// The nearest place of a route.
#[derive(Clone, Copy)]
pub(super) struct Nearest {
    /// How far away it is, mm.
    pub distance: f64,
    /// Where it is.
    pub at: Point,
    /// The number of its segment.
    pub piece: usize,
}

impl Route {
    pub(super) fn new<'a>(segments: impl Iterator<Item = &'a Segment>) -> Self {
        Self { pieces: segments.map(Prepared::new).collect() }
    }

    /// The segment with this number.
    pub(super) fn segment(&self, piece: usize) -> Option<&Segment> {
        self.pieces.get(piece).map(Prepared::segment)
    }

    /// The place nearest to `p`; `None` without segments. `hint` is the segment that is looked at first and becomes the one
    /// that was found: from one place to the next it hardly changes, and the boxes of the others are then too far away.
    pub(super) fn nearest(&self, p: Point, hint: &mut usize) -> Option<Nearest> {
        let mut best: Option<(f64, Point, usize)> = None;
        let mut look = |index: usize, piece: &Prepared| {
            if best.is_none_or(|(least, ..)| squared_gap(&piece.bounds, p) < least) {
                let at = piece.nearest(p);
                let squared = (at - p).norm_squared();
                if best.is_none_or(|(least, ..)| squared < least) {
                    best = Some((squared, at, index));
                }
            }
        };
        self.pieces.get(*hint).into_iter().for_each(|piece| look(*hint, piece));
        self.pieces.iter().enumerate().for_each(|(index, piece)| look(index, piece));
        let (_, at, piece) = best?;
        *hint = piece;
        Some(Nearest { distance: at.distance(p), at, piece })
    }
}

/// Square of the distance of a point from a box, mm².
pub(super) fn squared_gap(b: &Bounds, p: Point) -> f64 {
    let dz = (b.min.z - p.z).max(p.z - b.max.z).max(0.0);
    let dr = (b.min.r - p.r).max(p.r - b.max.r).max(0.0);
    dz * dz + dr * dr
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(z: f64, r: f64) -> Point {
        Point::new(z, r)
    }

    /// Lines and arcs of either hand, less and more than half a turn, hardly bent, and a full turn.
    fn segments() -> Vec<Segment> {
        let arc = |start, end, center, ccw| Segment::Arc { start, end, center, ccw };
        vec![
            Segment::line(p(0.0, 0.0), p(10.0, 4.0)),
            Segment::line(p(3.0, 3.0), p(3.0, 3.0)),
            arc(p(10.0, 0.0), p(0.0, 10.0), p(0.0, 0.0), true),
            arc(p(10.0, 0.0), p(0.0, 10.0), p(0.0, 0.0), false),
            arc(p(-5.0, 0.0), p(5.0, 0.0), p(0.0, 0.0), true),
            arc(p(-5.0, 0.0), p(5.0, 0.0), p(0.0, 0.0), false),
            arc(p(0.0, 8.0), p(0.01, 8.0), p(0.005, -4000.0), false),
            arc(p(5.0, 0.0), p(5.0, 0.0), p(0.0, 0.0), true),
        ]
    }

    fn grid() -> impl Iterator<Item = Point> {
        (-26..=26).flat_map(|z| (-26..=26).map(move |r| p(f64::from(z) * 0.61 + 0.013, f64::from(r) * 0.57 - 0.007)))
    }

    #[test]
    fn a_prepared_segment_measures_as_the_segment_itself() {
        for segment in segments() {
            let prepared = Prepared::new(&segment);
            for k in 0..=20 {
                let share = f64::from(k) / 20.0;
                assert!(prepared.point_at(share).distance(segment.point_at(share)) < 1e-9, "{segment:?} {share}");
            }
            for at in grid() {
                let (own, wanted) = (prepared.nearest(at).distance(at), segment.nearest_point(at).distance(at));
                assert!((own - wanted).abs() < 1e-9, "{segment:?} {at:?}: {own} {wanted}");
            }
        }
    }

    #[test]
    fn whatever_is_looked_at_first_the_nearest_is_found() {
        let all = segments();
        let route = Route::new(all.iter());
        for at in grid() {
            let wanted = all.iter().map(|s| s.distance_to(at)).fold(f64::INFINITY, f64::min);
            for mut hint in [0, 3, 7, 99] {
                let found = route.nearest(at, &mut hint).unwrap();
                assert!((found.distance - wanted).abs() < 1e-9 && hint == found.piece, "{at:?}");
                assert!((route.segment(hint).unwrap().distance_to(at) - wanted).abs() < 1e-9);
            }
        }
        assert!(Route::new([].iter()).nearest(p(0.0, 0.0), &mut 0).is_none());
    }
}
