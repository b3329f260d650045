//! The cut plot: tool paths, the stock that is left and the tool at the slider, with playback.
//!
//! It takes data in and gives [`CutEvent`]s out. Besides the gestures of every canvas: space plays, left and right step
//! by block, home and end go to the ends, a click on a path selects its block.

mod bar;
mod chart;
mod draw;
mod paths;
mod playback;
mod stock;
mod tool;

use super::canvas::{self, Canvas, CanvasView, Rulers};
use super::coordinates::Coordinates;
use super::palette::Palette;
use super::tip::tip;
use crate::geometry::{Bounds, Point};
use crate::machine::Machine;
use crate::part::Setup;
use crate::proof::{BlockRef, Move};
use crate::regen::SetupDerived;
use crate::units::Unit;
use chart::Chart;
use egui::{Ui, Vec2};
use paths::Paths;
pub use playback::clock;
use playback::{Position, position_at, total_s};
use stock::StockCache;
pub(super) use stock::stock_ring_at;
use tool::Tools;

/// Longest step of the clock in one frame, s: after a pause of the window playback goes on where it was.
const LONGEST_FRAME_S: f64 = 0.1;

/// What the cut plot shows.
pub struct CutScene<'a> {
    /// Everything that follows for the set-up shown.
    pub derived: &'a SetupDerived,
    /// Unit of the document.
    pub unit: Unit,
    /// Machine whose chuck is drawn.
    pub machine: Option<&'a Machine>,
    /// Deviation from the contour that is allowed, mm.
    pub form_tolerance_mm: f64,
    /// Block that is selected.
    pub selected: Option<BlockRef>,
    /// Blocks that belong to what the pointer is on, here or elsewhere.
    pub lit_blocks: &'a [BlockRef],
    /// Rows that belong to what the pointer is on.
    pub lit_sections: &'a [u32],
    /// Colours.
    pub palette: &'a Palette,
}

/// What the cut plot keeps from frame to frame.
#[derive(Debug)]
#[allow(clippy::struct_excessive_bools, reason = "switches of the view that do not depend on one another")]
pub struct CutView {
    /// What the canvas shows.
    pub canvas: CanvasView,
    /// Time at the slider, s from the start of the first program.
    pub time_s: f64,
    /// The time runs.
    pub playing: bool,
    /// How many times faster than the machine the time runs.
    pub speed: u32,
    /// Show the stock that is left at the slider.
    pub stock: bool,
    /// Colour what the programs leave on the part.
    pub leftover: bool,
    /// Show the chart of the chip cross-section.
    pub chart: bool,
    paths: Paths,
    states: StockCache,
    tools: Tools,
    chips: Chart,
}

impl Default for CutView {
    fn default() -> Self {
        Self {
            canvas: CanvasView::default(),
            time_s: 0.0,
            playing: false,
            speed: 8,
            stock: true,
            leftover: false,
            chart: false,
            paths: Paths::default(),
            states: StockCache::default(),
            tools: Tools::default(),
            chips: Chart::default(),
        }
    }
}

impl CutView {
    /// The block that runs at the slider.
    #[must_use]
    pub fn block(&self, derived: &SetupDerived) -> Option<BlockRef> {
        self.running(derived).map(BlockRef::of)
    }

    /// `block 12 of 91 · tool 1`: what runs at the slider. Empty without a program.
    #[must_use]
    pub fn status(&self, derived: &SetupDerived) -> String {
        let Some(m) = self.running(derived) else { return String::new() };
        let program = derived.programs.get(m.program).map(|p| p.name.as_str()).unwrap_or_default();
        let of = derived.proof.blocks.iter().filter(|b| b.program == program).map(|b| b.block).max();
        let of = of.map_or_else(String::new, |blocks| format!(" of {blocks}"));
        let which = if derived.programs.len() > 1 { format!("{program} · ") } else { String::new() };
        format!("{which}block {}{of} · tool {}", m.block, m.tool)
    }

    /// Puts the slider to the start of the first run of `block`; of one that moves nothing, to the next block that does.
    pub fn go_to(&mut self, derived: &SetupDerived, block: BlockRef) {
        let moves = &derived.proof.moves;
        let own = moves.iter().find(|m| BlockRef::of(m) == block);
        let later = || moves.iter().find(|m| m.program == block.program && m.block > block.block);
        if let Some(m) = own.or_else(later) {
            self.time_s = m.starts_s;
            self.playing = false;
        }
    }

    fn running<'a>(&self, derived: &'a SetupDerived) -> Option<&'a Move> {
        let moves = &derived.proof.moves;
        moves.get(position_at(moves, self.time_s)?.index)
    }

    fn advance(&mut self, ui: &Ui, total: f64) {
        self.time_s = if self.time_s.is_finite() { self.time_s.clamp(0.0, total) } else { 0.0 };
        if !self.playing {
            return;
        }
        let passed = f64::from(ui.input(|i| i.stable_dt)).min(LONGEST_FRAME_S);
        self.time_s = (self.time_s + passed * f64::from(self.speed)).min(total);
        self.playing = self.time_s < total;
        ui.request_repaint();
    }
}

/// What a person asks of the cut plot.
#[derive(Debug, Clone, PartialEq)]
pub enum CutEvent {
    /// A path was clicked.
    SelectBlock(BlockRef),
    /// The pointer is on the path of this block; said in every frame.
    HoverBlock(BlockRef),
    /// The slider was moved by hand to this time, s.
    Scrub(f64),
    /// The pointer is at this z and diameter of the document, or left the plot.
    Pointer(Option<(f64, f64)>),
}

/// One frame of the cut plot.
struct Frame<'a> {
    scene: &'a CutScene<'a>,
    screen: canvas::Screen,
    /// Where the tool is, if there is a program.
    now: Option<Position>,
}

impl Frame<'_> {
    /// The move that runs at `now`.
    fn running(&self, now: Position) -> Option<&Move> {
        self.scene.derived.proof.moves.get(now.index)
    }
}

/// Shows paths, stock and tool with the playback bar in the room that is left in `ui`.
pub fn cut_plot(ui: &mut Ui, view: &mut CutView, scene: &CutScene<'_>) -> Vec<CutEvent> {
    let moves = &scene.derived.proof.moves;
    view.advance(ui, total_s(moves));
    let mut events = Vec::new();
    let below = bar::HEIGHT + Chart::height(view.chart) + 2.0 * ui.spacing().item_spacing.y;
    let size = (ui.available_size() - Vec2::new(0.0, below)).max(Vec2::splat(40.0));
    picture(ui, view, scene, size, &mut events);
    bar::bar(ui, view, moves, scene.palette, &mut events);
    view.chips.show(ui, &mut view.chart, scene, view.time_s);
    events
}

fn picture(ui: &mut Ui, view: &mut CutView, scene: &CutScene<'_>, size: Vec2, events: &mut Vec<CutEvent>) {
    let name = format!("Cut of {}", scene.derived.name);
    let bounds = shown_bounds(&scene.derived.setup);
    let canvas = canvas::canvas(ui, &mut view.canvas, size, bounds, &name, true);
    if canvas.response.has_focus() {
        bar::keys(ui, view, &scene.derived.proof.moves, events);
    }
    let now = position_at(&scene.derived.proof.moves, view.time_s);
    let frame = Frame { scene, screen: canvas.screen, now };
    let painter = ui.painter_at(canvas.response.rect);
    let coordinates = Coordinates::of(&scene.derived.setup, scene.unit);
    Rulers { coordinates, grid: false, mirrored: false }.draw(&painter, &canvas.screen, scene.palette);
    let free = painter.with_clip_rect(Rulers::free(canvas.response.rect));
    view.paths.update(scene.derived, canvas.screen);
    view.tools.update(&scene.derived.tools);
    draw::picture(&free, &frame, view);
    canvas::overlay(ui, &view.canvas, &canvas, scene.palette);
    events.push(CutEvent::Pointer(canvas.pointer.map(|p| (coordinates.document_z(p.z), coordinates.diameter(p.r)))));
    point_at(&frame, view, &canvas, &free, events);
}

/// What a fitted view shows: the part, the bar and room for the tool above it.
fn shown_bounds(setup: &Setup) -> Bounds {
    let radius = setup.bar_radius.max(setup.length * 0.02);
    let from = setup.chuck_face_z.min(0.0) - 0.05 * setup.length;
    Bounds { min: Point::new(from, -0.08 * radius), max: Point::new(setup.length * 1.12, 1.7 * radius) }
}

/// Says what lies under the pointer and what was clicked.
fn point_at(
    frame: &Frame<'_>,
    view: &mut CutView,
    canvas: &Canvas,
    painter: &egui::Painter,
    events: &mut Vec<CutEvent>,
) {
    let pos = canvas.response.hover_pos();
    let block = pos.and_then(|pos| view.paths.block_at(pos));
    events.extend(block.map(CutEvent::HoverBlock));
    if let Some(block) = block.filter(|_| canvas.response.clicked()) {
        events.push(CutEvent::SelectBlock(block));
    }
    let Some(pos) = pos.filter(|_| !canvas.response.dragged()) else { return };
    let text = draw::finding_at(frame, pos).or_else(|| block.map(|block| block_text(frame.scene.derived, block)));
    if let Some(lines) = text {
        tip(painter, frame.scene.palette, pos, &lines, &[]);
    }
}

/// Index of the stock state at a time of the programs.
pub(super) fn stock_index_at(derived: &SetupDerived, time_s: f64) -> usize {
    let moves = &derived.proof.moves;
    position_at(moves, time_s).map_or(0, |now| playback::stock_at(moves, now))
}

/// A block in words: its number and what it does.
fn block_text(derived: &SetupDerived, at: BlockRef) -> Vec<String> {
    let program = derived.programs.get(at.program);
    let generated = program.filter(|p| !p.edited).and_then(|p| derived.post.programs.iter().find(|g| g.name == p.name));
    let summary = at.block.checked_sub(1).and_then(|k| generated?.blocks.get(k)).map(|b| b.summary.clone());
    let name = program.map_or("", |p| p.name.as_str());
    std::iter::once(format!("{name} block {}", at.block)).chain(summary).collect()
}

#[cfg(test)]
mod tests;
