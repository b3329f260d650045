//! The stock after every pass, for playback.

use super::columns::Columns;
use super::cutter::Cutter;
use super::grid::{GridPoint, Ring, Window, to_grid};
use super::overlap::Overlap;
use super::stock::Stock;
use super::sweep::{covered, swept};
use crate::geometry::{Contour, Point, Segment};
use crate::proof::report::StockState;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Arcs of paths become chords no further from them than this, mm: a fifth of the gouge that is looked for, for on the way round a
/// crest chords cut deeper than the arc.
const PATH_CHORD_MM: f64 = 0.000_2;

/// Passes between two stocks that are kept, at first.
const FIRST_STRIDE: usize = 16;
/// Columns that all kept stocks together may hold; beyond, every second one is dropped. 400,000 columns are 25 MB.
const MOST_COLUMNS: usize = 400_000;
/// Grooves of one thread at most; the longest travel at the finest pitch has 1000.
const MOST_GROOVES: u32 = 5_000;

/// The stock before the first pass that cut and after each: some are kept, those between are cut anew when asked for.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StockHistory {
    cutters: BTreeMap<u32, Arc<Cutter>>,
    passes: Vec<Pass>,
    /// The stock after every `stride` passes, the first one before any.
    kept: Vec<Stock>,
    kept_columns: usize,
    stride: usize,
}

/// A motion of a tool that took stock away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pass {
    /// Path of the programmed point; of a thread its last pass.
    pub path: Segment,
    /// Turret station.
    pub tool: u32,
    /// Pitch of a thread, mm.
    pub pitch_mm: Option<f64>,
}

impl StockHistory {
    /// The history of a stock that nothing has cut yet.
    #[must_use]
    pub fn uncut(stock: &Contour) -> Self {
        Self::new(Stock::of_contour(stock))
    }

    pub(super) fn new(stock: Stock) -> Self {
        let cutters = BTreeMap::new();
        Self { cutters, kept_columns: stock.columns(), kept: vec![stock], passes: Vec::new(), stride: FIRST_STRIDE }
    }

    /// The same with the tools of its passes.
    pub(super) fn with_cutters(self, cutters: BTreeMap<u32, Arc<Cutter>>) -> Self {
        Self { cutters, ..self }
    }

    /// Adds a pass and the stock that it left.
    pub(super) fn push(&mut self, pass: Pass, stock: &Stock) {
        self.passes.push(pass);
        if self.passes.len().is_multiple_of(self.stride) {
            self.kept_columns += stock.columns();
            self.kept.push(stock.clone());
            while self.kept_columns > MOST_COLUMNS && self.kept.len() > 2 {
                self.thin_out();
            }
        }
    }

    /// Drops every second stock but the first.
    fn thin_out(&mut self) {
        let mut index = 0;
        self.kept.retain(|_| {
            index += 1;
            index % 2 == 1
        });
        self.stride *= 2;
        self.kept_columns = self.kept.iter().map(Stock::columns).sum();
    }

    /// Number of states: one more than passes that cut; 0 if there is no stock.
    #[must_use]
    pub fn len(&self) -> usize {
        if self.kept.is_empty() { 0 } else { self.passes.len() + 1 }
    }

    /// True if there is no stock.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.kept.is_empty()
    }

    /// The stock after `index` passes that cut; moves name it by `stock_after`. `None` beyond the last.
    ///
    /// Up to some dozens of passes are cut anew (some hundreds in programs of 100,000 blocks), so keep what is shown.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<StockState> {
        let nearest = index.checked_div(self.stride)?.min(self.kept.len().checked_sub(1)?);
        let passes = self.passes.get(nearest * self.stride..index)?;
        let mut stock = self.kept.get(nearest)?.clone();
        let mut overlap = Overlap::default();
        for pass in passes {
            if let Some(cutter) = self.cutters.get(&pass.tool) {
                let points = pass.points();
                let window = cutter.insert_window.moved(&Window::around(&points));
                stock.cut_away(&pass.covers(cutter, &points), &window, &mut overlap);
            }
        }
        Some(stock.state())
    }

    /// The stock before the first pass.
    #[must_use]
    pub fn first(&self) -> Option<StockState> {
        self.get(0)
    }

    /// The stock after the last pass.
    #[must_use]
    pub fn last(&self) -> Option<StockState> {
        self.get(self.len().checked_sub(1)?)
    }
}

impl Pass {
    /// The path on the grid, arcs as chords.
    pub(super) fn points(&self) -> Vec<GridPoint> {
        let mut points: Vec<GridPoint> =
            std::iter::once(self.path.start()).chain(self.path.polyline_points(PATH_CHORD_MM)).map(to_grid).collect();
        points.dedup();
        points
    }

    /// What the insert covers on its way along `points`.
    pub(super) fn covers(&self, cutter: &Cutter, points: &[GridPoint]) -> Columns {
        let Some(pitch) = self.pitch_mm else { return covered(&cutter.insert, points) };
        let (near, far) = (self.path.start(), self.path.end());
        let length = near.distance(far);
        let at = |k: u32| near + (far - near) * (f64::from(k) * pitch / length.max(pitch)).min(1.0);
        let places = (0..self.grooves()).map(at).chain([far]).map(to_grid);
        let rings: Vec<Ring> =
            places.flat_map(|p: GridPoint| cutter.insert.iter().map(move |piece| swept(piece, &[p]))).collect();
        Columns::of_rings(&rings)
    }

    /// Grooves that a thread has beside each other: one at every pitch.
    pub(super) fn grooves(&self) -> u32 {
        let (near, far): (Point, Point) = (self.path.start(), self.path.end());
        let most = f64::from(MOST_GROOVES);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=MOST_GROOVES")]
        let whole = self.pitch_mm.map_or(0.0, |pitch| (near.distance(far) / pitch).clamp(0.0, most)) as u32;
        whole + 1
    }
}
