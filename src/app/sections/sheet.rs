//! The section table of the part that is shown, outside or bore, as a table of the window.

use super::{cells, icon, rows, tsv};
use crate::app::desk::Requests;
use crate::app::sheet::{self, Cell, Change, Heading, RowLook, Sheet, Takes};
use crate::diagnostic::{Column, Place, SectionTable, Severity};
use crate::document::{Document, TurnedPart};
use crate::part::Section;
use crate::session::{Hovered, Session};
use crate::units::Unit;
use egui::{Color32, Painter, Rect, vec2};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// Width of the section type, points.
const KIND: f32 = 96.0;
/// Least width of a figure, points.
const FIGURE: f32 = 55.0;
/// Room of the picture before a type, points.
const PICTURE: f32 = 21.0;

/// Where the part comes from.
enum Shown {
    Document(Arc<Document>),
    Roll(Arc<TurnedPart>),
    Nothing,
}

/// One table of rows.
pub(super) struct Rows {
    shown: Shown,
    table: SectionTable,
    unit: Unit,
    columns: Vec<Column>,
    headings: Vec<Heading>,
}

impl Rows {
    /// The table of the part as it is now.
    pub(super) fn of(session: &Session, table: SectionTable) -> Self {
        let document = session.document();
        let shown = match (document.content.turned_part(), session.setup()) {
            (Some(_), _) => Shown::Document(Arc::clone(document)),
            (None, Some(setup)) => Shown::Roll(Arc::clone(&setup.part)),
            (None, None) => Shown::Nothing,
        };
        let mut made = Self { shown, table, unit: document.unit, columns: Vec::new(), headings: Vec::new() };
        made.columns = cells::columns(made.list());
        made.headings = made.columns.iter().map(|column| heading(*column)).collect();
        made
    }

    fn list(&self) -> &[Section] {
        let part = match &self.shown {
            Shown::Document(document) => document.content.turned_part(),
            Shown::Roll(part) => Some(part.as_ref()),
            Shown::Nothing => None,
        };
        part.map_or(&[], |part| part.table(self.table))
    }

    fn id(&self, row: usize) -> Option<u32> {
        self.list().get(row).map(|section| section.id)
    }
}

fn heading(column: Column) -> Heading {
    match column {
        Column::Kind => Heading { fixed: true, ..Heading::words(column.to_string(), KIND) },
        _ => Heading::figures(column.to_string(), FIGURE),
    }
}

impl Sheet for Rows {
    fn name(&self) -> &'static str {
        "Row"
    }

    fn title(&self) -> String {
        format!("Section table{}", if self.table.is_outside() { "" } else { " of the bore" })
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn rows(&self) -> usize {
        self.list().len()
    }

    fn key(&self, row: usize) -> u32 {
        self.id(row).unwrap_or_default()
    }

    fn row_name(&self, row: usize) -> String {
        format!("row {}", row + 1)
    }

    fn row_label(&self, row: usize) -> String {
        self.list().get(row).map_or_else(|| self.row_name(row), |section| cells::row_name(self.table, row, section))
    }

    fn cell(&self, row: usize, column: usize) -> Cell {
        let Some((section, column)) = self.list().get(row).zip(self.columns.get(column).copied()) else {
            return Cell::default();
        };
        let takes = match column {
            Column::Kind => Takes::Words(&cells::KINDS),
            _ if cells::get(section, column).is_some() => Takes::Text,
            _ => Takes::Nothing,
        };
        Cell { text: cells::text(section, column, self.unit), takes, ..Cell::default() }
    }

    fn write(&self, document: &mut Document, row: usize, column: usize, text: &str) -> Result<(), String> {
        let unit = document.unit;
        let Some((id, column)) = self.id(row).zip(self.columns.get(column).copied()) else { return Ok(()) };
        let section = document.content.turned_part_mut().and_then(|part| part.row_mut(id));
        section.map_or(Ok(()), |section| cells::set(section, column, text, unit))
    }

    fn change(&self, document: &mut Document, change: &Change) -> bool {
        let Some(part) = document.content.turned_part_mut() else { return false };
        match change {
            Change::Insert(at) => _ = rows::insert(part, self.table, *at),
            Change::Delete(rows) => rows::delete(part.table_mut(self.table), rows),
            Change::Duplicate(rows) => rows::duplicate(part, self.table, rows),
            Change::Move { rows, down } => return sheet::shift(part.table_mut(self.table), rows, *down),
        }
        true
    }

    fn copied(&self, rows: &RangeInclusive<usize>) -> Option<String> {
        let list = self.list();
        list.get(*rows.start()..(rows.end() + 1).min(list.len())).map(crate::storage::export::tsv)
    }

    fn paste(&self, document: &mut Document, at: (usize, usize), text: &str) -> Option<Result<usize, String>> {
        let unit = document.unit;
        let column = self.columns.get(at.1).copied().unwrap_or(Column::Kind);
        let part = document.content.turned_part_mut()?;
        Some(tsv::paste(part, self.table, at.0, column, text, unit))
    }

    /// The worst message about a cell.
    fn mark(&self, session: &Session, row: usize, column: usize) -> Option<String> {
        let (id, column) = self.id(row).zip(self.columns.get(column).copied())?;
        let about = |at: &Place| matches!(at, Place::Section { column: Some(c), .. } if *c == column);
        let found = session.problems_of_row(id).find(|d| d.severity >= Severity::Warning && about(&d.at))?;
        let hint = found.hint.as_ref().map(|hint| format!("\n{hint}")).unwrap_or_default();
        Some(format!("{}{hint}", found.message))
    }

    fn look(&self, session: &Session, row: usize) -> RowLook {
        let Some(id) = self.id(row) else { return RowLook::default() };
        RowLook {
            lit: session.lit().sections.contains(&id),
            wrong: session.problems_of_row(id).any(|d| d.severity == Severity::Error),
        }
    }

    fn picture(&self, painter: &Painter, cell: Rect, at: (usize, usize), color: Color32) -> f32 {
        let section = self.list().get(at.0).filter(|_| self.columns.get(at.1) == Some(&Column::Kind));
        let Some(section) = section else { return 0.0 };
        let picture = Rect::from_center_size(egui::pos2(cell.left() + 13.0, cell.center().y), vec2(14.0, 9.0));
        icon::paint(painter, picture, &section.kind, color);
        PICTURE
    }

    fn point_at(&self, row: usize, requests: &mut Requests) {
        requests.hovered = self.id(row).map(Hovered::Section);
    }

    fn selected(&self, session: &Session) -> Option<usize> {
        let id = session.selection.section?;
        self.list().iter().position(|section| section.id == id)
    }

    fn select(&self, session: &mut Session, row: usize, _column: usize) {
        session.selection.section = self.id(row);
    }
}
