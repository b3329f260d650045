//! The stock at a moment, cut into triangles once, and what is gouged out of the part.

use crate::app::plots::profile::draw::Lines;
use crate::app::plots::regions::{Triangles, from_axis_to_axis};
use crate::geometry::Point;
use crate::proof::{ProofReport, StockState};
use crate::regen::SetupDerived;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use std::collections::HashMap;
use std::sync::Arc;

/// Stock states kept; a long program has thousands, playback needs the ones around the slider.
const KEPT: usize = 96;
/// Chords of the part's outline are this near to its arcs, mm: below what the proof takes for a gouge.
const CHORDS_MM: f64 = 0.002;

/// Stock states of one proof, made ready when first shown.
#[derive(Debug, Default)]
pub(super) struct StockCache {
    made_for: Option<Arc<ProofReport>>,
    states: HashMap<usize, Arc<Shown>>,
}

/// One stock state ready to be drawn.
#[derive(Debug, Default)]
pub(super) struct Shown {
    /// The stock; `None` without a proof.
    pub(super) state: Option<StockState>,
    /// The same in triangles.
    pub(super) region: Triangles,
    /// Where it reaches into the finished part's place too little: what is gouged.
    pub(super) gouged: Triangles,
}

impl StockCache {
    /// The stock state `index`, made ready if it is not yet. Gouges thinner than `tolerance_mm` are left out.
    pub(super) fn state(&mut self, derived: &SetupDerived, index: usize, tolerance_mm: f64) -> Arc<Shown> {
        if !self.made_for.as_ref().is_some_and(|proof| Arc::ptr_eq(proof, &derived.proof)) {
            self.states.clear();
            self.made_for = Some(Arc::clone(&derived.proof));
        }
        if self.states.len() >= KEPT {
            self.states.clear();
        }
        let made = self.states.entry(index).or_insert_with(|| Arc::new(shown(derived, index, tolerance_mm)));
        Arc::clone(made)
    }
}

fn shown(derived: &SetupDerived, index: usize, tolerance_mm: f64) -> Shown {
    let Some(state) = derived.proof.stock.get(index) else { return Shown::default() };
    let gouged = gouged(&part_ring(derived), &state.rings, tolerance_mm);
    Shown { region: Triangles::of(&state.rings), gouged: Triangles::of(&gouged), state: Some(state) }
}

/// The outside of the stock state `index` in front of `from_z`, from the axis round to the axis; empty without one.
pub(in crate::app::plots) fn stock_ring_at(derived: &SetupDerived, index: usize, from_z: f64) -> Vec<Point> {
    let Some(state) = derived.proof.stock.get(index) else { return Vec::new() };
    let span = |ring: &&Vec<Point>| ring.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
    let longest = state.rings.iter().max_by(|a, b| span(a).total_cmp(&span(b)));
    // Counter-clockwise from the axis: turned over it runs from the clamped end up and along to the free end.
    let ring: Vec<Point> = longest.into_iter().flatten().rev().map(|p| Point::new(p.z.max(from_z), p.r)).collect();
    from_axis_to_axis(&ring)
}

fn part_ring(derived: &SetupDerived) -> Vec<Point> {
    Lines::of(derived, CHORDS_MM).outline()
}

/// The part without the stock, as rings; slivers thinner than `tolerance_mm` are left out.
fn gouged(part: &[Point], stock: &[Vec<Point>], tolerance_mm: f64) -> Vec<Vec<Point>> {
    if part.len() < 3 || stock.is_empty() || part.iter().chain(stock.iter().flatten()).any(|p| !p.is_finite()) {
        return Vec::new();
    }
    let pairs = |ring: &[Point]| ring.iter().map(|p| [p.z, p.r]).collect::<Vec<[f64; 2]>>();
    let subject = vec![pairs(part)];
    let clip: Vec<_> = stock.iter().map(|ring| pairs(ring)).collect();
    let shapes = subject.overlay(&clip, OverlayRule::Difference, FillRule::NonZero);
    let thick = |shape: &Vec<Vec<[f64; 2]>>| shape.first().is_some_and(|ring| thickness(ring) > tolerance_mm);
    let rings = shapes.into_iter().filter(thick).flatten();
    rings.map(|ring| ring.into_iter().map(|[z, r]| Point::new(z, r)).collect()).collect()
}

/// Twice the area over the length round: the mean thickness of a sliver, mm.
fn thickness(ring: &[[f64; 2]]) -> f64 {
    let pairs = || ring.iter().zip(ring.iter().cycle().skip(1));
    let area: f64 = pairs().map(|(a, b)| (a[0] * b[1] - b[0] * a[1]) / 2.0).sum();
    let round: f64 = pairs().map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1])).sum();
    2.0 * area.abs() / round
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[(f64, f64)]) -> Vec<Point> {
        points.iter().map(|&(z, r)| Point::new(z, r)).collect()
    }

    #[test]
    fn a_groove_into_the_part_is_a_gouge() {
        let part = ring(&[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (0.0, 5.0)]);
        let whole = ring(&[(-5.0, 0.0), (10.0, 0.0), (10.0, 6.0), (-5.0, 6.0)]);
        assert!(gouged(&part, &[whole], 0.01).is_empty());
        let cut =
            ring(&[(-5.0, 0.0), (10.0, 0.0), (10.0, 6.0), (4.0, 6.0), (4.0, 4.5), (3.0, 4.5), (3.0, 6.0), (-5.0, 6.0)]);
        let found = gouged(&part, &[cut], 0.01);
        assert_eq!(found.len(), 1);
        assert!((thickness(&found[0].iter().map(|p| [p.z, p.r]).collect::<Vec<_>>()) - 1.0 / 3.0).abs() < 1e-6);
    }

    #[test]
    fn chords_of_an_arc_are_no_gouge() {
        let part = ring(&[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (0.0, 5.0)]);
        let near = ring(&[(-5.0, 0.0), (10.0, 0.0), (10.0, 4.997), (-5.0, 4.997)]);
        assert!(gouged(&part, &[near], 0.01).is_empty());
    }
}
