//! The region that a convex outline covers while it moves along a path.

use super::columns::Columns;
use super::envelope::swept_one_way;
use super::grid::{GridPoint, Ring, Window, plus};
use super::overlap::Overlap;
use super::stock::Stock;

/// What convex pieces cover together while they move along `path`.
pub(super) fn covered(pieces: &[Ring], path: &[GridPoint]) -> Columns {
    if let ([piece], true) = (pieces, path.len() > 2)
        && let Some(columns) = swept_one_way(piece, path)
    {
        return columns;
    }
    Columns::of_rings(&pieces.iter().map(|piece| swept(piece, path)).collect::<Vec<_>>())
}

/// The outlines of what convex pieces share with a region while they move along `path`: one after another, so that they may
/// overlap. Most pieces are nowhere near, and their rectangles tell.
pub(super) fn met(region: &Stock, pieces: &[Ring], path: &[GridPoint], overlap: &mut Overlap) -> Vec<Ring> {
    let way = Window::around(path);
    let mut rings = Vec::new();
    for piece in pieces {
        let window = Window::around(piece).moved(&way);
        if region.may_meet(&window) {
            rings.extend(region.shared(&covered(std::slice::from_ref(piece), path), &window, overlap).rings());
        }
    }
    rings
}

/// The ring that winds around every point covered by `outline` (convex, counter-clockwise) moved along `path`.
///
/// It is the convolution of the outline with the path walked there and back: its winding number is positive exactly where
/// the moved outline has been (Guibas, Ramshaw, Stolfi 1983). For a straight path it is the convex hull of both ends. It may
/// cross itself, so it must be filled by the non-zero rule.
pub(super) fn swept(outline: &[GridPoint], path: &[GridPoint]) -> Ring {
    if let ([from, to], true) = (path, !outline.is_empty()) {
        return swept_straight(outline, *from, *to);
    }
    let mut there = path.to_vec();
    there.dedup();
    let Some(&first) = there.first() else { return Ring::new() };
    if there.len() == 1 || outline.is_empty() {
        return outline.iter().map(|&p| plus(p, first)).collect();
    }
    let there_and_back: Vec<GridPoint> = there.iter().chain(there.iter().rev().skip(1)).copied().collect();
    let directions: Vec<(i64, i64)> = there_and_back.windows(2).map(|w| direction(w[0], w[1])).collect();
    let mut ring = Ring::with_capacity(there_and_back.len() + 2 * outline.len());
    let mut vertex = support(outline, directions[0]);
    for (index, &from) in directions.iter().enumerate() {
        let to = directions[(index + 1) % directions.len()];
        let corner = there_and_back[index + 1];
        ring.push(plus(corner, outline[vertex]));
        let last = support(outline, to);
        let left = cross(from, to) > 0 || (cross(from, to) == 0 && dot(from, to) < 0);
        while vertex != last {
            vertex = (vertex + if left { 1 } else { outline.len() - 1 }) % outline.len();
            ring.push(plus(corner, outline[vertex]));
        }
    }
    ring
}

/// The same for one straight step: the side that looks ahead at its end, the side that looks back at its start.
fn swept_straight(outline: &[GridPoint], from: GridPoint, to: GridPoint) -> Ring {
    if from == to {
        return outline.iter().map(|&p| plus(p, from)).collect();
    }
    let along = direction(from, to);
    let (right, left) = (support(outline, along), support(outline, (-along.0, -along.1)));
    let mut ring = Ring::with_capacity(outline.len() + 2);
    for (begin, end, at) in [(right, left, to), (left, right, from)] {
        let mut vertex = begin;
        ring.push(plus(outline[vertex], at));
        while vertex != end {
            vertex = (vertex + 1) % outline.len();
            ring.push(plus(outline[vertex], at));
        }
    }
    ring
}

/// The way from one point to another.
pub(super) fn direction(a: GridPoint, b: GridPoint) -> (i64, i64) {
    (i64::from(b.x) - i64::from(a.x), i64::from(b.y) - i64::from(a.y))
}

/// Positive if the second direction lies to the left of the first.
pub(super) fn cross(a: (i64, i64), b: (i64, i64)) -> i64 {
    a.0 * b.1 - a.1 * b.0
}

/// Positive if two directions look the same way.
pub(super) fn dot(a: (i64, i64), b: (i64, i64)) -> i64 {
    a.0 * b.0 + a.1 * b.1
}

/// The vertex furthest to the right of a direction; of two the one that comes first counter-clockwise.
pub(super) fn support(outline: &[GridPoint], d: (i64, i64)) -> usize {
    let reach = |i: usize| i64::from(outline[i].x) * d.1 - i64::from(outline[i].y) * d.0;
    let count = outline.len();
    let best = (0..count).max_by_key(|&i| reach(i)).unwrap_or(0);
    let before = (best + count - 1) % count;
    if reach(before) == reach(best) { before } else { best }
}

/// The same, found by walking around from a vertex: few steps where the direction has changed little.
pub(super) fn support_near(outline: &[GridPoint], vertex: usize, d: (i64, i64)) -> usize {
    let reach = |i: usize| i64::from(outline[i].x) * d.1 - i64::from(outline[i].y) * d.0;
    let count = outline.len();
    let (mut at, mut most) = (vertex, reach(vertex));
    // On a convex outline the reach rises to the furthest vertex from both sides.
    let mut walk = |step: usize, ties: bool| {
        for _ in 0..count {
            let next = (at + step) % count;
            let further = reach(next);
            if further < most || further == most && !ties {
                break;
            }
            (at, most) = (next, further);
        }
    };
    walk(1, false);
    walk(count - 1, true);
    at
}

#[cfg(test)]
mod tests {
    use super::super::grid::{area_mm2, hull};
    use super::*;
    use proptest::prelude::*;

    fn points(raw: &[(i32, i32)]) -> Ring {
        raw.iter().map(|&(x, y)| GridPoint::new(x, y)).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        #[test]
        fn a_straight_sweep_is_the_hull(
            raw in prop::collection::vec((-90_000..90_000, -90_000..90_000), 3..9),
            to in (-300_000..300_000, -300_000..300_000),
        ) {
            let outline = hull(points(&raw));
            prop_assume!(outline.len() >= 3);
            let path = points(&[(0, 0), to]);
            let both = path.iter().flat_map(|&p| outline.iter().map(move |&o| plus(o, p))).collect();
            prop_assert!((area_mm2(&swept(&outline, &path)) - area_mm2(&hull(both))).abs() < 1e-9);
        }

        #[test]
        fn the_furthest_vertex_is_found_from_every_other(
            raw in prop::collection::vec((-9..9, -9..9), 3..30),
            d in (-9_i64..9, -9_i64..9),
        ) {
            let outline = hull(points(&raw));
            prop_assume!(outline.len() >= 3 && d != (0, 0));
            for vertex in 0..outline.len() {
                prop_assert_eq!(support_near(&outline, vertex, d), support(&outline, d));
            }
        }

        #[test]
        fn a_bent_sweep_is_the_union_of_its_parts(
            raw in prop::collection::vec((-90_000..90_000, -90_000..90_000), 3..9),
            bends in prop::collection::vec((-300_000..300_000, -300_000..300_000), 2..7),
        ) {
            let outline = hull(points(&raw));
            prop_assume!(outline.len() >= 3);
            let path = points(&bends);
            let whole = covered(std::slice::from_ref(&outline), &path).area_mm2();
            let parts: Vec<Ring> = path.windows(2).map(|w| swept(&outline, w)).collect();
            let parts = Columns::of_rings(&parts).area_mm2();
            prop_assert!((whole - parts).abs() < 2e-3, "{whole} {parts}");
        }
    }
}
