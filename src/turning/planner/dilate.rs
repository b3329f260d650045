//! Pushing a body against a function: where the body's reference point may be without the two overlapping.
//!
//! With a tool turned over as the body this gives the lowest programmed point at every z, exactly: lines and arcs rolled
//! along lines and arcs are lines and arcs, and the limit is the largest of what every piece of the surface allows. There is
//! no offset contour to be trimmed, so nothing can be lost or left crossing itself.
//!
//! This is what planning costs. Ways and strokes therefore say where they look and above which height, and what cannot reach there
//! is not rolled along ([`Shape::over_within`]); along a line, which most pieces are, the body's pieces are only moved. Together this
//! halves the time of a plan (1470b-2T, QUEEN, a staircase and waves of 1,000 rows: 0.58, 0.54, 0.57 and 0.47 of the time before, side
//! by side on one machine).
//!
//! A surface without overhang is met from above by the lower side of insert and holder only, and a point that the lower side
//! keeps clear of is clear of the whole tool; so functions of z say all.

use super::chain::Chain;
use super::piece::{Form, Piece};
use super::shape::{Concave, Shape};
use crate::geometry::Point;

impl Shape {
    /// The largest of the shape's boundary put on every point of `surface`.
    pub(super) fn over(&self, surface: &Chain) -> Chain {
        self.over_within(surface, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY)
    }

    /// The same for who looks only between two positions and above a height: what cannot reach there is not rolled along. Where
    /// that is all there may be a lower value, or none.
    pub(super) fn over_within(&self, surface: &Chain, z0: f64, z1: f64, above: f64) -> Chain {
        let mut leaves = Vec::new();
        for piece in &surface.pieces {
            let top = piece.highest();
            let reaches =
                |part: &&Concave| top + part.top > above && piece.z0 + part.z0() < z1 && piece.z1 + part.z1() > z0;
            leaves.extend(self.parts.iter().filter(reaches).map(|part| over_piece(part, piece)));
        }
        Chain::largest_of(leaves).without_pits()
    }

    /// The shape's boundary put on one point.
    pub(super) fn at(&self, p: Point) -> Chain {
        Chain::largest(&self.parts.iter().map(|part| part.put_on(p)).collect::<Vec<_>>())
    }
}

impl Concave {
    fn put_on(&self, p: Point) -> Chain {
        Chain { pieces: self.chain.pieces.iter().map(|piece| piece.shifted(p.z, p.r)).collect() }
    }
}

fn over_piece(part: &Concave, piece: &Piece) -> Chain {
    match piece.form {
        Form::Arc { center, radius, upper: false } => over_hollow(part, piece, center, radius),
        Form::Arc { .. } => part.rolled_along(piece),
        Form::Line { .. } => part.along_line(piece),
    }
}

/// In a hollow the ends hold the shape off; between them only roundings of a smaller radius and sharp corners touch.
fn over_hollow(part: &Concave, piece: &Piece, center: Point, radius: f64) -> Chain {
    let mut over = part.put_on(piece.left()).max(&part.put_on(piece.right()));
    // Normals point from the hollow to its centre; they turn to the left along z.
    let normal = |z: f64| ((center.z - z) / radius).clamp(-1.0, 1.0).acos();
    let (first, last) = (normal(piece.z0), normal(piece.z1));
    for rounding in part.roundings() {
        let (low, high) = (first.max(rounding.to), last.min(rounding.from));
        if rounding.radius < radius && low < high {
            let middle = Point::new(center.z + rounding.center.z, center.r + rounding.center.r);
            let left = radius - rounding.radius;
            let form = Form::Arc { center: middle, radius: left, upper: false };
            let touching = Piece { z0: middle.z - left * low.cos(), z1: middle.z - left * high.cos(), form };
            over = over.max(&Chain { pieces: vec![touching] });
        }
    }
    over
}

#[cfg(test)]
mod tests {
    use super::super::outline::Turn;
    use super::*;
    use crate::geometry::Segment;
    use crate::machine::Catalog;
    use proptest::prelude::*;

    /// Points on a surface of random lines and arcs, and the surface.
    fn surface() -> impl Strategy<Value = Chain> {
        proptest::collection::vec((0.3..4.0_f64, 1.0..9.0_f64, 1.0..9.0_f64, 0..3_u8, 1.0..3.0_f64), 1..7).prop_map(
            |rows| {
                let mut z = 0.0;
                let mut pieces = Vec::new();
                for (width, r1, r2, kind, bend) in rows {
                    let (a, b) = (Point::new(z, r1), Point::new(z + width, r2));
                    z += width;
                    let chord = a.distance(b);
                    let radius = chord * bend;
                    let height =
                        (radius * radius - chord * chord / 4.0).sqrt() * if kind == 1 { 1.0 } else { -1.0 } / chord;
                    let along = b - a;
                    let center = Point::new(
                        f64::midpoint(a.z, b.z) - along.y * height,
                        f64::midpoint(a.r, b.r) + along.x * height,
                    );
                    let upper = kind == 2;
                    let monotone = if upper { center.r <= r1.min(r2) } else { center.r >= r1.max(r2) };
                    pieces.push(if kind == 0 || !monotone {
                        Piece::line(a, b)
                    } else {
                        Piece { z0: a.z, z1: b.z, form: Form::Arc { center, radius, upper } }
                    });
                }
                Chain { pieces }
            },
        )
    }

    fn shapes() -> Vec<Shape> {
        let catalog = Catalog::shipped();
        let outline = |id: &str| catalog.tool(id).unwrap().outline();
        let tools = ["orac-right", "orac-left", "orac-thread", "orac-part-off"].map(outline);
        tools.iter().map(|t| Shape::of([&t.insert, &t.holder], Turn::Both)).chain([Shape::disc(0.4)]).collect()
    }

    /// The largest sum over many places, near steps and ends from either side, and finer around the best.
    fn sampled(surface: &Chain, body: &Chain, at: f64) -> Option<f64> {
        let (from, to) = (surface.pieces[0].z0, surface.pieces.last()?.z1);
        let step = (to - from) / 1500.0;
        let value = |z: f64| Some((surface.at(z)? + body.at(at - z)?, z));
        let ends = |chain: &Chain| chain.pieces.iter().flat_map(|p| [p.z0, p.z1]).collect::<Vec<f64>>();
        let steps = ends(surface).into_iter().chain(ends(body).into_iter().map(|z| at - z));
        let sides = steps.flat_map(|z| [z - 1e-7, z, z + 1e-7]);
        let all = (0..=1500).map(|i| from + step * f64::from(i)).chain(sides);
        let larger = |a: (f64, f64), b: (f64, f64)| if b.0 > a.0 { b } else { a };
        let (_, best) = all.filter_map(value).reduce(larger)?;
        let finer = (-200..=200).map(|i| best + step * f64::from(i) / 200.0);
        finer.chain([best]).filter_map(value).reduce(larger).map(|(largest, _)| largest)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        #[test]
        fn the_limit_is_the_largest_over_every_point(surface in surface(), which in 0..5_usize) {
            let shape = &shapes()[which];
            let limit = shape.over(&surface);
            let body = shape.chain();
            let (from, to) = (surface.pieces[0].z0, surface.pieces.last().unwrap().z1);
            for k in 0..25 {
                let at = from - 3.0 + (to - from + 6.0) * f64::from(k) / 25.0 + 1e-5;
                if let (Some(limit), Some(sampled)) = (limit.at(at), sampled(&surface, &body, at)) {
                    prop_assert!(sampled <= limit + 1e-9, "at {at}: {sampled} above {limit}");
                    prop_assert!(limit <= sampled + 0.02, "at {at}: {limit} far above {sampled}");
                }
            }
        }
    }

    #[test]
    fn a_ball_on_a_corner_rolls_over_it() {
        let step = Chain { pieces: vec![Piece::level(0.0, 5.0, 3.0), Piece::level(5.0, 9.0, 1.0)] };
        let limit = Shape::disc(0.5).over(&step);
        assert_eq!(limit.at(2.0), Some(3.5));
        assert!((limit.at(5.3).unwrap() - 3.4).abs() < 1e-12);
        assert_eq!(limit.at(7.0), Some(1.5));
        let hollow = Segment::Arc {
            start: Point::new(0.0, 5.0),
            end: Point::new(6.0, 5.0),
            center: Point::new(3.0, 9.0),
            ccw: true,
        };
        let limit = Shape::disc(1.0).over(&Chain { pieces: vec![Piece::of(&hollow).unwrap()] });
        assert!((limit.at(3.0).unwrap() - 5.0).abs() < 1e-12, "4 mm radius inside 5");
    }
}
