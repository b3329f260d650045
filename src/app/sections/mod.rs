//! The panel with the section table and the stock.

pub(crate) mod cells;
mod generator;
mod icon;
mod keys;
mod rows;
mod stock;
mod table;
pub(crate) mod tsv;

use super::desk::Requests;
use super::widgets::{link, title_row, toggle};
use crate::diagnostic::{Column, SectionTable};
use crate::session::Session;
use egui::Ui;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Height kept for the stock under the table, points.
const BELOW: f32 = 190.0;
/// Least height of the table, points.
const LEAST: f32 = 140.0;

/// What the table keeps from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct SectionsView {
    /// The table that is shown.
    table: SectionTable,
    cursor: Cursor,
    /// The cell under the cursor is being edited.
    editing: Option<Editing>,
    /// Texts that did not fit their cell, with the reason, by row id and column number.
    bad: BTreeMap<(u32, usize), (String, String)>,
    /// Scroll so that the cursor is seen.
    reveal: bool,
    /// Give the keyboard to the table.
    take_focus: bool,
}

/// What is typed into a cell.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Editing {
    text: String,
    /// What the cell showed before.
    before: String,
    /// The text that the document has been told of.
    told: String,
    /// Why the text does not fit the cell.
    wrong: Option<String>,
}

/// The cell with the frame, and the other end of a selection of rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Cursor {
    row: usize,
    column: usize,
    other_row: usize,
    /// Whole rows are selected, not cells.
    whole_rows: bool,
}

impl Cursor {
    fn rows(self) -> RangeInclusive<usize> {
        self.row.min(self.other_row)..=self.row.max(self.other_row)
    }
}

impl SectionsView {
    /// Puts the cursor on a cell, as when a message about it is clicked.
    pub(crate) fn go_to(&mut self, session: &Session, id: u32, column: Option<Column>) {
        let Some((table, row, _)) = session.part().row(id) else { return };
        self.table = table;
        let columns = cells::columns(session.part().table(table));
        let column = column.and_then(|c| columns.iter().position(|other| *other == c)).unwrap_or(0);
        self.cursor = Cursor { row, column, other_row: row, whole_rows: false };
        self.reveal = true;
        self.take_focus = true;
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
    table::show(ui, view, session, requests, height);
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
            keys::commit(view, session, &cells::columns(session.part().table(view.table)));
            view.table = table;
            view.cursor = Cursor::default();
            session.selection.section = session.part().table(table).first().map(|s| s.id);
        }
    }
}

fn add_row(view: &mut SectionsView, session: &mut Session) {
    let table = view.table;
    let at = session.part().table(table).len();
    let mut id = 0;
    session.edit_part("add a row", None, |part| id = rows::insert(part, table, at));
    session.selection.section = Some(id);
    view.cursor = Cursor { row: at, column: 1, other_row: at, whole_rows: false };
    view.reveal = true;
    view.take_focus = true;
}
