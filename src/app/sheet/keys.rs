//! What keyboard and clipboard do to a table.

use super::{Change, Cursor, Editing, Sheet, SheetView, Takes};
use crate::app::desk::Requests;
use crate::document::Document;
use crate::session::Session;
use egui::{Event, Key, Modifiers, Ui};

/// Does what was typed while the table has the keyboard and no cell is being edited.
pub(super) fn handle(ui: &Ui, sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session, requests: &mut Requests) {
    for event in ui.input(|i| i.events.clone()) {
        match event {
            // The cell was opened earlier in this frame: what follows in it belongs to the cell.
            Event::Text(text) if view.editing.is_some() => view.editing.get_or_insert_default().text.push_str(&text),
            Event::Key { key: Key::Enter | Key::Tab, pressed: true, modifiers, .. } if view.editing.is_some() => {
                commit(sheet, view, session);
                step(sheet, view, session, if modifiers.shift { -1 } else { 1 }, 0, false);
            }
            _ if view.editing.is_some() => {}
            Event::Key { key, pressed: true, modifiers, .. } => press(sheet, view, session, key, modifiers),
            Event::Text(text) if !text.chars().all(char::is_whitespace) => begin(sheet, view, session, Some(text)),
            Event::Copy => copy(ui, sheet, view),
            Event::Cut => {
                copy(ui, sheet, view);
                delete(sheet, view, session);
            }
            Event::Paste(text) => paste(sheet, view, session, requests, &text),
            _ => {}
        }
    }
    tell(sheet, view, session);
}

fn press(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session, key: Key, modifiers: Modifiers) {
    let (last, columns) = (sheet.rows().saturating_sub(1), sheet.headings().len());
    match key {
        Key::ArrowUp | Key::ArrowDown if modifiers.alt => shift(sheet, view, session, key == Key::ArrowDown),
        Key::ArrowUp => step(sheet, view, session, -1, 0, modifiers.shift),
        Key::ArrowDown => step(sheet, view, session, 1, 0, modifiers.shift),
        Key::ArrowLeft => step(sheet, view, session, 0, -1, false),
        Key::ArrowRight => step(sheet, view, session, 0, 1, false),
        Key::Enter => step(sheet, view, session, if modifiers.shift { -1 } else { 1 }, 0, false),
        Key::Tab => step_cell(sheet, view, session, !modifiers.shift),
        Key::Home => place(sheet, view, session, if modifiers.command { 0 } else { view.cursor.row }, 0, false),
        Key::End if modifiers.command => place(sheet, view, session, last, view.cursor.column, false),
        Key::End => place(sheet, view, session, view.cursor.row, columns.saturating_sub(1), false),
        Key::F2 => begin(sheet, view, session, None),
        Key::Insert => insert(sheet, view, session),
        Key::D if modifiers.command => duplicate(sheet, view, session),
        Key::A if modifiers.command => view.cursor = Cursor { row: 0, column: 0, other_row: last, whole_rows: true },
        Key::Delete | Key::Backspace if view.cursor.whole_rows || modifiers.command => delete(sheet, view, session),
        Key::Delete | Key::Backspace => begin(sheet, view, session, Some(String::new())),
        _ => {}
    }
}

/// Moves the cursor by rows and columns, staying inside the table.
pub(super) fn step(
    sheet: &dyn Sheet,
    view: &mut SheetView,
    session: &mut Session,
    down: isize,
    right: isize,
    extend: bool,
) {
    let row = view.cursor.row.saturating_add_signed(down);
    let column = view.cursor.column.saturating_add_signed(right);
    place(sheet, view, session, row, column, extend);
}

/// Moves the cursor to the next cell that can be changed, over the ends of rows.
pub(super) fn step_cell(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session, forward: bool) {
    let width = sheet.headings().len().max(1);
    let all = sheet.rows() * width;
    let takes = |index: &usize| sheet.cell(index / width, index % width).takes != Takes::Nothing;
    let here = view.cursor.row * width + view.cursor.column;
    let next = if forward { (here + 1..all).find(takes) } else { (0..here.min(all)).rev().find(takes) };
    if let Some(next) = next {
        place(sheet, view, session, next / width, next % width, false);
    }
}

/// Puts the cursor on a cell and selects its row everywhere.
pub(super) fn place(
    sheet: &dyn Sheet,
    view: &mut SheetView,
    session: &mut Session,
    row: usize,
    column: usize,
    extend: bool,
) {
    let row = row.min(sheet.rows().saturating_sub(1));
    let column = column.min(sheet.headings().len().saturating_sub(1));
    let other_row = if extend { view.cursor.other_row } else { row };
    view.cursor = Cursor { row, column, other_row, whole_rows: view.cursor.whole_rows && extend };
    view.reveal = true;
    sheet.select(session, row, column);
}

/// Opens the cell under the cursor with `text`, or with what is in it.
pub(super) fn begin(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session, text: Option<String>) {
    let Cursor { row, column, .. } = view.cursor;
    if row >= sheet.rows() {
        return;
    }
    let cell = sheet.cell(row, column);
    if cell.takes == Takes::Nothing {
        return;
    }
    let kept = view.bad.get(&(sheet.key(row), column)).map(|(text, _)| text.clone());
    let text = text.or(kept).unwrap_or_else(|| cell.text.clone());
    view.editing = Some(Editing { text, told: cell.text.clone(), before: cell.text, wrong: None });
    session.begin_typing();
}

/// Puts the text of the edited cell into the document as far as it is typed. A word takes effect only when the cell is left.
pub(super) fn tell(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session) {
    let Cursor { row, column, .. } = view.cursor;
    let Some(editing) = view.editing.as_mut().filter(|e| e.text != e.told) else { return };
    editing.told.clone_from(&editing.text);
    editing.wrong = None;
    if matches!(sheet.cell(row, column).takes, Takes::Words(_)) {
        return;
    }
    if editing.text == editing.before {
        return session.take_back_typing();
    }
    editing.wrong = write(sheet, session, row, column, &editing.text).err();
    if editing.wrong.is_some() {
        session.take_back_typing();
    }
}

fn write(sheet: &dyn Sheet, session: &mut Session, row: usize, column: usize, text: &str) -> Result<(), String> {
    let mut outcome = Ok(());
    session.type_in(&label(sheet, row, column), |document| outcome = sheet.write(document, row, column, text));
    outcome
}

/// What a change of a cell is called in the history.
fn label(sheet: &dyn Sheet, row: usize, column: usize) -> String {
    let title = sheet.headings().get(column).map(|heading| heading.title.clone()).unwrap_or_default();
    format!("{title} of {}", sheet.row_label(row))
}

/// Ends the editing of a cell; a text that does not fit stays there, marked, and the value is the one before.
pub(crate) fn commit(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session) {
    tell(sheet, view, session);
    let Some(editing) = view.editing.take() else { return };
    let Cursor { row, column, .. } = view.cursor;
    view.bad.remove(&(sheet.key(row), column));
    let mut wrong = editing.wrong;
    if matches!(sheet.cell(row, column).takes, Takes::Words(_)) && editing.text != editing.before {
        wrong = write(sheet, session, row, column, &editing.text).err();
    }
    if let Some(reason) = wrong {
        view.bad.insert((sheet.key(row), column), (editing.text, reason));
    }
    session.end_typing();
}

/// Ends the editing of a cell; everything is as before.
pub(super) fn give_up(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session) {
    view.editing = None;
    session.give_up_typing();
    view.bad.remove(&(sheet.key(view.cursor.row), view.cursor.column));
}

/// Chooses a word of a cell.
pub(super) fn choose(sheet: &dyn Sheet, session: &mut Session, row: usize, column: usize, word: &str) {
    session.edit(&label(sheet, row, column), None, |document| {
        let _ = sheet.write(document, row, column, word);
    });
}

fn change(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session, label: &str, change: &Change) -> bool {
    let mut done = false;
    session.edit(label, None, |document| done = sheet.change(document, change));
    if done {
        view.bad.clear();
    }
    done
}

/// Puts the cursor on a row that the table will have in the next frame.
fn put(view: &mut SheetView, row: usize) {
    view.cursor = Cursor { row, other_row: row, whole_rows: false, ..view.cursor };
    view.settle = true;
    view.reveal = true;
}

/// Inserts a row above the cursor.
pub(super) fn insert(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session) {
    let row = view.cursor.row;
    if change(sheet, view, session, "insert a row", &Change::Insert(row)) {
        put(view, row);
    }
}

/// Deletes the selected rows.
pub(super) fn delete(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session) {
    let rows = view.cursor.rows();
    let label = if rows.clone().count() > 1 { "delete rows" } else { "delete a row" };
    if change(sheet, view, session, label, &Change::Delete(rows.clone())) {
        put(view, *rows.start());
    }
}

/// Puts a copy of the selected rows after them.
pub(super) fn duplicate(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session) {
    let rows = view.cursor.rows();
    if change(sheet, view, session, "duplicate rows", &Change::Duplicate(rows.clone())) {
        put(view, rows.end() + 1);
    }
}

/// Moves the selected rows by one place.
pub(super) fn shift(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session, down: bool) {
    let rows = view.cursor.rows();
    if change(sheet, view, session, "move rows", &Change::Move { rows, down }) {
        let by = |row: usize| if down { row + 1 } else { row.saturating_sub(1) };
        view.cursor = Cursor { row: by(view.cursor.row), other_row: by(view.cursor.other_row), ..view.cursor };
        view.followed = Some(view.cursor.row);
        view.reveal = true;
    }
}

/// Puts the selected rows on the clipboard, a tab between cells.
pub(super) fn copy(ui: &Ui, sheet: &dyn Sheet, view: &SheetView) {
    if let Some(text) = sheet.copied(&view.cursor.rows()) {
        return ui.copy_text(text);
    }
    let columns = sheet.headings().len();
    let line = |row| (0..columns).map(|column| sheet.cell(row, column).text).collect::<Vec<_>>().join("\t");
    let rows: Vec<String> = view.cursor.rows().filter(|row| *row < sheet.rows()).map(line).collect();
    ui.copy_text(rows.join("\n"));
}

/// Writes cells from the cursor on, to the right and down; cells that follow from others are passed over. All or nothing.
fn paste(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session, requests: &mut Requests, text: &str) {
    let Cursor { row, column, .. } = view.cursor;
    let mut outcome = Ok(0);
    session.edit("paste rows", None, |document| {
        outcome = sheet
            .paste(document, (row, column), text)
            .unwrap_or_else(|| by_cells(sheet, document, (row, column), text));
    });
    match outcome {
        Ok(count) => {
            put(view, row);
            view.cursor.other_row = (row + count).saturating_sub(1).max(row);
        }
        Err(reason) => requests.complain(format!("Nothing was pasted. {reason}")),
    }
}

/// Writes cell by cell; the document is as before if a text does not fit.
fn by_cells(
    sheet: &dyn Sheet,
    document: &mut Document,
    (top, left): (usize, usize),
    text: &str,
) -> Result<usize, String> {
    let mut edited = document.clone();
    let mut count = 0;
    for (row, line) in (top..sheet.rows()).zip(text.lines()) {
        for (column, text) in (left..sheet.headings().len()).zip(line.split('\t')) {
            if sheet.cell(row, column).takes != Takes::Nothing && !text.trim().is_empty() {
                sheet.write(&mut edited, row, column, text.trim())?;
            }
        }
        count += 1;
    }
    *document = edited;
    Ok(count)
}
