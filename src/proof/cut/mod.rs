//! Cuts the stock with the swept insert and finds what touches that must not.
//!
//! The stock is kept as `columns`: stretches of z with a stack of spans between lines, in chunks (`stock`). What a tool covers
//! on its way (`sweep`) becomes columns too (`envelope`, `scan`), and `overlap` compares the two where they meet. `outline` makes rings of
//! columns for everybody else, and `history` keeps what playback needs.

mod columns;
mod contact;
mod cutter;
mod envelope;
pub(super) mod grid;
mod history;
mod line;
mod outline;
mod overlap;
#[cfg(test)]
mod reference;
mod scan;
mod stock;
mod sweep;

use super::input::Work;
use crate::geometry::{Contour, Point, Segment};
use crate::machine::{Chuck, ToolOutline};
pub(super) use contact::{CONTACT_AREA_MM2, Contact};
use contact::{NearEdges, Touched};
use cutter::Cutter;
use grid::{GridPoint, Ring, Window, area_of};
use history::Pass;
pub use history::StockHistory;
use overlap::Overlap;
use std::collections::BTreeMap;
use std::sync::Arc;
pub(super) use stock::Stock;
use sweep::{covered, met};

/// What holds the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Holding {
    /// The jaws of the chuck.
    Chuck,
    /// What drives work between centres.
    Mandrel,
    /// The centre of the tailstock.
    Tailstock,
}

/// The stock, the tools and what holds the work.
pub(super) struct Cutting<'a> {
    stock: Stock,
    tools: &'a BTreeMap<u32, ToolOutline>,
    /// The tools that have moved so far.
    cutters: BTreeMap<u32, Arc<Cutter>>,
    held_by: Vec<(Holding, Stock)>,
    history: StockHistory,
    /// The tool that came to a place with its holder clear of the stock.
    clear: Option<(u32, GridPoint)>,
    overlap: Overlap,
}

/// What one move did.
#[derive(Debug, Default)]
pub(super) struct Cut {
    /// Stock that the insert took away.
    pub taken: Vec<Ring>,
    /// Its area, mm².
    pub taken_mm2: f64,
    /// Stock that went through an edge that cannot cut.
    pub flank: Option<Contact>,
    /// Stock that the holder ran into.
    pub holder: Option<Contact>,
    /// What holds the work that insert or holder ran into.
    pub holding: Vec<(Holding, Contact)>,
}

impl Cut {
    /// Where stock was taken, if enough was taken to matter.
    pub(super) fn contact(&self) -> Option<Contact> {
        Contact::of(&self.taken)
    }
}

impl<'a> Cutting<'a> {
    /// Work and tools before the first move.
    pub(super) fn new(work: &Work, tools: &'a BTreeMap<u32, ToolOutline>, chuck: &Chuck) -> Self {
        let stock = Stock::of_contour(&work.stock);
        let others = [(Holding::Mandrel, &work.mandrel), (Holding::Tailstock, &work.tailstock)];
        let others = others.into_iter().filter_map(|(holding, outline)| Some((holding, outline.clone()?)));
        let held_by = std::iter::once((Holding::Chuck, jaws(chuck, work.chuck_face_z))).chain(others);
        Self {
            history: StockHistory::new(stock.clone()),
            stock,
            tools,
            cutters: BTreeMap::new(),
            held_by: held_by.map(|(holding, outline)| (holding, Stock::of_contour(&outline))).collect(),
            clear: None,
            overlap: Overlap::default(),
        }
    }

    /// The stock as it is.
    pub(super) fn stock(&self) -> &Stock {
        &self.stock
    }

    /// Moves that have cut so far; the history has a state for each.
    pub(super) fn passes(&self) -> usize {
        self.history.len().saturating_sub(1)
    }

    /// The stock after every move that has cut.
    pub(super) fn into_history(self) -> StockHistory {
        self.history.with_cutters(self.cutters)
    }

    /// The tool of a turret station; `None` for a station without one.
    fn cutter(&mut self, tool: u32) -> Option<Arc<Cutter>> {
        if let Some(cutter) = self.cutters.get(&tool) {
            return Some(Arc::clone(cutter));
        }
        let cutter = Arc::new(Cutter::new(self.tools.get(&tool)?));
        self.cutters.insert(tool, Arc::clone(&cutter));
        Some(cutter)
    }

    /// Moves a tool along a path and cuts.
    pub(super) fn travel(&mut self, path: &Segment, tool: u32) -> Cut {
        let Some(cutter) = self.cutter(tool) else { return Cut::default() };
        let cutter = &*cutter;
        let pass = Pass { path: *path, tool, pitch_mm: None };
        let points = pass.points();
        let holding = self.holding_met(cutter, &points);
        let mut touched = self.touched_ahead(cutter, &points);
        let start = points.first().copied().filter(|&start| self.clear != Some((tool, start)));
        if let Some(start) = start {
            touched.at_start(&self.stock, cutter, start, &mut self.overlap);
        }
        let taken = self.take(cutter, &points, pass);
        touched.after(&self.stock, cutter, &points, &mut self.overlap);
        self.clear = points.last().filter(|_| touched.holder.is_empty()).map(|&end| (tool, end));
        Cut {
            taken_mm2: area_of(&taken),
            taken,
            flank: Contact::of_all(&touched.flank),
            holder: Contact::of_all(&touched.holder),
            holding,
        }
    }

    /// Cuts the grooves of a thread from `near` to `far`: the insert at every pitch and at the far end. The passes before the
    /// last lie inside its grooves. Returns how many grooves there are too.
    pub(super) fn thread(&mut self, near: Point, far: Point, pitch: f64, tool: u32) -> (Cut, u32) {
        let Some(cutter) = self.cutter(tool) else { return (Cut::default(), 1) };
        let cutter = &*cutter;
        let pass = Pass { path: Segment::line(near, far), tool, pitch_mm: Some(pitch) };
        let points = pass.points();
        let holding = self.holding_met(cutter, &points);
        let taken = self.take(cutter, &points, pass);
        let mut touched = Touched::default();
        touched.after(&self.stock, cutter, &points, &mut self.overlap);
        let holder = Contact::of_all(&touched.holder);
        (Cut { taken_mm2: area_of(&taken), taken, flank: None, holder, holding }, pass.grooves())
    }

    /// What insert and holder run into on their way of what holds the work.
    fn holding_met(&mut self, cutter: &Cutter, points: &[GridPoint]) -> Vec<(Holding, Contact)> {
        let way = Window::around(points);
        let pieces = [(&cutter.insert, &cutter.insert_window), (&cutter.holder, &cutter.holder_window)];
        let pieces = pieces.map(|(pieces, window)| (pieces, window.moved(&way)));
        let mut found = Vec::new();
        for (holding, region) in &self.held_by {
            let near = pieces.iter().filter(|(_, window)| region.may_meet(window));
            let rings: Vec<Ring> =
                near.flat_map(|(pieces, _)| met(region, pieces, points, &mut self.overlap)).collect();
            found.extend(Contact::of_all(&rings).map(|contact| (*holding, contact)));
        }
        found
    }

    /// What holder and back of the insert run into before the insert has been there.
    ///
    /// A straight move is one step. Along an arc the steps are looked at against the stock before the move first, which can
    /// only find too much; if it does, they are run one after another on a copy.
    fn touched_ahead(&mut self, cutter: &Cutter, points: &[GridPoint]) -> Touched {
        let mut touched = Touched::default();
        let steps = || points.windows(2).map(|step| [step[0], step[1]]);
        let edges = NearEdges::of(cutter, &self.stock, points);
        if edges.is_empty() {
            return touched;
        }
        for step in steps() {
            touched.before(&self.stock, cutter, &edges, step, &mut self.overlap);
        }
        if points.len() <= 2 {
            return touched;
        }
        let looks_closer = touched.matters();
        touched = Touched::default();
        if looks_closer {
            let mut stock = self.stock.clone();
            for step in steps() {
                touched.before(&stock, cutter, &edges, step, &mut self.overlap);
                let window = cutter.insert_window.moved(&Window::around(&step));
                stock.cut_away(&covered(&cutter.insert, &step), &window, &mut self.overlap);
                touched.after(&stock, cutter, &step, &mut self.overlap);
            }
        }
        touched
    }

    /// Takes away what the insert covers on its way.
    fn take(&mut self, cutter: &Cutter, points: &[GridPoint], pass: Pass) -> Vec<Ring> {
        let window = cutter.insert_window.moved(&Window::around(points));
        if !self.stock.may_meet(&window) {
            return Vec::new();
        }
        let taken = self.stock.cut_away(&pass.covers(cutter, points), &window, &mut self.overlap);
        if !taken.is_empty() {
            self.history.push(pass, &self.stock);
        }
        taken
    }
}

/// The outline of the jaws.
fn jaws(chuck: &Chuck, face_z: f64) -> Contour {
    let left = face_z - chuck.depth_mm;
    let corners = [(left, 0.0), (face_z, 0.0), (face_z, chuck.radius_mm), (left, chuck.radius_mm)];
    Contour::polygon(&corners.map(|(z, r)| Point::new(z, r)))
}
