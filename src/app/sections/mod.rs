//! The panel with the section table and the stock.

pub(crate) mod cells;
mod generator;
mod icon;
mod rows;
mod sheet;
mod stock;
pub(crate) mod tsv;

use super::desk::Requests;
use super::sheet::{self as app_sheet, SheetView};
use super::widgets::{link, title_row, toggle};
use crate::diagnostic::{Column, SectionTable};
use crate::session::Session;
use egui::Ui;

/// Height kept for the stock under the table, points.
const BELOW: f32 = 190.0;
/// Least height of the table, points.
const LEAST: f32 = 140.0;

/// What the table keeps from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct SectionsView {
    /// The table that is shown.
    table: SectionTable,
    sheet: SheetView,
}

impl SectionsView {
    /// Puts the cursor on a cell, as when a message about it is clicked.
    pub(crate) fn go_to(&mut self, session: &Session, id: u32, column: Option<Column>) {
        let Some((table, row, _)) = session.part().row(id) else { return };
        self.table = table;
        let columns = cells::columns(session.part().table(table));
        let column = column.and_then(|c| columns.iter().position(|other| *other == c)).unwrap_or(0);
        self.sheet.go_to(row, column);
    }

    /// Shows the table that the selected row is in.
    fn follow(&mut self, session: &Session) {
        let selected = session.selection.section.filter(|_| !self.sheet.is_editing());
        if let Some((table, ..)) = selected.and_then(|id| session.part().row(id)) {
            self.table = table;
        }
    }
}

/// Shows the panel; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    view: &mut SectionsView,
    session: &mut Session,
    requests: &mut Requests,
    titled: bool,
) -> bool {
    let count = session.part().table(view.table).len();
    let mut add = false;
    let dragged = title_row(ui, titled.then_some("Sections"), &count.to_string(), |ui| {
        add = link(ui, "+ Add").on_hover_text("Add a row at the end (Insert adds one above the cursor)").clicked();
        table_choice(ui, view, session);
    });
    if add {
        add_row(view, session);
    }
    let height = (ui.available_height() - BELOW).max(LEAST);
    view.follow(session);
    let rows = sheet::Rows::of(session, view.table);
    app_sheet::show(ui, &rows, &mut view.sheet, session, requests, height);
    egui::ScrollArea::vertical().id_salt("below-table").auto_shrink([false, false]).show(ui, |ui| {
        ui.add_space(10.0);
        stock::show(ui, session, requests);
    });
    dragged
}

/// Outside or bore; the words stand from right to left.
fn table_choice(ui: &mut Ui, view: &mut SectionsView, session: &mut Session) {
    ui.add_space(8.0);
    for (table, name) in [(SectionTable::Bore, "bore"), (SectionTable::Outside, "outside")] {
        let mut on = view.table == table;
        if toggle(ui, &mut on, name).clicked() && view.table != table {
            app_sheet::leave(&sheet::Rows::of(session, view.table), &mut view.sheet, session);
            *view = SectionsView { table, ..SectionsView::default() };
            session.selection.section = session.part().table(table).first().map(|s| s.id);
        }
    }
}

fn add_row(view: &mut SectionsView, session: &mut Session) {
    let table = view.table;
    let at = session.part().table(table).len();
    session.edit_part("add a row", None, |part| _ = rows::insert(part, table, at));
    view.sheet.go_to(at, 1);
}
