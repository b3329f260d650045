//! Pushing a body against a function: where the body's reference point may be without the two overlapping.
//!
//! With a tool turned over as the body this gives the lowest programmed point at every z, exactly: lines and arcs rolled
//! along lines and arcs are lines and arcs, and the limit is the largest of what every piece of the surface allows. There is
//! no offset contour to be trimmed, so nothing can be lost or left crossing itself.
//!
//! This is what planning costs. The body is a few concave stretches. Of a concave stretch that is put on two places of a surface the
//! one put further on the right is, once it is the higher one, the higher one for good; so the limit is made like a stack, piece by
//! piece along the surface, and what a piece hides of those before it is taken off the end ([`Front`]): nobody looks at two pieces
//! that are far apart. What a further stretch, of a holder mostly, cannot lift above what the stretches before it gave is not even
//! rolled along ([`Lows`]). Ways and strokes say where they look and above which height ([`Shape::over_within`]), passes above which
//! limit ([`Shape::over_floor`]), and what cannot reach there is left out.
//!
//! A surface without overhang is met from above by the lower side of insert and holder only, and a point that the lower side
//! keeps clear of is clear of the whole tool; so functions of z say all.

use super::chain::Chain;
use super::lows::Lows;
use super::piece::{EQUAL_MM, Lie, Piece, SAME_MM};
use super::rolling::{Way, Window};
use super::shape::{Concave, Shape};
use crate::geometry::Point;

/// How far over the ends of what is asked for the limit is made, mm: who looks at an end finds a value there.
const BESIDE_MM: f64 = 1e-5;

impl Shape {
    /// The largest of the shape's boundary put on every point of `surface`.
    pub(super) fn over(&self, surface: &Chain) -> Chain {
        self.over_within(surface, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY)
    }

    /// The same for who looks only between two positions and above a height: what cannot reach there is not rolled along. Where
    /// that is all there may be a lower value, or none.
    pub(super) fn over_within(&self, surface: &Chain, z0: f64, z1: f64, above: f64) -> Chain {
        let window = Window { z0: z0 - BESIDE_MM, z1: z1 + BESIDE_MM };
        self.rolled_along(self.reached(surface, window), window, above, None).without_pits()
    }

    /// The same between two positions for who looks only where it is above `floor`, which has values from one to the other.
    pub(super) fn over_floor(&self, surface: &Chain, z0: f64, z1: f64, floor: &Chain) -> Chain {
        let window = Window { z0, z1 };
        self.rolled_along(self.reached(surface, window), window, f64::NEG_INFINITY, Some(floor)).without_pits()
    }

    /// The largest of the shape's boundary put on every point of a piece.
    pub(super) fn over_piece(&self, piece: &Piece) -> Chain {
        self.rolled_along(std::slice::from_ref(piece), Window::ALL, f64::NEG_INFINITY, None).without_pits()
    }

    /// The same everywhere, with the pits that rounding leaves.
    pub(super) fn over_all(&self, surface: &Chain) -> Chain {
        self.rolled_along(&surface.pieces, Window::ALL, f64::NEG_INFINITY, None)
    }

    fn rolled_along(&self, surface: &[Piece], window: Window, above: f64, floor: Option<&Chain>) -> Chain {
        let ways: Vec<Way> = surface.iter().map(Way::of).collect();
        let mut limit = Chain::default();
        for part in &self.parts {
            let lows = floor.or(Some(&limit).filter(|limit| !limit.pieces.is_empty())).map(Lows::of);
            let front = part.over(&ways, window, above, lows);
            if limit.pieces.is_empty() {
                limit = front;
            } else if !front.pieces.is_empty() {
                limit = limit.max(&front);
            }
        }
        limit
    }

    /// The pieces on which the shape reaches into a window.
    fn reached<'a>(&self, surface: &'a Chain, window: Window) -> &'a [Piece] {
        let (z0, z1) = self.extent();
        surface.over(window.z0 - z1, window.z1 - z0)
    }

    /// The shape's boundary put on one point.
    pub(super) fn at(&self, p: Point) -> Chain {
        Chain::largest(&self.parts.iter().map(|part| part.put_on(p, Window::ALL)).collect::<Vec<_>>())
    }
}

impl Concave {
    /// The stretch rolled along what it reaches from, but for what cannot rise above `lows`.
    fn over(&self, ways: &[Way], window: Window, above: f64, mut lows: Option<Lows>) -> Chain {
        let most = self.edges.len() + 2;
        let (mut front, mut rolled) = (Front::with_capacity(ways.len() + most, most), Vec::with_capacity(most));
        let mut before: Option<&Way> = None;
        for way in ways {
            let (z0, z1) = (way.z0() + self.z0(), way.z1() + self.z1());
            let top = way.top + self.top;
            let mut rises = || {
                let lowest = lows.as_mut().map(|lows| lows.least(z0.max(window.z0), z1.min(window.z1)));
                lowest.is_none_or(|lowest| top > lowest)
            };
            if top > above && z0 < window.z1 && z1 > window.z0 && rises() {
                self.roll(way, before.is_some_and(|b| b.leads_to(way)), window, &mut rolled);
                front.add(&rolled);
            }
            before = Some(way);
        }
        front.chain
    }
}

/// The limit as it grows to the right.
struct Front {
    chain: Chain,
    /// What is put on its end next, the right one first.
    tail: Vec<Piece>,
}

impl Front {
    /// Nothing yet; room for so many pieces, and for so many that are put on the end at once.
    fn with_capacity(pieces: usize, at_once: usize) -> Self {
        Self { chain: Chain { pieces: Vec::with_capacity(pieces) }, tail: Vec::with_capacity(at_once) }
    }

    /// The larger of what there is and of what ends behind it and stays above it wherever it has once risen above it.
    fn add(&mut self, rolled: &[Piece]) {
        let Some(end) = rolled.last().map(|p| p.z1) else { return };
        if self.chain.pieces.is_empty() {
            for piece in rolled {
                self.chain.push_part(piece, piece.z0, piece.z1);
            }
            return;
        }
        if self.chain.pieces.last().is_some_and(|last| last.z1 > end + SAME_MM) {
            self.chain = self.chain.max(&Chain { pieces: rolled.to_vec() });
            return;
        }
        for piece in rolled.iter().rev() {
            if !self.hides(piece) {
                break;
            }
        }
        while let Some(piece) = self.tail.pop() {
            self.chain.push(piece);
        }
    }

    /// Takes what lies under a piece off the end; false where something stays above the piece.
    fn hides(&mut self, piece: &Piece) -> bool {
        let mut to = piece.z1;
        while let Some(last) = self.chain.pieces.last().copied().filter(|last| last.z1 > piece.z0) {
            if last.z1 < to {
                self.keep(piece, last.z1, to);
                to = last.z1;
            }
            let from = last.z0.max(piece.z0);
            let shown = shown_from(piece, &last, from, to);
            self.keep(piece, shown, to);
            self.end_at(shown);
            if shown > from {
                return false;
            }
            to = from;
        }
        self.keep(piece, piece.z0, to);
        true
    }

    fn keep(&mut self, piece: &Piece, z0: f64, z1: f64) {
        if z1 - z0 > SAME_MM {
            self.tail.push(Piece { z0, z1, form: piece.form });
        }
    }

    /// Cuts off the end of what there is.
    fn end_at(&mut self, z: f64) {
        if let Some(last) = self.chain.pieces.last_mut() {
            last.z1 = last.z1.min(z);
            if last.z1 - last.z0 <= SAME_MM {
                self.chain.pieces.pop();
            }
        }
    }
}

/// From where on a piece is above another one as far as `to`; `to` if it is not.
fn shown_from(piece: &Piece, other: &Piece, from: f64, to: f64) -> f64 {
    if to - from <= SAME_MM {
        return from;
    }
    let meeting = match piece.against(other, from, to) {
        Lie::Above => return from,
        Lie::Below => return to,
        Lie::Near(meeting) => meeting,
    };
    let mut shown = to;
    for low in meeting.iter().rev().chain([from]) {
        let middle = f64::midpoint(low, shown);
        if piece.at(middle) <= other.at(middle) + EQUAL_MM {
            break;
        }
        shown = low;
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::super::outline::Turn;
    use super::super::piece::Form;
    use super::*;
    use crate::geometry::Segment;
    use crate::machine::Catalog;
    use proptest::prelude::*;

    /// A surface of random lines and arcs, with and without faces between them.
    fn surface() -> impl Strategy<Value = Chain> {
        let row = (0.3..4.0_f64, 1.0..9.0_f64, 1.0..9.0_f64, 0..3_u8, 1.0..3.0_f64, any::<bool>());
        proptest::collection::vec(row, 1..7).prop_map(|rows| {
            let mut z = 0.0;
            let mut pieces: Vec<Piece> = Vec::new();
            for (width, r1, r2, kind, bend, goes_on) in rows {
                let r1 = pieces.last().filter(|_| goes_on).map_or(r1, |last| last.right().r);
                let (a, b) = (Point::new(z, r1), Point::new(z + width, r2));
                z += width;
                let chord = a.distance(b);
                let radius = chord * bend;
                let height =
                    (radius * radius - chord * chord / 4.0).sqrt() * if kind == 1 { 1.0 } else { -1.0 } / chord;
                let along = b - a;
                let center =
                    Point::new(f64::midpoint(a.z, b.z) - along.y * height, f64::midpoint(a.r, b.r) + along.x * height);
                let upper = kind == 2;
                let monotone = if upper { center.r <= r1.min(r2) } else { center.r >= r1.max(r2) };
                pieces.push(if kind == 0 || !monotone {
                    Piece::line(a, b)
                } else {
                    Piece { z0: a.z, z1: b.z, form: Form::Arc { center, radius, upper } }
                });
            }
            Chain { pieces }
        })
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

    proptest! {
        #[test]
        fn what_is_above_a_floor_is_as_without_it(
            surface in surface(), which in 0..5_usize, heights in (1.0..9.0_f64, 1.0..9.0_f64), window in (0.0..9.0_f64, 0.1..9.0_f64),
        ) {
            let (shape, (z0, z1)) = (&shapes()[which], (window.0, window.0 + window.1));
            let floor = Chain { pieces: vec![Piece::line(Point::new(z0, heights.0), Point::new(z1, heights.1))] };
            let (all, above) = (shape.over(&surface), shape.over_floor(&surface, z0, z1, &floor));
            for k in 0..50 {
                let z = z0 + (z1 - z0) * (f64::from(k) + 0.5) / 50.0;
                let over = |chain: &Chain| chain.at(z).unwrap_or(f64::NEG_INFINITY).max(floor.at(z).unwrap());
                prop_assert!((over(&all) - over(&above)).abs() < 1e-9, "at {z}: {} {}", over(&all), over(&above));
            }
        }
    }

    #[test]
    fn a_line_along_an_edge_of_the_body_is_passed_once() {
        for shape in shapes() {
            let body: Vec<Piece> = shape.parts.iter().flat_map(|p| p.chain.pieces.clone()).collect();
            for edge in body.iter().filter(|p| matches!(p.form, Form::Line { .. })) {
                let (from, along) = (Point::new(8.1, 27.3), edge.right() - edge.left());
                // Parallel but for what rounding makes of it.
                for k in 1..400 {
                    let surface = Chain { pieces: vec![Piece::line(from, from + along * (f64::from(k) * 0.0037))] };
                    let limit = shape.over(&surface);
                    let in_order = limit.pieces.windows(2).all(|w| w[1].z0 >= w[0].z1 - SAME_MM);
                    assert!(in_order, "{k}: {limit:?}");
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
