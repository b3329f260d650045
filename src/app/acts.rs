//! What the desk does when it is asked to.

use super::actions::Action;
use super::data::{DataEditor, Entry, Kind};
use super::desk::{Desk, Views};
use super::dialogs::{Dialog, FileDialog, Purpose, UnsavedQuestion};
use super::files::Written;
use super::layout::{Layout, Pane};
use super::plots::fixed;
use super::rolls::select_station;
use crate::diagnostic::Place;
use crate::document::Document;
use crate::machine::Catalog;
use crate::papers::PaperKind;
use crate::proof::BlockRef;
use crate::session::{Origin, Session};
use crate::storage::import::MidLineThickness;
use crate::storage::{self, read_pages, read_program};
use egui::{Context, ViewportCommand};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Files that the start page offers.
const RECENT_KEPT: usize = 8;
/// Ending of a file of ORAC pages.
const PAGES_ENDING: &str = "cnc";
/// Machine of a part whose file names none.
const FIRST_MACHINE: &str = "orac";

impl Desk {
    /// Does what a person asked for; asks first where unsaved work would be lost.
    pub fn act(&mut self, ctx: &Context, action: Action) {
        if action.leaves_document()
            && let Some(session) = self.session.as_ref().filter(|s| s.has_unsaved_work())
        {
            let name = super::menus::name_of(session);
            self.dialog = Some(Dialog::Unsaved(UnsavedQuestion { name, then: action }));
            return;
        }
        match action {
            Action::New(kind) => self.open_document(ctx, super::new::document(kind, FIRST_MACHINE), Origin::Fresh),
            Action::OpenMade(document) => self.open_document(ctx, *document, Origin::Fresh),
            Action::Open(path) => self.open_file(ctx, &path),
            Action::OpenExample(index) => self.open_example(ctx, index),
            Action::Recover(index) => self.open_recovered(ctx, index),
            Action::ForgetRecovered(index) => self.forget_recovered(index),
            Action::Close => self.session = None,
            Action::StopRig => self.views.shell.emergency_stop(),
            Action::Quit => {
                self.session = None;
                ctx.send_viewport_cmd(ViewportCommand::Close);
            }
            Action::GiveUp(then) => {
                self.files.discard_recovery();
                self.session = None;
                self.act(ctx, *then);
            }
            Action::SaveThen(then) => {
                self.after_save = Some(*then);
                self.act(ctx, Action::Save);
            }
            Action::Save => self.save(ctx),
            Action::SaveAs => self.ask_file(ctx, Purpose::SaveAs, "turn"),
            Action::AskExport => self.ask_file(ctx, Purpose::Export, "dxf"),
            Action::AskOpen => self.ask_file(ctx, Purpose::Open, ""),
            Action::AskOpenProgram => self.ask_file(ctx, Purpose::OpenProgram, ""),
            Action::AskOpenSection => self.ask_file(ctx, Purpose::OpenSection, ""),
            Action::OpenSection(path) => self.open_section(ctx, &path),
            Action::OpenProgram(path) => self.open_program(&path),
            Action::AskSaveProgram { name, text } => self.ask_program_file(ctx, &name, text),
            Action::AskSaveText { name, text } => self.ask_text_file(ctx, &name, text),
            Action::AskSavePapers(kind) => self.ask_file(ctx, Purpose::Papers(kind), "pdf"),
            Action::WritePapers(path, kind) => self.write_papers(path, kind),
            Action::WriteText(path, text) => self.files.write_text(path, text),
            Action::WriteTo(path) => self.write(path),
            Action::Undo => self.session.iter_mut().for_each(Session::undo),
            Action::Redo => self.session.iter_mut().for_each(Session::redo),
            Action::TogglePane(pane) => {
                let layout = self.layout();
                layout.set_shown(pane, !layout.is_shown(pane));
            }
            Action::ShowPane(pane) => self.layout().bring_to_front(pane),
            Action::ResetLayout => {
                let kind = self.layout().kind();
                *self.layout() = Layout::standard(kind);
            }
            Action::Theme(theme) => ctx.set_theme(theme),
            Action::Zoom(0) => ctx.set_zoom_factor(1.0),
            Action::Zoom(step) => ctx.set_zoom_factor((ctx.zoom_factor() + 0.1 * f32::from(step)).clamp(0.5, 3.0)),
            Action::Shortcuts => self.dialog = Some(Dialog::Shortcuts),
            Action::GoTo(place) => self.go_to(&place),
            Action::ShowBlock => self.show_block(),
            Action::EditData(kind, key) => self.edit_data(kind, key.as_deref()),
            Action::SaveData(entry) => self.save_data(ctx, &entry),
            Action::Send => self.send(ctx, false),
            Action::SendAllTheSame => self.send(ctx, true),
        }
    }

    fn open_document(&mut self, ctx: &Context, document: Document, origin: Origin) {
        let catalog = Arc::clone(&self.catalog);
        let ctx = ctx.clone();
        let make = move || crate::worker::regenerating(Arc::clone(&catalog));
        self.session = Some(Session::new(document, origin, make, move || ctx.request_repaint()));
        let shell = std::mem::take(&mut self.views.shell).for_another_document();
        self.views = Views { shell, ..Views::default() };
        self.after_save = None;
    }

    fn open_file(&mut self, ctx: &Context, path: &Path) {
        match storage::import::any(path, FIRST_MACHINE) {
            Ok((document, remarks)) => {
                let own = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("turn"));
                let origin = if own { Origin::File(path.to_owned()) } else { Origin::Fresh };
                self.remember_file(path);
                self.open_document(ctx, document, origin);
                self.say_all(&remarks);
            }
            Err(reasons) => self.say_all(&reasons),
        }
    }

    /// Makes a set of form-rolls of a drawing of its cross-section. A mid-line is taken to be as thick as the section that is open, or
    /// 1 mm, and that is said; how thick an outline is, too.
    fn open_section(&mut self, ctx: &Context, path: &Path) {
        let open = self.session.as_ref().map(Session::document);
        let open = open.and_then(|d| Some(d.content.roll_set()?.section.thickness * d.unit.in_mm()));
        match storage::import::section_drawing(path, MidLineThickness::TakenMm(open.unwrap_or(1.0))) {
            Ok((document, remarks)) => {
                let thickness = document.content.roll_set().map_or(0.0, |set| set.section.thickness);
                let unit = document.unit;
                self.open_document(ctx, document, Origin::Fresh);
                if !remarks.iter().any(|d| d.code == "dxf-thickness-taken") {
                    self.say(&format!("The outline is {} {} thick.", fixed(thickness, unit.decimals()), unit.symbol()));
                }
                self.say_all(&remarks);
            }
            Err(reasons) => self.say_all(&reasons),
        }
    }

    /// Puts the program of a file in the place of the program that is shown: one step of undo.
    fn open_program(&mut self, path: &Path) {
        let shown = self.session.as_ref().and_then(Session::program).map(|program| program.name.clone());
        let (Some(session), Some(name)) = (&mut self.session, shown) else {
            self.say("A program is shown and proved on a part. Open a part first, and let its own program be made.");
            return;
        };
        let text = if session.is_in_pages() { read_pages(path) } else { read_program(path).map_err(|d| vec![d]) };
        match text {
            Ok(text) => {
                let file = path.file_name().unwrap_or_default().to_string_lossy();
                let label = format!("{file} as {name}");
                session.put_by_hand(&label, None, &name, Some(text));
                self.layout().bring_to_front(Pane::Program);
            }
            Err(reasons) => self.say_all(&reasons),
        }
    }

    fn remember_file(&mut self, path: &Path) {
        self.settings.recent.retain(|p| p != path);
        self.settings.recent.insert(0, path.to_owned());
        self.settings.recent.truncate(RECENT_KEPT);
    }

    fn open_example(&mut self, ctx: &Context, index: usize) {
        let Some(example) = storage::examples().get(index) else { return };
        match storage::document_from_text(example.name, example.text) {
            Ok(document) => self.open_document(ctx, document, Origin::Fresh),
            Err(reasons) => self.say_all(&reasons),
        }
    }

    fn open_recovered(&mut self, ctx: &Context, index: usize) {
        if index >= self.recovered.len() {
            return;
        }
        let recovered = self.recovered.remove(index);
        self.open_document(ctx, recovered.document.clone(), Origin::Recovered(recovered.original.clone()));
        self.files.take_over(recovered);
    }

    fn forget_recovered(&mut self, index: usize) {
        if index < self.recovered.len()
            && let Err(reason) = self.recovered.remove(index).discard()
        {
            self.say(&reason.message);
        }
    }

    fn save(&mut self, ctx: &Context) {
        let Some(session) = &self.session else { return };
        match session.path() {
            Some(path) => self.files.write(path.to_owned(), Arc::clone(session.document()), Arc::clone(&self.catalog)),
            None => self.ask_file(ctx, Purpose::SaveAs, "turn"),
        }
    }

    fn ask_file(&mut self, ctx: &Context, purpose: Purpose, ending: &str) {
        let name = self.session.as_ref().map(|s| s.document().name.to_lowercase());
        let present = self.session.as_ref().and_then(|s| s.path().map(Path::to_owned));
        let path = match purpose {
            Purpose::Open | Purpose::OpenProgram | Purpose::OpenSection | Purpose::Program(_) | Purpose::Text(_) => {
                PathBuf::new()
            }
            Purpose::SaveAs | Purpose::Export | Purpose::Papers(_) => {
                present.or(name.map(PathBuf::from)).unwrap_or_default().with_extension(ending)
            }
        };
        let system = self.surroundings.system_dialogs;
        self.dialog = Some(Dialog::File(FileDialog::ask(ctx, purpose, &path, system)));
    }

    fn ask_text_file(&mut self, ctx: &Context, name: &str, text: Arc<str>) {
        let folder = self.session.as_ref().and_then(|s| s.path().and_then(Path::parent)).unwrap_or(Path::new(""));
        let (path, system) = (folder.join(name), self.surroundings.system_dialogs);
        self.dialog = Some(Dialog::File(FileDialog::ask(ctx, Purpose::Text(text), &path, system)));
    }

    fn ask_program_file(&mut self, ctx: &Context, name: &str, text: Arc<str>) {
        let folder = self.session.as_ref().and_then(|s| s.path().and_then(Path::parent)).unwrap_or(Path::new(""));
        let machine = self.session.as_ref().and_then(Session::derived).and_then(|d| d.machine.as_ref());
        let ending = machine.and_then(|m| m.words.as_ref()).map_or(PAGES_ENDING, |words| words.extension.as_str());
        let path = folder.join(name).with_extension(ending);
        let system = self.surroundings.system_dialogs;
        self.dialog = Some(Dialog::File(FileDialog::ask(ctx, Purpose::Program(text), &path, system)));
    }

    fn write(&mut self, path: PathBuf) {
        if let Some(session) = &self.session {
            self.files.write(path, Arc::clone(session.document()), Arc::clone(&self.catalog));
        }
    }

    /// Papers of what the document is now, never of an older one.
    fn write_papers(&mut self, path: PathBuf, kind: PaperKind) {
        let Some(session) = &self.session else { return };
        let subject = if kind.is_of_set() { session.derived() } else { session.shown() };
        match (session.outdated(), subject) {
            (None, Some(subject)) => {
                self.files.write_papers(path, kind, Arc::clone(subject), Arc::clone(&self.catalog));
            }
            (reason, _) => {
                let reason = reason.unwrap_or("There is nothing to draw yet.");
                self.say(&format!("The {} was not saved. {reason}", kind.name()));
            }
        }
    }

    /// A file was written, or could not be.
    pub(super) fn after_writing(&mut self, ctx: &Context, written: Written) {
        let name = written.path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        match written.result {
            Err(reasons) => {
                self.after_save = None;
                self.say_all(&reasons);
            }
            Ok(remarks) => {
                self.say_done(&format!("Saved {name}."));
                self.say_all(&remarks);
                let own = written.path.extension().is_some_and(|e| e.eq_ignore_ascii_case("turn"));
                if let Some(document) = written.document.filter(|_| own) {
                    self.document_saved(ctx, &written.path, document);
                }
            }
        }
    }

    fn document_saved(&mut self, ctx: &Context, path: &Path, document: Arc<Document>) {
        self.remember_file(path);
        if let Some(session) = &mut self.session {
            session.set_saved(path.to_owned(), document);
            if !session.has_unsaved_work() {
                self.files.discard_recovery();
            }
        }
        if let Some(action) = self.after_save.take() {
            self.act(ctx, action);
        }
    }

    fn edit_data(&mut self, kind: Kind, key: Option<&str>) {
        let has_folder = self.surroundings.config_folder.is_some();
        let editor = DataEditor::new(Arc::clone(&self.catalog), kind, key, has_folder);
        self.dialog = Some(Dialog::Data(Box::new(editor)));
    }

    /// Saves an item of data and lets everything follow from it.
    fn save_data(&mut self, ctx: &Context, entry: &Entry) {
        let Some(folder) = self.surroundings.config_folder.clone() else { return };
        match entry.save(&folder) {
            Ok(path) => self.say_done(&format!("Saved {}.", path.display())),
            Err(reason) => return self.say_all(&[reason]),
        }
        let (catalog, complaints) = Catalog::load(Some(&folder));
        self.catalog = Arc::new(catalog);
        self.say_all(&complaints);
        if let Some(Dialog::Data(editor)) = &mut self.dialog {
            editor.reload(Arc::clone(&self.catalog));
        }
        if let Some(session) = &mut self.session {
            let (catalog, ctx) = (Arc::clone(&self.catalog), ctx.clone());
            let make = move || crate::worker::regenerating(Arc::clone(&catalog));
            session.work_anew(make, move || ctx.request_repaint());
        }
    }

    fn send(&mut self, ctx: &Context, insists: bool) {
        let Some(session) = &self.session else { return };
        let ctx = ctx.clone();
        self.transfer.send(session, insists, move || ctx.request_repaint());
        self.layout().bring_to_front(Pane::Transfer);
    }

    fn go_to(&mut self, place: &Place) {
        let Some(session) = &mut self.session else { return };
        match place {
            Place::Section { id, column, .. } => {
                session.selection.section = Some(*id);
                self.views.sections.go_to(session, *id, *column);
                self.layout().bring_to_front(Pane::Sections);
            }
            Place::Block { program, block } => {
                session.select_block(program, *block);
                self.layout().bring_to_front(Pane::Program);
                self.show_block();
            }
            Place::Document if session.document().content.roll_set().is_some() => {
                self.layout().bring_to_front(Pane::Elements);
            }
            Place::Stock | Place::Document | Place::Machine { .. } | Place::Tool { .. } => {
                session.selection.section = None;
                self.layout().bring_to_front(Pane::Sections);
                self.layout().bring_to_front(Pane::Inspector);
            }
            Place::Setting { .. } => self.layout().bring_to_front(Pane::ShellData),
            Place::Element { id, .. } => {
                self.views.rolls.go_to_element(session, *id);
                self.layout().bring_to_front(Pane::Elements);
            }
            Place::Station { id, .. } => {
                select_station(session, *id);
                self.layout().bring_to_front(Pane::StationData);
            }
            Place::Roll { name } => {
                let rolls = session.derived().and_then(|derived| derived.rolls.clone());
                if let Some(roll) = rolls.as_ref().and_then(|rolls| rolls.design.rolls().find(|r| r.name == *name)) {
                    session.select_roll(roll.roll);
                    self.layout().bring_to_front(Pane::Station);
                    self.layout().bring_to_front(Pane::RollList);
                }
            }
            Place::Line { .. } | Place::File { .. } => {}
        }
    }

    fn show_block(&mut self) {
        let Some(session) = &self.session else { return };
        if let (Some(setup), Some(block)) = (session.setup(), session.selection.block) {
            self.views.cut.go_to(setup, BlockRef { program: session.selection.program, block });
        }
    }
}
