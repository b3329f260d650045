//! A table with a spreadsheet's habits over any rows of a document: Tab, Enter, arrows, F2, insert, delete, duplicate and move
//! a row, copy and paste of several, expressions in any figure.

mod keys;
mod table;

use crate::app::desk::Requests;
use crate::document::Document;
use crate::session::Session;
use egui::{Color32, Painter, Rect};
pub(crate) use keys::commit as leave;
use std::collections::HashMap;
use std::ops::RangeInclusive;
pub(crate) use table::show;

/// What a table shows, made anew for every frame from the document.
pub(crate) trait Sheet {
    /// What one row is called, `Element`; also the name under which the window knows the table.
    fn name(&self) -> &'static str;

    /// What a screen reader calls the table.
    fn title(&self) -> String {
        self.name().to_owned()
    }

    /// The columns.
    fn headings(&self) -> &[Heading];

    /// How many rows there are.
    fn rows(&self) -> usize;

    /// What is in front of a row: its number, most often.
    fn number(&self, row: usize) -> String {
        (row + 1).to_string()
    }

    /// What a text that did not fit is kept by: the row's place, or an id that stays with it when rows come and go.
    fn key(&self, row: usize) -> u32 {
        u32::try_from(row).unwrap_or(u32::MAX)
    }

    /// What a screen reader calls a row: `Element 3`.
    fn row_name(&self, row: usize) -> String {
        format!("{} {}", self.name(), self.number(row))
    }

    /// What a row is called in the history: `element 3`.
    fn row_label(&self, row: usize) -> String {
        self.row_name(row).to_lowercase()
    }

    /// A cell.
    fn cell(&self, row: usize, column: usize) -> Cell;

    /// Writes what is typed into a cell; the document stays as it is if the text does not fit.
    ///
    /// # Errors
    /// A sentence that says what would be right.
    fn write(&self, document: &mut Document, row: usize, column: usize, text: &str) -> Result<(), String>;

    /// Inserts, deletes, duplicates or moves rows; false if the table does not allow it.
    fn change(&self, document: &mut Document, change: &Change) -> bool;

    /// What the cells of these rows are on the clipboard, if it is not just their texts.
    fn copied(&self, _rows: &RangeInclusive<usize>) -> Option<String> {
        None
    }

    /// Pastes a text at a row and a column in a way of its own, rows added where they are needed, and tells how many rows were
    /// written or why none was; `None` if cells are written one by one.
    fn paste(&self, _document: &mut Document, _at: (usize, usize), _text: &str) -> Option<Result<usize, String>> {
        None
    }

    /// A message about a cell that is looked up only when the cell is drawn.
    fn mark(&self, _session: &Session, _row: usize, _column: usize) -> Option<String> {
        None
    }

    /// How a row stands out beside being selected.
    fn look(&self, _session: &Session, _row: usize) -> RowLook {
        RowLook::default()
    }

    /// Draws a picture in front of the text of a cell, and tells how much room it takes, points.
    fn picture(&self, _painter: &Painter, _cell: Rect, _at: (usize, usize), _color: Color32) -> f32 {
        0.0
    }

    /// The pointer is over a row.
    fn point_at(&self, _row: usize, _requests: &mut Requests) {}

    /// The row that is selected elsewhere.
    fn selected(&self, session: &Session) -> Option<usize>;

    /// Tells the rest of the window which row and column the cursor is on now.
    fn select(&self, session: &mut Session, row: usize, column: usize);
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Heading {
    /// What stands above it.
    pub(crate) title: String,
    /// Least width, points.
    pub(crate) least: f32,
    /// Words stand left, figures right.
    pub(crate) words: bool,
    /// True if the whole column is marked as the one in use.
    pub(crate) current: bool,
    /// True if the column keeps its least width where there is more room.
    pub(crate) fixed: bool,
}

/// How a row stands out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct RowLook {
    /// The pointer is over what belongs to it elsewhere.
    pub(crate) lit: bool,
    /// There is an error in it.
    pub(crate) wrong: bool,
}

impl Heading {
    /// A column of figures.
    pub(crate) fn figures(title: impl Into<String>, least: f32) -> Self {
        Self { title: title.into(), least, words: false, current: false, fixed: false }
    }

    /// A column of words.
    pub(crate) fn words(title: impl Into<String>, least: f32) -> Self {
        Self { title: title.into(), least, words: true, current: false, fixed: false }
    }
}

/// What a cell shows, and what can be done with it.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Cell {
    /// Its text; a dash is shown for none.
    pub(crate) text: String,
    /// What it can be.
    pub(crate) takes: Takes,
    /// Set off from its neighbours, as a value that was entered and not carried over.
    pub(crate) strong: bool,
    /// What is wrong with it.
    pub(crate) wrong: Option<String>,
}

/// What a cell can be.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) enum Takes {
    /// Nothing: it follows from others.
    #[default]
    Nothing,
    /// What is typed.
    Text,
    /// One of these words.
    Words(&'static [&'static str]),
}

/// What can be done with rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Change {
    /// A row before this one.
    Insert(usize),
    /// Away with these.
    Delete(RangeInclusive<usize>),
    /// Copies after them.
    Duplicate(RangeInclusive<usize>),
    /// One place down or up.
    Move {
        /// These rows.
        rows: RangeInclusive<usize>,
        /// Down.
        down: bool,
    },
}

/// Cursor and editing of one table.
#[derive(Debug, Default)]
pub(crate) struct SheetView {
    cursor: Cursor,
    editing: Option<Editing>,
    /// Texts that did not fit their cells, with the reason.
    bad: HashMap<(u32, usize), (String, String)>,
    /// The row that was selected elsewhere when that was last looked at.
    followed: Option<usize>,
    /// The row under the cursor is to be selected once the table knows it.
    settle: bool,
    reveal: bool,
    take_focus: bool,
}

/// The cell with the frame, and the other end of a selection of rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Cursor {
    row: usize,
    column: usize,
    other_row: usize,
    whole_rows: bool,
}

/// What is typed into a cell.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Editing {
    text: String,
    before: String,
    /// The text that the document has been told of.
    told: String,
    wrong: Option<String>,
}

impl Cursor {
    fn rows(self) -> RangeInclusive<usize> {
        self.row.min(self.other_row)..=self.row.max(self.other_row)
    }
}

impl SheetView {
    /// Puts the cursor on a cell and the keyboard into the table.
    pub(crate) fn go_to(&mut self, row: usize, column: usize) {
        self.cursor = Cursor { row, column, other_row: row, whole_rows: false };
        self.settle = true;
        self.reveal = true;
        self.take_focus = true;
    }

    /// True while a cell is being edited.
    pub(crate) const fn is_editing(&self) -> bool {
        self.editing.is_some()
    }
}

/// Moves items of a list one place up or down; false at its ends.
pub(crate) fn shift<T>(items: &mut [T], rows: &RangeInclusive<usize>, down: bool) -> bool {
    let (start, end) = (*rows.start(), *rows.end());
    let range = if down { start..end.saturating_add(2) } else { start.wrapping_sub(1)..end.saturating_add(1) };
    let Some(part) = items.get_mut(range) else { return false };
    if down {
        part.rotate_right(1);
    } else {
        part.rotate_left(1);
    }
    true
}
