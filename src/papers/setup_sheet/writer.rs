//! Headings and rows from the top of a page to its end, and on a new one.

use crate::geometry::Point;
use crate::papers::font::{fitted, wrapped};
use crate::papers::page::{Align, Ink, Page, Paper, Pen};
use std::borrow::Cow;

/// Left border of the page, mm.
pub(in crate::papers) const LEFT_MM: f64 = 20.0;
/// Right border of the page, mm from the left.
pub(in crate::papers) const RIGHT_MM: f64 = 195.0;
/// Upper border of the page, mm from below.
const TOP_MM: f64 = 285.0;
/// Lower border of the page, mm.
const BOTTOM_MM: f64 = 15.0;
/// Height of the capitals of text, mm.
pub(in crate::papers) const TEXT_MM: f64 = 2.3;
/// From one line of text to the next, mm.
pub(in crate::papers) const LINE_MM: f64 = 5.2;

/// Writes from the top of a page to its end, and on a new one.
pub(in crate::papers) struct Writer {
    title: String,
    pages: Vec<Page>,
    /// The page being written.
    pub(in crate::papers) page: Page,
    /// The heading of what is being written.
    table: Option<String>,
    /// Height on the page down to which it is written, mm.
    pub(in crate::papers) r: f64,
}

impl Writer {
    /// Begins the sheet of a clamping.
    pub(in crate::papers) fn new(name: &str) -> Self {
        Self::titled(format!("Setup sheet {name}"))
    }

    /// Begins a paper with this title.
    pub(in crate::papers) fn titled(title: String) -> Self {
        Self { page: empty(&title), title, pages: Vec::new(), table: None, r: TOP_MM }
    }

    /// Makes room for something of this height, on a new page if there is none left; what goes on there says so.
    pub(in crate::papers) fn need(&mut self, height: f64) {
        if self.r - height < BOTTOM_MM {
            self.turn_over();
            if let Some(table) = self.table.clone() {
                self.write_heading(&format!("{table}, continued"));
            }
        }
    }

    fn turn_over(&mut self) {
        let full = std::mem::replace(&mut self.page, empty(&self.title));
        self.pages.push(full);
        self.r = TOP_MM;
    }

    /// A heading that stays with what follows, at least `follows` mm of it.
    pub(in crate::papers) fn heading(&mut self, text: &str, follows: f64) {
        if self.r - (1.5 * LINE_MM + 2.0 + follows) < BOTTOM_MM {
            self.turn_over();
        }
        self.table = Some(text.to_owned());
        self.write_heading(text);
    }

    fn write_heading(&mut self, text: &str) {
        self.r -= 1.5 * LINE_MM;
        self.page.heading(Point::new(LEFT_MM, self.r), 3.0, text);
        self.r -= 2.0;
        self.rule();
    }

    /// A line across the page.
    pub(in crate::papers) fn rule(&mut self) {
        self.page.line(Point::new(LEFT_MM, self.r), Point::new(RIGHT_MM, self.r), Pen::THIN);
    }

    /// One row of a table; texts that are too long for their column are cut with an ellipsis.
    pub(in crate::papers) fn row(&mut self, cells: &[Cell<'_>]) {
        self.need(LINE_MM);
        self.r -= LINE_MM;
        for cell in cells {
            let text = fitted(&cell.text, TEXT_MM, cell.width);
            let z = if cell.align == Align::End { cell.z + cell.width } else { cell.z };
            self.page.ink_text(Point::new(z, self.r + 1.2), TEXT_MM, cell.align, cell.ink, text);
        }
    }

    /// A row whose last text may take several lines.
    pub(in crate::papers) fn wrapped_row(&mut self, first: Option<Cell<'_>>, last: &Cell<'_>) {
        let mut first = first;
        for line in wrapped(&last.text, TEXT_MM, last.width) {
            let text = Cell { text: Cow::Owned(line), ..*last };
            match first.take() {
                Some(first) => self.row(&[first, text]),
                None => self.row(&[text]),
            }
        }
    }

    /// The pages with their numbers.
    pub(in crate::papers) fn done(mut self) -> Vec<Page> {
        self.pages.push(self.page);
        let count = self.pages.len();
        for (k, page) in self.pages.iter_mut().enumerate() {
            let text = format!("{}   {} of {count}", self.title, k + 1);
            page.ink_text(Point::new(RIGHT_MM, 8.0), 2.0, Align::End, Ink::Grey, text);
            page.ink_text(Point::new(LEFT_MM, 8.0), 2.0, Align::Start, Ink::Grey, "Turnwright");
        }
        self.pages
    }
}

fn empty(title: &str) -> Page {
    let (short, long) = Paper::A4.sides_mm();
    Page::new(short, long, title)
}

/// A text in a column.
pub(in crate::papers) struct Cell<'a> {
    /// Left border, mm.
    pub(in crate::papers) z: f64,
    /// Width, mm.
    pub(in crate::papers) width: f64,
    /// Side at which the text stands.
    pub(in crate::papers) align: Align,
    /// Colour.
    pub(in crate::papers) ink: Ink,
    /// The characters.
    pub(in crate::papers) text: Cow<'a, str>,
}

/// A text at the left of its column.
pub(in crate::papers) fn cell<'a>(z: f64, width: f64, text: impl Into<Cow<'a, str>>) -> Cell<'a> {
    Cell { z, width, align: Align::Start, ink: Ink::Black, text: text.into() }
}

/// A remark.
pub(in crate::papers) fn grey<'a>(z: f64, width: f64, text: impl Into<Cow<'a, str>>) -> Cell<'a> {
    Cell { ink: Ink::Grey, ..cell(z, width, text) }
}

/// A figure at the right of its column.
pub(in crate::papers) fn figure<'a>(z: f64, width: f64, text: impl Into<Cow<'a, str>>) -> Cell<'a> {
    Cell { align: Align::End, ..cell(z, width, text) }
}
