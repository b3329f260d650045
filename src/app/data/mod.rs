//! Editors of machines, tools and materials: a list, fields made from tables, and a live picture of a tool.

mod entry;
mod field;
mod form;
mod machine_form;
mod material_form;
mod tool_form;
mod words_form;

use super::actions::Action;
use super::plots::{Palette, fixed, tool_picture};
use super::theme::{self, Colors};
use super::widgets::{choice, form_label, link, primary_button, remark, toggle};
use crate::machine::{Catalog, Fault, ToolKind, ToolOutline};
use egui::{Align, Layout, RichText, ScrollArea, Sense, Ui, vec2};
pub use entry::{Entry, Kind};
use serde_json::Value;
use std::sync::Arc;

/// Size of the editor, points.
const SIZE: egui::Vec2 = vec2(1020.0, 620.0);
/// Width of the list of items, points.
const LIST: f32 = 210.0;
/// Width of the fields, points.
const FIELDS: f32 = 390.0;
/// Height of the picture, points.
const PICTURE: f32 = 330.0;

/// An item that is being edited.
#[derive(Debug, Clone, Default)]
struct Draft {
    /// Tells drafts apart for widgets that keep a text.
    number: u64,
    item: Value,
    /// As it is in the catalog; `None` for a new one.
    saved: Option<Value>,
    /// The field that is typed into, with what it held before.
    before: Option<(String, Value)>,
    faults: Vec<Fault>,
    /// Texts of this frame that say nothing.
    unread: Vec<Fault>,
}

/// The editor of machines, tools and materials.
#[derive(Debug)]
pub(crate) struct DataEditor {
    catalog: Arc<Catalog>,
    kind: Kind,
    items: Vec<(String, Value)>,
    draft: Draft,
    /// Outline of the tool when it was last without fault.
    outline: ToolOutline,
    /// Scroll the list so that the open item is seen.
    reveal: bool,
    /// Why nothing can be saved at all.
    hindrance: Option<&'static str>,
}

impl Draft {
    /// Messages about the value at `path` and what is in it.
    fn faults_at(&self, path: &str) -> Vec<Fault> {
        let all = self.faults.iter().chain(&self.unread);
        let here = |f: &&Fault| f.path == path || f.path.strip_prefix(path).is_some_and(|rest| rest.starts_with('.'));
        all.filter(here).cloned().collect()
    }

    /// Messages about the value at `path` as a whole.
    fn faults_just_at(&self, path: &str) -> Vec<Fault> {
        self.faults.iter().filter(|f| f.path == path).cloned().collect()
    }

    fn is_edited(&self) -> bool {
        self.saved.as_ref() != Some(&self.item)
    }
}

impl DataEditor {
    /// The editor of the items of one kind, with the item called `key` open. Without a folder of the user's own nothing can be
    /// saved.
    pub(crate) fn new(catalog: Arc<Catalog>, kind: Kind, key: Option<&str>, has_folder: bool) -> Self {
        let hindrance = (!has_folder).then_some("There is no configuration folder to save your own data in.");
        let items = kind.items(&catalog);
        let mut editor = Self {
            catalog,
            kind,
            items,
            draft: Draft::default(),
            outline: ToolOutline::default(),
            reveal: true,
            hindrance,
        };
        let index = key.and_then(|key| editor.items.iter().position(|(name, _)| name == key)).unwrap_or(0);
        editor.open(index);
        editor
    }

    /// Takes what was loaded after something was saved, and stays at its item.
    pub(crate) fn reload(&mut self, catalog: Arc<Catalog>) {
        self.items = self.kind.items(&catalog);
        self.catalog = catalog;
        let key = self.kind.key();
        let same =
            |item: &Value| item.get(key) == self.draft.item.get(key) && item.get("unit") == self.draft.item.get("unit");
        if let Some(index) = self.items.iter().position(|(_, item)| same(item)) {
            self.open(index);
        }
    }

    fn open(&mut self, index: usize) {
        let item = self.items.get(index).map(|(_, item)| item.clone());
        self.begin(item.clone().unwrap_or_default(), item);
    }

    fn begin(&mut self, item: Value, saved: Option<Value>) {
        self.draft = Draft { number: self.draft.number + 1, item, saved, ..Draft::default() };
        self.check();
    }

    /// Looks for faults, and draws the tool anew if there are none.
    fn check(&mut self) -> Option<Entry> {
        match self.kind.read(&self.draft.item) {
            Ok(entry) => {
                self.draft.faults = entry.faults(&self.catalog);
                if let (Entry::Tool(tool), []) = (&entry, self.draft.faults.as_slice()) {
                    self.outline = tool.outline();
                }
                Some(entry)
            }
            Err(message) => {
                self.draft.faults = vec![Fault { path: String::new(), message }];
                None
            }
        }
    }

    /// Shows the editor; true when it is closed.
    pub(crate) fn show(&mut self, ui: &mut Ui, actions: &mut Vec<Action>) -> bool {
        ui.set_min_size(SIZE);
        ui.set_max_size(SIZE);
        self.head(ui);
        ui.add_space(4.0);
        let height = SIZE.y - 84.0;
        let entry = ui
            .horizontal_top(|ui| {
                let column = Layout::top_down(Align::Min);
                ui.allocate_ui_with_layout(vec2(LIST, height), column, |ui| self.list(ui));
                ui.add_space(8.0);
                let width = if self.kind == Kind::Tools { FIELDS } else { SIZE.x - LIST - 40.0 };
                ui.allocate_ui_with_layout(vec2(width, height), column, |ui| self.fields(ui));
                let entry = self.check();
                if self.kind == Kind::Tools {
                    ui.add_space(8.0);
                    ui.vertical(|ui| self.picture(ui));
                }
                entry
            })
            .inner;
        ui.add_space(8.0);
        self.foot(ui, entry, actions)
    }

    fn head(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            for kind in Kind::ALL {
                let mut on = self.kind == kind;
                let before = self.kind;
                toggle(ui, &mut on, kind.title());
                if on && before != kind {
                    *self = Self::new(Arc::clone(&self.catalog), kind, None, self.hindrance.is_none());
                }
            }
            let note = "Shipped data stay as they are; yours are saved beside them and take their place.";
            ui.label(theme::quiet(note, Colors::of(ui.visuals())));
        });
    }

    fn list(&mut self, ui: &mut Ui) {
        let (mut chosen, mut fresh) = (None, None);
        ui.vertical(|ui| {
            ui.horizontal(|ui| {
                if let Some(item) = self.kind.fresh()
                    && link(ui, "+ New").clicked()
                {
                    fresh = Some(item);
                }
                if link(ui, "copy").on_hover_text("Begin a new one from this one").clicked() {
                    fresh = Some(self.copy());
                }
            });
            ScrollArea::vertical().id_salt(("items", self.kind.title())).auto_shrink([false, false]).show(ui, |ui| {
                let open = self.draft.saved.as_ref();
                for (index, (name, item)) in self.items.iter().enumerate() {
                    let response = ui.selectable_label(open == Some(item), name);
                    if self.reveal && open == Some(item) {
                        response.scroll_to_me(Some(Align::Center));
                    }
                    if response.clicked() {
                        chosen = Some(index);
                    }
                }
            });
        });
        self.reveal = false;
        if let Some(index) = chosen {
            self.open(index);
        }
        if let Some(item) = fresh {
            self.begin(item, None);
        }
    }

    /// The item with another key.
    fn copy(&self) -> Value {
        let mut item = self.draft.item.clone();
        let key = self.kind.key();
        let copied = format!("{}-copy", field::text(item.get(key)));
        field::set(&mut item, key, Value::String(copied));
        item
    }

    fn fields(&mut self, ui: &mut Ui) {
        self.draft.unread.clear();
        let scroll = ScrollArea::vertical()
            .id_salt(("fields", self.kind.title(), self.draft.number))
            .auto_shrink([false, false]);
        scroll.show(ui, |ui| {
            ui.push_id(("draft", self.kind.title(), self.draft.number), |ui| {
                if self.kind == Kind::Tools {
                    self.shape_choices(ui);
                }
                for group in self.kind.groups(&self.draft.item) {
                    form::group(ui, &mut self.draft, &group);
                }
                if let Some(table) = self.kind.table() {
                    form::table(ui, &mut self.draft, &table);
                }
            });
        });
    }

    /// What kind of tool it is, and how its holder is given.
    fn shape_choices(&mut self, ui: &mut Ui) {
        let item = &mut self.draft.item;
        let now = tool_form::kind(item).to_owned();
        if let Some(kind) = words(ui, "Kind", &now, &tool_form::KINDS) {
            tool_form::set_kind(item, &kind);
        }
        let Some(way) = tool_form::holder(item) else { return };
        let ways = if tool_form::takes_shank(item) { &tool_form::HOLDERS[..] } else { &tool_form::HOLDERS[1..] };
        if let Some(way) = words(ui, "Holder as", way, ways) {
            tool_form::set_holder(item, &way);
        }
    }

    fn picture(&self, ui: &mut Ui) {
        let palette = Palette::of(ui.visuals());
        let colors = Colors::of(ui.visuals());
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), PICTURE), Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Picture of the tool"));
        ui.painter().rect(rect, 8.0, colors.panel, egui::Stroke::new(1.0, colors.line), egui::StrokeKind::Inside);
        tool_picture(ui.painter(), rect.shrink(8.0), &self.outline, &palette);
        let tool = &self.outline;
        let nose =
            if tool.nose_radius > 0.0 { format!("nose R {} mm", fixed(tool.nose_radius, 3)) } else { "sharp".into() };
        ui.label(format!("{nose} · orientation {}", tool.orientation));
        ui.label(theme::quiet(ways_of(tool), colors));
        if !self.draft.faults.is_empty() {
            ui.label(theme::quiet("The picture is of the last figures without fault.", colors));
        }
        ui.add_space(4.0);
        remark(
            ui,
            "Left the whole tool, right its tip, seen with the chuck on the left and the radius upwards. The cross is the \
             point that the program moves, blue edges cut, the dashed circle is the nose; the line from its centre to the \
             cross is the orientation.",
        );
    }

    fn foot(&self, ui: &mut Ui, entry: Option<Entry>, actions: &mut Vec<Action>) -> bool {
        let colors = Colors::of(ui.visuals());
        let faults: Vec<&Fault> = self.draft.faults.iter().chain(&self.draft.unread).collect();
        let mut closed = false;
        ui.horizontal(|ui| {
            let edited = self.draft.is_edited();
            let ready = edited && faults.is_empty() && self.hindrance.is_none() && entry.is_some();
            if primary_button(ui, "Save", ready).clicked() {
                actions.extend(entry.map(|entry| Action::SaveData(Box::new(entry))));
            }
            closed = ui.button("Close").clicked();
            let said = match (self.hindrance, faults.first()) {
                (_, Some(fault)) if fault.path.is_empty() => fault.message.clone(),
                (_, Some(fault)) => format!("{}: {}", fault.path, fault.message),
                (Some(hindrance), None) => hindrance.to_owned(),
                (None, None) if edited => "Edited, not saved yet.".to_owned(),
                (None, None) => String::new(),
            };
            let color = if faults.is_empty() { colors.plot.quiet } else { colors.plot.wrong };
            ui.label(RichText::new(said).color(color));
        });
        closed
    }
}

/// A choice of words with names.
fn words(ui: &mut Ui, label: &str, now: &str, all: &[(&str, &str)]) -> Option<String> {
    ui.horizontal(|ui| {
        form_label(ui, label, 104.0);
        let all: Vec<(String, String)> = all.iter().map(|(w, n)| ((*w).to_owned(), (*n).to_owned())).collect();
        let width = form::field_width(ui);
        choice(ui, label, &now.to_owned(), &all, width)
    })
    .inner
}

/// Which ways a tool cuts, in words.
fn ways_of(tool: &ToolOutline) -> String {
    let ways = [
        (tool.cuts_towards_headstock(), "towards the headstock"),
        (tool.cuts_away_from_headstock(), "away from it"),
        (tool.kind == ToolKind::Grooving, "straight in"),
        (tool.cuts_face(), "the face"),
        (tool.kind.is_inside(), "in a bore"),
    ];
    let ways: Vec<&str> = ways.into_iter().filter(|(yes, _)| *yes).map(|(_, way)| way).collect();
    if ways.is_empty() { "cuts straight in".to_owned() } else { format!("cuts {}", ways.join(", ")) }
}
