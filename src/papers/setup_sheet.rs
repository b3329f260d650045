//! The setup sheet: what the operator needs beside the lathe, for one clamping.

use super::body::Body;
use super::font::fitted;
use super::page::{Align, Ink, Page, Paper, Pen};
use super::tool_picture;
use super::view::View;
use crate::diagnostic::Severity;
use crate::document::{Content, Holding, TurnedPart};
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::machine::{Catalog, Machine};
use crate::proof::Motion;
use crate::regen::{Derived, SetupDerived};
use crate::units::Unit;

/// Borders of the page, mm.
const LEFT_MM: f64 = 20.0;
/// Borders of the page, mm.
const RIGHT_MM: f64 = 195.0;
/// Borders of the page, mm.
const TOP_MM: f64 = 285.0;
/// Borders of the page, mm.
const BOTTOM_MM: f64 = 15.0;
/// Height of the capitals of text, mm.
const TEXT_MM: f64 = 2.3;
/// From one line of text to the next, mm.
const LINE_MM: f64 = 5.5;
/// Height of the picture of the set-up, mm.
const PICTURE_MM: f64 = 75.0;
/// Side of a tool's picture, mm.
const TOOL_MM: f64 = 18.0;
/// Findings that are told; the others are counted.
const MOST_FINDINGS: usize = 12;

/// The pages of one clamping's setup sheet, A4 upright: part, stock, holding, program zero, tools with pictures, operations
/// and programs with their times, and what the proof found.
#[must_use]
pub fn setup_sheets(derived: &Derived, item: &SetupDerived, catalog: &Catalog) -> Vec<Page> {
    let Content::TurnedPart(part) = &derived.document.content;
    let sheet = Subject { derived, item, catalog, part, unit: derived.document.unit };
    let mut writer = Writer::new(&item.name);
    sheet.head(&mut writer);
    sheet.facts(&mut writer);
    sheet.picture(&mut writer);
    sheet.tools(&mut writer);
    sheet.operations(&mut writer);
    sheet.programs(&mut writer);
    sheet.findings(&mut writer);
    writer.done()
}

/// Writes from the top of a page to its end, and on a new one.
struct Writer {
    title: String,
    pages: Vec<Page>,
    page: Page,
    r: f64,
}

impl Writer {
    fn new(name: &str) -> Self {
        let title = format!("Setup sheet {name}");
        Self { page: empty(&title), title, pages: Vec::new(), r: TOP_MM }
    }

    /// Makes room for something of this height, on a new page if there is none left.
    fn need(&mut self, height: f64) {
        if self.r - height < BOTTOM_MM {
            let full = std::mem::replace(&mut self.page, empty(&self.title));
            self.pages.push(full);
            self.r = TOP_MM;
        }
    }

    fn heading(&mut self, text: &str) {
        self.need(4.0 * LINE_MM);
        self.r -= 1.7 * LINE_MM;
        self.page.heading(Point::new(LEFT_MM, self.r), 3.0, text);
        self.r -= 2.0;
        self.rule();
    }

    fn rule(&mut self) {
        self.page.line(Point::new(LEFT_MM, self.r), Point::new(RIGHT_MM, self.r), Pen::THIN);
    }

    /// One line of a table.
    fn row(&mut self, cells: &[Cell<'_>]) {
        self.need(LINE_MM);
        self.r -= LINE_MM;
        for cell in cells {
            let text = fitted(&cell.text, TEXT_MM, cell.width);
            let z = if cell.align == Align::End { cell.z + cell.width } else { cell.z };
            self.page.ink_text(Point::new(z, self.r + 1.2), TEXT_MM, cell.align, cell.ink, text);
        }
    }

    fn done(mut self) -> Vec<Page> {
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
struct Cell<'a> {
    z: f64,
    width: f64,
    align: Align,
    ink: Ink,
    text: std::borrow::Cow<'a, str>,
}

fn cell<'a>(z: f64, width: f64, text: impl Into<std::borrow::Cow<'a, str>>) -> Cell<'a> {
    Cell { z, width, align: Align::Start, ink: Ink::Black, text: text.into() }
}

fn grey<'a>(z: f64, width: f64, text: impl Into<std::borrow::Cow<'a, str>>) -> Cell<'a> {
    Cell { ink: Ink::Grey, ..cell(z, width, text) }
}

fn figure<'a>(z: f64, width: f64, text: impl Into<std::borrow::Cow<'a, str>>) -> Cell<'a> {
    Cell { align: Align::End, ..cell(z, width, text) }
}

/// What the sheet is about.
struct Subject<'a> {
    derived: &'a Derived,
    item: &'a SetupDerived,
    catalog: &'a Catalog,
    part: &'a TurnedPart,
    unit: Unit,
}

impl Subject<'_> {
    fn machine(&self) -> Option<&Machine> {
        self.derived.machine.as_deref()
    }

    /// A length of the set-up in the document's unit.
    fn length(&self, mm: f64) -> String {
        format!("{:.*} {}", self.unit.decimals(), mm / self.unit.in_mm() + 0.0, self.unit.symbol())
    }

    fn head(&self, to: &mut Writer) {
        to.r -= 6.0;
        to.page.heading(Point::new(LEFT_MM, to.r), 5.0, fitted(&self.item.name, 5.0, 110.0));
        let (ink, verdict) =
            if self.item.proof.passed { (Ink::Green, "Proved") } else { (Ink::Red, "NOT PROVED: do not run") };
        to.page.ink_text(Point::new(RIGHT_MM, to.r), 3.5, Align::End, ink, verdict);
        to.r -= 3.0;
        to.rule();
    }

    fn facts(&self, to: &mut Writer) {
        let setup = &self.item.setup;
        let stock = setup.stock.bounds().map_or(0.0, |b| b.max.z - setup.chuck_face_z);
        let times = &self.item.proof.times;
        let holding = match self.part.holding {
            Holding::Chuck => "chuck",
            Holding::BetweenCentres => "between centres",
        };
        let end = if setup.turned_round { "second end, turned round" } else { "from the free end" };
        let zero = self.item.path.program_zero_z - setup.length;
        let zero = if zero.abs() < 5e-4 {
            "on the axis at the finished free end".to_owned()
        } else {
            format!("on the axis, {} from the finished free end", self.length(zero))
        };
        let rows = [
            ("Machine", self.machine().map_or(String::new(), |m| m.name.clone())),
            ("Material", self.part.material.clone()),
            ("Bar", format!("Ø {}, {} out of the chuck", self.length(2.0 * setup.bar_radius), self.length(stock))),
            ("Holding", format!("{holding}, {end}")),
            ("Program zero", zero),
            ("Finished length", self.length(setup.length)),
            (
                "Time",
                format!(
                    "{} (cutting {}, rapid {}, tool changes {})",
                    minutes(times.total_s),
                    minutes(times.feed_s),
                    minutes(times.rapid_s),
                    minutes(times.tool_change_s)
                ),
            ),
        ];
        for (name, value) in rows {
            to.row(&[grey(LEFT_MM, 32.0, name), cell(LEFT_MM + 34.0, RIGHT_MM - LEFT_MM - 34.0, value)]);
        }
    }

    /// Stock, part, chuck and program zero, to scale.
    fn picture(&self, to: &mut Writer) {
        let setup = &self.item.setup;
        let Some(stock) = setup.stock.bounds() else { return };
        to.need(PICTURE_MM + 4.0);
        let (low, high) = (to.r - PICTURE_MM, to.r - 4.0);
        let shown = Bounds { min: Point::new(stock.min.z, 0.0), max: Point::new(stock.max.z, stock.max.r) };
        let chuck = self.machine().map(|m| (setup.chuck_face_z - m.chuck.depth_mm, m.chuck.radius_mm));
        let min_z = chuck.map_or(shown.min.z, |(z, _)| z.min(shown.min.z));
        let max_r = chuck.map_or(shown.max.r, |(_, r)| r.max(shown.max.r));
        let (width, height) = (shown.max.z - min_z, 2.0 * max_r);
        let scale = ((RIGHT_MM - LEFT_MM - 20.0) / width).min((high - low - 6.0) / height);
        let middle_z = f64::midpoint(LEFT_MM, RIGHT_MM) - f64::midpoint(min_z, shown.max.z) * scale;
        let view = View { origin: Point::new(middle_z, f64::midpoint(low, high)), scale };
        if let Some((z, r)) = chuck {
            draw_chuck(&mut to.page, &view, z, setup.chuck_face_z, r, setup.bar_radius);
        }
        let bar = |p: Point| {
            Contour::polygon(&[Point::new(shown.min.z, -p.r), Point::new(p.z, -p.r), p, Point::new(shown.min.z, p.r)])
        };
        to.page.area(view.segments(&bar(shown.max).segments), Ink::Sand, Some(Pen::DASHED));
        let bore = self.item.bore.as_ref().as_ref().map(|b| b.contour.segments.as_slice()).unwrap_or_default();
        let body = Body { view, outside: &self.item.contour.contour.segments, bore };
        body.fill(&mut to.page, Ink::Pale);
        body.edges(&mut to.page, &[]);
        body.bore_lower(&mut to.page);
        body.outlines(&mut to.page);
        view.axis(&mut to.page, min_z, shown.max.z);
        draw_zero(&mut to.page, view.place(Point::new(self.item.path.program_zero_z, 0.0)));
        to.r = low;
    }

    fn tools(&self, to: &mut Writer) {
        to.heading("Tools");
        let mut stations: Vec<u32> = self.item.path.operations.iter().map(|o| o.tool).collect();
        stations.sort_unstable();
        stations.dedup();
        for station in stations {
            to.need(TOOL_MM + 3.0);
            to.r -= TOOL_MM + 2.0;
            if let Some(outline) = self.item.tools.get(&station) {
                tool_picture::draw(&mut to.page, outline, Point::new(LEFT_MM, to.r), TOOL_MM);
            }
            let text_z = LEFT_MM + TOOL_MM + 5.0;
            let width = RIGHT_MM - text_z;
            let name = fitted(&format!("{station}   {}", self.tool_name(station)), 2.6, width);
            to.page.heading(Point::new(text_z, to.r + TOOL_MM - 5.0), 2.6, name);
            let uses: Vec<&str> =
                self.item.path.operations.iter().filter(|o| o.tool == station).map(|o| o.name.as_str()).collect();
            let uses = fitted(&uses.join(", "), TEXT_MM, width);
            to.page.ink_text(Point::new(text_z, to.r + TOOL_MM - 10.5), TEXT_MM, Align::Start, Ink::Grey, uses);
        }
    }

    fn tool_name(&self, station: u32) -> String {
        let turret = self.machine().and_then(|m| m.tools.iter().find(|t| t.station == station));
        let tool = turret.and_then(|t| self.catalog.tool(&t.tool));
        tool.map_or("not in the turret".to_owned(), |tool| tool.name.clone())
    }

    fn operations(&self, to: &mut Writer) {
        to.heading("Operations");
        for (k, operation) in self.item.path.operations.iter().enumerate() {
            let blocks: usize = self
                .item
                .post
                .programs
                .iter()
                .map(|p| p.blocks.iter().filter(|b| b.operation_index == Some(k)).count())
                .sum();
            to.row(&[
                figure(LEFT_MM, 8.0, (k + 1).to_string()),
                cell(LEFT_MM + 12.0, 85.0, operation.name.as_str()),
                cell(LEFT_MM + 100.0, 20.0, format!("tool {}", operation.tool)),
                figure(LEFT_MM + 120.0, 25.0, format!("{blocks} blocks")),
                figure(LEFT_MM + 148.0, 27.0, minutes(self.operation_s(k))),
            ]);
        }
    }

    /// Time of all moves of an operation, s.
    fn operation_s(&self, index: usize) -> f64 {
        let of = |program: usize, block: usize| {
            self.item.post.programs.get(program)?.blocks.get(block.checked_sub(1)?)?.operation_index
        };
        let moves = self.item.proof.moves.iter().filter(|m| of(m.program, m.block) == Some(index));
        moves.map(|m| m.lasts_s).sum()
    }

    fn programs(&self, to: &mut Writer) {
        to.heading("Programs");
        for (k, program) in self.item.post.programs.iter().enumerate() {
            let moves = self.item.proof.moves.iter().filter(|m| m.program == k);
            let (total, cutting) = moves.fold((0.0, 0.0), |(total, cutting), m| {
                let cuts = matches!(m.motion, Motion::Feed | Motion::Thread);
                (total + m.lasts_s, cutting + if cuts { m.lasts_s } else { 0.0 })
            });
            let edited = self.item.programs.get(k).is_some_and(|p| p.edited);
            to.row(&[
                cell(LEFT_MM, 60.0, format!("{}.{}", program.name, program.extension)),
                grey(LEFT_MM + 62.0, 35.0, if edited { "edited by hand" } else { "" }),
                figure(LEFT_MM + 95.0, 25.0, format!("{} blocks", program.blocks.len())),
                figure(LEFT_MM + 122.0, 28.0, minutes(total)),
                Cell { ink: Ink::Grey, ..figure(LEFT_MM + 148.0, 27.0, format!("cut {}", minutes(cutting))) },
            ]);
        }
    }

    fn findings(&self, to: &mut Writer) {
        let told: Vec<_> = self.item.proof.findings.iter().filter(|f| f.severity != Severity::Info).collect();
        if told.is_empty() {
            return;
        }
        to.heading("What the proof found");
        for finding in told.iter().take(MOST_FINDINGS) {
            let ink = if finding.severity == Severity::Error { Ink::Red } else { Ink::Black };
            let place = format!("{} block {}", finding.program, finding.block);
            to.row(&[
                Cell { ink, ..cell(LEFT_MM, 42.0, place) },
                cell(LEFT_MM + 44.0, RIGHT_MM - LEFT_MM - 44.0, finding.message.as_str()),
            ]);
        }
        if told.len() > MOST_FINDINGS {
            to.row(&[grey(LEFT_MM, 100.0, format!("and {} more", told.len() - MOST_FINDINGS))]);
        }
    }
}

/// The jaws above and below the bar.
fn draw_chuck(page: &mut Page, view: &View, from_z: f64, face_z: f64, radius: f64, bar_radius: f64) {
    let grey = Pen { ink: Ink::Grey, ..Pen::THIN };
    for side in [1.0, -1.0] {
        let corners = [(from_z, bar_radius), (face_z, bar_radius), (face_z, radius), (from_z, radius)];
        let corners = corners.map(|(z, r)| view.place(Point::new(z, side * r)));
        page.area(Contour::polygon(&corners).segments, Ink::Pale, Some(grey));
    }
}

/// The sign for the zero of the coordinates: a circle with two of its quarters filled.
fn draw_zero(page: &mut Page, at: Point) {
    const RADIUS_MM: f64 = 2.0;
    let on = |quarter: f64| {
        let angle = quarter * std::f64::consts::FRAC_PI_2;
        Point::new(at.z + RADIUS_MM * angle.cos(), at.r + RADIUS_MM * angle.sin())
    };
    let arc = |from: f64| Segment::Arc { start: on(from), end: on(from + 1.0), center: at, ccw: true };
    for quarter in [0.0, 2.0] {
        let sides = vec![Segment::line(at, on(quarter)), arc(quarter), Segment::line(on(quarter + 1.0), at)];
        page.area(sides, Ink::Black, None);
    }
    page.path((0..4).map(|k| arc(f64::from(k))).collect(), Pen::THIN);
}

/// A time as minutes and seconds.
fn minutes(seconds: f64) -> String {
    let whole = seconds.max(0.0).round();
    format!("{:.0}:{:02.0} min", (whole / 60.0).floor(), whole % 60.0)
}
