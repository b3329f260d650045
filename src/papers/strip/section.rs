//! The drawing of the finished section: its outline with overall sizes, numbers at its elements, and the table of them.

use super::{Placed, Subject, axis, draw_strip, placed, remark};
use crate::diagnostic::Diagnostic;
use crate::document::{Element, ElementKind, Origin};
use crate::geometry::{Point, Vector};
use crate::papers::arrow;
use crate::papers::drawing::DrawingChoice;
use crate::papers::frame;
use crate::papers::page::{Align, Ink, Page, Paper, Pen};
use crate::regen::Derived;
use crate::rollform::bends::Stage;
use crate::rollform::developed::element_mm;
use crate::rollform::strip::{Side, Strip};
use crate::units::trimmed;

/// Largest scale of a section.
const MOST: f64 = 50.0;
/// Distance of dimension lines from the section, mm: beyond the numbers of the elements.
const DIMENSION_MM: f64 = 15.0;
/// Distance of element numbers from the face, mm.
const NUMBER_MM: f64 = 6.0;
/// Numbers are not closer to one another, mm.
const APART_MM: f64 = 4.2;
/// Height of a row of the table, mm.
const ROW_MM: f64 = 5.0;
/// Widths of the columns of the table, mm.
const COLUMNS_MM: [f64; 5] = [12.0, 22.0, 24.0, 22.0, 26.0];
/// Height of the figures, mm.
const TEXT_MM: f64 = 2.5;

/// The section on one sheet, and the table of its elements on the next ones.
///
/// # Errors
/// A diagnostic if there is nothing to draw or the scale asked for does not fit, with the largest that does.
pub(in crate::papers) fn section_drawing(derived: &Derived, choice: DrawingChoice) -> Result<Vec<Page>, Diagnostic> {
    let subject = Subject::of(derived)?;
    let strip = subject.derived.flower.at(Stage::Finished).map(|shape| shape.strip.clone());
    let strip = strip.unwrap_or_else(|| Strip::at(&subject.set.scaled(subject.unit().in_mm()), Stage::Finished));
    let placed = placed(&strip, choice, MOST)?;
    let rows = rows(&subject);
    let tables: Vec<&[[String; 5]]> = rows.chunks(rows_on(placed.paper)).collect();
    let count = 1 + tables.len();
    let name = || subject.document.name.clone();
    let mut page = subject.page(name(), &placed.scale.name(), placed.paper, (1, count));
    draw_strip(&mut page, &placed.view, &strip);
    if !matches!(subject.set.section.origin, Origin::LeftToRight | Origin::RightToLeft) {
        axis(&mut page, &placed);
    }
    overall(&mut page, &placed, &subject);
    numbers(&mut page, &placed, &strip, &subject);
    remark(&mut page, placed.paper, "Finished section");
    page.part = Some(placed.view);
    let mut pages = vec![page];
    for (number, rows) in (2..).zip(tables) {
        let mut page = subject.page(name(), "–", placed.paper, (number, count));
        remark(&mut page, placed.paper, "Elements from the origin");
        table(&mut page, placed.paper, rows);
        pages.push(page);
    }
    Ok(pages)
}

/// Overall width below and overall height at the right.
fn overall(page: &mut Page, placed: &Placed, subject: &Subject<'_>) {
    let (min, max) = (placed.view.place(placed.bounds.min), placed.view.place(placed.bounds.max));
    let size = placed.bounds.max - placed.bounds.min;
    let (below, right) = (min.r - DIMENSION_MM, max.z + DIMENSION_MM);
    for z in [min.z, max.z] {
        page.line(Point::new(z, min.r - 1.0), Point::new(z, below - 2.0), Pen::THIN);
    }
    dimension(page, Point::new(min.z, below), Point::new(max.z, below));
    page.text(Point::new(f64::midpoint(min.z, max.z), below + 1.2), TEXT_MM, Align::Middle, subject.length(size.x));
    for r in [min.r, max.r] {
        page.line(Point::new(max.z + 1.0, r), Point::new(right + 2.0, r), Pen::THIN);
    }
    dimension(page, Point::new(right, min.r), Point::new(right, max.r));
    let at = Point::new(right - 1.2, f64::midpoint(min.r, max.r));
    page.upright_text(at, TEXT_MM, Align::Middle, subject.length(size.y));
}

/// A line with arrows at both ends.
fn dimension(page: &mut Page, from: Point, to: Point) {
    page.line(from, to, Pen::THIN);
    arrow::head(page, from, from - to);
    arrow::head(page, to, to - from);
}

/// Numbers of the elements at the upper face, as far as they have room; of a symmetrical section only those at the right.
fn numbers(page: &mut Page, placed: &Placed, strip: &Strip, subject: &Subject<'_>) {
    let symmetrical = subject.set.section.origin == Origin::Symmetrical;
    let mut taken: Vec<Point> = Vec::new();
    for piece in strip.pieces.iter().filter(|piece| !symmetrical || piece.side == Side::Right) {
        let along = piece.top.direction_at(0.5);
        let outward = Vector::new(-along.y, along.x);
        let foot = placed.view.place(piece.top.point_at(0.5));
        let at = foot + outward * NUMBER_MM;
        if taken.iter().any(|other| other.distance(at) < APART_MM) {
            continue;
        }
        taken.push(at);
        page.line(foot, at - outward * (TEXT_MM * 0.8), Pen::THIN);
        let number = number_of(subject, piece.element);
        page.text(at - Vector::new(0.0, TEXT_MM / 2.0), TEXT_MM, Align::Middle, number);
    }
}

fn number_of(subject: &Subject<'_>, id: u32) -> String {
    let place = |list: &[Element]| list.iter().position(|e| e.id == id).map(|index| index + 1);
    let section = &subject.set.section;
    let other = || place(&section.other_side).map(|number| format!("{number}'"));
    place(&section.elements).map(|number| number.to_string()).or_else(other).unwrap_or_default()
}

/// Number, type, length or inside radius, bend angle and mean length of every element.
fn rows(subject: &Subject<'_>) -> Vec<[String; 5]> {
    let section = &subject.set.section;
    let in_mm = subject.unit().in_mm();
    let row = |e: &Element| {
        let mean = subject.length(element_mm(&e.kind, section.thickness, section.developed_width) * in_mm);
        let number = number_of(subject, e.id);
        match e.kind {
            ElementKind::Line { length } => {
                [number, "line".to_owned(), subject.length(length * in_mm), "–".to_owned(), mean]
            }
            ElementKind::Bend { inside_radius, angle_deg } => {
                let kind = if angle_deg < 0.0 { "bend down" } else { "bend up" };
                let radius = format!("R {}", subject.length(inside_radius * in_mm));
                [number, kind.to_owned(), radius, format!("{}°", trimmed(angle_deg, 3)), mean]
            }
        }
    };
    section.all().map(row).collect()
}

/// Room for the head of the table and the remark above it, mm.
const HEAD_MM: f64 = 20.0;

/// Rows of the table that a sheet holds, in as many columns of tables as fit side by side.
fn rows_on(paper: Paper) -> usize {
    (rows_high(paper) * tables_wide(paper)).max(1)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a sheet holds a few hundred rows at most")]
fn rows_high(paper: Paper) -> usize {
    let room = frame::room(paper);
    ((room.max.r - room.min.r - HEAD_MM) / ROW_MM).floor().max(1.0) as usize
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a sheet holds a few tables at most")]
fn tables_wide(paper: Paper) -> usize {
    let room = frame::room(paper);
    ((room.max.z - room.min.z - 4.0) / (COLUMNS_MM.iter().sum::<f64>() + 8.0)).floor().max(1.0) as usize
}

fn table(page: &mut Page, paper: Paper, rows: &[[String; 5]]) {
    let room = frame::room(paper);
    let width: f64 = COLUMNS_MM.iter().sum();
    let mut left = room.min.z + 4.0;
    let top = room.max.r - 14.0;
    for part in rows.chunks(rows_high(paper)) {
        let head = ["no.", "type", "length / r", "bend", "mean length"].map(str::to_owned);
        line(page, Point::new(left, top), &head, Ink::Grey);
        page.line(Point::new(left, top - 1.6), Point::new(left + width, top - 1.6), Pen::THIN);
        for (index, row) in (1..).zip(part) {
            line(page, Point::new(left, top - f64::from(index) * ROW_MM), row, Ink::Black);
        }
        left += width + 8.0;
    }
}

/// A row of the table on its base line; words stand left, figures right.
fn line(page: &mut Page, at: Point, cells: &[String; 5], ink: Ink) {
    let mut left = at.z;
    for (index, (cell, width)) in cells.iter().zip(COLUMNS_MM).enumerate() {
        let (align, z) = if index == 1 { (Align::Start, left + 4.0) } else { (Align::End, left + width - 2.0) };
        page.ink_text(Point::new(z, at.r), TEXT_MM, align, ink, cell.clone());
        left += width;
    }
}
