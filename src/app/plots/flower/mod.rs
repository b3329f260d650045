//! The flower: the strip at all stages, laid over one another or side by side, with one of them to take hold of.
//!
//! It takes data in and gives [`FlowerEvent`]s out; it never edits the document.

mod drag;
mod draw;

use super::canvas::{self, CanvasView};
use super::palette::Palette;
use super::profile::Phase;
use super::tip::tip;
use crate::geometry::{Bounds, Point, Vector};
use crate::rollform::bends::Stage;
use crate::rollform::flower::Flower;
use crate::rollform::strip::Strip;
use drag::Drag;
use egui::{CursorIcon, PointerButton, Ui, Vec2};

/// Gap between shapes that stand side by side, as a part of the widest one.
const GAP: f64 = 0.12;
/// A piece nearer to the pointer than this is under it, points.
const NEAR: f32 = 7.0;

/// What the flower plot shows.
pub struct FlowerScene<'a> {
    /// The strip at all stages, mm.
    pub flower: &'a Flower,
    /// The strip that stands out, mm; between two stages while it is played.
    pub shown: &'a Strip,
    /// The stage of `shown`, if it is at one.
    pub stage: Option<Stage>,
    /// The strip after release, if it is to be drawn.
    pub released: Option<&'a Strip>,
    /// Element that is selected.
    pub selected: Option<u32>,
    /// What an element is called.
    pub name_of: &'a dyn Fn(u32) -> String,
    /// Angle of a bend at the stage shown, degrees.
    pub angle_of: &'a dyn Fn(u32) -> Option<f64>,
    /// Shapes stand side by side.
    pub side_by_side: bool,
    /// Colours.
    pub palette: &'a Palette,
}

/// What the flower plot keeps from frame to frame.
#[derive(Debug, Default)]
pub struct FlowerPlotView {
    /// What the canvas shows.
    pub canvas: CanvasView,
    drag: Option<Drag>,
}

/// What a person wants of the flower.
#[derive(Debug, Clone, PartialEq)]
pub enum FlowerEvent {
    /// An element was clicked.
    Select(u32),
    /// A stage was clicked where they stand side by side.
    Pick(Stage),
    /// A leg was turned about its bend.
    Bend {
        /// The bend.
        element: u32,
        /// Its new angle, degrees.
        angle_deg: f64,
        /// Where the gesture is.
        phase: Phase,
    },
}

/// Shows the flower in the room that is left in `ui`, less `below` points.
pub fn flower_plot(ui: &mut Ui, view: &mut FlowerPlotView, scene: &FlowerScene<'_>, below: f32) -> Vec<FlowerEvent> {
    let size = (ui.available_size() - Vec2::new(0.0, below)).max(Vec2::splat(40.0));
    let places = places(scene);
    let bounds = bounds(scene, &places);
    let before = view.canvas;
    let canvas = canvas::canvas(ui, &mut view.canvas, size, bounds, "Flower", false);
    let painter = ui.painter_at(canvas.response.rect);
    draw::shapes(&painter, &canvas.screen, scene, &places);
    let mut events = Vec::new();
    if scene.side_by_side {
        pick(&canvas, scene, &places, &mut events);
    } else {
        hold(ui, view, &canvas, scene, &mut events);
        // What turns a leg does not move the picture.
        if view.drag.is_some() {
            view.canvas = before;
        }
    }
    canvas::overlay(ui, &view.canvas, &canvas, scene.palette);
    events
}

/// Where every shape stands.
fn places(scene: &FlowerScene<'_>) -> Vec<Vector> {
    let shapes = &scene.flower.shapes;
    if !scene.side_by_side {
        return vec![Vector::zeros(); shapes.len()];
    }
    let extents: Vec<Option<Bounds>> = shapes.iter().map(|shape| shape.strip.mean().bounds()).collect();
    let widest = extents.iter().flatten().map(|b| b.max.z - b.min.z).fold(0.0, f64::max);
    let mut at = 0.0;
    extents
        .iter()
        .map(|extent| {
            let Some(extent) = extent else { return Vector::zeros() };
            let place = Vector::new(at - extent.min.z, 0.0);
            at += extent.max.z - extent.min.z + widest * GAP;
            place
        })
        .collect()
}

fn bounds(scene: &FlowerScene<'_>, places: &[Vector]) -> Bounds {
    let placed = scene.flower.shapes.iter().zip(places).filter_map(|(shape, place)| {
        let bounds = shape.strip.mean().bounds()?;
        Some(Bounds { min: bounds.min + *place, max: bounds.max + *place })
    });
    let around = placed.reduce(Bounds::union);
    around.unwrap_or(Bounds { min: Point::new(-50.0, -25.0), max: Point::new(50.0, 25.0) })
}

/// Side by side, a click picks the stage.
fn pick(canvas: &canvas::Canvas, scene: &FlowerScene<'_>, places: &[Vector], events: &mut Vec<FlowerEvent>) {
    let Some(point) = canvas.pointer.filter(|_| canvas.response.clicked()) else { return };
    let nearest = scene.flower.shapes.iter().zip(places).min_by(|(a, pa), (b, pb)| {
        let distance = |strip: &Strip, place: &Vector| strip.mean().distance_to(point - *place);
        distance(&a.strip, pa).total_cmp(&distance(&b.strip, pb))
    });
    events.extend(nearest.map(|(shape, _)| FlowerEvent::Pick(shape.stage)));
}

/// Laid over one another, the shown strip can be taken hold of: a leg turns about the bend that holds it.
fn hold(
    ui: &Ui,
    view: &mut FlowerPlotView,
    canvas: &canvas::Canvas,
    scene: &FlowerScene<'_>,
    events: &mut Vec<FlowerEvent>,
) {
    let over = canvas.pointer.and_then(|p| drag::piece_at(scene.shown, p, f64::from(NEAR) / canvas.screen.scale()));
    let can_bend = matches!(scene.stage, Some(Stage::Station(_)));
    if canvas.response.drag_started_by(PointerButton::Primary) && can_bend {
        let press = ui.input(|i| i.pointer.press_origin()).map(|pos| canvas.screen.point(pos));
        let held =
            press.and_then(|p| Some((p, drag::piece_at(scene.shown, p, f64::from(NEAR) / canvas.screen.scale())?)));
        view.drag = held.and_then(|(p, piece)| Drag::begin(scene, piece, p));
    }
    if let Some(drag) = &mut view.drag {
        let free = ui.input(|i| i.modifiers.alt);
        if let Some(point) = canvas.pointer.filter(|_| canvas.response.dragged()) {
            events.extend(drag.to(point, free));
        }
        ui.set_cursor_icon(CursorIcon::Grabbing);
        if canvas.response.drag_stopped() {
            events.extend(drag.end());
            view.drag = None;
        }
        return;
    }
    let Some((index, piece)) = over.and_then(|index| Some((index, scene.shown.pieces.get(index)?))) else { return };
    if canvas.response.clicked() {
        events.push(FlowerEvent::Select(piece.element));
    }
    let Some(pos) = canvas.response.hover_pos() else { return };
    if can_bend && canvas.pointer.is_some_and(|p| Drag::begin(scene, index, p).is_some()) {
        ui.set_cursor_icon(CursorIcon::Grab);
    }
    let mut lines = vec![(scene.name_of)(piece.element)];
    lines.extend((scene.angle_of)(piece.element).map(|angle| format!("{angle:.1}°")));
    tip(&ui.painter_at(canvas.response.rect), scene.palette, pos, &lines, &[]);
}
