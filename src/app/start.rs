//! The page between the program's start and the first drawing.

use super::actions::Action;
use super::plots::{flower_thumbnail, thumbnail};
use super::theme::{self, Colors};
use super::widgets::{link, primary_button};
use crate::document::{Content, Kind};
use crate::geometry::Contour;
use crate::machine::Catalog;
use crate::part;
use crate::rollform::bends::Stage;
use crate::rollform::strip::Strip;
use crate::spinning;
use crate::storage;
use crate::storage::recovery::Recovered;
use egui::{Align, Rect, Sense, Stroke, StrokeKind, Ui, vec2};
use std::path::{Path, PathBuf};

/// Width of the page, points.
const PAGE: f32 = 980.0;
/// Size of an example's card, points.
const CARD: egui::Vec2 = vec2(316.0, 214.0);

/// Distance that a picture may keep from the part, mm: less than a pixel.
const PICTURE_TOLERANCE_MM: f64 = 0.02;

/// Pictures of the examples.
pub(crate) struct StartPage {
    pictures: Vec<Option<Picture>>,
}

/// What the card of an example shows.
enum Picture {
    /// A turned part, or the former of a shell.
    Turned(Contour),
    /// The strip at every station.
    Strip(Vec<Contour>),
}

impl StartPage {
    /// Draws the examples' outlines.
    #[must_use]
    pub(crate) fn new(catalog: &Catalog) -> Self {
        Self { pictures: storage::examples().iter().map(|example| picture(example, catalog)).collect() }
    }

    /// Shows the page.
    pub(crate) fn show(&self, ui: &mut Ui, recent: &[PathBuf], recovered: &[Recovered], actions: &mut Vec<Action>) {
        egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            let side = ((ui.available_width() - PAGE) / 2.0).max(8.0);
            ui.add_space(36.0);
            ui.horizontal(|ui| {
                ui.add_space(side);
                ui.vertical(|ui| {
                    ui.set_max_width(PAGE);
                    self.page(ui, recent, recovered, actions);
                    ui.add_space(24.0);
                });
            });
        });
    }

    fn examples(&self, ui: &mut Ui, kind: Kind, actions: &mut Vec<Action>) {
        let colors = Colors::of(ui.visuals());
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(16.0, 16.0);
            for (index, example) in storage::examples().iter().enumerate().filter(|(_, example)| example.kind == kind) {
                let shows = self.pictures.get(index).and_then(Option::as_ref);
                if card(ui, example, shows, colors) {
                    actions.push(Action::OpenExample(index));
                }
            }
        });
    }

    fn page(&self, ui: &mut Ui, recent: &[PathBuf], recovered: &[Recovered], actions: &mut Vec<Action>) {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::strong("Start with a part, a roll set or a shell").font(theme::strong_font(22.0)));
        ui.label(theme::quiet("Open an example and drag a dimension: paths, program and proof follow.", colors));
        ui.add_space(14.0);
        ui.horizontal(|ui| {
            if primary_button(ui, "New part", true).clicked() {
                actions.push(Action::New(Kind::TurnedPart));
            }
            let mut button = |ui: &mut Ui, text: &str, action: Action| {
                if ui.add(egui::Button::new(text).min_size(vec2(0.0, 27.0))).clicked() {
                    actions.push(action);
                }
            };
            button(ui, "New roll set", Action::New(Kind::RollSet));
            button(ui, "New shell", Action::New(Kind::Shell));
            button(ui, "Open or import…", Action::AskOpen);
        });
        unsaved_work(ui, recovered, colors, actions);
        for (kind, title) in
            [(Kind::TurnedPart, "Turned parts"), (Kind::RollSet, "Form-rolls"), (Kind::Shell, "Flow-turned shells")]
        {
            ui.add_space(20.0);
            ui.label(theme::strong(title));
            ui.add_space(4.0);
            self.examples(ui, kind, actions);
        }
        if !recent.is_empty() {
            ui.add_space(20.0);
            ui.label(theme::strong("Recent files"));
            for path in recent {
                recent_file(ui, path, colors, actions);
            }
        }
    }
}

/// Picture of what an example makes; none if it cannot be made.
fn picture(example: &storage::Example, catalog: &Catalog) -> Option<Picture> {
    let document = storage::document_from_text(example.name, example.text).ok()?;
    let in_mm = document.unit.in_mm();
    match &document.content {
        Content::TurnedPart(part) => {
            let machine = catalog.machine(&part.machine)?;
            let (setups, _) = part::setups(&part.scaled(in_mm), machine);
            Some(Picture::Turned(part::contour(&setups.first()?.profile, PICTURE_TOLERANCE_MM).contour))
        }
        Content::RollSet(set) => {
            let set = set.scaled(in_mm);
            let stages = (0..set.stations.len()).map(Stage::Station).chain([Stage::Finished]);
            Some(Picture::Strip(stages.map(|stage| Strip::at(&set, stage).mean()).collect()))
        }
        Content::Shell(shell) => Some(Picture::Turned(spinning::contour(&shell.scaled(in_mm).former)?.reversed())),
    }
}

fn card(ui: &mut Ui, example: &storage::Example, shows: Option<&Picture>, colors: &Colors) -> bool {
    let (rect, response) = ui.allocate_exact_size(CARD, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Open {}", example.name)));
    let lifted = response.hovered() || response.has_focus();
    let line = if lifted { colors.plot.accent } else { colors.line };
    ui.painter().rect(rect, 8.0, colors.panel, Stroke::new(1.0, line), StrokeKind::Inside);
    let picture =
        Rect::from_min_max(rect.min + vec2(22.0, 18.0), egui::pos2(rect.right() - 22.0, rect.bottom() - 76.0));
    match shows {
        Some(Picture::Turned(outline)) => thumbnail(ui.painter(), picture, outline, &colors.plot),
        Some(Picture::Strip(stages)) => flower_thumbnail(ui.painter(), picture, stages, &colors.plot),
        None => {}
    }
    let text = Rect::from_min_max(egui::pos2(rect.left() + 18.0, rect.bottom() - 66.0), rect.max - vec2(16.0, 8.0));
    let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(text).layout(egui::Layout::top_down(Align::Min)));
    inner.spacing_mut().item_spacing.y = 2.0;
    inner.add(egui::Label::new(theme::strong(example.name)).selectable(false));
    inner.add(egui::Label::new(theme::quiet(example.description, colors)).wrap().selectable(false));
    response.on_hover_cursor(egui::CursorIcon::PointingHand).clicked()
}

/// What runs that crashed left behind.
fn unsaved_work(ui: &mut Ui, recovered: &[Recovered], colors: &Colors, actions: &mut Vec<Action>) {
    if recovered.is_empty() {
        return;
    }
    ui.add_space(20.0);
    ui.label(theme::strong("Unsaved work from last time"));
    for (index, left) in recovered.iter().enumerate() {
        ui.horizontal(|ui| {
            if link(ui, &format!("Open {} as it was", left.document.name)).clicked() {
                actions.push(Action::Recover(index));
            }
            let file = left.original.as_ref().map_or_else(|| "never saved".to_owned(), |p| p.display().to_string());
            ui.label(theme::quiet(file, colors));
            if link(ui, "throw away").clicked() {
                actions.push(Action::ForgetRecovered(index));
            }
        });
    }
}

fn recent_file(ui: &mut Ui, path: &Path, colors: &Colors, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        if link(ui, &name).clicked() {
            actions.push(Action::Open(path.to_owned()));
        }
        let folder = path.parent().map(|p| p.display().to_string()).unwrap_or_default();
        ui.label(theme::quiet(folder, colors));
    });
}
