//! The desk: everything the window keeps, and one frame of it.

use super::actions::Action;
use super::layout::{Layout, Pane};
use super::plots::{CutView, ProfileView};
use super::sections::SectionsView;
use super::start::StartPage;
use super::theme::{self, Colors};
use super::{menus, panes, status};
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::document::Document;
use crate::machine::Catalog;
use crate::session::Session;
use crate::storage;
use egui::{Context, Margin, Panel, Ui};
use egui_notify::Toasts;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Files that the start page offers.
const RECENT_KEPT: usize = 8;
/// Messages of one file that are shown as toasts; more would cover the desk.
const SAID_AT_ONCE: usize = 3;
/// How long a toast stays.
const TOAST: Duration = Duration::from_secs(6);

/// What panels ask for while they are shown; the desk does it after the frame.
pub(crate) struct Requests {
    /// What to do.
    pub(crate) actions: Vec<Action>,
    /// Row under the pointer.
    pub(crate) hovered: Option<u32>,
    /// Position of the pointer in the document: z and diameter.
    pub(crate) pointer: Option<(f64, f64)>,
    /// Machines, tools and materials to choose from.
    pub(crate) catalog: Arc<Catalog>,
    complaints: Vec<String>,
}

impl Requests {
    /// Says a sentence to the person.
    pub(crate) fn complain(&mut self, sentence: String) {
        self.complaints.push(sentence);
    }
}

/// What is remembered from one run to the next.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Settings {
    /// Files opened last, newest first.
    pub(crate) recent: Vec<PathBuf>,
}

/// The views of the panels.
#[derive(Default)]
pub(crate) struct Views {
    /// Section table.
    pub(crate) sections: SectionsView,
    /// Profile plot.
    pub(crate) profile: ProfileView,
    /// Cut plot.
    pub(crate) cut: CutView,
    /// Gesture of the drag in the profile plot.
    pub(crate) drag: Option<crate::session::GestureId>,
}

/// Everything that the window keeps.
pub struct Desk {
    catalog: Arc<Catalog>,
    session: Option<Session>,
    start: StartPage,
    layout: Layout,
    views: Views,
    settings: Settings,
    toasts: Toasts,
    pointer: Option<(f64, f64)>,
}

impl Desk {
    /// A desk with the start page on it.
    #[must_use]
    pub fn new(ctx: &Context) -> Self {
        theme::install(ctx);
        let (catalog, complaints) = Catalog::load(storage::config_folder().as_deref());
        let catalog = Arc::new(catalog);
        let mut desk = Self {
            start: StartPage::new(&catalog),
            catalog,
            session: None,
            layout: Layout::standard(),
            views: Views::default(),
            settings: Settings::default(),
            toasts: Toasts::default().with_margin(egui::vec2(16.0, 52.0)),
            pointer: None,
        };
        for complaint in complaints.iter().filter(|c| c.severity == Severity::Error) {
            desk.say(&complaint.message);
        }
        desk
    }

    /// Takes back what an earlier run remembered.
    pub fn restore(&mut self, get: impl Fn(&str) -> Option<String>) {
        if let Some(layout) = get("layout").as_deref().and_then(Layout::from_text) {
            self.layout = layout;
        }
        if let Some(settings) = get("settings").and_then(|text| serde_json::from_str(&text).ok()) {
            self.settings = settings;
        }
    }

    /// Hands out what the next run is to remember.
    pub fn remember(&self, mut set: impl FnMut(&str, String)) {
        if let Some(layout) = self.layout.to_text() {
            set("layout", layout);
        }
        if let Ok(settings) = serde_json::to_string(&self.settings) {
            set("settings", settings);
        }
    }

    /// The open document.
    #[must_use]
    pub const fn session(&self) -> Option<&Session> {
        self.session.as_ref()
    }

    /// The open document, to be changed.
    pub const fn session_mut(&mut self) -> Option<&mut Session> {
        self.session.as_mut()
    }

    /// One frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        if let Some(session) = &mut self.session {
            session.receive();
        }
        let catalog = Arc::clone(&self.catalog);
        let mut requests =
            Requests { actions: Vec::new(), hovered: None, pointer: None, catalog, complaints: Vec::new() };
        super::shortcuts::read(ui, &mut requests.actions);
        take_dropped_files(ui, &mut requests.actions);
        self.frame(ui, &mut requests);
        self.toasts.show(ui.ctx());
        self.finish(ui.ctx(), requests);
    }

    fn frame(&mut self, ui: &mut Ui, requests: &mut Requests) {
        let colors = Colors::of(ui.visuals());
        let bar = |margin| egui::Frame::new().fill(colors.panel).inner_margin(margin);
        Panel::top("header").frame(bar(Margin::symmetric(12, 8))).show(ui, |ui| {
            menus::show(ui, self.session.as_ref(), &self.layout, requests);
        });
        if let Some(session) = &self.session {
            Panel::bottom("status").frame(bar(Margin::symmetric(14, 4))).show(ui, |ui| {
                status::show(ui, session, self.pointer);
            });
        }
        let ground = egui::Frame::new().fill(colors.ground).inner_margin(Margin::same(8));
        egui::CentralPanel::default().frame(ground).show(ui, |ui| match &mut self.session {
            None => self.start.show(ui, &self.settings.recent, &mut requests.actions),
            Some(session) => {
                let problems = session.problems().len();
                let badge = move |pane: Pane| (pane == Pane::Problems).then_some(problems);
                let views = &mut self.views;
                self.layout
                    .ui(ui, &badge, &mut |ui, pane, titled| panes::show(ui, pane, titled, session, views, requests));
            }
        });
    }

    fn finish(&mut self, ctx: &Context, requests: Requests) {
        self.pointer = requests.pointer;
        if let Some(session) = &mut self.session {
            if session.selection.hovered != requests.hovered {
                session.selection.hovered = requests.hovered;
                ctx.request_repaint();
            }
        }
        for complaint in &requests.complaints {
            self.say(complaint);
        }
        for action in requests.actions {
            self.act(ctx, action);
            ctx.request_repaint();
        }
    }

    /// Does what a person asked for.
    pub fn act(&mut self, ctx: &Context, action: Action) {
        match action {
            Action::New => self.open_document(ctx, new_part(), None),
            Action::Open(path) => self.open_file(ctx, &path),
            Action::OpenExample(index) => self.open_example(ctx, index),
            Action::Close => self.session = None,
            Action::Undo => self.session.iter_mut().for_each(Session::undo),
            Action::Redo => self.session.iter_mut().for_each(Session::redo),
            Action::TogglePane(pane) => self.layout.set_shown(pane, !self.layout.is_shown(pane)),
            Action::ShowPane(pane) => self.layout.bring_to_front(pane),
            Action::ResetLayout => self.layout = Layout::standard(),
            Action::Theme(theme) => ctx.set_theme(theme),
            Action::Zoom(0) => ctx.set_zoom_factor(1.0),
            Action::Zoom(step) => ctx.set_zoom_factor((ctx.zoom_factor() + 0.1 * f32::from(step)).clamp(0.5, 3.0)),
            Action::GoTo(place) => self.go_to(&place),
        }
    }

    fn open_document(&mut self, ctx: &Context, document: Document, path: Option<PathBuf>) {
        let catalog = Arc::clone(&self.catalog);
        let ctx = ctx.clone();
        let make = move || crate::worker::regenerating(Arc::clone(&catalog));
        self.session = Some(Session::new(document, path, make, move || ctx.request_repaint()));
        self.views = Views::default();
    }

    fn open_file(&mut self, ctx: &Context, path: &Path) {
        match storage::open_document(path) {
            Ok(document) => {
                self.settings.recent.retain(|p| p != path);
                self.settings.recent.insert(0, path.to_owned());
                self.settings.recent.truncate(RECENT_KEPT);
                self.open_document(ctx, document, Some(path.to_owned()));
            }
            Err(reasons) => self.say_all(&reasons),
        }
    }

    fn open_example(&mut self, ctx: &Context, index: usize) {
        let Some(example) = storage::examples().get(index) else { return };
        match storage::document_from_text(example.name, example.text) {
            Ok(document) => self.open_document(ctx, document, None),
            Err(reasons) => self.say_all(&reasons),
        }
    }

    fn go_to(&mut self, place: &Place) {
        let Some(session) = &mut self.session else { return };
        match place {
            Place::Section { id, column, .. } => {
                session.selection.section = Some(*id);
                self.views.sections.go_to(session, *id, *column);
                self.layout.bring_to_front(Pane::Sections);
            }
            Place::Stock | Place::Document | Place::Machine { .. } => self.layout.bring_to_front(Pane::Sections),
            Place::Block { program, block } => {
                session.select_block(program, *block);
                self.layout.bring_to_front(Pane::Program);
            }
            Place::Tool { .. } | Place::Line { .. } | Place::File { .. } => {}
        }
    }

    fn say_all(&mut self, diagnostics: &[Diagnostic]) {
        for diagnostic in diagnostics.iter().take(SAID_AT_ONCE) {
            self.say(&format!("{}: {}", diagnostic.at, diagnostic.message));
        }
    }

    fn say(&mut self, sentence: &str) {
        self.toasts.error(sentence.to_owned()).duration(TOAST);
    }
}

fn take_dropped_files(ui: &Ui, actions: &mut Vec<Action>) {
    let dropped = ui.input(|i| i.raw.dropped_files.first().map(|file| file.path().to_owned()));
    actions.extend(dropped.map(Action::Open));
}

/// A plain cylinder, for a person to go on from.
fn new_part() -> Document {
    use crate::document::{Content, FORMAT_VERSION, TurnedPart};
    let part = TurnedPart {
        machine: "orac".to_owned(),
        material: "ALUMINUM".to_owned(),
        bar_diameter: 25.0,
        length: 40.0,
        ends: crate::document::Ends::One,
        part_off: false,
        automatic: false,
        generator: crate::document::Generator::default(),
        form_tolerance: 0.05,
        sections: vec![
            crate::part::Section::line(1, 0.0, 22.0, 25.0, 22.0),
            crate::part::Section::line(2, 25.0, 16.0, 40.0, 16.0),
        ],
        overrides: std::collections::BTreeMap::new(),
    };
    Document {
        turnwright: FORMAT_VERSION,
        name: "PART".to_owned(),
        unit: crate::units::Unit::Mm,
        content: Content::TurnedPart(part),
    }
}
