//! What keyboard and clipboard do to the section table.

use super::{Cursor, Editing, SectionsView, cells, rows, tsv};
use crate::app::desk::Requests;
use crate::diagnostic::Column;
use crate::part::Section;
use crate::session::Session;
use egui::{Event, Key, Modifiers, Ui};

/// Does what was typed while the table has the keyboard and no cell is being edited.
pub(crate) fn handle(
    ui: &Ui,
    view: &mut SectionsView,
    session: &mut Session,
    requests: &mut Requests,
    columns: &[Column],
) {
    for event in ui.input(|i| i.events.clone()) {
        match event {
            // The cell was opened earlier in this frame: what follows in it belongs to the cell.
            Event::Text(text) if view.editing.is_some() => {
                view.editing.get_or_insert_default().text.push_str(&text);
            }
            Event::Key { key: Key::Enter | Key::Tab, pressed: true, modifiers, .. } if view.editing.is_some() => {
                commit(view, session, columns);
                step(view, session, if modifiers.shift { -1 } else { 1 }, 0, false);
            }
            _ if view.editing.is_some() => {}
            Event::Key { key, pressed: true, modifiers, .. } => {
                key_press(view, session, columns, key, modifiers);
            }
            Event::Text(text) if !text.chars().all(char::is_whitespace) => {
                begin_edit(view, session, columns, Some(text));
            }
            Event::Copy => copy(ui, view, session),
            Event::Cut => {
                copy(ui, view, session);
                delete(view, session);
            }
            Event::Paste(text) => paste(view, session, requests, columns, &text),
            _ => {}
        }
    }
    tell(view, session, columns);
}

fn key_press(view: &mut SectionsView, session: &mut Session, columns: &[Column], key: Key, modifiers: Modifiers) {
    let count = session.part().table(view.table).len();
    match key {
        Key::ArrowUp | Key::ArrowDown if modifiers.alt => shift(view, session, key == Key::ArrowDown),
        Key::ArrowUp => step(view, session, -1, 0, modifiers.shift),
        Key::ArrowDown => step(view, session, 1, 0, modifiers.shift),
        Key::ArrowLeft => step(view, session, 0, -1, false),
        Key::ArrowRight => step(view, session, 0, 1, false),
        Key::Enter => step(view, session, if modifiers.shift { -1 } else { 1 }, 0, false),
        Key::Tab => step_cell(view, session, columns, !modifiers.shift),
        Key::Home => place(view, session, if modifiers.command { 0 } else { view.cursor.row }, 0, false),
        Key::End if modifiers.command => place(view, session, count.saturating_sub(1), view.cursor.column, false),
        Key::End => place(view, session, view.cursor.row, columns.len().saturating_sub(1), false),
        Key::F2 => begin_edit(view, session, columns, None),
        Key::Insert => insert(view, session),
        Key::D if modifiers.command => duplicate(view, session),
        Key::A if modifiers.command => {
            view.cursor = Cursor { row: 0, column: 0, other_row: count.saturating_sub(1), whole_rows: true };
        }
        Key::Delete | Key::Backspace if view.cursor.whole_rows || modifiers.command => delete(view, session),
        Key::Delete | Key::Backspace => begin_edit(view, session, columns, Some(String::new())),
        _ => {}
    }
}

/// Moves the cursor by rows and columns, staying inside the table.
pub(crate) fn step(view: &mut SectionsView, session: &mut Session, down: isize, right: isize, extend: bool) {
    let columns = cells::columns(session.part().table(view.table)).len();
    let row = view.cursor.row.saturating_add_signed(down);
    let column = view.cursor.column.saturating_add_signed(right).min(columns.saturating_sub(1));
    place(view, session, row, column, extend);
}

/// Moves the cursor to the next cell that has a value, over the ends of rows.
pub(crate) fn step_cell(view: &mut SectionsView, session: &mut Session, columns: &[Column], forward: bool) {
    let sections = session.part().table(view.table);
    let width = columns.len();
    let all = sections.len() * width;
    let has_value = |index: usize| {
        let cell = sections.get(index / width).zip(columns.get(index % width));
        cell.is_some_and(|(s, c)| *c == Column::Kind || cells::get(s, *c).is_some())
    };
    let here = view.cursor.row * width + view.cursor.column;
    let next = if forward {
        (here + 1..all).find(|i| has_value(*i))
    } else {
        (0..here.min(all)).rev().find(|i| has_value(*i))
    };
    if let Some(next) = next {
        place(view, session, next / width, next % width, false);
    }
}

/// Puts the cursor on a cell and selects its row everywhere.
pub(crate) fn place(view: &mut SectionsView, session: &mut Session, row: usize, column: usize, extend: bool) {
    let row = row.min(session.part().table(view.table).len().saturating_sub(1));
    let other_row = if extend { view.cursor.other_row } else { row };
    view.cursor = Cursor { row, column, other_row, whole_rows: view.cursor.whole_rows && extend };
    view.reveal = true;
    session.selection.section = session.part().table(view.table).get(row).map(|s| s.id);
}

/// Opens the cell under the cursor with `text`, or with what is in it.
pub(crate) fn begin_edit(view: &mut SectionsView, session: &mut Session, columns: &[Column], text: Option<String>) {
    let cell = session.part().table(view.table).get(view.cursor.row).zip(columns.get(view.cursor.column));
    let Some((section, column)) = cell else { return };
    if *column != Column::Kind && cells::get(section, *column).is_none() {
        return;
    }
    let kept = view.bad.get(&(section.id, view.cursor.column)).map(|(text, _)| text.clone());
    let before = cells::text(section, *column, session.document().unit);
    let text = text.or(kept).unwrap_or_else(|| before.clone());
    view.editing = Some(Editing { text, told: before.clone(), before, wrong: None });
    session.begin_typing();
}

/// Puts the text of the edited cell into the document as far as it is typed. A type takes effect only when the cell is
/// left, because every letter of its name would make another one.
pub(crate) fn tell(view: &mut SectionsView, session: &mut Session, columns: &[Column]) {
    let (row, index) = (view.cursor.row, view.cursor.column);
    let Some(editing) = view.editing.as_mut().filter(|e| e.text != e.told) else { return };
    editing.told.clone_from(&editing.text);
    editing.wrong = None;
    let cell = session.part().table(view.table).get(row).cloned().zip(columns.get(index).copied());
    let Some((mut section, column)) = cell.filter(|(_, column)| *column != Column::Kind) else { return };
    if editing.text == editing.before {
        return session.take_back_typing();
    }
    match cells::set(&mut section, column, &editing.text, session.document().unit) {
        Ok(()) => type_row(session, row, column, section),
        Err(reason) => {
            editing.wrong = Some(reason);
            session.take_back_typing();
        }
    }
}

fn type_row(session: &mut Session, row: usize, column: Column, section: Section) {
    let table = session.part().row(section.id).map(|(table, ..)| table).unwrap_or_default();
    let label = format!("{column} of {}", cells::row_name(table, row, &section));
    session.type_in_part(&label, |part| {
        if let Some(old) = part.row_mut(section.id) {
            *old = section;
        }
    });
}

/// Ends the editing of a cell; a text that does not fit stays there, marked, and the value is the one before.
pub(crate) fn commit(view: &mut SectionsView, session: &mut Session, columns: &[Column]) {
    tell(view, session, columns);
    let Some(editing) = view.editing.take() else { return };
    let cell =
        session.part().table(view.table).get(view.cursor.row).cloned().zip(columns.get(view.cursor.column).copied());
    if let Some((mut section, column)) = cell {
        let key = (section.id, view.cursor.column);
        view.bad.remove(&key);
        let mut wrong = editing.wrong;
        if column == Column::Kind && editing.text != editing.before {
            match cells::set(&mut section, column, &editing.text, session.document().unit) {
                Ok(()) => type_row(session, view.cursor.row, column, section),
                Err(reason) => wrong = Some(reason),
            }
        }
        if let Some(reason) = wrong {
            view.bad.insert(key, (editing.text, reason));
        }
    }
    session.end_typing();
}

/// Ends the editing of a cell; everything is as before.
pub(crate) fn give_up(view: &mut SectionsView, session: &mut Session) {
    view.editing = None;
    session.give_up_typing();
    if let Some(section) = session.part().table(view.table).get(view.cursor.row) {
        view.bad.remove(&(section.id, view.cursor.column));
    }
}

/// Puts an edited row in the place of the old one.
pub(crate) fn replace(session: &mut Session, label: &str, row: Section) {
    session.edit_part(label, None, |part| {
        if let Some(old) = part.row_mut(row.id) {
            *old = row;
        }
    });
}

/// Inserts a row above the cursor.
pub(crate) fn insert(view: &mut SectionsView, session: &mut Session) {
    let (at, table) = (view.cursor.row, view.table);
    session.edit_part("insert a row", None, |part| {
        rows::insert(part, table, at);
    });
    place(view, session, at, view.cursor.column, false);
}

/// Deletes the selected rows.
pub(crate) fn delete(view: &mut SectionsView, session: &mut Session) {
    let (rows, table) = (view.cursor.rows(), view.table);
    let label = if rows.clone().count() > 1 { "delete rows" } else { "delete a row" };
    session.edit_part(label, None, |part| rows::delete(part.table_mut(table), &rows));
    place(view, session, *rows.start(), view.cursor.column, false);
}

/// Puts a copy of the selected rows after them.
pub(crate) fn duplicate(view: &mut SectionsView, session: &mut Session) {
    let (rows, table) = (view.cursor.rows(), view.table);
    session.edit_part("duplicate rows", None, |part| rows::duplicate(part, table, &rows));
    place(view, session, rows.end() + 1, view.cursor.column, false);
}

/// Moves the selected rows by one place.
pub(crate) fn shift(view: &mut SectionsView, session: &mut Session, down: bool) {
    let (rows, table) = (view.cursor.rows(), view.table);
    let mut moved = false;
    session.edit_part("move rows", None, |part| moved = rows::shift(part.table_mut(table), &rows, down));
    if moved {
        let by = |row: usize| if down { row + 1 } else { row.saturating_sub(1) };
        view.cursor.row = by(view.cursor.row);
        view.cursor.other_row = by(view.cursor.other_row);
        view.reveal = true;
    }
}

/// Puts the selected rows on the clipboard.
pub(crate) fn copy(ui: &Ui, view: &SectionsView, session: &Session) {
    let rows = view.cursor.rows();
    let sections = session.part().table(view.table);
    if let Some(rows) = sections.get(*rows.start()..(rows.end() + 1).min(sections.len())) {
        ui.copy_text(crate::storage::export::tsv(rows));
    }
}

fn paste(view: &mut SectionsView, session: &mut Session, requests: &mut Requests, columns: &[Column], text: &str) {
    let unit = session.document().unit;
    let (row, table) = (view.cursor.row, view.table);
    let column = columns.get(view.cursor.column).copied().unwrap_or(Column::Kind);
    let mut outcome = Ok(0);
    session.edit_part("paste rows", None, |part| outcome = tsv::paste(part, table, row, column, text, unit));
    match outcome {
        Ok(count) => {
            let last = (row + count).saturating_sub(1);
            place(view, session, row, view.cursor.column, false);
            view.cursor.other_row = last;
        }
        Err(reason) => requests.complain(format!("Nothing was pasted. {reason}")),
    }
}
