//! The profile plot: the part with its stock and chuck, and handles that shape it.
//!
//! It takes data in and gives [`ProfileEvent`]s out; it never edits the document.

pub(super) mod draw;
mod nodes;

use super::canvas::{self, CanvasView, Rulers};
use super::coordinates::Coordinates;
use super::palette::Palette;
use crate::document::TurnedPart;

use crate::machine::Machine;
use crate::regen::SetupDerived;
use crate::units::Unit;
use egui::{Ui, Vec2};
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
    /// Row under the pointer, here or elsewhere.
    pub hovered: Option<u32>,
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
}

impl Default for ProfileView {
    fn default() -> Self {
        Self { canvas: CanvasView::default(), full_section: true, dimensions: true }
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
    /// The row under the pointer changed.
    HoverSection(Option<u32>),
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
    let bounds = draw::bounds(scene, view.full_section);
    let size = ui.available_size().max(Vec2::splat(40.0));
    let name = format!("Profile of {}", scene.derived.name);
    let canvas = canvas::canvas(ui, &mut view.canvas, size, bounds, &name, false);
    let painter = ui.painter_at(canvas.response.rect);
    let rulers = Rulers { coordinates, grid: true, mirrored: view.full_section };
    rulers.draw(&painter, &canvas.screen, scene.palette);
    let free = painter.with_clip_rect(Rulers::free(canvas.response.rect));
    draw::scenery(&free, &canvas.screen, scene, view.full_section);
    canvas::overlay(ui, &view.canvas, &canvas, scene.palette);
    let pointer = canvas.pointer.map(|p| (coordinates.document_z(p.z), coordinates.diameter(p.r)));
    vec![ProfileEvent::Pointer(pointer)]
}
