//! The frame and the title block of a drawing (after ISO 5457 and ISO 7200).

use super::font::fitted;
use super::page::{Align, Ink, Page, Paper, Pen};
use crate::geometry::{Bounds, Point};

/// Border at the left, where the sheet is bound, mm.
const BOUND_MARGIN_MM: f64 = 20.0;
/// Border at the other sides, mm.
const MARGIN_MM: f64 = 10.0;
/// Title block, mm.
const BLOCK_WIDTH_MM: f64 = 180.0;
/// Title block, mm.
pub(super) const BLOCK_HEIGHT_MM: f64 = 24.0;
/// Distance of texts from the lines of the block, mm.
const INSET_MM: f64 = 1.5;

/// A field of the title block: what it is and what it says.
pub(super) struct Field<'a> {
    pub(super) name: &'a str,
    pub(super) value: String,
}

/// A landscape page with its frame; what is inside the frame.
pub(super) fn framed(paper: Paper, title: &str) -> (Page, Bounds) {
    let (short, long) = paper.sides_mm();
    let mut page = Page::new(long, short, title);
    let inside =
        Bounds { min: Point::new(BOUND_MARGIN_MM, MARGIN_MM), max: Point::new(long - MARGIN_MM, short - MARGIN_MM) };
    page.rectangle(inside.min, inside.max, Pen::EDGE);
    (page, inside)
}

/// The title block in the lower right corner: the name above, the fields in one row below it.
pub(super) fn title_block(page: &mut Page, inside: Bounds, name: &str, fields: &[Field<'_>]) {
    let min = Point::new(inside.max.z - BLOCK_WIDTH_MM, inside.min.r);
    let max = Point::new(inside.max.z, inside.min.r + BLOCK_HEIGHT_MM);
    page.rectangle(min, max, Pen::EDGE);
    let middle = min.r + BLOCK_HEIGHT_MM / 2.0;
    page.line(Point::new(min.z, middle), Point::new(max.z, middle), Pen::THIN);
    page.heading(Point::new(min.z + INSET_MM, middle + 3.5), 4.0, fitted(name, 4.0, BLOCK_WIDTH_MM - 50.0));
    let made_by = Point::new(max.z - INSET_MM, middle + 3.5);
    page.ink_text(made_by, 2.0, Align::End, Ink::Grey, "Turnwright");
    let width = BLOCK_WIDTH_MM / fields.len().max(1) as f64;
    let mut left = min.z;
    for field in fields {
        if left > min.z {
            page.line(Point::new(left, min.r), Point::new(left, middle), Pen::THIN);
        }
        let at = |r: f64| Point::new(left + INSET_MM, r);
        page.ink_text(at(middle - 3.5), 1.8, Align::Start, Ink::Grey, field.name);
        page.text(at(min.r + 2.5), 2.5, Align::Start, fitted(&field.value, 2.5, width - 2.0 * INSET_MM));
        left += width;
    }
}
