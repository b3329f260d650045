//! Questions above the desk: files, unsaved work, keyboard shortcuts.

mod file;
mod help;
mod unsaved;

use super::actions::Action;
use super::data::DataEditor;
use egui::{Context, Id, Modal, Ui};
pub(crate) use file::{FileDialog, Purpose};
pub(crate) use unsaved::UnsavedQuestion;

/// The question that is open, if any.
pub(crate) enum Dialog {
    /// Which file?
    File(FileDialog),
    /// What becomes of unsaved work?
    Unsaved(UnsavedQuestion),
    /// Machines, tools and materials.
    Data(Box<DataEditor>),
    /// The list of shortcuts.
    Shortcuts,
}

/// Shows the open question; it is closed when it is answered.
pub(crate) fn show(ctx: &Context, dialog: &mut Option<Dialog>, actions: &mut Vec<Action>) {
    let Some(open) = dialog else { return };
    let modal = Modal::new(Id::unique("dialog")).frame(frame(ctx));
    let response = modal.show(ctx, |ui: &mut Ui| match open {
        Dialog::File(file) => file.show(ui, actions),
        Dialog::Unsaved(question) => question.show(ui, actions),
        Dialog::Data(editor) => editor.show(ui, actions),
        Dialog::Shortcuts => help::show(ui),
    });
    if response.inner || response.should_close() {
        *dialog = None;
    }
}

fn frame(ctx: &Context) -> egui::Frame {
    egui::Frame::window(&ctx.global_style()).inner_margin(egui::Margin::same(20))
}
