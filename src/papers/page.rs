//! A page: lines, arcs and texts on paper.

use super::view::View;
use crate::geometry::{Contour, Point, Segment};

/// A sheet of the ISO A series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// 841 × 1189 mm.
    A0,
    /// 594 × 841 mm.
    A1,
    /// 420 × 594 mm.
    A2,
    /// 297 × 420 mm.
    A3,
    /// 210 × 297 mm.
    A4,
}

impl Paper {
    /// Every size, the smallest first.
    pub const ALL: [Self; 5] = [Self::A4, Self::A3, Self::A2, Self::A1, Self::A0];

    /// Shorter and longer side, mm (ISO 216).
    #[must_use]
    pub const fn sides_mm(self) -> (f64, f64) {
        match self {
            Self::A0 => (841.0, 1189.0),
            Self::A1 => (594.0, 841.0),
            Self::A2 => (420.0, 594.0),
            Self::A3 => (297.0, 420.0),
            Self::A4 => (210.0, 297.0),
        }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::A0 => "A0",
            Self::A1 => "A1",
            Self::A2 => "A2",
            Self::A3 => "A3",
            Self::A4 => "A4",
        }
    }
}

impl std::str::FromStr for Paper {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|paper| paper.name().eq_ignore_ascii_case(text.trim()));
        found.ok_or_else(|| format!("\"{text}\" is no paper size; use A0 to A4."))
    }
}

/// One page. On paper a point's `z` runs to the right and its `r` upwards from the lower left corner, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    /// Width, mm.
    pub width_mm: f64,
    /// Height, mm.
    pub height_mm: f64,
    /// Title for the file's properties.
    pub title: String,
    /// What stands on it, in order of drawing.
    pub items: Vec<Item>,
    /// How the part lies on it, where it shows one to scale; a DXF file has the part in its true size then.
    pub part: Option<View>,
}

/// Something on a page.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// A line along segments, with or without an area inside.
    Path {
        /// Segments that follow one another.
        path: Contour,
        /// How the line is drawn; none for an area without an edge.
        pen: Option<Pen>,
        /// Colour of the area inside.
        fill: Option<Ink>,
    },
    /// A line of text.
    Text {
        /// Where it stands: on its base line, at the side that `align` says.
        at: Point,
        /// Height of its capitals, mm.
        height_mm: f64,
        /// Which end of the text is at `at`.
        align: Align,
        /// True for a text that is read from the right of the page.
        upright: bool,
        /// True for a heading.
        bold: bool,
        /// Colour.
        ink: Ink,
        /// The characters.
        text: String,
    },
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// Width, mm.
    pub width_mm: f64,
    /// Kind of line.
    pub stroke: Stroke,
    /// Colour.
    pub ink: Ink,
}

/// Kinds of line of technical drawings (ISO 128).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// Continuous.
    Solid,
    /// Long dashes and dots: axes.
    Centre,
    /// Dashes: hidden edges and what is not the part.
    Dashed,
}

/// Colours of a paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    /// Lines of the part, texts.
    Black,
    /// Remarks.
    Grey,
    /// Light areas: the part's section, heads of tables.
    Pale,
    /// The stock.
    Sand,
    /// What is wrong.
    Red,
    /// What is right.
    Green,
}

/// Which end of a text is at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Align {
    /// Its beginning.
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

impl Ink {
    /// Red, green, blue.
    #[must_use]
    pub const fn rgb(self) -> [u8; 3] {
        match self {
            Self::Black => [0x1f, 0x29, 0x33],
            Self::Grey => [0x6b, 0x76, 0x84],
            Self::Pale => [0xdc, 0xe6, 0xf1],
            Self::Sand => [0xf6, 0xeb, 0xd0],
            Self::Red => [0xd5, 0x5e, 0x00],
            Self::Green => [0x00, 0x80, 0x5c],
        }
    }
}

impl Pen {
    /// Visible edges (ISO 128: 0.5 mm on A4 to A2).
    pub const EDGE: Self = Self { width_mm: 0.5, stroke: Stroke::Solid, ink: Ink::Black };
    /// Dimension and extension lines.
    pub const THIN: Self = Self { width_mm: 0.25, stroke: Stroke::Solid, ink: Ink::Black };
    /// Axes.
    pub const CENTRE: Self = Self { width_mm: 0.25, stroke: Stroke::Centre, ink: Ink::Black };
    /// Outlines of what is not the part.
    pub const DASHED: Self = Self { width_mm: 0.25, stroke: Stroke::Dashed, ink: Ink::Black };
}

impl Stroke {
    /// Lengths of dash, gap, dash, gap ... in mm; empty for a continuous line.
    #[must_use]
    pub const fn dashes_mm(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Centre => &[6.0, 1.0, 0.5, 1.0],
            Self::Dashed => &[2.0, 1.0],
        }
    }
}

impl Page {
    /// An empty page.
    #[must_use]
    pub fn new(width_mm: f64, height_mm: f64, title: &str) -> Self {
        Self { width_mm, height_mm, title: clean(title), items: Vec::new(), part: None }
    }

    /// A line along `segments`.
    pub(super) fn path(&mut self, segments: Vec<Segment>, pen: Pen) {
        self.items.push(Item::Path { path: Contour::new(segments), pen: Some(pen), fill: None });
    }

    /// An area with an optional edge.
    pub(super) fn area(&mut self, segments: Vec<Segment>, fill: Ink, pen: Option<Pen>) {
        self.items.push(Item::Path { path: Contour::new(segments), pen, fill: Some(fill) });
    }

    /// A straight line.
    pub(super) fn line(&mut self, from: Point, to: Point, pen: Pen) {
        self.path(vec![Segment::line(from, to)], pen);
    }

    /// The outline of a rectangle.
    pub(super) fn rectangle(&mut self, min: Point, max: Point, pen: Pen) {
        let corners = [min, Point::new(max.z, min.r), max, Point::new(min.z, max.r)];
        self.path(Contour::polygon(&corners).segments, pen);
    }

    /// A text of black ink.
    pub(super) fn text(&mut self, at: Point, height_mm: f64, align: Align, text: impl Into<String>) {
        self.ink_text(at, height_mm, align, Ink::Black, text);
    }

    /// A text of any ink.
    pub(super) fn ink_text(&mut self, at: Point, height_mm: f64, align: Align, ink: Ink, text: impl Into<String>) {
        let text = clean(&text.into());
        self.items.push(Item::Text { at, height_mm, align, upright: false, bold: false, ink, text });
    }

    /// A heading.
    pub(super) fn heading(&mut self, at: Point, height_mm: f64, text: impl Into<String>) {
        let (ink, text) = (Ink::Black, clean(&text.into()));
        self.items.push(Item::Text { at, height_mm, align: Align::Start, upright: false, bold: true, ink, text });
    }

    /// A text read from the right of the page.
    pub(super) fn upright_text(&mut self, at: Point, height_mm: f64, align: Align, text: impl Into<String>) {
        let (ink, text) = (Ink::Black, clean(&text.into()));
        self.items.push(Item::Text { at, height_mm, align, upright: true, bold: false, ink, text });
    }
}

/// A text without control characters, which would end lines, labels or whole files.
fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::papers::{dxf, hpgl, pdf, svg};

    #[test]
    fn control_characters_of_a_name_reach_no_file() {
        let name = "A\r\n  0\nEOF\u{3}PU;<B>\u{0}";
        let mut page = Page::new(100.0, 50.0, name);
        page.text(Point::new(1.0, 1.0), 2.5, Align::Start, name);
        page.heading(Point::new(1.0, 9.0), 2.5, name);
        page.upright_text(Point::new(1.0, 19.0), 2.5, Align::End, name);
        assert!(page.items.iter().all(|i| matches!(i, Item::Text { text, .. } if !text.contains(char::is_control))));
        let file = dxf(&page).unwrap();
        assert_eq!(::dxf::Drawing::load(&mut file.as_bytes()).unwrap().entities().count(), 3);
        assert_eq!(hpgl(&page).matches('\u{3}').count(), 3);
        assert!(!svg(&page).contains(|c: char| c.is_control() && c != '\n'));
        assert!(pdf(&[page]).is_ok());
    }
}
