//! The stock as a region of the grid, and the polygon operations on it.

use super::grid::{GridPoint, Ring, Window, area_mm2, from_grid, hull, is_sliver, overlaps, to_grid};
use crate::geometry::Contour;
use crate::proof::report::StockState;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use std::sync::Arc;

/// Arcs of stock, tools and paths become chords no further from them than this, mm.
pub(in crate::proof) const CHORD_TOLERANCE_MM: f64 = 0.000_5;

/// A region: rings with the material to the left.
#[derive(Default)]
pub(in crate::proof) struct Region {
    rings: Vec<Ring>,
    /// Rectangle around the rings.
    window: Option<Window>,
    engine: Engine,
}

/// Keeps its buffers from one operation to the next.
struct Engine(Overlay<i32>);

impl Default for Engine {
    fn default() -> Self {
        Self(Overlay::new(256))
    }
}

impl Engine {
    fn load(&mut self, subject: &[Ring], clip: &[Ring]) {
        self.0.clear();
        for ring in subject {
            self.0.add_contour(ring, ShapeType::Subject);
        }
        for ring in clip {
            self.0.add_contour(ring, ShapeType::Clip);
        }
    }

    fn run(&mut self, subject: &[Ring], clip: &[Ring], rule: OverlayRule) -> Vec<Ring> {
        self.load(subject, clip);
        material(self.0.overlay(rule, FillRule::NonZero))
    }
}

/// The rings of shapes without slivers.
fn material(shapes: Vec<Vec<Ring>>) -> Vec<Ring> {
    shapes.into_iter().flatten().filter(|ring| !is_sliver(ring)).collect()
}

impl Region {
    /// The region inside a closed contour.
    pub(in crate::proof) fn of_contour(contour: &Contour) -> Self {
        let ring: Ring = contour.polyline(CHORD_TOLERANCE_MM).into_iter().map(to_grid).collect();
        let mut region = Self::default();
        let rings = region.united(&[ring]);
        region.set(rings);
        region
    }

    fn set(&mut self, rings: Vec<Ring>) {
        self.window = rings.iter().map(|ring| Window::around(ring)).reduce(Window::union);
        self.rings = rings;
    }

    /// True if the material and the convex hull of `ring` may share more than their borders; exact if `ring` is convex.
    pub(super) fn may_meet(&self, ring: &[GridPoint]) -> bool {
        self.window.is_some_and(|window| window.meets(&Window::around(ring)))
            && overlaps(&hull(ring.to_vec()), &self.rings)
    }

    /// The rings.
    pub(in crate::proof) fn rings(&self) -> &[Ring] {
        &self.rings
    }

    /// The region as it is shown and kept.
    pub(in crate::proof) fn state(&self) -> StockState {
        let ring = |ring: &Ring| ring.iter().map(|&p| from_grid(p)).collect();
        StockState { rings: Arc::new(self.rings.iter().map(ring).collect()) }
    }

    /// Takes away what the rings of `cut` cover and returns what was taken; `None` if nothing was.
    pub(super) fn cut_away(&mut self, cut: &[Ring]) -> Option<Vec<Ring>> {
        self.engine.load(&self.rings, cut);
        let mut buffer = i_overlay::core::extract::BooleanExtractionBuffer::default();
        let graph = self.engine.0.build_graph_view(FillRule::NonZero)?;
        let taken = material(graph.extract_shapes(OverlayRule::Intersect, &mut buffer));
        if taken.is_empty() {
            return None;
        }
        let left = material(graph.extract_shapes(OverlayRule::Difference, &mut buffer));
        self.set(left);
        Some(taken)
    }

    /// What the rings of `other` share with the region.
    pub(super) fn shared(&mut self, other: &[Ring]) -> Vec<Ring> {
        self.engine.run(&self.rings, other, OverlayRule::Intersect)
    }

    /// The union of rings.
    pub(super) fn united(&mut self, rings: &[Ring]) -> Vec<Ring> {
        self.engine.run(rings, &[], OverlayRule::Subject)
    }

    /// A copy with an engine of its own.
    pub(super) fn copied(&self) -> Self {
        Self { rings: self.rings.clone(), window: self.window, engine: Engine::default() }
    }
}

/// Area of rings together, mm²; holes run clockwise and count negative.
pub(super) fn area_of(rings: &[Ring]) -> f64 {
    rings.iter().map(|ring| area_mm2(ring)).sum()
}
