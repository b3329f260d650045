//! The finished form: how deep a point lies below the contour, exactly against its lines and arcs.

use super::input::{MayCut, Work};
use super::strips::Strips;
use super::tops::{Tops, radius_at};
use crate::geometry::{Bounds, Point, Segment, Vector};
use std::f64::consts::PI;

/// Positions within this of the border of a region that may be cut belong to it, mm.
const BORDER_MM: f64 = 0.001;
/// What comes no higher than this, mm, lies on the axis.
const ON_AXIS_MM: f64 = 1e-6;
/// Edges longer than this, mm, are looked at in between too.
const SAMPLE_MM: f64 = 0.25;
/// Points looked at along one edge at most.
const MOST_SAMPLES: u32 = 64;

/// The finished part of one set-up.
pub(super) struct Form {
    /// Outside and bore.
    pieces: Strips<Piece>,
    tops: Tops,
    may_cut: Vec<MayCut>,
    may_cut_inside: Vec<MayCut>,
}

/// A line or an arc along which z runs one way only.
#[derive(Debug, Clone, Copy)]
struct Piece {
    segment: Segment,
    bounds: Bounds,
}

/// The deepest point of a gouge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Depth {
    /// Distance below the contour, mm.
    pub mm: f64,
    /// Where.
    pub at: Point,
}

impl Form {
    /// The form that must come out.
    pub(super) fn new(work: &Work) -> Self {
        let bore = work.target.bore.as_ref();
        let segments = work.target.contour.segments.iter().chain(bore.iter().flat_map(|b| &b.contour.segments));
        let piece = |segment: Segment| {
            let bounds = segment.bounds();
            (bounds.min.z, bounds.max.z, Piece { segment, bounds })
        };
        // What lies on the axis is no surface.
        let surface = segments.filter(|segment| segment.bounds().max.r > ON_AXIS_MM);
        let surface: Vec<Segment> = surface.flat_map(one_way).collect();
        let pieces: Vec<_> = surface.iter().copied().map(piece).collect();
        Self {
            tops: Tops::of(&surface),
            pieces: Strips::of(&pieces),
            may_cut: work.may_cut.clone(),
            may_cut_inside: bore.map_or_else(Vec::new, |b| b.may_cut.clone()),
        }
    }

    /// How far below the surface a point lies, mm; 0 outside the part and where may be cut.
    pub(super) fn depth(&self, p: Point) -> f64 {
        if !self.inside(p) {
            return 0.0;
        }
        let at_z = |m: &&MayCut| p.z >= m.z1.min(m.z2) - BORDER_MM && p.z <= m.z1.max(m.z2) + BORDER_MM;
        let below = self.may_cut.iter().filter(at_z).map(|m| m.radius - p.r);
        let beyond = self.may_cut_inside.iter().filter(at_z).map(|m| p.r - m.radius);
        let allowed = below.chain(beyond).fold(f64::INFINITY, f64::min);
        if allowed <= BORDER_MM { 0.0 } else { allowed.min(self.distance(p)) }
    }

    /// The deepest point along the borders of what was taken away.
    pub(super) fn deepest(&self, edges: impl Iterator<Item = (Point, Point)>) -> Option<Depth> {
        let mut deepest: Option<Depth> = None;
        for (a, b) in edges {
            self.deepest_on_edge(a, b, &mut deepest);
        }
        deepest
    }

    /// Along an edge the distance from a line is linear and that from an arc is largest where the edge passes its centre, so
    /// the ends and those points are enough as long as one segment is nearest; samples between catch the rest.
    fn deepest_on_edge(&self, a: Point, b: Point, deepest: &mut Option<Depth>) {
        let reach = Bounds { min: a, max: a }.including(b);
        if !self.tops.rise_above(reach.min.z, reach.max.z, reach.min.r) {
            return;
        }
        let mut look = |at: Point| {
            if !self.tops.rise_above(at.z, at.z, at.r) {
                return;
            }
            let mm = self.depth(at);
            if mm > deepest.map_or(0.0, |d| d.mm) {
                *deepest = Some(Depth { mm, at });
            }
        };
        look(a);
        let along = b - a;
        let length = along.norm();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_SAMPLES")]
        let samples = (length / SAMPLE_MM).ceil().clamp(1.0, f64::from(MOST_SAMPLES)) as u32;
        for k in 1..samples {
            look(a + along * (f64::from(k) / f64::from(samples)));
        }
        for piece in self.pieces.between(reach.min.z, reach.max.z) {
            if let Segment::Arc { center, .. } = piece.segment {
                let t = (center - a).dot(&along) / (length * length);
                if t > 0.0 && t < 1.0 {
                    look(a + along * t);
                }
            }
        }
    }

    /// True if outside and bore together pass above the point an odd number of times.
    fn inside(&self, p: Point) -> bool {
        let above = |piece: &&Piece| {
            let (from, to) = (piece.segment.start().z, piece.segment.end().z);
            (from <= p.z) != (to <= p.z) && piece.bounds.max.r >= p.r && radius_at(&piece.segment, p.z) > p.r
        };
        self.pieces.at(p.z).iter().filter(above).count() % 2 == 1
    }

    fn distance(&self, p: Point) -> f64 {
        self.pieces.nearest(p.z, |piece, nearest| {
            if apart(piece.bounds, p) < nearest { distance_to(&piece.segment, p) } else { nearest }
        })
    }
}

/// Distance from a point to a rectangle, mm.
fn apart(bounds: Bounds, p: Point) -> f64 {
    let dz = (bounds.min.z - p.z).max(p.z - bounds.max.z).max(0.0);
    let dr = (bounds.min.r - p.r).max(p.r - bounds.max.r).max(0.0);
    (dz * dz + dr * dr).sqrt()
}

/// Distance from a point to a line or arc, mm.
pub(super) fn distance_to(segment: &Segment, p: Point) -> f64 {
    match *segment {
        Segment::Line { start, end } => distance_to_line(start, end, p),
        Segment::Arc { start, end, center, ccw } => {
            let foot = p - center;
            if turns_through(start - center, foot, end - center, ccw) {
                (foot.norm() - start.distance(center)).abs()
            } else {
                p.distance(start).min(p.distance(end))
            }
        }
    }
}

/// True if a turn from one direction to another passes a third; between equal directions there is none.
fn turns_through(from: Vector, through: Vector, to: Vector, ccw: bool) -> bool {
    let (from, to) = if ccw { (from, to) } else { (to, from) };
    let left = |a: Vector, b: Vector| a.x * b.y - a.y * b.x;
    let ahead = left(from, to);
    if ahead > 0.0 || (ahead == 0.0 && from.dot(&to) < 0.0) {
        left(from, through) >= 0.0 && left(through, to) >= 0.0
    } else {
        ahead < 0.0 && (left(to, through) <= 0.0 || left(through, from) <= 0.0)
    }
}

/// Distance from a point to a straight line between two points, mm.
pub(super) fn distance_to_line(start: Point, end: Point, p: Point) -> f64 {
    let along = end - start;
    let squared = along.norm_squared();
    let t = if squared > 0.0 { ((p - start).dot(&along) / squared).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(start + along * t)
}

/// Parts an arc where it turns back along z.
fn one_way(segment: &Segment) -> Vec<Segment> {
    let Segment::Arc { start, end, center, ccw } = *segment else { return vec![*segment] };
    let radius = start.distance(center);
    let sweep = segment.sweep();
    let from = (start - center).y.atan2((start - center).x);
    let mut turns: Vec<f64> = (-2..=4)
        .map(|k| (f64::from(k) * PI - from) / sweep)
        .filter(|t| t.is_finite() && *t > 0.0 && *t < 1.0)
        .collect();
    turns.sort_by(f64::total_cmp);
    let turn = |t: &f64| {
        let angle = from + sweep * t;
        Point::new(center.z + radius * angle.cos(), center.r + radius * angle.sin())
    };
    let ends: Vec<Point> = [start].into_iter().chain(turns.iter().map(turn)).chain([end]).collect();
    ends.windows(2).map(|w| Segment::Arc { start: w[0], end: w[1], center, ccw }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Contour;
    use crate::proof::{BoreTarget, Target};
    use proptest::prelude::*;

    /// A ball of radius 10 at z = 0 on a shank of radius 6 to its left.
    fn ball() -> Form {
        ball_with(None)
    }

    /// The ball with a hole.
    fn ball_with(bore: Option<BoreTarget>) -> Form {
        let center = Point::new(0.0, 0.0);
        let joint = Point::new(-8.0, 6.0);
        let contour = Contour::new(vec![
            Segment::line(Point::new(-20.0, 6.0), joint),
            Segment::Arc { start: joint, end: Point::new(10.0, 0.0), center, ccw: false },
        ]);
        let sections = vec![1, 2];
        Form::new(&Work {
            stock: Contour::default(),
            target: Target {
                contour,
                sections,
                names: std::collections::BTreeMap::new(),
                machined_from_z: -20.0,
                bore,
            },
            program_zero_z: 0.0,
            chuck_face_z: -30.0,
            mandrel: None,
            tailstock: None,
            material: None,
            form_tolerance_mm: 0.05,
            may_cut: vec![MayCut { z1: -15.0, z2: -12.0, radius: 4.0 }],
        })
    }

    #[test]
    fn depth_is_exact_against_lines_and_arcs() {
        let form = ball();
        assert!((form.depth(Point::new(3.0, 4.0)) - 5.0).abs() < 1e-12);
        assert!((form.depth(Point::new(-17.0, 5.75)) - 0.25).abs() < 1e-12);
        assert_eq!(form.depth(Point::new(8.0, 8.0)), 0.0);
        assert_eq!(form.depth(Point::new(-25.0, 1.0)), 0.0);
    }

    #[test]
    fn a_bore_is_no_gouge_but_its_wall_is_part_of_the_form() {
        // A hole of radius 3 from the shank's end to z = 0, with a thread down to radius 3.5 at its mouth.
        let corners = [(-20.0, 3.0), (0.0, 3.0), (0.0, 0.0)].map(|(z, r)| Point::new(z, r));
        let contour = Contour::new(corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect());
        let may_cut = vec![MayCut { z1: -20.0, z2: -15.0, radius: 3.5 }];
        let form = ball_with(Some(BoreTarget { contour, sections: vec![1, 1], machined_from_z: -20.0, may_cut }));
        assert_eq!(form.depth(Point::new(-10.0, 2.5)), 0.0);
        assert!((form.depth(Point::new(-10.0, 3.4)) - 0.4).abs() < 1e-12);
        assert!((form.depth(Point::new(0.25, 1.0)) - 0.25).abs() < 1e-12);
        assert_eq!(form.depth(Point::new(-17.0, 3.4)), 0.0);
        assert!((form.depth(Point::new(-17.0, 3.75)) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn what_may_be_cut_is_not_deep() {
        let form = ball();
        assert_eq!(form.depth(Point::new(-13.0, 4.5)), 0.0);
        assert!((form.depth(Point::new(-13.0, 3.75)) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn a_straight_cut_across_the_ball_is_deepest_in_the_middle() {
        let (a, b) = (Point::new(-6.0, 8.0), Point::new(6.0, 8.0));
        let above = Point::new(0.0, 11.0);
        let depth = ball().deepest([(a, b), (b, above), (above, a)].into_iter()).unwrap();
        assert!((depth.mm - 2.0).abs() < 1e-12 && depth.at.distance(Point::new(0.0, 8.0)) < 1e-9);
    }

    proptest! {
        #[test]
        fn an_arc_is_as_far_away_as_its_points(from in 0.0..6.2_f64, sweep in -6.2..6.2_f64, z in -9.0..9.0_f64, r in -9.0..9.0_f64) {
            let on = |angle: f64| Point::new(3.0 * angle.cos(), 3.0 * angle.sin());
            let center = Point::default();
            let arc = Segment::Arc { start: on(from), end: on(from + sweep), center, ccw: sweep > 0.0 };
            let p = Point::new(z, r);
            let nearest = (0..=4000).map(|k| on(from + sweep * f64::from(k) / 4000.0).distance(p)).fold(f64::INFINITY, f64::min);
            prop_assert!((distance_to(&arc, p) - nearest).abs() < 3e-3, "{} {nearest}", distance_to(&arc, p));
        }

        #[test]
        fn a_point_is_inside_exactly_if_the_polygon_says_so(z in -25.0..15.0_f64, r in 0.0..12.0_f64) {
            let truth = if !(-20.0..=10.0).contains(&z) { false } else if z < -8.0 { r < 6.0 } else { z.hypot(r) < 10.0 };
            prop_assert_eq!(ball().inside(Point::new(z, r)), truth);
        }
    }
}
