//! The profile plot: the part with its stock and chuck, and handles that shape it.
//!
//! It takes data in and gives [`ProfileEvent`]s out; it never edits the document.

mod dimensions;
mod drag;
pub(super) mod draw;
mod frame;
mod handles;
mod hatch;
mod nodes;

use super::canvas::{self, CanvasView, Rulers};
use super::coordinates::Coordinates;
use super::palette::Palette;
use super::tip::tip;
use crate::document::TurnedPart;

use crate::machine::Machine;
use crate::regen::SetupDerived;
use crate::units::Unit;
use dimensions::Typing;
use drag::Drag;
use egui::{Ui, Vec2};
use frame::Frame;
pub use nodes::{End, NodeMove, SectionEnd};

/// What the profile plot shows.
pub struct ProfileScene<'a> {
    /// Everything that follows for the set-up shown.
    pub derived: &'a SetupDerived,
    /// The part as edited, in the document's unit.
    pub part: &'a TurnedPart,
    /// Unit of the document.
    pub unit: Unit,
    /// Machine whose chuck is drawn and whose tools are named.
    pub machine: Option<&'a Machine>,
    /// Row that is selected.
    pub selected: Option<u32>,
    /// Rows that belong to what the pointer is on, here or elsewhere.
    pub lit: &'a [u32],
    /// Colours.
    pub palette: &'a Palette,
}

/// What the profile plot keeps from frame to frame.
#[derive(Debug)]
pub struct ProfileView {
    /// What the canvas shows.
    pub canvas: CanvasView,
    /// Draw the mirrored lower half too.
    pub full_section: bool,
    /// Draw dimensions.
    pub dimensions: bool,
    drag: Option<Drag>,
    typing: Option<Typing>,
    stock: draw::Stock,
    /// The row under the pointer.
    hovered: Option<u32>,
}

impl ProfileView {
    /// True while a handle is dragged.
    #[must_use]
    pub const fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }
}

impl Default for ProfileView {
    fn default() -> Self {
        let canvas = CanvasView::default();
        let stock = draw::Stock::default();
        Self { canvas, full_section: true, dimensions: true, drag: None, typing: None, stock, hovered: None }
    }
}

/// Where a gesture of the hand is. All events from `Begin` to `End` are one step of undo.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The first change of a drag.
    Begin,
    /// One more change of the same drag.
    Move,
    /// The drag is over; the value is the one of the last change.
    End,
    /// A whole gesture by itself, as one press of a key.
    Single,
}

/// What a person wants of the part. Positions, diameters and radii are in the document's unit.
#[derive(Debug, Clone, PartialEq)]
pub enum ProfileEvent {
    /// The pointer is on this row; said in every frame, but not during a drag.
    HoverSection(u32),
    /// A row was clicked.
    SelectSection(u32),
    /// A node was moved; [`NodeMove::apply`] writes it into a part.
    DragNode {
        /// The ends that move and their new position.
        node: NodeMove,
        /// Where the gesture is.
        phase: Phase,
    },
    /// The middle of an arc was moved.
    DragRadius {
        /// Row of the arc.
        section: u32,
        /// New radius.
        radius: f64,
        /// Where the gesture is.
        phase: Phase,
    },
    /// A dimension was typed; the text may be an expression.
    EditDimension {
        /// What it measures.
        dimension: Dimension,
        /// The text as typed.
        text: String,
    },
    /// The pointer is at this z and diameter, or left the plot.
    Pointer(Option<(f64, f64)>),
}

/// What a dimension of the profile plot measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// Length of the part.
    PartLength,
    /// Diameter of the bar.
    BarDiameter,
    /// Distance from `z1` to `z2` of a row.
    SectionLength {
        /// Row id.
        section: u32,
    },
    /// Diameter at one end of a row.
    Diameter(SectionEnd),
    /// Radius of an arc.
    Radius {
        /// Row id.
        section: u32,
    },
}

/// Shows the profile in the room that is left in `ui`.
pub fn profile_plot(ui: &mut Ui, view: &mut ProfileView, scene: &ProfileScene<'_>) -> Vec<ProfileEvent> {
    let coordinates = Coordinates::of(&scene.derived.setup, scene.unit);
    let bounds = draw::shown_bounds(&scene.derived.setup, view.full_section);
    let size = ui.available_size().max(Vec2::splat(40.0));
    let name = format!("Profile of {}", scene.derived.name);
    let canvas = canvas::canvas(ui, &mut view.canvas, size, bounds, &name, false);
    let painter = ui.painter_at(canvas.response.rect);
    Rulers { coordinates, grid: true, mirrored: view.full_section }.draw(&painter, &canvas.screen, scene.palette);
    let frame = Frame::new(scene, canvas.screen, coordinates, &canvas.response);
    draw::scenery(&painter.with_clip_rect(frame.free), &frame, view);
    let mut events = Vec::new();
    let over_empty = canvas.response.hovered();
    point_at(&frame, view, &canvas, over_empty, &mut events);
    if view.dimensions {
        dimensions::dimensions(ui, &frame, view, &mut events);
    }
    handles::handles(ui, &frame, view, &mut events);
    canvas::overlay(ui, &view.canvas, &canvas, scene.palette);
    let pos = canvas.response.hover_pos().filter(|_| over_empty);
    if let Some((pos, lines)) = pos.and_then(|pos| Some((pos, hatch::hover_text(&frame, pos)?))) {
        tip(&painter, scene.palette, pos, &lines, &[]);
    }
    events
}

/// Says where the pointer is, what lies under it and what was clicked.
fn point_at(
    frame: &Frame<'_>,
    view: &mut ProfileView,
    canvas: &canvas::Canvas,
    over_empty: bool,
    events: &mut Vec<ProfileEvent>,
) {
    let c = frame.coordinates;
    events.push(ProfileEvent::Pointer(canvas.pointer.map(|p| (c.document_z(p.z), c.diameter(p.r)))));
    let pos = canvas.response.hover_pos().filter(|_| over_empty && view.drag.is_none());
    let hovered = pos.and_then(|pos| frame.section_at(pos));
    // Over a handle the section stays as it was, so that an arc's middle does not vanish under the pointer.
    let over_handle = canvas.pointer.is_some() && !over_empty;
    if !over_handle {
        view.hovered = hovered;
    }
    events.extend(view.hovered.filter(|_| view.drag.is_none()).map(ProfileEvent::HoverSection));
    if let Some(section) = hovered.filter(|_| canvas.response.clicked()) {
        events.push(ProfileEvent::SelectSection(section));
    }
}

#[cfg(test)]
mod tests;
