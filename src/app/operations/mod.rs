//! The operations of the clamping shown: in which order, with what, and how long they take.

mod edit;
mod inspect;
mod instruction;
mod line;
mod list;
mod pick;
mod planned;

use super::desk::Requests;
use super::plots::{TimeShare, time_bar};
use super::theme::{self, Colors};
use super::widgets::{clock, link, title_row};
use crate::document::Generator;
use crate::session::Session;
use edit::ListEdit;
use egui::{Align, Layout, Ui};
pub(crate) use inspect::show as inspect;
use line::Lines;
use pick::Pick;

/// What the panel keeps from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct OperationsView {
    lines: Lines,
    /// The elements of an instruction are being picked on the profile.
    pick: Option<Pick>,
    /// Give the keyboard to this line.
    take_focus: Option<usize>,
}

impl OperationsView {
    /// What the operation `index` is called at the head of the inspector.
    pub(crate) fn title(&self, index: usize) -> String {
        let mut lines = (1_usize..).zip(&self.lines.all);
        lines
            .find(|(_, line)| line.index == index)
            .map_or_else(String::new, |(number, _)| format!("Operation {number}"))
    }
}

/// Shows the panel; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    view: &mut OperationsView,
    session: &mut Session,
    requests: &mut Requests,
    titled: bool,
) -> bool {
    // A row of the table that is selected later takes the operation's place.
    if session.selection.section.is_some() {
        session.selection.operation = None;
    }
    let palette = Colors::of(ui.visuals()).plot;
    view.lines.update(session, &palette);
    let remark = view.lines.all.len().to_string();
    let mut wish = None;
    let dragged = title_row(ui, titled.then_some("Operations"), &remark, |ui| {
        if matches!(session.part().generator, Generator::Cycles { .. }) {
            wish = edit_links(ui, session.selection.operation);
        } else if planned::is_planned(session) {
            wish = planned::links(ui, session, session.selection.operation);
        }
    });
    egui::ScrollArea::vertical().id_salt("operations").auto_shrink([false, false]).show(ui, |ui| {
        if planned::is_planned(session) {
            planned::left_out(ui, session);
        }
        wish = list::show(ui, view, session, requests).or(wish);
        ui.add_space(8.0);
        times(ui, &view.lines);
    });
    if let Some(edit) = wish {
        apply(edit, view, session);
    }
    dragged
}

/// What can be done with the list of instructions.
fn edit_links(ui: &mut Ui, selected: Option<usize>) -> Option<ListEdit> {
    let mut wish = None;
    let mut offer = |ui: &mut Ui, text: &str, hint: &str, edit: Option<ListEdit>| {
        let clicked = ui.add_enabled_ui(edit.is_some(), |ui| link(ui, text).on_hover_text(hint).clicked()).inner;
        if clicked {
            wish = edit;
        }
    };
    offer(ui, "+ Add", "Add an operation after the selected one (Insert)", Some(ListEdit::Add(selected)));
    if selected.is_some() {
        offer(ui, "delete", "Take it out (Ctrl+Delete)", selected.map(ListEdit::Delete));
        offer(ui, "duplicate", "Put a copy behind it (Ctrl+D)", selected.map(ListEdit::Duplicate));
        offer(ui, "↓", "Move it down (Alt+↓)", selected.map(ListEdit::Down));
        offer(ui, "↑", "Move it up (Alt+↑)", selected.map(ListEdit::Up));
    }
    wish
}

fn apply(edit: ListEdit, view: &mut OperationsView, session: &mut Session) {
    if planned::is_planned(session) {
        planned::apply(edit, session);
        view.take_focus = session.selection.operation;
        return;
    }
    let mm = session.document().unit.in_mm();
    let mut selected = None;
    session.edit_part(&edit.label(), None, |part| selected = edit.apply(part, mm));
    if let Some(index) = selected {
        session.selection.section = None;
        session.selection.operation = Some(index);
        view.take_focus = Some(index);
    }
}

/// Where the time goes.
fn times(ui: &mut Ui, lines: &Lines) {
    let colors = Colors::of(ui.visuals());
    let mut shares: Vec<TimeShare> = lines
        .all
        .iter()
        .filter_map(|line| Some(TimeShare { name: line.name.clone(), color: line.color, time_s: line.time?.total_s() }))
        .collect();
    let rest = lines.rest.total_s();
    if rest > 0.0 {
        let color = colors.plot.operation(None);
        shares.push(TimeShare { name: "Start and end".to_owned(), color, time_s: rest });
    }
    if shares.is_empty() {
        return;
    }
    time_bar(ui, &shares, &colors.plot);
    let of_lines = lines.all.iter().filter_map(|line| line.time);
    let (cutting, other) = of_lines.fold((lines.rest.cutting_s, lines.rest.other_s), |(cutting, other), time| {
        (cutting + time.cutting_s, other + time.other_s)
    });
    ui.horizontal(|ui| {
        ui.label(theme::quiet(format!("cutting {}", clock(cutting)), colors));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.label(theme::quiet(format!("through air, tool changes {}", clock(other)), colors));
        });
    });
}
