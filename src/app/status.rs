//! The line at the foot of the window.

use super::plots::fixed;
use super::theme::{self, Colors};
use crate::session::{SaveState, Session};
use egui::{Align, Layout, RichText, Ui};

/// Shows pointer, last step, saved state and the time of the last regeneration.
pub(crate) fn show(ui: &mut Ui, session: &Session, pointer: Option<(f64, f64)>, place: Option<&str>) {
    let colors = Colors::of(ui.visuals());
    let quiet = |text: String| RichText::new(text).size(theme::SMALL + 0.5).color(colors.plot.quiet);
    let unit = session.document().unit;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 18.0;
        if let Some((z, d)) = pointer {
            let text = format!("z {}  ⌀ {} {}", fixed(z, unit.decimals()), fixed(d, unit.decimals()), unit.symbol());
            ui.label(quiet(text));
        }
        if let Some(place) = place {
            ui.label(quiet(place.to_owned()));
        }
        if let Some(label) = session.history().undo_label() {
            ui.label(quiet(format!("undo: {label}")));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let made = if session.is_current() {
                format!("regenerated in {:.1} ms", session.took().as_secs_f64() * 1000.0)
            } else {
                "regenerating…".to_owned()
            };
            ui.label(quiet(made));
            ui.label(quiet(saved(session)));
        });
    });
}

fn saved(session: &Session) -> String {
    match session.save_state() {
        SaveState::New => "not saved yet".to_owned(),
        SaveState::Edited => "edited since saved".to_owned(),
        SaveState::Saved => "saved".to_owned(),
    }
}
