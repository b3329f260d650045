//! Asking for a file: the system's dialog, and a path field for when there is none.

use crate::app::actions::Action;
use crate::app::theme::{self, Colors};
use crate::app::widgets::primary_button;
use crate::papers::PaperKind;
use egui::{Key, TextEdit, Ui};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// What the file is for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Purpose {
    /// Open a document or import a part.
    Open,
    /// Take a program from a file in place of the one that is shown.
    OpenProgram,
    /// Save the document.
    SaveAs,
    /// Write the part as another kind of file.
    Export,
    /// Save this text, which is a program.
    Program(Arc<str>),
    /// Make a set of form-rolls of a drawing.
    OpenSection,
    /// Save a contour as a text.
    Text(Arc<str>),
    /// Save papers of the part.
    Papers(PaperKind),
}

impl Purpose {
    const fn title(&self) -> &'static str {
        match self {
            Self::Open => "Open or import a part",
            Self::OpenProgram => "Open a program",
            Self::OpenSection => "Import a cross-section",
            Self::Text(_) => "Save the contour",
            Self::SaveAs => "Save as",
            Self::Export => "Export",
            Self::Program(_) => "Save the program",
            Self::Papers(PaperKind::Drawing(_)) => "Save the drawing",
            Self::Papers(PaperKind::SetupSheet) => "Save the setup sheet",
            Self::Papers(PaperKind::Section(_)) => "Save the drawing of the section",
            Self::Papers(PaperKind::Templates(_)) => "Save the templates",
            Self::Papers(PaperKind::Stations(_)) => "Save the drawings of the stations",
            Self::Papers(PaperKind::PartsList) => "Save the parts list",
        }
    }

    const fn remark(&self) -> &'static str {
        match self {
            Self::Open => "Documents (.turn), ORACAP parts (.CAD), profiles (.dxf), section tables (.tsv).",
            Self::OpenProgram => "It takes the place of the program shown and is proved on this part.",
            Self::OpenSection => "A drawing (.dxf) of the closed outline, or of the line in the middle of the strip.",
            Self::Text(_) => "The published layout ends in .txt, a drawing in .dxf.",
            Self::SaveAs => "A document ends in .turn.",
            Self::Export => "The kind goes by the ending: .CAD, .dxf, .svg, .csv or .tsv.",
            Self::Program(_) => "The program with its control characters, as it goes over the line.",
            Self::Papers(_) => {
                "The kind goes by the ending: .pdf, .svg, .dxf or .plt (HP-GL). Only a PDF holds several pages."
            }
        }
    }

    const fn verb(&self) -> &'static str {
        match self {
            Self::Open | Self::OpenProgram | Self::OpenSection => "Open",
            Self::SaveAs | Self::Text(_) | Self::Program(_) | Self::Papers(_) => "Save",
            Self::Export => "Export",
        }
    }

    const fn kind(&self) -> &'static str {
        match self {
            Self::Program(_) | Self::OpenProgram => "Programs",
            Self::Papers(_) => "Papers",
            Self::OpenSection | Self::Text(_) => "Drawings",
            Self::Open | Self::SaveAs | Self::Export => "Parts",
        }
    }

    const fn endings(&self) -> &'static [&'static str] {
        match self {
            Self::Open => &["turn", "cad", "CAD", "dxf", "DXF", "tsv", "txt", "json"],
            Self::OpenSection => &["dxf", "DXF"],
            Self::Text(_) => &["txt", "dxf"],
            Self::OpenProgram => &["nc", "NC", "ngc", "cnc", "CNC", "tap", "txt", "anc", "bnc"],
            Self::SaveAs => &["turn"],
            Self::Export => &["CAD", "dxf", "svg", "csv", "tsv"],
            Self::Program(_) => &["nc", "ngc", "cnc", "CNC", "txt"],
            Self::Papers(_) => &["pdf", "svg", "dxf", "plt"],
        }
    }
}

/// The question which file.
pub(crate) struct FileDialog {
    purpose: Purpose,
    path: String,
    system: Option<Receiver<Option<PathBuf>>>,
    fresh: bool,
}

impl FileDialog {
    /// Asks for a file, beginning at `path`. With `system` the system's own dialog opens in front.
    pub(crate) fn ask(ctx: &egui::Context, purpose: Purpose, path: &Path, system: bool) -> Self {
        let mut dialog = Self { purpose, path: path.display().to_string(), system: None, fresh: true };
        if system {
            dialog.browse(ctx);
        }
        dialog
    }

    /// Opens the system's dialog on a thread of its own, because it returns only when it is closed.
    fn browse(&mut self, ctx: &egui::Context) {
        let (sender, receiver) = channel();
        let (purpose, start, ctx) = (self.purpose.clone(), PathBuf::from(&self.path), ctx.clone());
        std::thread::spawn(move || {
            let mut dialog =
                rfd::FileDialog::new().set_title(purpose.title()).add_filter(purpose.kind(), purpose.endings());
            if let Some(folder) = start.parent().filter(|p| p.is_dir()) {
                dialog = dialog.set_directory(folder);
            }
            if let Some(name) = start.file_name() {
                dialog = dialog.set_file_name(name.to_string_lossy());
            }
            let opens = matches!(purpose, Purpose::Open | Purpose::OpenProgram | Purpose::OpenSection);
            let path = if opens { dialog.pick_file() } else { dialog.save_file() };
            // The window may be gone by now; then nobody waits for the answer.
            let _ = sender.send(path);
            ctx.request_repaint();
        });
        self.system = Some(receiver);
    }

    /// Shows the question; true when it is answered.
    pub(super) fn show(&mut self, ui: &mut Ui, actions: &mut Vec<Action>) -> bool {
        ui.set_width(460.0);
        ui.label(theme::strong(self.purpose.title()).size(15.0));
        ui.label(theme::quiet(self.purpose.remark(), Colors::of(ui.visuals())));
        ui.add_space(8.0);
        if let Some(path) = self.answer_of_system() {
            self.path = path.display().to_string();
            return self.finish(actions);
        }
        let response = ui.add(TextEdit::singleline(&mut self.path).hint_text("/path/to/file").desired_width(444.0));
        response.widget_info(|| {
            let mut info = egui::WidgetInfo::text_edit(true, "", &self.path, "");
            info.label = Some("Path of the file".to_owned());
            info
        });
        if std::mem::take(&mut self.fresh) {
            response.request_focus();
        }
        let entered = response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
        ui.add_space(8.0);
        let mut cancelled = false;
        let mut chosen = entered;
        ui.horizontal(|ui| {
            let ready = !self.path.trim().is_empty();
            chosen |= primary_button(ui, self.purpose.verb(), ready).clicked();
            if ui.add_enabled(self.system.is_none(), egui::Button::new("Browse…")).clicked() {
                self.browse(ui.ctx());
            }
            cancelled = ui.button("Cancel").clicked();
        });
        cancelled || (chosen && self.finish(actions))
    }

    fn answer_of_system(&mut self) -> Option<PathBuf> {
        match self.system.as_ref()?.try_recv() {
            Ok(answer) => {
                self.system = None;
                answer
            }
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                self.system = None;
                None
            }
        }
    }

    fn finish(&self, actions: &mut Vec<Action>) -> bool {
        let path = PathBuf::from(self.path.trim());
        if path.as_os_str().is_empty() {
            return false;
        }
        actions.push(match &self.purpose {
            Purpose::Open => Action::Open(path),
            Purpose::OpenProgram => Action::OpenProgram(path),
            Purpose::OpenSection => Action::OpenSection(path),
            Purpose::SaveAs => Action::WriteTo(with_ending(path, "turn")),
            Purpose::Export => Action::WriteTo(path),
            Purpose::Program(text) | Purpose::Text(text) => Action::WriteText(path, Arc::clone(text)),
            Purpose::Papers(kind) if path.extension().is_none() => Action::WritePapers(with_ending(path, "pdf"), *kind),
            Purpose::Papers(kind) => Action::WritePapers(path, *kind),
        });
        true
    }
}

fn with_ending(path: PathBuf, ending: &str) -> PathBuf {
    if path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending)) { path } else { path.with_extension(ending) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_gets_its_ending() {
        assert_eq!(with_ending(PathBuf::from("a/queen"), "turn"), PathBuf::from("a/queen.turn"));
        assert_eq!(with_ending(PathBuf::from("a/queen.TURN"), "turn"), PathBuf::from("a/queen.TURN"));
    }
}
