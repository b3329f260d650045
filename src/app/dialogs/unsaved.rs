//! What becomes of unsaved work, asked once before it would be lost.

use crate::app::actions::Action;
use crate::app::theme::{self, Colors};
use crate::app::widgets::primary_button;
use egui::Ui;

/// The question, and what a person was about to do.
pub(crate) struct UnsavedQuestion {
    /// Name of the document.
    pub(crate) name: String,
    /// What to do once it is answered.
    pub(crate) then: Action,
}

impl UnsavedQuestion {
    /// Shows the question; true when it is answered.
    pub(super) fn show(&self, ui: &mut Ui, actions: &mut Vec<Action>) -> bool {
        ui.set_width(400.0);
        ui.label(theme::strong(format!("Save the changes to {}?", self.name)).size(15.0));
        ui.label(theme::quiet("They are lost otherwise.", Colors::of(ui.visuals())));
        ui.add_space(10.0);
        let mut answered = false;
        ui.horizontal(|ui| {
            if primary_button(ui, "Save", true).clicked() {
                actions.push(Action::SaveThen(Box::new(self.then.clone())));
                answered = true;
            }
            if ui.button("Do not save").clicked() {
                actions.push(Action::GiveUp(Box::new(self.then.clone())));
                answered = true;
            }
            answered |= ui.button("Cancel").clicked();
        });
        answered
    }
}
