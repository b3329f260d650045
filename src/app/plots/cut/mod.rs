//! The cut plot: tool paths, the stock that is left and the tool at the slider, with playback.
//!
//! It takes data in and gives [`CutEvent`]s out.

mod playback;

use super::canvas::{self, CanvasView};
use super::palette::Palette;
use super::profile::draw;
use crate::machine::Machine;
use crate::regen::SetupDerived;
use crate::units::Unit;
use egui::{Shape, Stroke, Ui, Vec2};
pub use playback::{BlockRef, clock};

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
    /// Colours.
    pub palette: &'a Palette,
}

/// What the cut plot keeps from frame to frame.
#[derive(Debug)]
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
}

impl Default for CutView {
    fn default() -> Self {
        let canvas = CanvasView::default();
        Self { canvas, time_s: 0.0, playing: false, speed: 8, stock: true, leftover: false, chart: false }
    }
}

/// What a person asks of the cut plot.
#[derive(Debug, Clone, PartialEq)]
pub enum CutEvent {
    /// A path was clicked, or the slider came to another block.
    SelectBlock(BlockRef),
    /// The block under the pointer changed.
    HoverBlock(Option<BlockRef>),
    /// The slider was moved by hand to this time, s.
    Scrub(f64),
    /// The pointer is at this z and diameter of the document, or left the plot.
    Pointer(Option<(f64, f64)>),
}

/// Shows paths, stock and tool with the playback bar in the room that is left in `ui`.
pub fn cut_plot(ui: &mut Ui, view: &mut CutView, scene: &CutScene<'_>) -> Vec<CutEvent> {
    let bounds = draw::shown_bounds(&scene.derived.setup, false);
    let size = ui.available_size().max(Vec2::splat(40.0));
    let name = format!("Cut of {}", scene.derived.name);
    let canvas = canvas::canvas(ui, &mut view.canvas, size, bounds, &name, true);
    let painter = ui.painter_at(canvas.response.rect);
    for m in &scene.derived.proof.moves {
        let mut points = vec![m.path.start()];
        points.extend(m.path.polyline_points(canvas.screen.tolerance()));
        painter.add(Shape::line(draw::on_screen(&canvas.screen, &points), Stroke::new(1.0, scene.palette.quiet)));
    }
    canvas::overlay(ui, &view.canvas, &canvas, scene.palette);
    Vec::new()
}
