//! The fields on the screen: groups, fields with their faults, lists.

use super::Draft;
use super::field::{Field, Group, Is, Table, get, number, read_rows, set, text};
use crate::app::theme::{self, Colors};
use crate::app::widgets::{Typed, choice, field, form_label, link};
use crate::machine::Fault;
use crate::units::{Unit, parse_length};
use egui::{Id, RichText, TextEdit, Ui};
use serde_json::Value;

/// Width of the labels, points.
const LABEL: f32 = 104.0;
/// Width of the units, points.
const UNIT: f32 = 52.0;
/// Greatest width of a field, points.
const WIDEST: f32 = 260.0;
/// Lines that a list of figures shows at least.
const LINES: usize = 4;

/// Shows a group of fields.
pub(super) fn group(ui: &mut Ui, draft: &mut Draft, group: &Group) {
    let mut there = true;
    if !group.title.is_empty() {
        ui.add_space(6.0);
        ui.horizontal(|ui| {
            ui.label(theme::strong(group.title));
            let Some((path, first)) = group.optional else { return };
            there = get(&draft.item, path).is_some_and(|value| !value.is_null());
            let word = if there { "leave out" } else { "add" };
            if link(ui, word).on_hover_text(format!("{word}: {}", group.title.to_lowercase())).clicked() {
                set(&mut draft.item, path, if there { Value::Null } else { first() });
                there = !there;
            }
        });
    }
    for fault in group.optional.iter().flat_map(|(path, _)| draft.faults_just_at(path)) {
        said(ui, &fault);
    }
    if there {
        for field in group.fields {
            one(ui, draft, field);
        }
    }
}

fn one(ui: &mut Ui, draft: &mut Draft, spec: &Field) {
    ui.horizontal(|ui| {
        form_label(ui, spec.label, LABEL);
        let width = field_width(ui);
        value(ui, draft, spec, spec.path, spec.label, width);
        form_label(ui, spec.unit, UNIT);
    });
    for fault in draft.faults_at(spec.path) {
        said(ui, &fault);
    }
}

/// Width of a field with room for a unit behind it.
pub(super) fn field_width(ui: &Ui) -> f32 {
    (ui.available_width() - UNIT - ui.spacing().item_spacing.x).clamp(60.0, WIDEST)
}

/// What is wrong, under its field.
pub(super) fn said(ui: &mut Ui, fault: &Fault) {
    let wrong = Colors::of(ui.visuals()).plot.wrong;
    ui.label(RichText::new(&fault.message).size(theme::SMALL).color(wrong));
}

/// The field of the value at `path`.
fn value(ui: &mut Ui, draft: &mut Draft, spec: &Field, path: &str, name: &str, width: f32) {
    let present = get(&draft.item, path);
    match spec.is {
        Is::OneOf(words) => {
            let now = present.and_then(Value::as_str).unwrap_or_default().to_owned();
            let all: Vec<(String, String)> = words.iter().map(|(w, n)| ((*w).to_owned(), (*n).to_owned())).collect();
            if let Some(word) = choice(ui, name, &now, &all, width) {
                set(&mut draft.item, path, Value::String(word));
            }
        }
        Is::YesNo => {
            let now = present.and_then(Value::as_bool).unwrap_or_default();
            let all = [(false, "no".to_owned()), (true, "yes".to_owned())];
            if let Some(yes) = choice(ui, name, &now, &all, width) {
                set(&mut draft.item, path, Value::Bool(yes));
            }
        }
        Is::Rows(per_row) => rows(ui, draft, path, name, per_row, width),
        Is::Text | Is::Figure | Is::MaybeFigure | Is::Whole | Is::MaybeWhole => {
            let shown = text(present);
            let typed = ui.push_id(path, |ui| field(ui, name, &shown, width, |text| read(spec.is, text))).inner;
            if let Some(typed) = typed {
                put(draft, path, typed);
            }
        }
    }
}

fn read(is: Is, text: &str) -> Result<Value, String> {
    match is {
        Is::MaybeFigure | Is::MaybeWhole if text.trim().is_empty() => Ok(Value::Null),
        Is::Figure | Is::MaybeFigure => {
            let value = parse_length(text, Unit::Mm)?;
            number(value).ok_or_else(|| "The figure is not finite.".to_owned())
        }
        Is::Whole | Is::MaybeWhole => {
            text.trim().parse::<u32>().map(Value::from).map_err(|_| "A whole figure is needed.".to_owned())
        }
        _ => Ok(Value::String(text.trim().to_owned())),
    }
}

/// Takes what is typed at once; a text that says nothing leaves the value before it.
fn put(draft: &mut Draft, path: &str, typed: Typed<Value>) {
    let before = draft.before.take().filter(|(of, _)| of == path);
    let keep = |draft: &mut Draft, before: Option<(String, Value)>| {
        draft.before = before.or_else(|| Some((path.to_owned(), get(&draft.item, path).cloned().unwrap_or_default())));
    };
    match typed {
        Typed::Begun => keep(draft, None),
        Typed::Value(value) => {
            keep(draft, before);
            set(&mut draft.item, path, value);
        }
        Typed::Nothing | Typed::GivenUp => {
            if let Some((_, value)) = &before {
                set(&mut draft.item, path, value.clone());
            }
            draft.before = before;
        }
        Typed::Left(_) => {}
    }
}

/// A list of rows of figures, one row a line.
fn rows(ui: &mut Ui, draft: &mut Draft, path: &str, name: &str, per_row: usize, width: f32) {
    let id = Id::unique(("rows", path, draft.number));
    let kept: Option<String> = ui.data(|d| d.get_temp(id));
    let mut written = kept.unwrap_or_else(|| text(get(&draft.item, path)));
    let edit = TextEdit::multiline(&mut written).code_editor().desired_width(width - 8.0).desired_rows(LINES);
    let response = ui.add(edit);
    response.widget_info(|| {
        let mut info = egui::WidgetInfo::text_edit(true, "", &written, "");
        info.label = Some(name.to_owned());
        info
    });
    let made = read_rows(&written, per_row);
    if response.changed()
        && let Ok(value) = &made
    {
        set(&mut draft.item, path, value.clone());
    }
    if response.has_focus() || made.is_err() {
        ui.data_mut(|d| d.insert_temp(id, written));
    } else {
        ui.data_mut(|d| d.remove::<String>(id));
    }
    if let Err(message) = made {
        draft.unread.push(Fault { path: path.to_owned(), message });
    }
}

/// Shows a list of entries, one a row.
pub(super) fn table(ui: &mut Ui, draft: &mut Draft, table: &Table) {
    ui.add_space(6.0);
    let mut add = false;
    ui.horizontal(|ui| {
        ui.label(theme::strong(table.title));
        add = link(ui, "+ add").clicked();
    });
    let count = get(&draft.item, table.path).and_then(Value::as_array).map_or(0, Vec::len);
    let room = (ui.available_width() - 60.0).max(300.0);
    let width = room / table.columns.len() as f32;
    head(ui, table, width);
    let mut delete = None;
    for index in 0..count {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            for column in table.columns {
                let path = format!("{}.{index}.{}", table.path, column.path);
                value(ui, draft, column, &path, &format!("{} {}", column.label, index + 1), width - 4.0);
            }
            if link(ui, "×").on_hover_text("Take the row out").clicked() {
                delete = Some(index);
            }
        });
        for fault in draft.faults_at(&format!("{}.{index}", table.path)) {
            said(ui, &fault);
        }
    }
    if let Some(Value::Array(list)) = draft.item.pointer_mut(&format!("/{}", table.path)) {
        if add {
            list.push((table.fresh)());
        }
        if let Some(index) = delete {
            list.remove(index);
        }
    } else if add {
        set(&mut draft.item, table.path, Value::Array(vec![(table.fresh)()]));
    }
}

fn head(ui: &mut Ui, table: &Table, width: f32) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for column in table.columns {
            let unit = if column.unit.is_empty() { String::new() } else { format!(" {}", column.unit) };
            form_label(ui, &format!("{}{unit}", column.label), width - 4.0);
        }
    });
}
