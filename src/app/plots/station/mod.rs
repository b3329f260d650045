//! The station plot: strip and rolls as they stand in the line, seen along it.
//!
//! It takes data in and gives [`StationEvent`]s out; it never edits the document.

mod clearance;
mod draw;

use super::canvas::{self, CanvasView};
use super::palette::Palette;
use crate::document::{RollKind, RollRef};
use crate::geometry::{Bounds, Point};
use crate::rollform::StationDesign;
use crate::rollform::roll::RollElement;
use crate::units::Unit;
use egui::Ui;

/// Room around strip and roll profiles in a fitted view, as a share of the width of the rolls.
const ROOM: f64 = 0.06;

/// What the station plot shows.
pub struct StationScene<'a> {
    /// The station.
    pub station: &'a StationDesign,
    /// Gap between the rolls in the drawing, mm: the top roll is drawn higher by it.
    pub drawn_gap_mm: f64,
    /// Unit of the document.
    pub unit: Unit,
    /// Roll that is shown elsewhere.
    pub roll: Option<RollRef>,
    /// Element of the section that is selected.
    pub element: Option<u32>,
    /// Colours.
    pub palette: &'a Palette,
}

/// What the station plot keeps from frame to frame.
#[derive(Debug, Default)]
pub struct StationView {
    /// What the canvas shows.
    pub canvas: CanvasView,
    /// Colour the rolls by the opening to the strip.
    pub clearance: bool,
    /// Fit the whole rolls, not only where they meet the strip.
    pub whole: bool,
}

/// What a person wants of the station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StationEvent {
    /// A piece of the strip was clicked.
    SelectElement(u32),
    /// A roll was clicked.
    SelectRoll(RollRef),
    /// Where the pointer is: across the line and height, mm.
    Pointer(Point),
}

/// Shows the plot in the room that is left in `ui`.
pub fn station_plot(ui: &mut Ui, view: &mut StationView, scene: &StationScene<'_>) -> Vec<StationEvent> {
    let size = ui.available_size();
    let bounds = bounds(scene, view.whole);
    let canvas = canvas::canvas(ui, &mut view.canvas, size, bounds, "Station", false);
    let painter = ui.painter_at(canvas.response.rect);
    let drawn = draw::Drawn { scene, screen: &canvas.screen, clearance: view.clearance };
    drawn.all(&painter);
    canvas::overlay(ui, &view.canvas, &canvas, scene.palette);
    let mut events: Vec<StationEvent> = canvas.pointer.map(StationEvent::Pointer).into_iter().collect();
    if let Some(pos) = canvas.response.interact_pointer_pos().filter(|_| canvas.response.clicked()) {
        events.extend(drawn.at(pos));
    }
    events
}

/// What a fitted view shows.
fn bounds(scene: &StationScene<'_>, whole: bool) -> Bounds {
    let rolls = scene.station.rolls.iter();
    let near = rolls.flat_map(|roll| {
        let faces = usize::from(!whole);
        let inner = roll.elements.len().saturating_sub(faces).max(faces);
        let elements: &[RollElement] = roll.elements.get(faces..inner).unwrap_or_default();
        let lift = lift(roll.roll.kind, scene.drawn_gap_mm);
        elements.iter().map(move |e| (roll.frame.to_strip(&e.segment).bounds(), lift))
    });
    let raised = near
        .map(|(b, lift)| Bounds { min: Point::new(b.min.z, b.min.r + lift), max: Point::new(b.max.z, b.max.r + lift) });
    let strip = scene.station.strip.outline().bounds();
    let all = raised
        .chain(strip)
        .reduce(Bounds::union)
        .unwrap_or(Bounds { min: Point::new(-1.0, -1.0), max: Point::new(1.0, 1.0) });
    let room = ROOM * (all.max.z - all.min.z);
    Bounds { min: Point::new(all.min.z - room, all.min.r - room), max: Point::new(all.max.z + room, all.max.r + room) }
}

/// By how much a roll is drawn higher than it stands.
fn lift(kind: RollKind, drawn_gap_mm: f64) -> f64 {
    if kind == RollKind::Top { drawn_gap_mm } else { 0.0 }
}
