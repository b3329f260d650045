//! The plot of a shell: former, wall, blank and roller path, with grips that shape the former.
//!
//! It takes data in and gives [`ShellEvent`]s out; it never edits the document.

mod draw;

use super::canvas::{self, CanvasView, Rulers, arrow};
use super::coordinates::Coordinates;
use super::palette::Palette;
use super::profile::Phase;
use super::tip::tip;
use crate::geometry::{Bounds, Point};
use crate::machine::Machine;
use crate::regen::ShellDerived;
use crate::spinning::reshape::{Grip, grips};
use crate::units::Unit;
use draw::Regions;
use egui::{CursorIcon, Key, PointerButton, Rect, Sense, Stroke, Ui, Vec2};

/// Size of the area that takes hold of a grip, points.
const GRIP: f32 = 16.0;

/// What the plot shows.
pub struct ShellScene<'a> {
    /// Everything that follows from the shell.
    pub made: &'a ShellDerived,
    /// Machine whose chuck and tailstock are drawn.
    pub machine: Option<&'a Machine>,
    /// Unit of the document.
    pub unit: Unit,
    /// Where the centre of the roller's nose is, if it is not at its approach.
    pub roller: Option<Point>,
    /// Colours.
    pub palette: &'a Palette,
}

/// What the plot keeps from frame to frame.
#[derive(Debug, Default)]
pub struct ShellPlot {
    /// What the canvas shows.
    pub canvas: CanvasView,
    /// Leaves out the lower half.
    pub half: bool,
    /// Leaves out the path of the roller.
    pub without_path: bool,
    dragged: Option<(Grip, bool)>,
    regions: Regions,
}

/// What a person wants of the shell.
#[derive(Debug, Clone, PartialEq)]
pub enum ShellEvent {
    /// Position of the pointer: z and diameter in the document's unit.
    Pointer(f64, f64),
    /// A grip was brought to a place in mm.
    Drag {
        /// Which.
        grip: Grip,
        /// Where to.
        to: Point,
        /// Without rounding.
        free: bool,
        /// Where the gesture is.
        phase: Phase,
    },
}

/// Shows the plot in what room there is.
pub fn shell_plot(ui: &mut Ui, view: &mut ShellPlot, scene: &ShellScene<'_>) -> Vec<ShellEvent> {
    let size = ui.available_size().max(Vec2::splat(40.0));
    let bounds = shown_bounds(scene, view.half);
    let canvas = canvas::canvas(ui, &mut view.canvas, size, bounds, "Former and roller plot", false);
    let coordinates = Coordinates { unit: scene.unit, length_mm: scene.made.shape.tip().z, turned_round: false };
    let painter = ui.painter_at(canvas.response.rect);
    Rulers { coordinates, grid: true, mirrored: !view.half }.draw(&painter, &canvas.screen, scene.palette);
    let free = Rulers::free(canvas.response.rect);
    let inner = ui.painter_at(free);
    view.regions.update(scene.made);
    draw::scenery(&inner, &canvas.screen, view, scene);
    let mut events = Vec::new();
    if let Some(p) = canvas.pointer {
        events.push(ShellEvent::Pointer(coordinates.document_z(p.z), coordinates.diameter(p.r)));
    }
    grip_handles(ui, view, scene, &canvas.screen, free, &mut events);
    canvas::overlay(ui, &view.canvas, &canvas, scene.palette);
    events
}

/// Former, follower and the roller at its approach.
fn shown_bounds(scene: &ShellScene<'_>, half: bool) -> Bounds {
    let shape = &scene.made.shape;
    let roller = &scene.made.shell.roller;
    let top = shape.blank_radius.max(shape.base().r) + 1.6 * roller.nose_radius;
    let right =
        shape.tip().z + shape.thickness + 3.2 * roller.nose_radius + 0.4 * scene.made.shell.blank.follower_length;
    let bottom = if half { -0.1 * top } else { -shape.blank_radius.max(shape.base().r) * 1.06 };
    Bounds { min: Point::new(-0.12 * right, bottom), max: Point::new(right, top) }
}

fn grip_handles(
    ui: &mut Ui,
    view: &mut ShellPlot,
    scene: &ShellScene<'_>,
    screen: &canvas::Screen,
    free: Rect,
    events: &mut Vec<ShellEvent>,
) {
    let shape = &scene.made.shape;
    for (grip, at) in grips(&scene.made.shell, shape.tip(), shape.base()) {
        let pos = screen.pos(at);
        if !free.contains(pos) {
            continue;
        }
        let id = ui.scope_id().with(("shell grip", grip));
        let response = ui.interact(Rect::from_center_size(pos, Vec2::splat(GRIP)), id, Sense::click_and_drag());
        let name = grip_name(grip);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name.clone()));
        if response.drag_started_by(PointerButton::Primary) {
            view.dragged = Some((grip, false));
        }
        let taken = view.dragged.filter(|(dragged, _)| *dragged == grip);
        if let (Some((_, began)), Some(pointer)) = (taken, ui.input(|i| i.pointer.latest_pos())) {
            let stopped = response.drag_stopped();
            let phase = match (stopped, began) {
                (true, _) => Phase::End,
                (false, false) => Phase::Begin,
                (false, true) => Phase::Move,
            };
            let alt = ui.input(|i| i.modifiers.alt);
            events.push(ShellEvent::Drag { grip, to: screen.point(pointer), free: alt, phase });
            view.dragged = (!stopped).then_some((grip, true));
        }
        if response.has_focus() {
            nudge(ui, grip, at, events);
        }
        let strong = response.hovered() || response.has_focus() || taken.is_some();
        if strong {
            ui.set_cursor_icon(CursorIcon::Grab);
            let lines = [name, said(scene, grip)];
            tip(&ui.painter_at(free), scene.palette, pos, &lines, &[]);
        }
        let radius = if strong { 5.0 } else { 3.6 };
        let painter = ui.painter_at(free);
        painter.circle(pos, radius, scene.palette.ground, Stroke::new(1.6, scene.palette.accent));
    }
}

/// Arrow keys move a grip by half a millimetre.
fn nudge(ui: &Ui, grip: Grip, at: Point, events: &mut Vec<ShellEvent>) {
    for key in [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown] {
        if ui.input(|i| i.key_pressed(key))
            && let Some(way) = arrow(key)
        {
            let to = Point::new(at.z + f64::from(way.x) * 0.5, at.r - f64::from(way.y) * 0.5);
            events.push(ShellEvent::Drag { grip, to, free: false, phase: Phase::Single });
        }
    }
}

fn grip_name(grip: Grip) -> String {
    match grip {
        Grip::Tip => "Tip of the former".to_owned(),
        Grip::Base => "Base of the former".to_owned(),
        Grip::Row(row, false) => format!("Start of row {}", row + 1),
        Grip::Row(row, true) => format!("End of row {}", row + 1),
    }
}

/// What a drag of the grip changes.
fn said(scene: &ShellScene<'_>, grip: Grip) -> String {
    let shape = &scene.made.shape;
    let at = match grip {
        Grip::Tip => shape.tip(),
        Grip::Base | Grip::Row(..) => shape.base(),
    };
    let angle = shape.stations.last().map_or(0.0, |s| s.half_angle.to_degrees());
    let diameter = 2.0 * at.r / scene.unit.in_mm();
    let decimals = scene.unit.decimals().saturating_sub(1);
    match grip {
        Grip::Base => format!("⌀ {diameter:.decimals$}, wall at {angle:.1}°"),
        _ => format!("⌀ {diameter:.decimals$}"),
    }
}
