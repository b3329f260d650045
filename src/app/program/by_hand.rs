//! Editing the text of a program by hand.

use crate::app::theme;
use crate::post::orac::PAGE_START;
use crate::proof::ProgramText;
use crate::session::{GestureId, Session};
use egui::{FontId, TextEdit, Ui};

/// Stands for the character that begins a page while the text is edited.
const START_PICTURE: char = '␂';

/// Shows the text to be edited; all typing until the field is left is one step of undo.
pub(super) fn show(ui: &mut Ui, gesture: &mut Option<GestureId>, session: &mut Session, program: &ProgramText) {
    let present = session.text_by_hand(&program.name).unwrap_or(&program.text);
    let mut text = shown(present);
    let carriage_returns = present.contains("\r\n");
    let id = ui.make_persistent_id(("by-hand", &program.name));
    egui::ScrollArea::vertical().id_salt("by-hand").auto_shrink([false, false]).show(ui, |ui| {
        let edit = TextEdit::multiline(&mut text)
            .id(id)
            .font(FontId::monospace(theme::CODE))
            .frame(egui::Frame::NONE)
            .desired_width(f32::INFINITY);
        let response = ui.add(edit);
        response.widget_info(|| {
            let mut info = egui::WidgetInfo::text_edit(true, "", &text, "");
            info.label = Some(format!("Text of {}", program.name));
            info
        });
        if response.changed() {
            let step = *gesture.get_or_insert_with(|| session.new_gesture());
            let (name, text) = (&program.name, sent(&text, carriage_returns));
            session.put_by_hand(&format!("edit {name} by hand"), Some(step), name, Some(text));
        }
        if response.lost_focus() {
            *gesture = None;
        }
    });
}

fn shown(text: &str) -> String {
    text.replace("\r\n", "\n").replace(PAGE_START, &START_PICTURE.to_string())
}

fn sent(text: &str, carriage_returns: bool) -> String {
    let text = text.replace(START_PICTURE, &PAGE_START.to_string());
    if carriage_returns { text.replace('\n', "\r\n") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shown_is_sent_unchanged() {
        let text = "\u{2}PAGE 01 MM-UNITS\r\n\u{2}PAGE 02 END-PROGRAM..M02\r\n";
        assert_eq!(sent(&shown(text), true), text);
        assert!(shown(text).starts_with('␂'));
    }
}
