//! The main view with its rows of figures at one scale on one sheet.

use super::detail::Detail;
use super::figure;
use super::marks::Mark;
use super::row::{Place, Row, TEXT_MM};
use super::subject::Subject;
use super::zones::{self, Zone};
use crate::geometry::{Bounds, Point, Segment, Vector};
use crate::papers::arrow;
use crate::papers::body::Body;
use crate::papers::page::{Align, Page, Pen};
use crate::papers::view::{View, mirrored};

/// Room beside the view for the largest diameter, mm.
const SIDE_MM: f64 = 18.0;
/// Least distance of figures from the frame, mm.
const MARGIN_MM: f64 = 4.0;
/// Distance of the largest diameter's dimension line from the view, mm.
const DIAMETER_MM: f64 = 9.0;
/// Extension lines end this far behind their dimension line and begin this far from the outline, mm.
const EXTENSION_MM: (f64, f64) = (1.5, 0.8);
/// Height of the capitals of a detail's letter, mm.
const LETTER_MM: f64 = 3.5;

/// Why a view does not fit.
pub(super) enum Unfit {
    /// The view and its rows are larger than the room.
    Size,
    /// This many figures have to stand in one row.
    Figures(usize),
}

/// A main view that fits.
pub(super) struct Layout {
    view: View,
    above: Row,
    below: Row,
    /// What is shown in details.
    pub(super) zones: Vec<Zone>,
}

impl Layout {
    /// Fits the view into `room` at this scale, with a detail wherever figures would crowd each other.
    pub(super) fn new(subject: &Subject<'_>, room: Bounds, scale: f64) -> Result<Self, Unfit> {
        let Bounds { min, max } = subject.bounds;
        let length = max.z - min.z;
        if length * scale > room.max.z - room.min.z - 2.0 * SIDE_MM {
            return Err(Unfit::Size);
        }
        let (mut above, mut below) = (subject.outside_leaders.clone(), subject.outside_positions.clone());
        let mut zones = zones::zones(above.iter().chain(&below), scale, length);
        if subject.bore.is_some() {
            // All figures of the outside share one row; what no detail has room for stays there.
            let half = Bounds { max: Point::new(f64::midpoint(room.min.z, room.max.z), room.max.r), ..room };
            zones.retain(|zone| Detail::new(subject, *zone, half, scale).is_some());
        }
        let shown_in_a_detail = |mark: &Mark| zones.iter().any(|zone| zone.holds(mark));
        above.retain(|mark| !shown_in_a_detail(mark));
        below.retain(|mark| !shown_in_a_detail(mark));
        if subject.bore.is_some() {
            above.append(&mut below);
            below.clone_from(&subject.bore_marks);
        }
        let origin_z = f64::midpoint(room.min.z, room.max.z) - f64::midpoint(min.z, max.z) * scale;
        let mut view = View { origin: Point::new(origin_z, 0.0), scale };
        let along = (room.min.z + MARGIN_MM, room.max.z - MARGIN_MM);
        let row = |marks: Vec<Mark>| {
            let count = marks.len();
            Row::new(marks, &view, along).ok_or(Unfit::Figures(count))
        };
        let (above, below) = (row(above)?, row(below)?);
        let half = max.r * scale;
        let height = above.height_mm() + 2.0 * half + below.height_mm();
        let spare = room.max.r - room.min.r - 2.0 * MARGIN_MM - height;
        if spare < 0.0 {
            return Err(Unfit::Size);
        }
        view.origin.r = room.min.r + MARGIN_MM + spare / 2.0 + below.height_mm() + half;
        Ok(Self { view, above, below, zones })
    }

    /// How the part lies on the sheet.
    pub(super) const fn view(&self) -> View {
        self.view
    }

    /// Draws the view and its figures.
    pub(super) fn draw(&self, page: &mut Page, subject: &Subject<'_>) {
        let view = self.view;
        draw_part(page, subject, view);
        let half = subject.bounds.max.r * view.scale;
        self.above.draw(page, &view, Place { side: 1.0, half: 1.0, edge_r: view.origin.r + half });
        self.below.draw(page, &view, Place { side: -1.0, half: -1.0, edge_r: view.origin.r - half });
        largest_diameter(page, subject, view);
        for (k, zone) in self.zones.iter().enumerate() {
            self.draw_zone(page, subject, *zone, &zones::letter(k));
        }
    }

    /// The frame around what a detail shows, with its letter.
    fn draw_zone(&self, page: &mut Page, subject: &Subject<'_>, zone: Zone, letter: &str) {
        let around = Vector::new(1.0, 1.0);
        let (low, high) =
            (subject.outside.smallest_radius(zone.from, zone.to), subject.outside.largest_radius(zone.from, zone.to));
        let min = self.view.place(Point::new(zone.from, low)) - around;
        let max = self.view.place(Point::new(zone.to, high)) + around;
        page.rectangle(min, max, Pen::THIN);
        // Towards the middle of the part, where there is more room.
        let part = subject.bounds;
        let r = min.r - LETTER_MM - 0.5;
        if f64::midpoint(zone.from, zone.to) < f64::midpoint(part.min.z, part.max.z) {
            page.text(Point::new(max.z + 1.0, r), LETTER_MM, Align::Start, letter);
        } else {
            page.text(Point::new(min.z - 1.0, r), LETTER_MM, Align::End, letter);
        }
    }
}

/// The part: a view of a solid one, a half section of one with a bore.
fn draw_part(page: &mut Page, subject: &Subject<'_>, view: View) {
    let bore: &[Segment] = subject.bore.as_ref().map(|b| b.segments.as_slice()).unwrap_or_default();
    let body = Body { view, outside: &subject.outside.segments, bore, pen: Pen::EDGE };
    if !bore.is_empty() {
        body.hatch_lower(page);
    }
    let [outside, inside] = subject.threads();
    let thread_ends: Vec<Point> = outside.iter().flat_map(|thread| thread.ends).collect();
    body.edges(page, &thread_ends);
    body.bore_lower(page);
    body.outlines(page);
    for root in outside.iter().map(|thread| thread.root) {
        page.path(vec![view.segment(&root)], Pen::THIN);
        page.path(vec![view.segment(&mirrored(&root))], Pen::THIN);
    }
    for root in inside.iter().map(|thread| thread.root) {
        page.path(vec![view.segment(&mirrored(&root))], Pen::THIN);
    }
    view.axis(page, subject.bounds.min.z, subject.bounds.max.z);
}

/// The largest diameter beside the view.
fn largest_diameter(page: &mut Page, subject: &Subject<'_>, view: View) {
    let bounds = subject.bounds;
    let from = view.place(subject.outside.largest().unwrap_or(bounds.max));
    let x = view.place(bounds.min).z - DIAMETER_MM;
    let (top, bottom) = (from.r, 2.0 * view.origin.r - from.r);
    for r in [top, bottom] {
        page.line(Point::new(from.z - EXTENSION_MM.1, r), Point::new(x - EXTENSION_MM.0, r), Pen::THIN);
    }
    page.line(Point::new(x, bottom), Point::new(x, top), Pen::THIN);
    arrow::head(page, Point::new(x, top), Vector::new(0.0, 1.0));
    arrow::head(page, Point::new(x, bottom), Vector::new(0.0, -1.0));
    let text = figure::diameter(bounds.max.r, subject.document.unit);
    page.upright_text(Point::new(x - 1.2, view.origin.r + TEXT_MM), TEXT_MM, Align::Start, text);
}
