//! The edits made on a roll, in order, with those that no longer fit marked.

use crate::app::theme::{self, Colors};
use crate::app::widgets::link;
use crate::document::{EditAction, NewElement, RollEdit};
use crate::rollform::Roll;
use crate::rollform::editor::{begin_own, decided, described};
use crate::session::Session;
use egui::{RichText, Ui};

/// Shows the list.
pub(super) fn show(ui: &mut Ui, session: &mut Session, roll: &Roll) {
    let colors = Colors::of(ui.visuals());
    let document = std::sync::Arc::clone(session.document());
    let work = document.content.roll_set().map(|set| decided(set, roll.roll));
    let edits = work.as_ref().map(|work| work.edits.as_slice()).unwrap_or_default();
    ui.horizontal(|ui| {
        ui.label(theme::strong("Edits"));
        ui.label(theme::quiet(edits.len().to_string(), colors));
    });
    let mut gone = None;
    ui.vertical(|ui| {
        for (number, edit) in (1..).zip(edits) {
            let fault = roll.faults.iter().find(|fault| fault.edit == edit.id);
            ui.horizontal(|ui| {
                let text = format!("{number}  {}", told(edit));
                let color = if fault.is_some() { colors.plot.wrong } else { colors.plot.text };
                let remove = link(ui, "remove");
                if remove.on_hover_text(format!("Take edit {number} back")).clicked() {
                    gone = Some(edit.id);
                }
                let label = ui.add(egui::Label::new(RichText::new(text).color(color)).truncate());
                if let Some(fault) = fault {
                    label.on_hover_text(format!("{} {}", fault.message, fault.hint));
                }
            });
        }
        if edits.is_empty() {
            ui.label(theme::quiet("The contour is as it was designed.", colors));
        }
    });
    if let Some(id) = gone {
        let at = roll.roll;
        session.edit("removed edit of a roll", None, |document| {
            if let Some(set) = super::super::set_mut(document) {
                begin_own(set, at).edits.retain(|edit| edit.id != id);
            }
        });
    }
}

/// An edit in a few words.
fn told(edit: &RollEdit) -> String {
    match edit.action {
        EditAction::Chamfer { after, depth } => format!("chamfer {depth} behind {}", described(after)),
        EditAction::Blend { after, radius } => format!("arc R{radius} behind {}", described(after)),
        EditAction::Insert { after, ref shape } => format!("{} behind {}", shape_told(shape), described(after)),
        EditAction::Replace { element, ref shape } => format!("{} for {}", shape_told(shape), described(element)),
        EditAction::Delete { element } => format!("without {}", described(element)),
    }
}

const fn shape_told(shape: &NewElement) -> &'static str {
    match shape {
        NewElement::LineTwoPoints { .. } | NewElement::LineAngle { .. } | NewElement::LineParallel { .. } => "line",
        NewElement::CircleRadius { .. } | NewElement::CirclePoint { .. } | NewElement::CircleMoved { .. } => "circle",
        NewElement::CircleTangent { .. } => "tangent circle",
    }
}
