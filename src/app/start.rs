//! The page between the program's start and the first drawing.

use super::actions::Action;
use super::theme::{self, Colors};
use super::widgets::{link, primary_button};
use crate::document::Content;
use crate::geometry::Point;
use crate::machine::Catalog;
use crate::part;
use crate::storage;
use egui::{Align, Color32, Frame, Margin, Rect, Sense, Shape, Stroke, StrokeKind, Ui, vec2};
use std::path::PathBuf;

/// Width of the page, points.
const PAGE: f32 = 980.0;
/// Size of an example's card, points.
const CARD: egui::Vec2 = vec2(316.0, 214.0);

/// Distance that a picture may keep from the part, mm: less than a pixel.
const PICTURE_TOLERANCE_MM: f64 = 0.02;

/// Pictures of the examples.
pub(crate) struct StartPage {
    outlines: Vec<Vec<Point>>,
}

impl StartPage {
    /// Draws the examples' outlines.
    #[must_use]
    pub(crate) fn new(catalog: &Catalog) -> Self {
        Self { outlines: storage::examples().iter().map(|example| outline(example, catalog)).collect() }
    }

    /// Shows the page.
    pub(crate) fn show(&self, ui: &mut Ui, recent: &[PathBuf], actions: &mut Vec<Action>) {
        egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            let side = ((ui.available_width() - PAGE) / 2.0).max(8.0);
            Frame::new().inner_margin(Margin { left: margin(side), right: margin(side), top: 36, bottom: 24 }).show(
                ui,
                |ui| {
                    self.page(ui, recent, actions);
                },
            );
        });
    }

    fn page(&self, ui: &mut Ui, recent: &[PathBuf], actions: &mut Vec<Action>) {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::strong("Start with a part").font(theme::strong_font(22.0)));
        ui.label(theme::quiet("Open an example and drag a diameter: paths, program and proof follow.", colors));
        ui.add_space(14.0);
        ui.horizontal(|ui| {
            if primary_button(ui, "New part", true).clicked() {
                actions.push(Action::New);
            }
        });
        ui.add_space(20.0);
        ui.label(theme::strong("Examples"));
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(16.0, 16.0);
            for (index, example) in storage::examples().iter().enumerate() {
                let outline = self.outlines.get(index).map_or(&[][..], Vec::as_slice);
                if card(ui, example, outline, colors) {
                    actions.push(Action::OpenExample(index));
                }
            }
        });
        if !recent.is_empty() {
            ui.add_space(20.0);
            ui.label(theme::strong("Recent files"));
            for path in recent {
                recent_file(ui, path, colors, actions);
            }
        }
    }
}

#[allow(clippy::cast_possible_truncation, reason = "a margin beyond i8 is cut off on purpose")]
fn margin(points: f32) -> i8 {
    points.clamp(0.0, 127.0) as i8
}

/// Outline of an example's finished part; empty if it cannot be made.
fn outline(example: &storage::Example, catalog: &Catalog) -> Vec<Point> {
    let Ok(document) = storage::document_from_text(example.name, example.text) else { return Vec::new() };
    let Content::TurnedPart(part) = &document.content;
    let Some(machine) = catalog.machine(&part.machine) else { return Vec::new() };
    let (setups, _) = part::setups(&part.scaled(document.unit.in_mm()), machine);
    let Some(setup) = setups.first() else { return Vec::new() };
    part::contour(&setup.profile, PICTURE_TOLERANCE_MM).contour.polyline(PICTURE_TOLERANCE_MM)
}

fn card(ui: &mut Ui, example: &storage::Example, outline: &[Point], colors: &Colors) -> bool {
    let (rect, response) = ui.allocate_exact_size(CARD, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Open {}", example.name)));
    let lifted = response.hovered() || response.has_focus();
    let line = if lifted { colors.plot.accent } else { colors.line };
    ui.painter().rect(rect, 8.0, colors.panel, Stroke::new(1.0, line), StrokeKind::Inside);
    let picture =
        Rect::from_min_max(rect.min + vec2(22.0, 18.0), egui::pos2(rect.right() - 22.0, rect.bottom() - 76.0));
    paint_part(ui, picture, outline, colors);
    let text = Rect::from_min_max(egui::pos2(rect.left() + 18.0, rect.bottom() - 66.0), rect.max - vec2(16.0, 8.0));
    let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(text).layout(egui::Layout::top_down(Align::Min)));
    inner.spacing_mut().item_spacing.y = 2.0;
    inner.add(egui::Label::new(theme::strong(example.name)).selectable(false));
    inner.add(egui::Label::new(theme::quiet(example.description, colors)).wrap().selectable(false));
    response.on_hover_cursor(egui::CursorIcon::PointingHand).clicked()
}

/// Draws a part and its mirror image as large as fits.
fn paint_part(ui: &Ui, room: Rect, outline: &[Point], colors: &Colors) {
    let (mut z, mut r) = ((f64::INFINITY, f64::NEG_INFINITY), 0.0f64);
    for p in outline {
        z = (z.0.min(p.z), z.1.max(p.z));
        r = r.max(p.r);
    }
    if z.1 <= z.0 || r <= 0.0 {
        return;
    }
    let scale = (f64::from(room.width()) / (z.1 - z.0)).min(f64::from(room.height()) / (2.0 * r));
    let at = |p: &Point, side: f64| {
        let (x, y) = ((p.z - f64::midpoint(z.0, z.1)) * scale, -p.r * scale * side);
        room.center() + vec2(screen(x), screen(y))
    };
    for (side, fill, edge) in
        [(-1.0, colors.plot.part_mirror, colors.plot.edge_mirror), (1.0, colors.plot.part, colors.plot.edge)]
    {
        paint_half(ui, outline, &|p| at(p, side), fill, edge, room.center().y);
    }
}

#[allow(clippy::cast_possible_truncation, reason = "screen positions are f32")]
const fn screen(value: f64) -> f32 {
    value as f32
}

fn paint_half(ui: &Ui, outline: &[Point], at: &dyn Fn(&Point) -> egui::Pos2, fill: Color32, edge: Color32, axis: f32) {
    let mut strip = egui::Mesh::default();
    for (index, p) in (0u32..).zip(outline.iter().map(at)) {
        strip.colored_vertex(p, fill);
        strip.colored_vertex(egui::pos2(p.x, axis), fill);
        if index > 0 {
            let i = 2 * index;
            strip.add_triangle(i - 2, i - 1, i);
            strip.add_triangle(i - 1, i, i + 1);
        }
    }
    ui.painter().add(strip);
    let points = outline.iter().map(at).collect();
    ui.painter().add(Shape::line(points, Stroke::new(1.5, edge)));
}

fn recent_file(ui: &mut Ui, path: &PathBuf, colors: &Colors, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        if link(ui, &name).clicked() {
            actions.push(Action::Open(path.clone()));
        }
        let folder = path.parent().map(|p| p.display().to_string()).unwrap_or_default();
        ui.label(theme::quiet(folder, colors));
    });
}
