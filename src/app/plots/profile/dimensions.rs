//! Dimensions on the profile: figures that can be clicked and typed.

use super::handles::{arc_middle, arc_radius, end_name};
use super::nodes::{End, SectionEnd};
use super::{Dimension, Frame, ProfileEvent, ProfileView};
use crate::app::plots::palette::Palette;
use crate::geometry::Point;
use crate::part::{Section, SectionKind};
use egui::{Align2, FontId, Key, Painter, Pos2, Rect, Sense, Stroke, Ui, Vec2};

/// Size of a dimension's figures, points.
const TEXT: f32 = 11.0;
/// Distance of a dimension line from what it measures, points.
const AWAY: f32 = 14.0;
/// Half the length of the strokes that end a dimension line, points.
const TICK: f32 = 3.5;
/// Width of the field that a dimension is typed in, points.
const FIELD: f32 = 72.0;
/// Size of the sample behind a figure that hides the lines under it, points.
const ROOM: Vec2 = Vec2::new(3.0, 1.0);

/// A dimension that is being typed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Typing {
    dimension: Dimension,
    text: String,
    begun: bool,
}

/// One dimension ready to be drawn.
struct Figure {
    dimension: Dimension,
    /// The figure as drawn.
    text: String,
    /// The figure as first offered when typing.
    value: String,
    /// What it measures, in words.
    name: String,
    /// Middle of the figure.
    at: Pos2,
    /// Dimension line, if it has one.
    line: Option<[Pos2; 2]>,
}

/// Draws the dimensions and takes what is typed.
pub(super) fn dimensions(ui: &mut Ui, frame: &Frame<'_>, view: &mut ProfileView, events: &mut Vec<ProfileEvent>) {
    let painter = ui.painter_at(frame.free);
    for figure in figures(frame, view.full_section) {
        if let Some(line) = figure.line {
            dimension_line(&painter, line, frame.scene.palette);
        }
        if view.typing.as_ref().is_some_and(|t| t.dimension == figure.dimension) {
            type_in(ui, view, &figure, events);
        } else {
            figure_text(ui, frame, view, &figure);
        }
    }
}

fn figures(frame: &Frame<'_>, full_section: bool) -> Vec<Figure> {
    let mut figures = vec![part_length(frame, full_section)];
    figures.extend(full_section.then(|| bar_diameter(frame)));
    if let Some(section) = frame.scene.selected.and_then(|id| frame.section(id)) {
        figures.push(section_length(frame, section));
        figures.extend(diameters(frame, section, full_section));
        figures.extend(radius(frame, section));
    }
    figures.retain(|figure| frame.free.contains(figure.at));
    figures
}

fn figure(frame: &Frame<'_>, dimension: Dimension, sign: &str, value: f64, name: String, at: Pos2) -> Figure {
    let value = frame.coordinates.text(value);
    Figure { dimension, text: format!("{sign}{value}"), value, name, at, line: None }
}

fn part_length(frame: &Frame<'_>, full_section: bool) -> Figure {
    let setup = &frame.scene.derived.setup;
    let lowest = if full_section { -setup.bar_radius } else { 0.0 };
    let y = (frame.screen.pos(Point::new(0.0, lowest)).y + AWAY).min(frame.free.bottom() - AWAY);
    let [from, to] = [0.0, setup.length].map(|z| Pos2::new(frame.screen.pos(Point::new(z, 0.0)).x, y));
    let at = from + (to - from) * 0.5;
    let length = frame.scene.part.length;
    let name = "Length of the part".to_owned();
    Figure { line: Some([from, to]), ..figure(frame, Dimension::PartLength, "", length, name, at) }
}

fn bar_diameter(frame: &Frame<'_>) -> Figure {
    let setup = &frame.scene.derived.setup;
    let x = frame.screen.pos(Point::new(setup.length, 0.0)).x + 2.0 * AWAY;
    let [from, to] = [1.0, -1.0].map(|s| Pos2::new(x, frame.screen.pos(Point::new(0.0, s * setup.bar_radius)).y));
    let at = from + (to - from) * 0.75;
    let name = "Diameter of the bar".to_owned();
    let diameter = frame.scene.part.bar_diameter;
    Figure { line: Some([from, to]), ..figure(frame, Dimension::BarDiameter, "⌀ ", diameter, name, at) }
}

fn section_length(frame: &Frame<'_>, section: &Section) -> Figure {
    let top = frame.screen.pos(Point::new(0.0, frame.scene.derived.setup.bar_radius)).y - AWAY;
    let y = top.max(frame.free.top() + AWAY);
    let [from, to] =
        [section.z1, section.z2].map(|z| Pos2::new(frame.screen.pos(frame.coordinates.point(z, 0.0)).x, y));
    let at = Pos2::new(f32::midpoint(from.x, to.x), y);
    // A short line leaves no room for its figure: that goes above it.
    let at = if (to.x - from.x).abs() < 46.0 { at - Vec2::new(0.0, 9.0) } else { at };
    let name = format!("Length of {}", frame.section_name(section.id));
    let dimension = Dimension::SectionLength { section: section.id };
    Figure { line: Some([from, to]), ..figure(frame, dimension, "", section.z2 - section.z1, name, at) }
}

/// The diameters at both ends: measured in the lower half, or without one written beside their nodes.
fn diameters(frame: &Frame<'_>, section: &Section, full_section: bool) -> Vec<Figure> {
    let thread = matches!(section.kind, SectionKind::Thread { .. });
    let far = if thread { section.d1 } else { section.d2 };
    let ends = [(End::Start, section.z1, section.d1), (End::Finish, section.z2, far)];
    let shown = if thread { 1 } else { 2 };
    let figure = |(end, z, diameter)| end_diameter(frame, SectionEnd { section: section.id, end }, z, diameter);
    let mut figures: Vec<Figure> = ends.into_iter().take(shown).map(figure).collect();
    if !full_section {
        figures.iter_mut().for_each(raise_to_node);
    }
    figures
}

/// With no lower half to hold its line, a diameter is written beside its node.
fn raise_to_node(figure: &mut Figure) {
    if let Some([axis, below]) = figure.line.take() {
        figure.at.y = 2.0 * axis.y - below.y - AWAY;
    }
}

fn end_diameter(frame: &Frame<'_>, end: SectionEnd, z: f64, diameter: f64) -> Figure {
    let [from, to] = [0.0, -diameter].map(|d| frame.screen.pos(frame.coordinates.point(z, d)));
    let axis = from + Vec2::new(0.0, AWAY);
    let at = axis + if end.end == End::Start { Vec2::new(-30.0, 0.0) } else { Vec2::new(30.0, 0.0) };
    let name = format!("Diameter at the {}", end_name(frame, end));
    Figure { line: Some([from, to]), ..figure(frame, Dimension::Diameter(end), "⌀ ", diameter, name, at) }
}

fn radius(frame: &Frame<'_>, section: &Section) -> Option<Figure> {
    let radius = arc_radius(section)?;
    let middle = frame.screen.pos(arc_middle(frame, section.id)?);
    let name = format!("Radius of {}", frame.section_name(section.id));
    let at = middle + Vec2::new(34.0, -12.0);
    Some(figure(frame, Dimension::Radius { section: section.id }, "R ", radius, name, at))
}

fn dimension_line(painter: &Painter, [a, b]: [Pos2; 2], palette: &Palette) {
    let stroke = Stroke::new(1.0, palette.construction);
    let along = (b - a).normalized();
    let across = Vec2::new(-along.y, along.x) * TICK;
    painter.line_segment([a, b], stroke);
    for end in [a, b] {
        painter.line_segment([end - across, end + across], stroke);
    }
}

fn figure_text(ui: &Ui, frame: &Frame<'_>, view: &mut ProfileView, figure: &Figure) {
    let palette = frame.scene.palette;
    let painter = ui.painter_at(frame.free);
    let galley = painter.layout_no_wrap(figure.text.clone(), FontId::proportional(TEXT), palette.text);
    let rect = Align2::CENTER_CENTER.anchor_size(figure.at, galley.size()).expand2(ROOM);
    let response = ui.interact(rect, frame.id.with(("figure", figure.dimension)), Sense::click());
    response.widget_info(|| {
        let name = format!("{}, {} {}", figure.name, figure.value, frame.scene.unit.symbol());
        egui::WidgetInfo::labeled(egui::Role::Button, true, name)
    });
    let lit = response.hovered() || response.has_focus();
    painter.rect_filled(rect, 2.0, palette.ground.gamma_multiply(0.85));
    painter.galley_with_override_text_color(rect.min + ROOM, galley, if lit { palette.accent } else { palette.text });
    if lit {
        painter.hline(rect.x_range().shrink(ROOM.x), rect.bottom(), Stroke::new(1.0, palette.accent));
    }
    if response.clicked() {
        view.typing = Some(Typing { dimension: figure.dimension, text: figure.value.clone(), begun: false });
    }
}

fn type_in(ui: &mut Ui, view: &mut ProfileView, figure: &Figure, events: &mut Vec<ProfileEvent>) {
    let Some(typing) = &mut view.typing else { return };
    let rect = Rect::from_center_size(figure.at, Vec2::new(FIELD, 20.0));
    let field = egui::TextEdit::singleline(&mut typing.text).align(Align2::RIGHT_CENTER);
    let response = ui.put(rect, field.font(FontId::proportional(TEXT + 1.0)));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::TextInput, true, &figure.name));
    if !typing.begun {
        typing.begun = true;
        response.request_focus();
        select_all(ui, response.id, &typing.text);
    } else if response.lost_focus() {
        if !ui.input(|i| i.key_pressed(Key::Escape)) && typing.text != figure.value {
            let text = typing.text.clone();
            events.push(ProfileEvent::EditDimension { dimension: figure.dimension, text });
        }
        view.typing = None;
    }
}

fn select_all(ui: &Ui, id: egui::Id, text: &str) {
    use egui::text::{CCursor, CCursorRange};
    let mut state = egui::TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    let all = CCursorRange::two(CCursor::new(0), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(all));
    state.store(ui.ctx(), id);
}
