//! The stock: columns in chunks, so that a cut touches only the few chunks that it meets.

use super::columns::Columns;
use super::grid::{Ring, Window, from_grid, to_grid};
use super::overlap::Overlap;
use crate::geometry::Contour;
use crate::proof::report::StockState;
use std::sync::Arc;

/// Arcs of stock and tools become chords no further from them than this, mm.
pub(super) const CHORD_TOLERANCE_MM: f64 = 0.000_5;
/// Columns of one chunk at most: fewer are copied at every cut, more are passed over at every look.
const MOST_COLUMNS: usize = 64;
/// Neighbours with fewer columns than this together become one.
const FEW_COLUMNS: usize = 16;

/// A region that is cut again and again. A copy shares everything with the original that is not cut afterwards.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::proof) struct Stock {
    /// In order of z.
    chunks: Vec<Arc<Chunk>>,
}

/// A few columns that follow one another.
#[derive(Debug, PartialEq)]
struct Chunk {
    window: Window,
    columns: Columns,
}

impl Stock {
    /// The region inside a closed contour.
    pub(in crate::proof) fn of_contour(contour: &Contour) -> Self {
        let ring: Ring = contour.polyline(CHORD_TOLERANCE_MM).into_iter().map(to_grid).collect();
        let mut stock = Self::default();
        stock.chunks.extend(chunks_of(&Columns::of_rings(&[ring])));
        stock
    }

    /// Number of columns.
    pub(super) fn columns(&self) -> usize {
        self.chunks.iter().map(|chunk| chunk.columns.len()).sum()
    }

    /// The outlines of the material: outer ones counter-clockwise, holes clockwise.
    pub(in crate::proof) fn rings(&self) -> Vec<Ring> {
        let mut whole = Columns::default();
        self.chunks.iter().for_each(|chunk| whole.append(&chunk.columns));
        whole.rings()
    }

    /// The region as it is shown.
    pub(in crate::proof) fn state(&self) -> StockState {
        let ring = |ring: &Ring| ring.iter().map(|&p| from_grid(p)).collect();
        StockState { rings: Arc::new(self.rings().iter().map(ring).collect()) }
    }

    /// True if material may lie in a rectangle.
    pub(super) fn may_meet(&self, window: &Window) -> bool {
        self.near(window).any(|(_, chunk)| chunk.columns.reach_into(window))
    }

    /// The chunks that may reach into a rectangle.
    fn near(&self, window: &Window) -> impl Iterator<Item = (usize, &Chunk)> {
        let first = self.chunks.partition_point(|chunk| chunk.window.max.x < window.min.x);
        let (end, window) = (window.max.x, *window);
        let rest = self.chunks[first..].iter().enumerate().take_while(move |(_, chunk)| chunk.window.min.x <= end);
        rest.filter(move |(_, chunk)| chunk.window.meets(&window)).map(move |(k, chunk)| (first + k, &**chunk))
    }

    /// What the region shares with another one, which lies in `window`.
    pub(super) fn shared(&self, other: &Columns, window: &Window, overlap: &mut Overlap) -> Columns {
        overlap.shared.clear();
        self.near(window).for_each(|(_, chunk)| overlap.share(&chunk.columns, other));
        std::mem::take(&mut overlap.shared)
    }

    /// Takes away what `cut` covers, which lies in `window`, and returns the outlines of what was taken; slivers alone are
    /// left where they are.
    pub(super) fn cut_away(&mut self, cut: &Columns, window: &Window, overlap: &mut Overlap) -> Vec<Ring> {
        overlap.shared.clear();
        let mut changed: Vec<(usize, Columns)> = Vec::with_capacity(2);
        for (index, chunk) in self.near(window) {
            overlap.left.clear();
            if overlap.subtract(&chunk.columns, cut) {
                changed.push((index, overlap.left.clone()));
            }
        }
        let taken = overlap.outlines();
        if !taken.is_empty() {
            changed.into_iter().rev().for_each(|(index, columns)| self.replace(index, columns));
        }
        taken
    }

    /// Puts columns in the place of a chunk.
    fn replace(&mut self, index: usize, mut columns: Columns) {
        let next = self.chunks.get(index + 1).filter(|next| next.columns.len() + columns.len() < FEW_COLUMNS);
        if let Some(next) = next {
            columns.append(&next.columns);
            self.chunks.splice(index..index + 2, chunks_of(&columns));
        } else if columns.len() <= MOST_COLUMNS
            && let Some(window) = columns.window()
        {
            self.chunks[index] = Arc::new(Chunk { window, columns });
        } else {
            self.chunks.splice(index..=index, chunks_of(&columns));
        }
    }
}

/// Columns in chunks that can still grow.
fn chunks_of(columns: &Columns) -> Vec<Arc<Chunk>> {
    let most = if columns.len() <= MOST_COLUMNS { MOST_COLUMNS } else { MOST_COLUMNS / 2 };
    let part = |first: usize| {
        let mut part = Columns::default();
        columns.between(first, first + most).for_each(|c| part.push(c.from, c.to, c.spans));
        Some(Arc::new(Chunk { window: part.window()?, columns: part }))
    };
    (0..columns.len()).step_by(most).filter_map(part).collect()
}
