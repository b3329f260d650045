//! The section table: rows, cells, the cursor and the cell that is being edited.

use super::{Cursor, Editing, SectionsView, cells, icon, keys};
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::diagnostic::{Column, Place, Severity};
use crate::part::Section;
use crate::session::{Hovered, Session};
use egui::{Align2, EventFilter, FontId, Id, Key, Modifiers, Rect, Response, Sense, Stroke, StrokeKind, Ui, vec2};

/// Width of the row numbers, points.
const NUMBERS: f32 = 26.0;
/// Width of the section type, points.
const KIND: f32 = 96.0;
/// Least width of a figure, points.
const FIGURE: f32 = 55.0;

/// One frame of the table.
struct Frame<'a> {
    colors: &'static Colors,
    columns: &'a [Column],
    /// Left edge of each column and the right edge of the last.
    edges: Vec<f32>,
    focused: bool,
    id: Id,
}

/// Shows the table in at most `height`.
pub(crate) fn show(ui: &mut Ui, view: &mut SectionsView, session: &mut Session, requests: &mut Requests, height: f32) {
    keep_cursor_inside(view, session);
    let columns = cells::columns(session.part().table(view.table));
    view.cursor.column = view.cursor.column.min(columns.len().saturating_sub(1));
    let id = ui.make_persistent_id("section-table");
    if std::mem::take(&mut view.take_focus) {
        ui.memory_mut(|m| m.request_focus(id));
    }
    let area = egui::ScrollArea::both().id_salt("table").max_height(height).auto_shrink([false, true]);
    area.show(ui, |ui| {
        let edges = edges(ui.available_width(), &columns);
        let width = edges.last().copied().unwrap_or(0.0);
        let rows = session.part().table(view.table).len();
        let size = vec2(width, theme::ROW * (count(rows) + 1.0));
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let focused = grab_keyboard(ui, id, rect, view, session);
        let frame = Frame { colors: Colors::of(ui.visuals()), columns: &columns, edges, focused, id };
        if focused && view.editing.is_none() {
            keys::handle(ui, view, session, requests, &columns);
        }
        frame.rows(ui, rect, view, session, requests);
        frame.header(ui, rect);
    });
}

fn count(rows: usize) -> f32 {
    rows as f32
}

/// Puts the cursor on the selected row, whichever table it is in.
fn keep_cursor_inside(view: &mut SectionsView, session: &Session) {
    let at_cursor = session.part().table(view.table).get(view.cursor.row).map(|s| s.id);
    let selected = session.selection.section.filter(|id| Some(*id) != at_cursor && view.editing.is_none());
    if let Some((table, row, _)) = selected.and_then(|id| session.part().row(id)) {
        view.table = table;
        view.cursor = Cursor { row, other_row: row, whole_rows: false, ..view.cursor };
        view.reveal = true;
    }
    let last = session.part().table(view.table).len().saturating_sub(1);
    view.cursor.row = view.cursor.row.min(last);
    view.cursor.other_row = view.cursor.other_row.min(last);
}

fn edges(room: f32, columns: &[Column]) -> Vec<f32> {
    let figures = count(columns.len().saturating_sub(1)).max(1.0);
    let width = ((room - NUMBERS - KIND) / figures).max(FIGURE);
    let mut edges = vec![NUMBERS, NUMBERS + KIND];
    edges.extend((1..columns.len()).map(|i| NUMBERS + KIND + width * count(i)));
    edges
}

/// Makes the table a widget that takes arrows, Tab and Escape for itself; true if it has the keyboard.
fn grab_keyboard(ui: &Ui, id: Id, rect: Rect, view: &SectionsView, session: &Session) -> bool {
    let response = ui.interact(rect, id, Sense::focusable_noninteractive());
    response.widget_info(|| {
        let row = view.cursor.row + 1;
        let of = session.part().table(view.table).len();
        let of_bore = if view.table.is_outside() { "" } else { " of the bore" };
        egui::WidgetInfo::labeled(egui::Role::Table, true, format!("Section table{of_bore}, row {row} of {of}"))
    });
    let filter = EventFilter { tab: true, horizontal_arrows: true, vertical_arrows: true, escape: false };
    ui.memory_mut(|m| m.set_focus_lock_filter(id, filter));
    response.has_focus()
}

impl Frame<'_> {
    fn row_rect(&self, table: Rect, row: usize) -> Rect {
        let top = table.top() + theme::ROW * (count(row) + 1.0);
        let width = self.edges.last().copied().unwrap_or(0.0);
        Rect::from_min_size(egui::pos2(table.left(), top), vec2(width, theme::ROW))
    }

    fn cell_rect(&self, row: Rect, column: usize) -> Rect {
        let edge = |i: usize| self.edges.get(i).copied().unwrap_or(0.0);
        Rect::from_x_y_ranges(row.left() + edge(column)..=row.left() + edge(column + 1), row.y_range())
    }

    fn header(&self, ui: &Ui, table: Rect) {
        let top = ui.clip_rect().top().max(table.top());
        let row = Rect::from_min_size(egui::pos2(table.left(), top), vec2(table.width(), theme::ROW));
        ui.painter().rect_filled(row, 0.0, self.colors.panel);
        ui.painter().hline(row.x_range(), row.bottom(), Stroke::new(1.0, self.colors.line));
        for (index, column) in self.columns.iter().enumerate() {
            let cell = self.cell_rect(row, index).shrink2(vec2(6.0, 0.0));
            let (align, at) = match column {
                Column::Kind => (Align2::LEFT_CENTER, cell.left_center()),
                _ => (Align2::RIGHT_CENTER, cell.right_center()),
            };
            ui.painter().text(at, align, column.to_string(), FontId::proportional(theme::TEXT), self.colors.plot.quiet);
        }
    }

    fn rows(&self, ui: &mut Ui, table: Rect, view: &mut SectionsView, session: &mut Session, requests: &mut Requests) {
        if view.editing.is_some() {
            end_edit_by_key(ui, view, session, self);
        }
        let clip = ui.clip_rect();
        for row in 0..session.part().table(view.table).len() {
            let rect = self.row_rect(table, row);
            if view.reveal && row == view.cursor.row {
                let cell = self.cell_rect(rect, view.cursor.column).expand2(vec2(0.0, theme::ROW));
                ui.scroll_to_rect(cell, None);
                view.reveal = false;
            }
            if rect.intersects(clip) {
                self.row(ui, rect, row, view, session, requests);
            }
        }
    }

    fn row(
        &self,
        ui: &mut Ui,
        rect: Rect,
        row: usize,
        view: &mut SectionsView,
        session: &mut Session,
        requests: &mut Requests,
    ) {
        let Some(section) = session.part().table(view.table).get(row).cloned() else { return };
        if ui.rect_contains_pointer(rect) {
            requests.hovered = Some(Hovered::Section(section.id));
        }
        self.paint_row(ui, rect, row, &section, view, session);
        let number = Rect::from_min_max(rect.min, egui::pos2(rect.left() + NUMBERS, rect.bottom()));
        let response = ui.interact(number, self.id.with(("number", section.id)), Sense::click());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Row {}", row + 1)));
        if response.clicked() || response.secondary_clicked() {
            self.pick(ui, view, session, row, 0, response.secondary_clicked());
            view.cursor.whole_rows = true;
        }
        context_menu(&response, view, session);
        for column in 0..self.columns.len() {
            self.cell(ui, rect, row, column, &section, view, session);
        }
    }

    fn paint_row(&self, ui: &Ui, rect: Rect, row: usize, section: &Section, view: &SectionsView, session: &Session) {
        let painter = ui.painter();
        let selected = session.selection.section == Some(section.id);
        let in_range = view.cursor.rows().count() > 1 && view.cursor.rows().contains(&row);
        if selected || in_range {
            painter.rect_filled(rect, 0.0, self.colors.selected);
        } else if session.lit().sections.contains(&section.id) {
            painter.rect_filled(rect, 0.0, self.colors.hovered);
        }
        if selected {
            let mark = Rect::from_min_size(rect.min, vec2(3.0, rect.height()));
            painter.rect_filled(mark, 0.0, self.colors.plot.accent);
        }
        painter.hline(rect.x_range(), rect.bottom(), Stroke::new(1.0, self.colors.line.gamma_multiply(0.7)));
        let (font, color) = match (is_wrong(session, section.id), selected) {
            (true, _) => (theme::strong_font(theme::TEXT), self.colors.plot.wrong),
            (false, true) => (theme::strong_font(theme::TEXT), self.colors.plot.accent),
            (false, false) => (FontId::proportional(theme::TEXT), self.colors.plot.construction),
        };
        let at = egui::pos2(rect.left() + NUMBERS - 5.0, rect.center().y);
        painter.text(at, Align2::RIGHT_CENTER, (row + 1).to_string(), font, color);
    }

    #[allow(clippy::too_many_arguments, reason = "a cell is its place, its row and what it may change")]
    fn cell(
        &self,
        ui: &mut Ui,
        row_rect: Rect,
        row: usize,
        index: usize,
        section: &Section,
        view: &mut SectionsView,
        session: &mut Session,
    ) {
        let Some(column) = self.columns.get(index).copied() else { return };
        let rect = self.cell_rect(row_rect, index);
        let here = view.cursor.row == row && view.cursor.column == index && !view.cursor.whole_rows;
        if here && view.editing.is_some() {
            self.edit(ui, rect, column, view, session);
            return;
        }
        let bad = view.bad.get(&(section.id, index)).cloned();
        let text =
            bad.as_ref().map_or_else(|| cells::text(section, column, session.document().unit), |(t, _)| t.clone());
        let mut response = ui.interact(rect, self.id.with((section.id, index)), Sense::click());
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::Cell, true, format!("{column} of row {}: {text}", row + 1))
        });
        let message = bad.map(|(_, reason)| reason).or_else(|| cell_mark(session, section.id, column));
        self.paint_cell(ui, rect, column, section, &text, message.is_some());
        if here && self.focused {
            let frame = rect.shrink(1.0);
            ui.painter().rect_stroke(frame, 3.0, Stroke::new(1.5, self.colors.plot.accent), StrokeKind::Inside);
        }
        if let Some(message) = message {
            response = response.on_hover_text(message);
        }
        if response.clicked() || response.secondary_clicked() {
            self.pick(ui, view, session, row, index, response.secondary_clicked());
        }
        if column == Column::Kind {
            kind_menu(&response, section, row, session);
        } else if response.double_clicked() {
            keys::begin_edit(view, session, self.columns, None);
        }
        context_menu(&response, view, session);
    }

    fn pick(&self, ui: &Ui, view: &mut SectionsView, session: &mut Session, row: usize, column: usize, menu: bool) {
        if view.editing.is_some() {
            keys::commit(view, session, self.columns);
        }
        ui.memory_mut(|m| m.request_focus(self.id));
        if !(menu && view.cursor.rows().contains(&row)) {
            keys::place(view, session, row, column, ui.input(|i| i.modifiers.shift));
            view.reveal = false;
        }
    }

    fn paint_cell(&self, ui: &Ui, rect: Rect, column: Column, section: &Section, text: &str, wrong: bool) {
        let painter = ui.painter_at(rect);
        let color = if wrong { self.colors.plot.wrong } else { self.colors.plot.text };
        if wrong {
            painter.rect_filled(rect.shrink(1.5), 3.0, self.colors.wrong_field);
        }
        let font = FontId::proportional(theme::TEXT);
        if column == Column::Kind {
            let picture = Rect::from_center_size(egui::pos2(rect.left() + 13.0, rect.center().y), vec2(14.0, 9.0));
            icon::paint(&painter, picture, &section.kind, self.colors.plot.text);
            painter.text(egui::pos2(rect.left() + 27.0, rect.center().y), Align2::LEFT_CENTER, text, font, color);
        } else {
            let (text, color) = if text.is_empty() { ("–", self.colors.plot.construction) } else { (text, color) };
            painter.text(rect.right_center() - vec2(6.0, 0.0), Align2::RIGHT_CENTER, text, font, color);
        }
    }

    fn edit(&self, ui: &mut Ui, rect: Rect, column: Column, view: &mut SectionsView, session: &mut Session) {
        let Some(Editing { mut text, wrong, .. }) = view.editing.clone() else { return };
        let id = self.id.with("edit");
        let fresh = !ui.memory(|m| m.has_focus(id));
        let align = if column == Column::Kind { Align2::LEFT_CENTER } else { Align2::RIGHT_CENTER };
        let frame = egui::Frame::new()
            .fill(if wrong.is_some() { self.colors.wrong_field } else { self.colors.panel })
            .stroke(Stroke::new(1.5, if wrong.is_some() { self.colors.plot.wrong } else { self.colors.plot.accent }))
            .corner_radius(3)
            .inner_margin(egui::Margin::symmetric(5, 4));
        let filter = EventFilter { tab: true, horizontal_arrows: true, vertical_arrows: true, escape: true };
        let edit = egui::TextEdit::singleline(&mut text)
            .id(id)
            .frame(frame)
            .align(align)
            .event_filter(filter)
            .desired_width(rect.width() - 12.0);
        let response = ui.put(rect.shrink(1.0), edit);
        response.widget_info(|| {
            let mut info = egui::WidgetInfo::text_edit(true, &text, &text, "");
            info.label = Some(format!("{column} of row {}", view.cursor.row + 1));
            info
        });
        if fresh && !response.lost_focus() {
            response.request_focus();
            put_cursor_at_end(ui, id, &text);
        }
        if let Some(editing) = &mut view.editing {
            editing.text = text;
        }
        let lost_focus = response.lost_focus();
        if let Some(reason) = wrong {
            response.on_hover_text(reason);
        }
        if lost_focus {
            keys::commit(view, session, self.columns);
        } else {
            keys::tell(view, session, self.columns);
        }
    }
}

fn put_cursor_at_end(ui: &Ui, id: Id, text: &str) {
    let mut state = egui::TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    let end = egui::text::CCursor::new(text.chars().count());
    state.cursor.set_char_range(Some(egui::text::CCursorRange::one(end)));
    egui::TextEdit::store_state(ui.ctx(), id, state);
}

/// Enter, Tab and Escape end the editing of a cell and give the keyboard back to the table.
fn end_edit_by_key(ui: &Ui, view: &mut SectionsView, session: &mut Session, frame: &Frame<'_>) {
    let pressed = |modifiers: Modifiers, key: Key| ui.input_mut(|i| i.consume_key(modifiers, key));
    let back_to_table = |ui: &Ui| ui.memory_mut(|m| m.request_focus(frame.id));
    if pressed(Modifiers::NONE, Key::Escape) {
        keys::give_up(view, session);
        back_to_table(ui);
        return;
    }
    for (modifiers, key) in [
        (Modifiers::SHIFT, Key::Enter),
        (Modifiers::NONE, Key::Enter),
        (Modifiers::SHIFT, Key::Tab),
        (Modifiers::NONE, Key::Tab),
    ] {
        if !pressed(modifiers, key) {
            continue;
        }
        keys::commit(view, session, frame.columns);
        match key {
            Key::Enter => keys::step(view, session, if modifiers.shift { -1 } else { 1 }, 0, false),
            _ => keys::step_cell(view, session, frame.columns, !modifiers.shift),
        }
        back_to_table(ui);
        return;
    }
}

fn kind_menu(response: &Response, section: &Section, row: usize, session: &mut Session) {
    egui::Popup::menu(response).show(|ui| {
        for (index, name) in cells::KINDS.iter().enumerate() {
            if ui.selectable_label(cells::kind_index(&section.kind) == index, *name).clicked() {
                let mut changed = section.clone();
                cells::set_kind(&mut changed, index);
                keys::replace(session, &format!("type of row {}", row + 1), changed);
                ui.close();
            }
        }
    });
}

fn context_menu(response: &Response, view: &mut SectionsView, session: &mut Session) {
    response.context_menu(|ui| {
        let item = |ui: &mut Ui, text: &str, keys: &str| ui.add(egui::Button::new(text).shortcut_text(keys)).clicked();
        if item(ui, "Insert above", "Insert") {
            keys::insert(view, session);
        }
        if item(ui, "Duplicate", "Ctrl+D") {
            keys::duplicate(view, session);
        }
        if item(ui, "Move up", "Alt+↑") {
            keys::shift(view, session, false);
        }
        if item(ui, "Move down", "Alt+↓") {
            keys::shift(view, session, true);
        }
        if item(ui, "Copy", "Ctrl+C") {
            keys::copy(ui, view, session);
        }
        if item(ui, "Delete", "Ctrl+Delete") {
            keys::delete(view, session);
        }
    });
}

/// The worst message about a cell.
fn cell_mark(session: &Session, id: u32, column: Column) -> Option<String> {
    let about = |at: &Place| matches!(at, Place::Section { column: Some(c), .. } if *c == column);
    let found = session.problems_of_row(id).find(|d| d.severity >= Severity::Warning && about(&d.at))?;
    let hint = found.hint.as_ref().map(|hint| format!("\n{hint}")).unwrap_or_default();
    Some(format!("{}{hint}", found.message))
}

/// True if there is an error in a row as a whole or in any of its cells.
fn is_wrong(session: &Session, id: u32) -> bool {
    session.problems_of_row(id).any(|d| d.severity == Severity::Error)
}
