//! Handles on the profile: nodes and the middles of arcs, for mouse and keyboard.

use super::drag::{Drag, Guide, dragged, radius_through};
use super::nodes::{NodeMove, SectionEnd, nodes};
use super::{Frame, Phase, ProfileEvent, ProfileView};
use crate::app::plots::canvas::arrow;
use crate::app::plots::coordinates::snapped;
use crate::app::plots::tip::tip;
use crate::geometry::{Point, Segment};
use crate::part::{Section, SectionKind};
use egui::{CursorIcon, Event, EventFilter, PointerButton, Pos2, Rect, Response, Sense, Stroke, Ui, Vec2};
use std::collections::HashSet;

/// Size of the area that takes hold of a handle, points.
const GRIP: f32 = 15.0;
/// Radius of a node, points.
const NODE: f32 = 3.2;
/// Radius of a node that is selected or under the pointer, points.
const NODE_STRONG: f32 = 4.8;
/// Side of the square on the screen in which only one node is shown, points: nearer ones cannot be taken hold of singly.
const APART: f32 = 4.0;
/// One press of an arrow key with Alt moves by this part of a grid step.
const FINE: f64 = 0.1;

/// Lays out all handles, moves what is dragged and says so in `events`.
pub(super) fn handles(ui: &mut Ui, frame: &Frame<'_>, view: &mut ProfileView, events: &mut Vec<ProfileEvent>) {
    let mut tips = None;
    for (node, pos) in reachable(frame, view) {
        tips = node_handle(ui, frame, view, &node, pos, events).or(tips);
    }
    for section in lit_rows(frame) {
        tips = radius_handle(ui, frame, view, section, events).or(tips);
    }
    follow_drag(ui, frame, view, events);
    if let Some(Tip { at, lines, of }) = tips {
        let keep_free: Vec<_> = of.iter().flat_map(|&id| frame.segments_of(id)).map(|s| frame.polyline(s)).collect();
        tip(&ui.painter_at(frame.free), frame.scene.palette, at, &lines, &keep_free);
    }
}

/// The rows of both tables that are selected or under the pointer.
fn lit_rows<'a>(frame: &'a Frame<'_>) -> impl Iterator<Item = &'a Section> {
    let part = frame.scene.part;
    part.sections.iter().chain(&part.bore).filter(|s| frame.is_lit(s.id))
}

/// What is said about a handle.
struct Tip {
    at: Pos2,
    lines: [String; 2],
    /// Sections that a drag of it moves: the tip leaves them free.
    of: Vec<u32>,
}

/// The nodes that a hand can tell apart on the screen: of those within one small square the first, and always those of
/// the selected row and the one that is dragged. So there are never more than the screen has room for.
#[allow(clippy::cast_possible_truncation, reason = "positions on the screen are small")]
fn reachable(frame: &Frame<'_>, view: &ProfileView) -> Vec<(NodeMove, Pos2)> {
    let mut taken = HashSet::new();
    let placed = nodes(frame.scene.part).into_iter().map(|node| {
        let pos = frame.screen.pos(frame.coordinates.point(node.z, node.diameter));
        (node, pos)
    });
    let seen = placed.filter(|(_, pos)| frame.free.contains(*pos));
    seen.filter(|(node, pos)| {
        let free = taken.insert(((pos.x / APART).floor() as i32, (pos.y / APART).floor() as i32));
        free || is_dragged(view, node) || node.ends.iter().any(|end| frame.scene.selected == Some(end.section))
    })
    .collect()
}

fn is_dragged(view: &ProfileView, node: &NodeMove) -> bool {
    matches!(&view.drag, Some(Drag::Node { from, .. }) if from.ends == node.ends)
}

fn node_handle(
    ui: &mut Ui,
    frame: &Frame<'_>,
    view: &mut ProfileView,
    node: &NodeMove,
    pos: Pos2,
    events: &mut Vec<ProfileEvent>,
) -> Option<Tip> {
    let first = node.ends.first()?;
    let of = node_section(frame, node)?;
    let words = node_words(frame, node, of);
    let response = grip(ui, frame.id.with(first), pos, || format!("Node {}, {}", words[0], words[1]));
    let dragged_now = is_dragged(view, node);
    if response.clicked() {
        response.request_focus();
        events.push(ProfileEvent::SelectSection(of));
    }
    if response.drag_started_by(PointerButton::Primary) {
        let pressed = ui.input(|i| i.pointer.press_origin()).unwrap_or(pos);
        view.drag = Some(Drag::Node { from: node.clone(), grip: frame.document_at(pressed), last: None });
    }
    nudge_node(ui, frame, &response, node, events);
    let selected = node.ends.iter().any(|end| frame.scene.selected == Some(end.section));
    let strong = response.hovered() || response.has_focus() || dragged_now;
    draw_node(ui, frame, pos, selected, strong);
    strong.then(|| Tip {
        at: pos,
        lines: [words[0].clone(), format!("{} · drag, or type", words[1])],
        of: node.ends.iter().chain(&node.follow_z).map(|end| end.section).collect(),
    })
}

/// The section that a click on a node selects: the next one in turn if the node is shared and its section selected.
fn node_section(frame: &Frame<'_>, node: &NodeMove) -> Option<u32> {
    let selected = node.ends.iter().find(|end| frame.scene.selected == Some(end.section));
    selected.or(node.ends.last()).map(|end| end.section)
}

/// Position and section of a node in words.
fn node_words(frame: &Frame<'_>, node: &NodeMove, section: u32) -> [String; 2] {
    let c = frame.coordinates;
    let place = format!("z {}  ⌀ {}", c.text(node.z), c.text(node.diameter));
    [place, frame.section_name(section)]
}

/// A widget that takes hold of a handle.
fn grip(ui: &Ui, id: egui::Id, pos: Pos2, name: impl Fn() -> String) -> Response {
    let response = ui.interact(Rect::from_center_size(pos, Vec2::splat(GRIP)), id, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name()));
    if response.hovered() || response.dragged() {
        ui.set_cursor_icon(if response.dragged() { CursorIcon::Grabbing } else { CursorIcon::Grab });
    }
    response
}

fn draw_node(ui: &Ui, frame: &Frame<'_>, pos: Pos2, selected: bool, strong: bool) {
    let palette = frame.scene.palette;
    let painter = ui.painter_at(frame.free);
    let fill = if strong { palette.accent } else { palette.ground };
    let radius = if strong || selected { NODE_STRONG } else { NODE };
    painter.circle(pos, if strong { radius } else { radius.min(NODE + 0.6) }, fill, Stroke::new(1.5, palette.accent));
}

fn nudge_node(ui: &Ui, frame: &Frame<'_>, response: &Response, node: &NodeMove, events: &mut Vec<ProfileEvent>) {
    let way = nudges(ui, response);
    if way == Vec2::ZERO {
        return;
    }
    let step = frame.nudge_step(ui);
    let sense = if frame.coordinates.turned_round { -1.0 } else { 1.0 };
    let mut node = node.clone();
    node.z = snapped(node.z + f64::from(way.x) * sense * step, Some(step));
    node.diameter = snapped((node.diameter - f64::from(way.y) * step).max(0.0), Some(step));
    events.push(ProfileEvent::DragNode { node, phase: Phase::Single });
}

/// Presses of arrow keys while a handle has the focus, added up; y is downwards.
fn nudges(ui: &Ui, response: &Response) -> Vec2 {
    if !response.has_focus() {
        return Vec2::ZERO;
    }
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|m| m.set_focus_lock_filter(response.id, filter));
    ui.input(|i| {
        let keys = i.events.iter().filter_map(|event| match event {
            Event::Key { key, pressed: true, .. } => arrow(*key),
            _ => None,
        });
        keys.fold(Vec2::ZERO, |sum, way| sum + way)
    })
}

fn radius_handle(
    ui: &mut Ui,
    frame: &Frame<'_>,
    view: &mut ProfileView,
    section: &Section,
    events: &mut Vec<ProfileEvent>,
) -> Option<Tip> {
    let radius = arc_radius(section)?;
    let pos = frame.screen.pos(arc_middle(frame, section.id)?);
    if !frame.free.contains(pos) {
        return None;
    }
    let name = frame.section_name(section.id);
    let text = format!("R {}", frame.coordinates.text(radius));
    let response = grip(ui, frame.id.with(("radius", section.id)), pos, || format!("Radius {text} of {name}"));
    if response.clicked() {
        response.request_focus();
        events.push(ProfileEvent::SelectSection(section.id));
    }
    if response.drag_started_by(PointerButton::Primary) {
        view.drag = Some(Drag::Radius { section: section.id, last: None });
    }
    let up = -f64::from(nudges(ui, &response).y);
    if up != 0.0 {
        let step = frame.nudge_step(ui);
        let radius = snapped(radius + up * step, Some(step)).max(step);
        events.push(ProfileEvent::DragRadius { section: section.id, radius, phase: Phase::Single });
    }
    let dragged_now = matches!(view.drag, Some(Drag::Radius { section: of, .. }) if of == section.id);
    let strong = response.hovered() || response.has_focus() || dragged_now;
    draw_diamond(ui, frame, pos, strong);
    strong.then(|| Tip { at: pos, lines: [text, format!("{name} · drag, or type")], of: vec![section.id] })
}

fn draw_diamond(ui: &Ui, frame: &Frame<'_>, pos: Pos2, strong: bool) {
    let palette = frame.scene.palette;
    let size = if strong { 5.2 } else { 4.2 };
    let corners = [(0.0, -size), (size, 0.0), (0.0, size), (-size, 0.0)].map(|(x, y)| pos + Vec2::new(x, y));
    let fill = if strong { palette.accent } else { palette.ground };
    let shape = egui::Shape::convex_polygon(corners.to_vec(), fill, Stroke::new(1.5, palette.accent));
    ui.painter_at(frame.free).add(shape);
}

/// Radius of a row that is an arc, in the document's unit.
pub(super) const fn arc_radius(section: &Section) -> Option<f64> {
    match section.kind {
        SectionKind::Convex { radius } | SectionKind::Concave { radius } => Some(radius),
        _ => None,
    }
}

/// The middle of the longest arc that a row has on the profile.
pub(super) fn arc_middle(frame: &Frame<'_>, section: u32) -> Option<Point> {
    let arcs = frame.segments_of(section).filter(|s| s.radius().is_some());
    arcs.max_by(|a, b| a.length().total_cmp(&b.length())).map(|arc: &Segment| arc.point_at(0.5))
}

fn follow_drag(ui: &Ui, frame: &Frame<'_>, view: &mut ProfileView, events: &mut Vec<ProfileEvent>) {
    let Some(drag) = &mut view.drag else { return };
    let (pos, down, modifiers) = ui.input(|i| (i.pointer.latest_pos(), i.pointer.primary_down(), i.modifiers));
    let step = (!modifiers.alt).then(|| frame.snap_step());
    let guide = Guide { one_axis: modifiers.shift, step };
    if let Some(pos) = pos.filter(|_| down) {
        events.extend(drag_event(frame, drag, pos, guide));
    }
    if !down {
        events.extend(end_event(drag));
        view.drag = None;
    }
}

/// The change that the pointer at `pos` makes, if it is one.
fn drag_event(frame: &Frame<'_>, drag: &mut Drag, pos: Pos2, guide: Guide) -> Option<ProfileEvent> {
    let phase = |begun: bool| if begun { Phase::Move } else { Phase::Begin };
    match drag {
        Drag::Node { from, grip, last } => {
            let place = dragged(from, *grip, frame.document_at(pos), guide);
            let before = last.unwrap_or((from.z, from.diameter));
            (place != before).then(|| {
                let phase = phase(last.replace(place).is_some());
                ProfileEvent::DragNode { node: NodeMove { z: place.0, diameter: place.1, ..from.clone() }, phase }
            })
        }
        Drag::Radius { section, last } => {
            let radius = dragged_radius(frame, *section, pos, guide)?;
            (*last != Some(radius)).then(|| {
                let phase = phase(last.replace(radius).is_some());
                ProfileEvent::DragRadius { section: *section, radius, phase }
            })
        }
    }
}

fn dragged_radius(frame: &Frame<'_>, section: u32, pos: Pos2, guide: Guide) -> Option<f64> {
    let row = frame.section(section)?;
    let c = frame.coordinates;
    let (mut start, mut end) = (c.point(row.z1, row.d1), c.point(row.z2, row.d2));
    if start.z > end.z {
        std::mem::swap(&mut start, &mut end);
    }
    let bulges_out = matches!(row.kind, SectionKind::Convex { .. }) != frame.is_of_bore(section);
    let radius = radius_through(start, end, frame.screen.point(pos), bulges_out)? / c.unit.in_mm();
    Some(match guide.step {
        // Never below the half circle, which has no arc smaller.
        Some(step) => snapped(radius, Some(step)).max((radius / step).ceil().min(1.0) * step),
        None => radius,
    })
}

fn end_event(drag: &Drag) -> Option<ProfileEvent> {
    match drag {
        Drag::Node { from, last, .. } => last.map(|(z, diameter)| ProfileEvent::DragNode {
            node: NodeMove { z, diameter, ..from.clone() },
            phase: Phase::End,
        }),
        Drag::Radius { section, last } => {
            last.map(|radius| ProfileEvent::DragRadius { section: *section, radius, phase: Phase::End })
        }
    }
}

impl Frame<'_> {
    /// Step of an arrow key: the grid, a tenth of it with Alt.
    fn nudge_step(&self, ui: &Ui) -> f64 {
        if ui.input(|i| i.modifiers.alt) { self.snap_step() * FINE } else { self.snap_step() }
    }
}

/// An end of a section as it is called in a sentence.
pub(super) fn end_name(frame: &Frame<'_>, end: SectionEnd) -> String {
    let which = match end.end {
        super::End::Start => "start",
        super::End::Finish => "end",
    };
    format!("{which} of {}", frame.section_name(end.section))
}
