//! A table on the screen: rows, cells, the cursor and the cell that is being edited.

use super::{Cell, Cursor, Editing, Heading, Sheet, SheetView, Takes, keys};
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::session::Session;
use egui::{Align2, EventFilter, FontId, Id, Key, Modifiers, Rect, Response, Sense, Stroke, StrokeKind, Ui, vec2};

/// Width of the row numbers, points.
const NUMBERS: f32 = 28.0;

/// One frame of a table.
struct Frame<'a> {
    sheet: &'a dyn Sheet,
    colors: &'static Colors,
    /// Left edge of each column and the right edge of the last.
    edges: Vec<f32>,
    focused: bool,
    /// The row that is selected everywhere.
    selected: Option<usize>,
    id: Id,
}

/// Shows a table in at most `height`.
pub(crate) fn show(
    ui: &mut Ui,
    sheet: &dyn Sheet,
    view: &mut SheetView,
    session: &mut Session,
    requests: &mut Requests,
    height: f32,
) {
    follow(sheet, view, session);
    let id = ui.make_persistent_id(("sheet", sheet.name()));
    if std::mem::take(&mut view.take_focus) {
        ui.memory_mut(|m| m.request_focus(id));
    }
    let area = egui::ScrollArea::both().id_salt(("sheet", sheet.name())).max_height(height);
    area.auto_shrink([false, true]).show(ui, |ui| {
        let edges = edges(ui.available_width(), sheet.headings());
        let size = vec2(edges.last().copied().unwrap_or(0.0), theme::ROW * (count(sheet.rows()) + 1.0));
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let focused = grab_keyboard(ui, id, rect, sheet, view);
        let colors = Colors::of(ui.visuals());
        let mut frame = Frame { sheet, colors, edges, focused, selected: None, id };
        if focused && view.editing.is_none() {
            keys::handle(ui, sheet, view, session, requests);
        }
        frame.selected = sheet.selected(session);
        frame.rows(ui, rect, view, session, requests);
        frame.header(ui, rect);
    });
}

#[allow(clippy::cast_precision_loss, reason = "rows of a table are few")]
const fn count(rows: usize) -> f32 {
    rows as f32
}

/// Puts the cursor on the row that was selected elsewhere since the last frame, and keeps it inside the table.
fn follow(sheet: &dyn Sheet, view: &mut SheetView, session: &mut Session) {
    let last = sheet.rows().saturating_sub(1);
    view.cursor.row = view.cursor.row.min(last);
    view.cursor.other_row = view.cursor.other_row.min(last);
    view.cursor.column = view.cursor.column.min(sheet.headings().len().saturating_sub(1));
    if std::mem::take(&mut view.settle) && sheet.rows() > 0 {
        sheet.select(session, view.cursor.row, view.cursor.column);
        view.followed = Some(view.cursor.row);
        return;
    }
    let selected = sheet.selected(session);
    if selected == view.followed || view.editing.is_some() {
        return;
    }
    view.followed = selected;
    if let Some(row) = selected.filter(|row| *row != view.cursor.row) {
        view.cursor = Cursor { row, other_row: row, whole_rows: false, ..view.cursor };
        view.reveal = true;
    }
}

/// Columns that are not of a fixed width share what is left of the room by their least widths.
fn edges(room: f32, headings: &[Heading]) -> Vec<f32> {
    let least = |fixed: bool| headings.iter().filter(|h| h.fixed == fixed).map(|h| h.least).sum::<f32>();
    let stretch = ((room - NUMBERS - least(true)) / least(false).max(1.0)).max(1.0);
    let mut edges = vec![NUMBERS];
    for heading in headings {
        let width = if heading.fixed { heading.least } else { heading.least * stretch };
        edges.push(edges.last().copied().unwrap_or(NUMBERS) + width);
    }
    edges
}

/// Makes the table a widget that takes arrows, Tab and Escape for itself; true if it has the keyboard.
fn grab_keyboard(ui: &Ui, id: Id, rect: Rect, sheet: &dyn Sheet, view: &SheetView) -> bool {
    let response = ui.interact(rect, id, Sense::focusable_noninteractive());
    response.widget_info(|| {
        let text = format!("{}, row {} of {}", sheet.title(), view.cursor.row + 1, sheet.rows());
        egui::WidgetInfo::labeled(egui::Role::Table, true, text)
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
        for (index, heading) in self.sheet.headings().iter().enumerate() {
            let cell = self.cell_rect(row, index).shrink2(vec2(6.0, 0.0));
            let color = if heading.current { self.colors.plot.accent } else { self.colors.plot.quiet };
            let (align, at) = ends(heading, cell);
            ui.painter().text(at, align, &heading.title, FontId::proportional(theme::TEXT), color);
        }
    }

    fn rows(&self, ui: &mut Ui, table: Rect, view: &mut SheetView, session: &mut Session, requests: &mut Requests) {
        if view.editing.is_some() {
            self.end_edit_by_key(ui, view, session);
        }
        let clip = ui.clip_rect();
        for row in 0..self.sheet.rows() {
            let rect = self.row_rect(table, row);
            if view.reveal && row == view.cursor.row {
                let cell = self.cell_rect(rect, view.cursor.column).expand2(vec2(0.0, theme::ROW));
                ui.scroll_to_rect(cell, None);
                view.reveal = false;
            }
            if !rect.intersects(clip) {
                continue;
            }
            if ui.rect_contains_pointer(rect) {
                self.sheet.point_at(row, requests);
            }
            self.row(ui, rect, row, view, session);
        }
    }

    fn row(&self, ui: &mut Ui, rect: Rect, row: usize, view: &mut SheetView, session: &mut Session) {
        self.paint_row(ui, rect, row, view, session);
        let number = Rect::from_min_max(rect.min, egui::pos2(rect.left() + NUMBERS, rect.bottom()));
        let response = ui.interact(number, self.id.with(("number", self.sheet.key(row))), Sense::click());
        let name = format!("{} {}", self.sheet.name(), self.sheet.number(row));
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
        if response.clicked() || response.secondary_clicked() {
            self.pick(ui, view, session, row, 0, response.secondary_clicked());
            view.cursor.whole_rows = true;
        }
        self.context_menu(&response, view, session);
        for column in 0..self.sheet.headings().len() {
            self.cell(ui, self.cell_rect(rect, column), [row, column], view, session);
        }
    }

    fn paint_row(&self, ui: &Ui, rect: Rect, row: usize, view: &SheetView, session: &Session) {
        let painter = ui.painter();
        let (selected, look) = (self.selected == Some(row), self.sheet.look(session, row));
        let in_range = view.cursor.rows().count() > 1 && view.cursor.rows().contains(&row);
        if selected || in_range {
            painter.rect_filled(rect, 0.0, self.colors.selected);
            let mark = Rect::from_min_size(rect.min, vec2(3.0, rect.height()));
            painter.rect_filled(mark, 0.0, self.colors.plot.accent);
        } else if look.lit {
            painter.rect_filled(rect, 0.0, self.colors.hovered);
        }
        painter.hline(rect.x_range(), rect.bottom(), Stroke::new(1.0, self.colors.line.gamma_multiply(0.7)));
        let (font, color) = match (look.wrong, selected) {
            (true, _) => (theme::strong_font(theme::TEXT), self.colors.plot.wrong),
            (false, true) => (theme::strong_font(theme::TEXT), self.colors.plot.accent),
            (false, false) => (FontId::proportional(theme::TEXT), self.colors.plot.construction),
        };
        let at = egui::pos2(rect.left() + NUMBERS - 6.0, rect.center().y);
        painter.text(at, Align2::RIGHT_CENTER, self.sheet.number(row), font, color);
    }

    fn cell(&self, ui: &mut Ui, rect: Rect, [row, column]: [usize; 2], view: &mut SheetView, session: &mut Session) {
        let Some(heading) = self.sheet.headings().get(column) else { return };
        let here = view.cursor.row == row && view.cursor.column == column && !view.cursor.whole_rows;
        if here && view.editing.is_some() {
            return self.edit(ui, rect, heading, view, session);
        }
        let mut cell = self.sheet.cell(row, column);
        if let Some((text, reason)) = view.bad.get(&(self.sheet.key(row), column)) {
            (cell.text, cell.wrong) = (text.clone(), Some(reason.clone()));
        }
        cell.wrong = cell.wrong.or_else(|| self.sheet.mark(session, row, column));
        let mut response = ui.interact(rect, self.id.with((self.sheet.key(row), column)), Sense::click());
        let name = format!("{} of {}: {}", heading.title, self.sheet.row_name(row), cell.text);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Cell, true, &name));
        self.paint_cell(ui, rect, (row, column), &cell);
        if here && self.focused {
            let stroke = Stroke::new(1.5, self.colors.plot.accent);
            ui.painter().rect_stroke(rect.shrink(1.0), 3.0, stroke, StrokeKind::Inside);
        }
        if let Some(message) = cell.wrong {
            response = response.on_hover_text(message);
        }
        if response.clicked() || response.secondary_clicked() {
            self.pick(ui, view, session, row, column, response.secondary_clicked());
        }
        match cell.takes {
            Takes::Words(words) => self.words(&response, words, [row, column], session),
            Takes::Text if response.double_clicked() => keys::begin(self.sheet, view, session, None),
            Takes::Text | Takes::Nothing => {}
        }
        self.context_menu(&response, view, session);
    }

    fn words(&self, response: &Response, words: &[&str], [row, column]: [usize; 2], session: &mut Session) {
        let present = self.sheet.cell(row, column).text;
        egui::Popup::menu(response).show(|ui| {
            for word in words {
                if ui.selectable_label(present == *word, *word).clicked() {
                    keys::choose(self.sheet, session, row, column, word);
                    ui.close();
                }
            }
        });
    }

    fn pick(&self, ui: &Ui, view: &mut SheetView, session: &mut Session, row: usize, column: usize, menu: bool) {
        if view.editing.is_some() {
            keys::commit(self.sheet, view, session);
        }
        ui.memory_mut(|m| m.request_focus(self.id));
        if !(menu && view.cursor.rows().contains(&row)) {
            let extend = ui.input(|i| i.modifiers.shift);
            keys::place(self.sheet, view, session, row, column, extend);
            view.reveal = false;
        }
    }

    fn paint_cell(&self, ui: &Ui, rect: Rect, (row, column): (usize, usize), cell: &Cell) {
        let Some(heading) = self.sheet.headings().get(column) else { return };
        let painter = ui.painter_at(rect);
        let plot = &self.colors.plot;
        if cell.wrong.is_some() {
            painter.rect_filled(rect.shrink(1.5), 3.0, self.colors.wrong_field);
        } else if cell.strong {
            painter.rect_filled(rect.shrink2(vec2(0.0, 0.5)), 0.0, self.colors.selected);
        }
        let color = match cell {
            Cell { wrong: Some(_), .. } => plot.wrong,
            Cell { strong: true, .. } => plot.accent,
            Cell { takes: Takes::Nothing, .. } => plot.quiet,
            _ => plot.text,
        };
        let font = if cell.strong { theme::strong_font(theme::TEXT) } else { FontId::proportional(theme::TEXT) };
        let mut room = rect.shrink2(vec2(6.0, 0.0));
        room.min.x += self.sheet.picture(&painter, rect, (row, column), color);
        let (align, at) = ends(heading, room);
        let (text, color) = if cell.text.is_empty() { ("–", plot.construction) } else { (cell.text.as_str(), color) };
        painter.text(at, align, text, font, color);
    }

    fn edit(&self, ui: &mut Ui, rect: Rect, heading: &Heading, view: &mut SheetView, session: &mut Session) {
        let Some(Editing { mut text, wrong, .. }) = view.editing.clone() else { return };
        let id = self.id.with("edit");
        let fresh = !ui.memory(|m| m.has_focus(id));
        let (line, fill) = match &wrong {
            Some(_) => (self.colors.plot.wrong, self.colors.wrong_field),
            None => (self.colors.plot.accent, self.colors.panel),
        };
        let frame = egui::Frame::new()
            .fill(fill)
            .stroke(Stroke::new(1.5, line))
            .corner_radius(3)
            .inner_margin(egui::Margin::symmetric(5, 4));
        let filter = EventFilter { tab: true, horizontal_arrows: true, vertical_arrows: true, escape: true };
        let edit = egui::TextEdit::singleline(&mut text)
            .id(id)
            .frame(frame)
            .align(if heading.words { Align2::LEFT_CENTER } else { Align2::RIGHT_CENTER })
            .event_filter(filter)
            .desired_width(rect.width() - 12.0);
        let response = ui.put(rect.shrink(1.0), edit);
        response.widget_info(|| {
            let mut info = egui::WidgetInfo::text_edit(true, &text, &text, "");
            info.label = Some(format!("{} of {}", heading.title, self.sheet.row_name(view.cursor.row)));
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
            keys::commit(self.sheet, view, session);
        } else {
            keys::tell(self.sheet, view, session);
        }
    }

    /// Enter, Tab and Escape end the editing of a cell and give the keyboard back to the table.
    fn end_edit_by_key(&self, ui: &Ui, view: &mut SheetView, session: &mut Session) {
        let pressed = |modifiers: Modifiers, key: Key| ui.input_mut(|i| i.consume_key(modifiers, key));
        let back_to_table = || ui.memory_mut(|m| m.request_focus(self.id));
        if pressed(Modifiers::NONE, Key::Escape) {
            keys::give_up(self.sheet, view, session);
            return back_to_table();
        }
        let ends = [(Modifiers::SHIFT, Key::Enter), (Modifiers::NONE, Key::Enter)];
        let steps = [(Modifiers::SHIFT, Key::Tab), (Modifiers::NONE, Key::Tab)];
        let Some((modifiers, key)) = ends.into_iter().chain(steps).find(|(m, k)| pressed(*m, *k)) else { return };
        keys::commit(self.sheet, view, session);
        match key {
            Key::Enter => keys::step(self.sheet, view, session, if modifiers.shift { -1 } else { 1 }, 0, false),
            _ => keys::step_cell(self.sheet, view, session, !modifiers.shift),
        }
        back_to_table();
    }

    fn context_menu(&self, response: &Response, view: &mut SheetView, session: &mut Session) {
        let sheet = self.sheet;
        response.context_menu(|ui| {
            let item =
                |ui: &mut Ui, text: &str, keys: &str| ui.add(egui::Button::new(text).shortcut_text(keys)).clicked();
            if item(ui, "Insert above", "Insert") {
                keys::insert(sheet, view, session);
            }
            if item(ui, "Duplicate", "Ctrl+D") {
                keys::duplicate(sheet, view, session);
            }
            if item(ui, "Move up", "Alt+↑") {
                keys::shift(sheet, view, session, false);
            }
            if item(ui, "Move down", "Alt+↓") {
                keys::shift(sheet, view, session, true);
            }
            if item(ui, "Copy", "Ctrl+C") {
                keys::copy(ui, sheet, view);
            }
            if item(ui, "Delete", "Ctrl+Delete") {
                keys::delete(sheet, view, session);
            }
        });
    }
}

/// Words stand left, figures right.
fn ends(heading: &Heading, cell: Rect) -> (Align2, egui::Pos2) {
    if heading.words { (Align2::LEFT_CENTER, cell.left_center()) } else { (Align2::RIGHT_CENTER, cell.right_center()) }
}

fn put_cursor_at_end(ui: &Ui, id: Id, text: &str) {
    let mut state = egui::TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    let end = egui::text::CCursor::new(text.chars().count());
    state.cursor.set_char_range(Some(egui::text::CCursorRange::one(end)));
    egui::TextEdit::store_state(ui.ctx(), id, state);
}
