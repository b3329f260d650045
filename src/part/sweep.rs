//! A tool swept along a surface, on an even grid of positions: how low it can go, and what it leaves.
//!
//! The surface is a radius at every position, the tool the underside of its outline; what it leaves is the closing of
//! the surface by the tool (Serra, Image analysis and mathematical morphology, 1982). The underside is parted into convex
//! chains. Where two cells touch a convex chain, the further one does so at the further position, so that the cell that
//! holds the tool up only moves on with the tool: that makes a chain of any length and any number of chords cost
//! `n · log n` for `n` cells (Aggarwal, Klawe, Moran, Shor, Wilber, Geometric applications of a matrix-searching
//! algorithm, 1987).

use crate::geometry::{Contour, Point};

/// Largest distance of the chords of a nose from its arc, mm: below the width of a cell.
const NOSE_TOLERANCE_MM: f64 = 0.002;
/// Slopes may fall by this much along a convex chain: rounding.
const STRAIGHT: f64 = 1e-9;
/// A corner at which the slope grows by less than this lies less than a twentieth of a cell below the chord of its cells.
const BLUNT: f64 = 0.2;
/// Height in place of no surface, mm: below everything, and small enough to be reckoned with.
const NOTHING_MM: f64 = -1e6;

/// The underside of a tool.
pub(super) struct Underside {
    /// Convex chains of points with z growing.
    chains: Vec<Vec<Point>>,
}

impl Underside {
    /// The underside of a closed, counter-clockwise outline: what is travelled with z growing.
    pub(super) fn of(outline: &Contour) -> Self {
        let mut chains: Vec<Vec<Point>> = Vec::new();
        for segment in &outline.segments {
            let mut from = segment.start();
            for to in segment.polyline_points(NOSE_TOLERANCE_MM) {
                if to.z > from.z {
                    match chains.last_mut().filter(|chain| goes_on(chain, from, to)) {
                        Some(chain) => chain.push(to),
                        None => chains.push(vec![from, to]),
                    }
                }
                from = to;
            }
        }
        Self { chains }
    }

    /// How far it reaches along z from the programmed point, to the left and to the right, mm.
    pub(super) fn reach(&self) -> [f64; 2] {
        let z = self.chains.iter().flatten().map(|p| p.z);
        z.fold([0.0, 0.0], |[left, right]: [f64; 2], z| [left.min(z), right.max(z)])
    }

    fn mirrored(&self) -> Self {
        let mirrored = |chain: &Vec<Point>| chain.iter().rev().map(|p| p.mirrored_at_z(0.0)).collect();
        Self { chains: self.chains.iter().map(mirrored).collect() }
    }

    /// For every cell j the largest `surface[j + u] − underside(u)`: how low the tool can stand there. `step` is the
    /// width of a cell, mm; cells without surface are infinitely low.
    pub(super) fn lowest_positions(&self, surface: &[f64], step: f64) -> Vec<f64> {
        let surface: Vec<f64> = surface.iter().map(|r| r.max(NOTHING_MM)).collect();
        let mut lowest = vec![f64::NEG_INFINITY; surface.len()];
        for chain in &self.chains {
            Sampled::of(chain, step).raise(&mut lowest, &surface);
            // The corners between cells, at the nearest one.
            for corner in sharp_corners(chain) {
                raise_by_one(&mut lowest, &surface, cell((corner.z / step).round()), corner.r);
            }
        }
        let none = |r: f64| if r < NOTHING_MM / 2.0 { f64::NEG_INFINITY } else { r };
        lowest.into_iter().map(none).collect()
    }

    /// What the tool leaves at every cell if it stands as low as `positions` allow.
    pub(super) fn left_by(&self, positions: &[f64], step: f64) -> Vec<f64> {
        let upside_down: Vec<f64> = positions.iter().map(|r| if r.is_finite() { -r } else { NOTHING_MM }).collect();
        self.mirrored().lowest_positions(&upside_down, step).into_iter().map(|r| -r).collect()
    }
}

fn slope(from: Point, to: Point) -> f64 {
    (to.r - from.r) / (to.z - from.z)
}

/// True if a chain stays convex with one more stretch.
fn goes_on(chain: &[Point], from: Point, to: Point) -> bool {
    matches!(chain, [.., a, b] if *b == from && slope(from, to) >= slope(*a, *b) - STRAIGHT)
}

/// The ends of a chain and its corners that reach well below the chords between cells.
fn sharp_corners(chain: &[Point]) -> impl Iterator<Item = Point> + '_ {
    let sharp = |w: &&[Point]| matches!(w, [a, b, c] if slope(*b, *c) - slope(*a, *b) > BLUNT);
    let inner = chain.windows(3).filter(sharp).filter_map(|w| w.get(1));
    chain.first().into_iter().chain(inner).chain(chain.last()).copied()
}

/// A number of cells as an integer; outlines are some tens of mm wide.
fn cell(value: f64) -> isize {
    #[allow(clippy::cast_possible_truncation, reason = "clamped to what any outline spans")]
    {
        value.clamp(-1e9, 1e9) as isize
    }
}

/// A convex chain at the cells that it spans.
struct Sampled {
    /// Cells between the programmed point and the first height.
    first: isize,
    heights: Vec<f64>,
}

impl Sampled {
    fn of(chain: &[Point], step: f64) -> Self {
        let (Some(begin), Some(end)) = (chain.first(), chain.last()) else {
            return Self { first: 0, heights: Vec::new() };
        };
        let (first, last) = (cell((begin.z / step).ceil()), cell((end.z / step).floor()));
        let mut stretches = chain.windows(2).filter_map(|w| <[Point; 2]>::try_from(w).ok()).peekable();
        let height = |k: isize| {
            let z = step * k as f64;
            while stretches.next_if(|[_, to]| to.z < z).is_some() {}
            let [from, to] = *stretches.peek()?;
            Some(from.r + slope(from, to) * (z - from.z))
        };
        Self { first, heights: (first..=last).map_while(height).collect() }
    }

    /// Raises `lowest[j]` to the largest `surface[j + first + k] − heights[k]`.
    fn raise(&self, lowest: &mut [f64], surface: &[f64]) {
        let count = |slice: &[f64]| isize::try_from(slice.len()).unwrap_or(isize::MAX);
        let last = self.first + count(&self.heights) - 1;
        // Positions at which the chain lies over a cell.
        let from = usize::try_from(-last).unwrap_or(0);
        let end = usize::try_from(count(surface) - self.first).unwrap_or(0).min(lowest.len());
        if let Some(rows) = lowest.get_mut(from..end) {
            self.raise_rows(rows, from, surface, 0, surface.len().saturating_sub(1));
        }
    }

    /// Raises the positions from `begin`, at which a cell from `left` to `right` holds the tool up.
    fn raise_rows(&self, rows: &mut [f64], begin: usize, surface: &[f64], left: usize, right: usize) {
        if left == right {
            return self.raise_by_cell(rows, begin, surface, left);
        }
        let middle = rows.len() / 2;
        let (before, rest) = rows.split_at_mut(middle);
        let Some((low, after)) = rest.split_first_mut() else { return };
        let (cell, value) = self.highest(begin + middle, surface, left, right);
        *low = low.max(value);
        self.raise_rows(before, begin, surface, left, cell);
        self.raise_rows(after, begin + middle + 1, surface, cell, right);
    }

    /// Raises the positions from `begin`, all of which lie over one cell that holds the tool up.
    fn raise_by_cell(&self, rows: &mut [f64], begin: usize, surface: &[f64], cell: usize) {
        let Some(height) = surface.get(cell) else { return };
        let back = |index: usize| cell.checked_signed_diff(begin + index)?.checked_sub(self.first);
        for (index, low) in rows.iter_mut().enumerate() {
            let under = back(index).and_then(|k| self.heights.get(usize::try_from(k).ok()?));
            *low = under.map_or(*low, |under| low.max(height - under));
        }
    }

    /// The cell from `left` to `right` that holds the tool up at a position, the first of several, and how high.
    fn highest(&self, position: usize, surface: &[f64], left: usize, right: usize) -> (usize, f64) {
        // The cell below the first height, and the heights that lie before the cells.
        let (begin, outside) = match position.checked_add_signed(self.first) {
            Some(begin) => (begin, 0),
            None => (0, self.first.unsigned_abs() - position),
        };
        let from = left.max(begin);
        let skipped = outside + from - begin;
        let cells = surface.get(from..=right).unwrap_or_default();
        let heights = self.heights.get(skipped..).unwrap_or_default();
        let mut best = (from.min(right), f64::NEG_INFINITY);
        for (k, (cell, height)) in cells.iter().zip(heights).enumerate() {
            let value = cell - height;
            if value > best.1 {
                best = (from + k, value);
            }
        }
        best
    }
}

/// Raises `lowest[j]` to `surface[j + away] − base`.
fn raise_by_one(lowest: &mut [f64], surface: &[f64], away: isize, base: f64) {
    let ahead = usize::try_from(away).unwrap_or(0);
    let behind = usize::try_from(-away).unwrap_or(0);
    for (low, value) in lowest.iter_mut().skip(behind).zip(surface.iter().skip(ahead)) {
        *low = low.max(value - base);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_pointed_tool_leaves_its_flank_beside_a_wall() {
        let tool = Contour::polygon(&[Point::new(0.0, 0.0), Point::new(4.0, 4.0), Point::new(0.0, 4.0)]);
        let mut surface = vec![0.0; 100];
        surface[60..].fill(3.0);
        let underside = Underside::of(&tool);
        let left = underside.left_by(&underside.lowest_positions(&surface, 0.1), 0.1);
        assert!(left[20].abs() < 1e-9 && (left[80] - 3.0).abs() < 1e-9);
        // One millimetre before the wall the 45° flank stands two millimetres above the ground.
        assert!((left[50] - 2.0).abs() < 0.11, "{}", left[50]);
    }

    proptest! {
        #[test]
        fn every_position_is_the_lowest_one(
            surface in prop::collection::vec(prop_oneof![4 => 0.0..9.0_f64, 1 => Just(f64::NEG_INFINITY)], 1..60),
            corners in prop::collection::vec((-3.0..3.0_f64, -2.0..2.0_f64), 3..9),
        ) {
            let step = 0.25;
            let mut points: Vec<Point> = corners.iter().map(|&(z, r)| Point::new(z, r)).collect();
            points.sort_by(|a, b| a.z.total_cmp(&b.z));
            points.dedup_by(|later, earlier| later.z - earlier.z < 0.01);
            prop_assume!(points.len() > 1);
            // There along the corners, back far above them.
            let above: Vec<Point> = points.iter().rev().map(|p| Point::new(p.z, 50.0)).collect();
            let underside = Underside::of(&Contour::polygon(&[points.clone(), above].concat()));
            let found = underside.lowest_positions(&surface, step);
            // All corners but the blunt ones within a convex chain.
            let blunt = |k: usize| {
                let near = k.checked_sub(1).and_then(|before| points.get(before..before + 3));
                near.is_some_and(|w| (0.0..=BLUNT).contains(&(slope(w[1], w[2]) - slope(w[0], w[1]))))
            };
            let sharp: Vec<Point> = (0..points.len()).filter(|&k| !blunt(k)).map(|k| points[k]).collect();
            for (j, &found) in found.iter().enumerate() {
                let mut truth = f64::NEG_INFINITY;
                for (i, &s) in surface.iter().enumerate() {
                    let z = (i as f64 - j as f64) * step;
                    let on = points.windows(2).filter(|w| w[0].z <= z && z <= w[1].z);
                    let between = on.map(|w| w[0].r + (w[1].r - w[0].r) * (z - w[0].z) / (w[1].z - w[0].z));
                    let corner = sharp.iter().filter(|p| ((p.z / step).round() - (i as f64 - j as f64)).abs() < 0.5);
                    truth = between.chain(corner.map(|p| p.r)).map(|r| s - r).fold(truth, f64::max);
                }
                let close = found == truth || (truth - found).abs() < 1e-9;
                prop_assert!(close, "{found} {truth} at {j}: {points:?}");
            }
        }
    }
}
