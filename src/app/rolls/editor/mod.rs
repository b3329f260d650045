//! The roll editor: the contour of one roll, an edit that is being prepared, and the list of edits made.

mod form;
mod list;
mod reuse;

use super::RollsViews;
use crate::app::desk::Requests;
use crate::app::plots::{CanvasView, Palette, RollPlotEvent, RollScene, fixed, roll_plot};
use crate::app::theme::{self, Colors};
use crate::app::widgets::{link, title_row};
use crate::document::{ElementName, RollEdit, RollRef, RollSet};
use crate::rollform::Roll;
use crate::rollform::editor::{described, edited};
use crate::session::Session;
use crate::units::Unit;
use egui::{Ui, vec2};
use form::Draft;

/// Width of the column with form and list, points.
const COLUMN: f32 = 258.0;
/// What the panel keeps.
#[derive(Debug, Default)]
pub(super) struct EditorView {
    canvas: CanvasView,
    roll: Option<RollRef>,
    chosen: Option<ElementName>,
    draft: Draft,
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    views: &mut RollsViews,
    requests: &mut Requests,
) -> bool {
    let document = std::sync::Arc::clone(session.document());
    let design = session.derived().and_then(|d| d.rolls.as_ref()).map(|rolls| std::sync::Arc::clone(&rolls.design));
    let roll = design.as_ref().and_then(|design| {
        let shown = session.roll().and_then(|roll| design.roll(roll));
        shown.or_else(|| design.rolls().next())
    });
    let view = &mut views.editor;
    let remark = roll.map(|roll| told(roll, view.chosen)).unwrap_or_default();
    let dragged = title_row(ui, titled.then_some("Roll editor"), &remark, |ui| {
        if link(ui, "fit").clicked() {
            view.canvas.fit();
        }
    });
    let (Some(roll), Some(set)) = (roll, document.content.roll_set()) else {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There is no roll to edit yet; see the problems.", colors));
        return dragged;
    };
    if view.roll != Some(roll.roll) {
        *view = EditorView { roll: Some(roll.roll), ..EditorView::default() };
    }
    let pending = view.draft.action(view.chosen).map(|action| RollEdit { id: free_id(set, roll.roll), action });
    let tried = pending.as_ref().map(|edit| {
        let edit = edit.scaled(document.unit.in_mm());
        edited(&roll.elements, std::slice::from_ref(&edit))
    });
    let preview = tried.as_ref().filter(|tried| tried.faults.is_empty()).map(|tried| tried.elements.as_slice());
    let fault = tried.as_ref().and_then(|tried| tried.faults.first()).map(|fault| fault.message.clone());
    ui.horizontal_top(|ui| {
        let room = ui.available_size();
        ui.allocate_ui(vec2((room.x - COLUMN - 12.0).max(120.0), room.y), |ui| {
            ui.set_opacity(if session.is_designed() { 1.0 } else { super::STALE });
            plot(ui, view, roll, preview, document.unit, requests);
        });
        ui.allocate_ui(vec2(COLUMN, room.y), |ui| {
            ui.vertical(|ui| {
                ui.set_width(COLUMN);
                reuse::show(ui, session, set, roll);
                let chosen = view.chosen;
                let apply = form::show(ui, &mut view.draft, chosen, document.unit, pending.is_some(), fault.as_deref());
                if let Some(edit) = pending.filter(|_| apply) {
                    add(session, roll.roll, edit);
                }
                ui.add_space(6.0);
                list::show(ui, session, roll);
            });
        });
    });
    dragged
}

/// The roll and what is chosen on it, in a few words.
fn told(roll: &Roll, chosen: Option<ElementName>) -> String {
    let short = roll.name.rsplit('-').next().unwrap_or(&roll.name);
    let number = chosen.and_then(|name| roll.elements.iter().rposition(|e| e.has(name)));
    match (chosen, number) {
        (Some(name), Some(index)) => {
            format!("{short} · element {} of {}, from {}", index + 1, roll.elements.len(), described(name))
        }
        _ => format!("{short} · {} elements · click one to choose it and the corner behind it", roll.elements.len()),
    }
}

fn plot(
    ui: &mut Ui,
    view: &mut EditorView,
    roll: &Roll,
    preview: Option<&[crate::rollform::roll::RollElement]>,
    unit: Unit,
    requests: &mut Requests,
) {
    let palette = Palette::of(ui.visuals());
    let scene = RollScene {
        elements: &roll.elements,
        designed: &roll.designed,
        preview,
        chosen: view.chosen,
        palette: &palette,
    };
    for event in roll_plot(ui, &mut view.canvas, &scene) {
        match event {
            RollPlotEvent::Clicked(index) => {
                let name = roll.elements.get(index).and_then(|e| e.names.last()).copied();
                if !view.draft.take_element(name) {
                    view.chosen = name;
                }
            }
            RollPlotEvent::At(p) => view.draft.take_point(p, unit),
            RollPlotEvent::Pointer(p) => {
                let in_mm = unit.in_mm();
                requests.place = requests.place.clone().or(Some(format!(
                    "z {}  ⌀ {} {}",
                    fixed(p.z / in_mm, unit.decimals()),
                    fixed(2.0 * p.r / in_mm, unit.decimals()),
                    unit.symbol()
                )));
            }
        }
    }
}

/// An id that no edit of a roll has.
fn free_id(set: &RollSet, roll: RollRef) -> u32 {
    let edits = set.roll(roll).map(|work| work.edits.as_slice()).unwrap_or_default();
    edits.iter().map(|edit| edit.id).max().map_or(1, |id| id.saturating_add(1))
}

fn add(session: &mut Session, roll: RollRef, edit: RollEdit) {
    session.edit("edit of a roll", None, |document| {
        if let Some(set) = super::set_mut(document) {
            set.roll_mut(roll).edits.push(edit);
        }
    });
}
