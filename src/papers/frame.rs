//! The frame and the title block of a drawing (after ISO 5457 and ISO 7200).

use super::font::fitted;
use super::page::{Align, Ink, Page, Paper, Pen};
use crate::geometry::{Bounds, Point};

/// Border at the left, where the sheet is bound, mm.
const BOUND_MARGIN_MM: f64 = 20.0;
/// Border at the other sides, mm.
const MARGIN_MM: f64 = 10.0;
/// Width of the title block, mm.
const BLOCK_WIDTH_MM: f64 = 180.0;
/// Height of a row of the title block, mm.
const ROW_MM: f64 = 10.0;
/// Rows of the title block: the name and two of fields.
const ROWS: f64 = 3.0;
/// Distance of texts from the lines of the block, mm.
const INSET_MM: f64 = 1.5;

/// A field of the title block: what it is and what it says.
pub(super) struct Field {
    pub(super) name: &'static str,
    pub(super) value: String,
}

/// What a title block says.
pub(super) struct Block {
    /// Name of the part.
    pub(super) name: String,
    /// Fields below the name.
    pub(super) upper: Vec<Field>,
    /// Scale of its views: `2:1`.
    pub(super) scale: String,
    /// Number of the sheet, and how many there are.
    pub(super) sheet: (usize, usize),
}

impl Field {
    pub(super) fn new(name: &'static str, value: impl Into<String>) -> Self {
        Self { name, value: value.into() }
    }
}

impl Block {
    /// Fields that every drawing has; empty ones are filled in by hand.
    fn lower(&self, paper: Paper) -> Vec<Field> {
        let (number, count) = self.sheet;
        vec![
            Field::new("Drawn", ""),
            Field::new("Approved", ""),
            Field::new("Date", ""),
            Field::new("Scale", self.scale.as_str()),
            Field::new("Paper", paper.name()),
            Field::new("Sheet", format!("{number} of {count}")),
        ]
    }
}

/// A landscape page with its frame.
pub(super) fn framed(paper: Paper, title: &str) -> Page {
    let (short, long) = paper.sides_mm();
    let mut page = Page::new(long, short, title);
    let inside = inside(paper);
    page.rectangle(inside.min, inside.max, Pen::EDGE);
    page
}

/// What of a sheet is free for views: inside the frame and above the title block.
pub(super) fn room(paper: Paper) -> Bounds {
    let inside = inside(paper);
    Bounds { min: Point::new(inside.min.z, inside.min.r + ROWS * ROW_MM), ..inside }
}

fn inside(paper: Paper) -> Bounds {
    let (short, long) = paper.sides_mm();
    Bounds { min: Point::new(BOUND_MARGIN_MM, MARGIN_MM), max: Point::new(long - MARGIN_MM, short - MARGIN_MM) }
}

/// The title block in the lower right corner.
pub(super) fn title_block(page: &mut Page, paper: Paper, block: &Block) {
    let inside = inside(paper);
    let min = Point::new(inside.max.z - BLOCK_WIDTH_MM, inside.min.r);
    let top = min.r + ROWS * ROW_MM;
    page.rectangle(min, Point::new(inside.max.z, top), Pen::EDGE);
    let name_at = Point::new(min.z + INSET_MM, top - ROW_MM + 3.0);
    page.heading(name_at, 4.0, fitted(&block.name, 4.0, BLOCK_WIDTH_MM - 50.0));
    let made_by = Point::new(inside.max.z - INSET_MM, name_at.r);
    page.ink_text(made_by, 2.0, Align::End, Ink::Grey, "Turnwright");
    for (fields, top) in [(&block.upper, top - ROW_MM), (&block.lower(paper), top - 2.0 * ROW_MM)] {
        page.line(Point::new(min.z, top), Point::new(inside.max.z, top), Pen::THIN);
        row(page, Point::new(min.z, top), fields);
    }
}

/// Fields side by side, from their upper left corner.
fn row(page: &mut Page, corner: Point, fields: &[Field]) {
    let width = BLOCK_WIDTH_MM / fields.len().max(1) as f64;
    let mut left = corner.z;
    for field in fields {
        if left > corner.z {
            page.line(Point::new(left, corner.r - ROW_MM), Point::new(left, corner.r), Pen::THIN);
        }
        let at = |below: f64| Point::new(left + INSET_MM, corner.r - below);
        page.ink_text(at(3.2), 1.8, Align::Start, Ink::Grey, field.name);
        page.text(at(ROW_MM - 1.8), 2.5, Align::Start, fitted(&field.value, 2.5, width - 2.0 * INSET_MM));
        left += width;
    }
}
