//! The desk: everything the window keeps, and one frame of it.

use super::actions::Action;
use super::dialogs::{self, Dialog};
use super::files::{self, Files};
use super::layout::{Layout, Pane};
use super::operations::OperationsView;
use super::plots::{CutView, Palette, ProfileView, SolidView};
use super::problems::ProblemsView;
use super::program::ProgramView;
use super::rolls::RollsViews;
use super::sections::SectionsView;
use super::shell::ShellViews;
use super::start::StartPage;
use super::theme::{self, Colors};
use super::transfer::TransferPanel;
use super::{menus, panes, status};
use crate::diagnostic::{Diagnostic, Severity};
use crate::document::Kind;
use crate::machine::Catalog;
use crate::proof::BlockRef;
use crate::session::{GestureId, Hovered, Session};
use crate::storage::recovery::Recovered;
use crate::storage::{self, is_program};
use crate::transfer::{Outcome, Progress};
use egui::{Context, Margin, Panel, Ui, ViewportCommand};
use egui_notify::{Toast, ToastLevel, Toasts};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

/// Messages of one file that are shown as toasts; more would cover the desk.
const SAID_AT_ONCE: usize = 3;
/// How long a toast stays.
const TOAST: Duration = Duration::from_secs(6);
/// Age of an edit at which it goes into the recovery file; a crash may lose ten seconds at most.
const RECOVER_AFTER: Duration = Duration::from_secs(4);

/// What is around the window: folders of the user, and whether the system can be asked for files.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Surroundings {
    /// The user's machines, tools and materials.
    pub config_folder: Option<PathBuf>,
    /// Recovery files.
    pub recovery_folder: Option<PathBuf>,
    /// Open the system's file dialogs.
    pub system_dialogs: bool,
}

impl Surroundings {
    /// Those of the user who runs the program.
    #[must_use]
    pub fn of_user() -> Self {
        Self {
            config_folder: storage::config_folder(),
            recovery_folder: storage::data_folder().map(|folder| folder.join("recovery")),
            system_dialogs: true,
        }
    }
}

/// What panels ask for while they are shown; the desk does it after the frame.
pub(crate) struct Requests {
    /// What to do.
    pub(crate) actions: Vec<Action>,
    /// What the pointer is on.
    pub(crate) hovered: Option<Hovered>,
    /// Position of the pointer in the document: z and diameter.
    pub(crate) pointer: Option<(f64, f64)>,
    /// The same in words, where there is neither z nor diameter.
    pub(crate) place: Option<String>,
    /// Machines, tools and materials to choose from.
    pub(crate) catalog: Arc<Catalog>,
    complaints: Vec<String>,
}

impl Requests {
    fn new(catalog: Arc<Catalog>) -> Self {
        Self { actions: Vec::new(), hovered: None, pointer: None, place: None, catalog, complaints: Vec::new() }
    }

    /// Says a sentence to the person.
    pub(crate) fn complain(&mut self, sentence: String) {
        self.complaints.push(sentence);
    }
}

const KINDS: [Kind; 3] = [Kind::TurnedPart, Kind::RollSet, Kind::Shell];

/// Under which name the places of panels are remembered.
const fn layout_key(kind: Kind) -> &'static str {
    match kind {
        Kind::TurnedPart => "layout",
        Kind::RollSet => "layout-rolls",
        Kind::Shell => "layout-shell",
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
    pub(crate) sections: SectionsView,
    pub(crate) operations: OperationsView,
    pub(crate) profile: ProfileView,
    pub(crate) cut: CutView,
    pub(crate) solid: SolidView,
    pub(crate) program: ProgramView,
    pub(crate) problems: ProblemsView,
    pub(crate) rolls: RollsViews,
    pub(crate) shell: ShellViews,
    /// Block at the slider in the last frame.
    pub(crate) block_at_slider: Option<BlockRef>,
    /// Gesture of the drag in the profile plot.
    pub(crate) drag: Option<GestureId>,
}

/// Everything that the window keeps.
pub struct Desk {
    pub(super) surroundings: Surroundings,
    pub(super) catalog: Arc<Catalog>,
    pub(super) session: Option<Session>,
    /// The places of the panels, by kind of document.
    pub(super) layouts: BTreeMap<Kind, Layout>,
    pub(super) views: Views,
    pub(super) transfer: TransferPanel,
    pub(super) dialog: Option<Dialog>,
    pub(super) files: Files,
    pub(super) settings: Settings,
    pub(super) recovered: Vec<Recovered>,
    /// What to do once the document is saved.
    pub(super) after_save: Option<Action>,
    start: StartPage,
    toasts: Toasts,
    pointer: Option<(f64, f64)>,
    place: Option<String>,
    title: String,
}

impl Desk {
    /// A desk with the start page on it.
    #[must_use]
    pub fn new(ctx: &Context, surroundings: Surroundings) -> Self {
        theme::install(ctx);
        let (catalog, complaints) = Catalog::load(surroundings.config_folder.as_deref());
        let catalog = Arc::new(catalog);
        let repaint = ctx.clone();
        let recovered = files::recovered(surroundings.recovery_folder.as_deref());
        let notify = move || repaint.request_repaint();
        let mut desk = Self {
            files: Files::start(surroundings.recovery_folder.clone(), notify),
            start: StartPage::new(&catalog),
            surroundings,
            catalog,
            session: None,
            layouts: KINDS.map(|kind| (kind, Layout::standard(kind))).into(),
            views: Views::default(),
            transfer: TransferPanel::default(),
            dialog: None,
            settings: Settings::default(),
            recovered,
            after_save: None,
            toasts: Toasts::default().with_margin(egui::vec2(16.0, 52.0)),
            pointer: None,
            place: None,
            title: String::new(),
        };
        desk.say_all(&complaints);
        desk
    }

    /// Takes back what an earlier run remembered.
    pub fn restore(&mut self, get: impl Fn(&str) -> Option<String>) {
        for kind in KINDS {
            let text = get(layout_key(kind));
            if let Some(layout) = text.as_deref().and_then(|text| Layout::from_text(kind, text)) {
                self.layouts.insert(kind, layout);
            }
        }
        if let Some(settings) = get("settings").and_then(|text| serde_json::from_str(&text).ok()) {
            self.settings = settings;
        }
    }

    /// Hands out what the next run is to remember.
    pub fn remember(&self, mut set: impl FnMut(&str, String)) {
        for (&kind, layout) in &self.layouts {
            if let Some(text) = layout.to_text() {
                set(layout_key(kind), text);
            }
        }
        if let Ok(settings) = serde_json::to_string(&self.settings) {
            set("settings", settings);
        }
    }

    /// The kind of the open document; a turned part if none is open.
    fn kind(&self) -> Kind {
        self.session.as_ref().map_or(Kind::TurnedPart, |session| session.document().content.kind())
    }

    /// The places of the panels that are shown.
    pub(super) fn layout(&mut self) -> &mut Layout {
        let kind = self.kind();
        self.layouts.entry(kind).or_insert_with(|| Layout::standard(kind))
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

    /// How the last transfer ended.
    #[must_use]
    pub const fn transfer_outcome(&self) -> Option<&Outcome> {
        self.transfer.outcome()
    }

    /// How far the transfer that runs is; `None` while none runs.
    #[must_use]
    pub fn transfer_progress(&self) -> Option<&Progress> {
        self.transfer.is_running().then(|| self.transfer.progress())
    }

    /// True while the window asks whether to send a program whose proof fails.
    #[must_use]
    pub const fn asks_to_insist(&self) -> bool {
        self.transfer.waits_for_second_step()
    }

    /// Puts the slider of the cut to this time, s.
    pub const fn play_from(&mut self, time_s: f64) {
        self.views.cut.time_s = time_s;
    }

    /// Keeps transfers to the speed of the line, or not.
    pub const fn set_paced(&mut self, paced: bool) {
        self.transfer.paced = paced;
    }

    /// One frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.receive(&ctx);
        let mut requests = Requests::new(Arc::clone(&self.catalog));
        if self.dialog.is_none() {
            super::shortcuts::read(ui, &mut requests.actions);
        }
        let dropped = ui.input(|i| i.raw.dropped_files.first().map(|file| file.path().to_owned()));
        requests.actions.extend(dropped.map(|path| self.open_dropped(path)));
        let shown = self.session.as_ref().filter(|_| self.dialog.is_none());
        self.views.shell.tick(ui, shown);
        self.frame(ui, &mut requests);
        self.dialogs(&ctx, &mut requests.actions);
        self.toasts.show(&ctx);
        self.finish(&ctx, requests);
        self.name_window(&ctx);
    }

    /// A program is dropped on the part that it makes; everything else is a part of its own.
    fn open_dropped(&self, path: PathBuf) -> Action {
        if self.session.is_some() && is_program(&path) { Action::OpenProgram(path) } else { Action::Open(path) }
    }

    /// Shows the open question. One that is closed without an answer also ends what was to follow a save.
    fn dialogs(&mut self, ctx: &Context, actions: &mut Vec<Action>) {
        let (open, asked) = (self.dialog.is_some(), actions.len());
        dialogs::show(ctx, &mut self.dialog, actions);
        if open && self.dialog.is_none() && actions.len() == asked {
            self.after_save = None;
        }
    }

    /// Takes what threads have made since the last frame, and does what the clock asks for.
    fn receive(&mut self, ctx: &Context) {
        if let Some(outcome) = self.transfer.receive() {
            let (text, good) = (outcome.to_string(), outcome.is_good());
            self.toast(&text, good);
            if let Some((session, (name, text))) = self.session.as_mut().zip(self.transfer.reached()) {
                session.note_sent(&name, &text);
            }
        }
        while let Some(written) = self.files.written() {
            self.after_writing(ctx, written);
        }
        if ctx.input(|i| i.viewport().close_requested()) && self.session.as_ref().is_some_and(Session::has_unsaved_work)
        {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.act(ctx, Action::Quit);
        }
        let Some(session) = &mut self.session else { return };
        session.receive();
        match session.unrecovered_for() {
            Some(age) if age >= RECOVER_AFTER => {
                self.files.recover(Arc::clone(session.document()), session.path());
                session.set_recovered();
            }
            Some(age) => ctx.request_repaint_after(RECOVER_AFTER.saturating_sub(age)),
            None => {}
        }
    }

    fn frame(&mut self, ui: &mut Ui, requests: &mut Requests) {
        let colors = Colors::of(ui.visuals());
        let bar = |margin| egui::Frame::new().fill(colors.panel).inner_margin(margin);
        let kind = self.kind();
        let layout = self.layouts.entry(kind).or_insert_with(|| Layout::standard(kind));
        let hindrance = self.session.as_ref().and_then(|s| self.transfer.hindrance(s));
        Panel::top("header").frame(bar(Margin::symmetric(14, 7))).show(ui, |ui| {
            let rig = self.views.shell.is_live();
            menus::show(ui, self.session.as_ref(), layout, (hindrance.as_deref(), rig), requests);
        });
        if let Some(session) = &self.session {
            Panel::bottom("status").frame(bar(Margin::symmetric(14, 4))).show(ui, |ui| {
                status::show(ui, session, self.pointer, self.place.as_deref());
            });
        }
        let ground = egui::Frame::new().fill(colors.ground).inner_margin(Margin::same(8));
        egui::CentralPanel::default().frame(ground).show(ui, |ui| match &mut self.session {
            None => self.start.show(ui, &self.settings.recent, &self.recovered, &mut requests.actions),
            Some(session) => {
                let problems = session.problem_count(Severity::Error) + session.problem_count(Severity::Warning);
                let badge = move |pane: Pane| (pane == Pane::Problems).then_some(problems);
                let (views, transfer) = (&mut self.views, &mut self.transfer);
                layout.ui(ui, &badge, &mut |ui, pane, titled| {
                    panes::show(ui, pane, titled, session, views, transfer, requests)
                });
            }
        });
    }

    fn finish(&mut self, ctx: &Context, requests: Requests) {
        self.pointer = requests.pointer;
        self.place = requests.place;
        if self.session.as_mut().is_some_and(|session| session.hover(requests.hovered)) {
            ctx.request_repaint();
        }
        for complaint in &requests.complaints {
            self.say(complaint);
        }
        for action in requests.actions {
            self.act(ctx, action);
            ctx.request_repaint();
        }
    }

    fn name_window(&mut self, ctx: &Context) {
        let title = self.session.as_ref().map_or_else(
            || "Turnwright".to_owned(),
            |s| format!("{}{} – Turnwright", menus::name_of(s), if s.has_unsaved_work() { " *" } else { "" }),
        );
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    pub(super) fn say_all(&mut self, diagnostics: &[Diagnostic]) {
        for diagnostic in diagnostics.iter().take(SAID_AT_ONCE) {
            self.say(&format!("{}: {}", diagnostic.at, diagnostic.message));
        }
    }

    pub(super) fn say(&mut self, sentence: &str) {
        self.toast(sentence, false);
    }

    pub(super) fn say_done(&mut self, sentence: &str) {
        self.toast(sentence, true);
    }

    /// Icons of the bundled font: the toasts' own are in no bundled font.
    fn toast(&mut self, sentence: &str, good: bool) {
        let palette = Palette::LIGHT;
        let (icon, color) = if good { ("✓", palette.accent) } else { ("⚠", palette.wrong) };
        let mut toast = Toast::custom(sentence.to_owned(), ToastLevel::Custom(icon.to_owned(), color));
        toast.duration(TOAST).closable(false);
        self.toasts.add(toast);
    }
}
