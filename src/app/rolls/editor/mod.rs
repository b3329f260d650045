//! The roll editor: the contour of one roll, an edit that is being prepared, and the list of edits made.

mod form;
mod list;
mod reuse;

use super::RollsViews;
use crate::app::desk::Requests;
use crate::app::plots::{CanvasView, Palette, RollPlotEvent, RollScene, fixed, roll_plot};
use crate::app::theme::{self, Colors};
use crate::app::widgets::{link, title_row, toggle};
use crate::document::{ElementName, Origin, RollEdit, RollKind, RollRef, RollSet};
use crate::rollform::Roll;
use crate::rollform::editor::{begin_own, decided, described, edited, twin_edit};
use crate::session::Session;
use crate::units::Unit;
use egui::{Ui, vec2};
use form::Draft;

/// Width of the column with form and list, points.
const COLUMN: f32 = 258.0;

/// What the panel keeps.
#[derive(Debug)]
pub(super) struct EditorView {
    canvas: CanvasView,
    roll: Option<RollRef>,
    chosen: Option<ElementName>,
    draft: Draft,
    /// Edits of a symmetrical section's rolls are made on both sides.
    both_sides: bool,
    /// What concerns the whole roll is shown in place of its edits.
    of_roll: bool,
}

impl Default for EditorView {
    fn default() -> Self {
        Self {
            canvas: CanvasView::default(),
            roll: None,
            chosen: None,
            draft: Draft::default(),
            both_sides: true,
            of_roll: false,
        }
    }
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
        toggle(ui, &mut view.of_roll, "contour and material")
            .on_hover_text("Where the contour comes from, and the material");
    });
    let (Some(roll), Some(set)) = (roll, document.content.roll_set()) else {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There is no roll to edit yet; see the problems.", colors));
        return dragged;
    };
    if view.roll != Some(roll.roll) {
        let (both_sides, of_roll) = (view.both_sides, view.of_roll);
        *view = EditorView { roll: Some(roll.roll), both_sides, of_roll, ..EditorView::default() };
    }
    let pending = view.draft.action(view.chosen).map(|action| RollEdit { id: free_id(set, roll.roll), action });
    let tried = pending.as_ref().map(|edit| {
        let edit = edit.scaled(document.unit.in_mm());
        edited(&roll.elements, std::slice::from_ref(&edit))
    });
    let preview = tried.as_ref().filter(|tried| tried.faults.is_empty()).map(|tried| tried.elements.as_slice());
    let twin = pending.as_ref().and_then(|edit| twin(set, roll, edit, document.unit));
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
                if view.of_roll {
                    return reuse::show(ui, session, set, roll, &requests.catalog);
                }
                egui::ScrollArea::vertical().id_salt("roll-edit").auto_shrink([false, false]).show(ui, |ui| {
                    let asked =
                        form::Asked { roll, unit: document.unit, ready: pending.is_some(), fault: fault.as_deref() };
                    let both = twin.is_some().then_some(&mut view.both_sides);
                    let apply = form::show(ui, &mut view.draft, &mut view.chosen, &asked, both);
                    if let Some(edit) = pending.filter(|_| apply) {
                        add(session, roll.roll, std::iter::once(edit).chain(twin.filter(|_| view.both_sides)));
                    }
                    ui.add_space(6.0);
                    list::show(ui, session, roll);
                });
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
            RollPlotEvent::At(p) => view.draft.take_point(p, unit, &roll.elements),
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
    decided(set, roll).edits.iter().map(|edit| edit.id).max().map_or(1, |id| id.saturating_add(1))
}

/// The same edit on the other side of a roll that lies across a symmetrical section; `None` if there is none.
fn twin(set: &RollSet, roll: &Roll, edit: &RollEdit, unit: Unit) -> Option<RollEdit> {
    let level = matches!(roll.roll.kind, RollKind::Top | RollKind::Bottom);
    let symmetrical = level && set.section.origin == Origin::Symmetrical;
    let twin = symmetrical.then(|| twin_edit(roll, &edit.scaled(unit.in_mm()), edit.id.saturating_add(1)))?;
    Some(twin?.scaled(1.0 / unit.in_mm()))
}

fn add(session: &mut Session, roll: RollRef, edits: impl Iterator<Item = RollEdit>) {
    session.edit("edit of a roll", None, |document| {
        if let Some(set) = super::set_mut(document) {
            begin_own(set, roll).edits.extend(edits);
        }
    });
}
