//! Keyboard shortcuts of the window as a whole.

use super::actions::Action;
use crate::document::Kind;
use egui::{Key, KeyboardShortcut, Modifiers, Ui};

/// Take back.
pub(crate) const UNDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Z);
/// Do again.
pub(crate) const REDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
/// Do again, the other custom.
pub(crate) const REDO_Y: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Y);
/// New part.
pub(crate) const NEW: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::N);

/// Open or import.
pub(crate) const OPEN: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::O);
/// Save.
pub(crate) const SAVE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::S);
/// Save as.
pub(crate) const SAVE_AS: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::S);
/// Export.
pub(crate) const EXPORT: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::E);
/// Send.
pub(crate) const SEND: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Enter);
/// Close the window.
pub(crate) const QUIT: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Q);
/// List of shortcuts.
pub(crate) const HELP: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::F1);

/// Reads the shortcuts of this frame. While a text is being edited, undo belongs to the text.
pub(crate) fn read(ui: &Ui, actions: &mut Vec<Action>) {
    let typing = ui.ctx().text_edit_focused();
    let mut on = |shortcut: &KeyboardShortcut, action: Action| {
        if ui.input_mut(|i| i.consume_shortcut(shortcut)) {
            actions.push(action);
        }
    };
    if !typing {
        on(&REDO, Action::Redo);
        on(&REDO_Y, Action::Redo);
        on(&UNDO, Action::Undo);
    }
    for (shortcut, action) in [
        (&NEW, Action::New(Kind::TurnedPart)),
        (&OPEN, Action::AskOpen),
        (&SAVE_AS, Action::SaveAs),
        (&SAVE, Action::Save),
        (&EXPORT, Action::AskExport),
        (&SEND, Action::Send),
        (&QUIT, Action::Quit),
        (&HELP, Action::Shortcuts),
    ] {
        on(shortcut, action);
    }
}
