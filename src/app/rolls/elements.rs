//! Elements of the cross-section as a table, and what the strip is.

use super::RollsViews;
use crate::app::desk::Requests;
use crate::app::plots::fixed;
use crate::app::sheet::{self, Cell, Change, Heading, Sheet, SheetView, Takes};
use crate::app::widgets::{link, title_row, toggle};
use crate::diagnostic::{Place, Severity};
use crate::document::{CrossSection, Document, Element, ElementKind, RollSet};
use crate::rollform::developed::element_mm;
use crate::session::Session;
use crate::units::{Unit, parse_length};
use egui::Ui;
use std::collections::BTreeMap;

/// The table keeps at least this height, points.
const LEAST: f32 = 120.0;
/// Length of an element that is added, mm.
const NEW_LENGTH_MM: f64 = 10.0;
/// What an element can be.
const WORDS: [&str; 2] = ["line", "bend"];
/// Type, length or radius, bend angle, mean length.
const TYPE: usize = 0;
const LENGTH: usize = 1;
const BEND: usize = 2;

/// Table of the elements, and which list it shows.
#[derive(Debug, Default)]
pub(super) struct ElementsView {
    sheet: SheetView,
    other_side: bool,
    with_material: bool,
}

impl ElementsView {
    /// Selects an element and shows the list that it is in, without taking the keyboard.
    pub(super) fn select(&mut self, session: &mut Session, set: &RollSet, id: u32) {
        self.other_side = set.section.other_side.iter().any(|e| e.id == id);
        session.selection.element = Some(id);
    }

    /// Puts the cursor on an element, as when a message about it is clicked.
    pub(super) fn go_to(&mut self, set: &RollSet, id: u32) {
        let row = |list: &[Element]| list.iter().position(|e| e.id == id);
        let found = row(&set.section.elements).map(|row| (row, false));
        let found = found.or_else(|| row(&set.section.other_side).map(|row| (row, true)));
        if let Some((row, other_side)) = found {
            self.other_side = other_side;
            self.sheet.go_to(row, LENGTH);
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
    let Some(set) = document.content.roll_set() else { return false };
    let view = &mut views.elements;
    view.other_side &= set.section.origin.has_other_side();
    let count = set.section.all().count();
    let remark = format!("{count}, {}", super::words::origin(set.section.origin));
    let mut add = false;
    let dragged = title_row(ui, titled.then_some("Elements"), &remark, |ui| {
        add = link(ui, "+ Add").on_hover_text("Add an element at the end (Insert adds one above the cursor)").clicked();
        if set.section.origin.has_other_side() {
            toggle(ui, &mut view.other_side, "other side");
        }
    });
    let elements = Elements::new(set, document.unit, view.other_side, session);
    if add {
        let end = elements.rows();
        session.edit("add an element", None, |document| _ = elements.change(document, &Change::Insert(end)));
        view.sheet.go_to(end, LENGTH);
    }
    let height =
        (ui.available_height() - super::strip_data::height(view.with_material, set.section.developed_width)).max(LEAST);
    sheet::show(ui, &elements, &mut view.sheet, session, requests, height);
    egui::ScrollArea::vertical().id_salt("strip-data").auto_shrink([false, false]).show(ui, |ui| {
        ui.add_space(8.0);
        super::strip_data::show(ui, set, document.unit, session, &mut view.with_material);
    });
    dragged
}

/// What is wrong with cells, by element and column.
type Wrong = BTreeMap<(u32, usize), String>;

/// The first message about every cell.
fn wrong(session: &Session) -> Wrong {
    let mut found = Wrong::new();
    for problem in session.problems().iter().filter(|p| p.severity >= Severity::Warning) {
        let Place::Element { id, .. } = problem.at else { continue };
        let column = match problem.code.as_str() {
            "element-length" | "least-radius" => LENGTH,
            "bend-angle" => BEND,
            _ => TYPE,
        };
        found.entry((id, column)).or_insert_with(|| problem.message.clone());
    }
    found
}

/// One list of elements as a table.
struct Elements<'a> {
    set: &'a RollSet,
    unit: Unit,
    other_side: bool,
    headings: [Heading; 4],
    wrong: Wrong,
}

impl<'a> Elements<'a> {
    fn new(set: &'a RollSet, unit: Unit, other_side: bool, session: &Session) -> Self {
        let headings = [
            Heading::words("type", 62.0),
            Heading::figures("length / r", 66.0),
            Heading::figures("bend °", 58.0),
            Heading::figures("mean length", 74.0),
        ];
        Self { set, unit, other_side, headings, wrong: wrong(session) }
    }

    fn list(&self) -> &[Element] {
        if self.other_side { &self.set.section.other_side } else { &self.set.section.elements }
    }

    const fn list_of<'d>(&self, section: &'d mut CrossSection) -> &'d mut Vec<Element> {
        if self.other_side { &mut section.other_side } else { &mut section.elements }
    }

    /// Mean length in the unit of the document.
    fn mean_length(&self, kind: &ElementKind) -> f64 {
        element_mm(kind, self.set.section.thickness, self.set.section.developed_width)
    }
}

impl Sheet for Elements<'_> {
    fn name(&self) -> &'static str {
        if self.other_side { "Element of the other side" } else { "Element" }
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn rows(&self) -> usize {
        self.list().len()
    }

    fn key(&self, row: usize) -> u32 {
        self.list().get(row).map_or(u32::MAX, |element| element.id)
    }

    fn cell(&self, row: usize, column: usize) -> Cell {
        let Some(element) = self.list().get(row) else { return Cell::default() };
        let length = |mm| fixed(mm, self.unit.decimals());
        let (text, takes) = match (column, element.kind) {
            (TYPE, kind) => (word(&kind).to_owned(), Takes::Words(&WORDS)),
            (LENGTH, ElementKind::Line { length: l }) => (length(l), Takes::Text),
            (LENGTH, ElementKind::Bend { inside_radius, .. }) => (length(inside_radius), Takes::Text),
            (BEND, ElementKind::Bend { angle_deg, .. }) => (super::words::angle(angle_deg), Takes::Text),
            (BEND, ElementKind::Line { .. }) => (String::new(), Takes::Nothing),
            (_, kind) => (length(self.mean_length(&kind)), Takes::Nothing),
        };
        let wrong = self.wrong.get(&(element.id, column)).cloned();
        Cell { text, takes, wrong, ..Cell::default() }
    }

    fn write(&self, document: &mut Document, row: usize, column: usize, text: &str) -> Result<(), String> {
        let unit = document.unit;
        let Some(set) = super::set_mut(document) else { return Ok(()) };
        let Some(element) = self.list_of(&mut set.section).get_mut(row) else { return Ok(()) };
        match (column, &mut element.kind) {
            (TYPE, kind) => *kind = of_word(text, kind, unit)?,
            (LENGTH, ElementKind::Line { length: value } | ElementKind::Bend { inside_radius: value, .. }) => {
                *value = parse_length(text, unit)?;
            }
            (BEND, ElementKind::Bend { angle_deg, .. }) => *angle_deg = super::words::parse_angle(text)?,
            _ => {}
        }
        Ok(())
    }

    fn change(&self, document: &mut Document, change: &Change) -> bool {
        let new_length = NEW_LENGTH_MM / document.unit.in_mm();
        let Some(set) = super::set_mut(document) else { return false };
        let mut id = set.section.unused_id();
        let list = self.list_of(&mut set.section);
        match change {
            Change::Insert(at) => {
                let at = (*at).min(list.len());
                list.insert(at, Element { id, kind: ElementKind::Line { length: new_length } });
            }
            Change::Delete(rows) => {
                let end = rows.end().saturating_add(1).min(list.len());
                let gone: Vec<u32> = list.drain((*rows.start()).min(end)..end).map(|e| e.id).collect();
                forget(set, &gone);
            }
            Change::Duplicate(rows) => {
                let copies: Vec<Element> =
                    list.iter().skip(*rows.start()).take(rows.clone().count()).copied().collect();
                let at = rows.end().saturating_add(1).min(list.len());
                for copy in copies.into_iter().rev() {
                    list.insert(at, Element { id, ..copy });
                    id = id.saturating_add(1);
                }
            }
            Change::Move { rows, down } => return sheet::shift(list, rows, *down),
        }
        true
    }

    fn selected(&self, session: &Session) -> Option<usize> {
        let id = session.selection.element?;
        self.list().iter().position(|element| element.id == id)
    }

    fn select(&self, session: &mut Session, row: usize, _column: usize) {
        session.selection.element = self.list().get(row).map(|element| element.id);
    }
}

/// Takes out what the stations say about elements that are gone.
fn forget(set: &mut RollSet, gone: &[u32]) {
    set.composites.retain(|composite| !gone.contains(&composite.element));
    for station in &mut set.stations {
        station.bends.retain(|bend| !gone.contains(&bend.element));
    }
}

const fn word(kind: &ElementKind) -> &'static str {
    match kind {
        ElementKind::Line { .. } => WORDS[0],
        ElementKind::Bend { .. } => WORDS[1],
    }
}

/// An element of the kind that `word` names, with usual figures where it is another kind than before.
fn of_word(word: &str, before: &ElementKind, unit: Unit) -> Result<ElementKind, String> {
    /// Radius and angle of a new bend.
    const RADIUS_MM: f64 = 2.0;
    const ANGLE_DEG: f64 = 90.0;
    let wanted = word.trim().to_lowercase();
    match (wanted.as_str(), before) {
        ("line", ElementKind::Line { .. }) | ("bend", ElementKind::Bend { .. }) => Ok(*before),
        ("line", _) => Ok(ElementKind::Line { length: NEW_LENGTH_MM / unit.in_mm() }),
        ("bend", _) => Ok(ElementKind::Bend { inside_radius: RADIUS_MM / unit.in_mm(), angle_deg: ANGLE_DEG }),
        _ => Err(format!("“{word}” is no kind of element. Type line or bend.")),
    }
}
