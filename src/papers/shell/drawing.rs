//! The drawing of a finished shell: its section with sizes, and the table of its wall beside it.

use super::Subject;
use super::walls::{Wall, walls};
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Bounds, Contour, Point, Segment, Vector};
use crate::papers::DrawingChoice;
use crate::papers::arrow;
use crate::papers::drawing::scale::{SCALES, Scale};
use crate::papers::frame::{self, Block, Field};
use crate::papers::hatch::hatch;
use crate::papers::page::{Align, Ink, Page, Paper, Pen};
use crate::papers::view::{View, mirrored};
use crate::regen::Derived;

/// Room for dimensions at the sides of the view, mm.
const ASIDE_MM: f64 = 26.0;
/// Width of the table with its distance from the view, mm.
const TABLE_MM: f64 = 96.0;
/// Widths of the columns of the table, mm: number, then the figures of a wall.
const COLUMNS_MM: [f64; 6] = [9.0, 17.0, 18.0, 16.0, 14.0, 18.0];
/// Height of a row of the table, mm.
const ROW_MM: f64 = 5.0;
/// Height of the figures, mm.
const TEXT_MM: f64 = 2.5;
/// Distance of dimension lines from what they measure and from one another, mm.
const DIMENSION_MM: f64 = 9.0;
/// Distance of hatch lines, mm: a wall is thin.
const HATCH_MM: f64 = 1.2;
/// Distance of the wall's numbers from it, mm.
const NUMBER_MM: f64 = 5.0;

/// The section of the shell on one sheet.
///
/// # Errors
/// A diagnostic if there is nothing to draw or the scale asked for does not fit, with the largest that does.
pub(in crate::papers) fn drawing(derived: &Derived, choice: DrawingChoice) -> Result<Vec<Page>, Diagnostic> {
    let subject = Subject::of(derived)?;
    let bounds = bounds(&subject);
    let (paper, scale) = fitted(bounds, choice)?;
    let view = placed(bounds, paper, scale);
    let mut page = frame::framed(paper, &subject.document.name);
    frame::title_block(&mut page, paper, &block(&subject, &scale.name()));
    let walls = walls(&subject);
    section(&mut page, &subject, &view);
    dimensions(&mut page, &subject, &view, bounds);
    numbers(&mut page, &view, &walls);
    let room = frame::room(paper);
    table(&mut page, Point::new(room.max.z - TABLE_MM + 2.0, room.max.r - 8.0), &walls);
    remarks(&mut page, &subject, Point::new(room.max.z - TABLE_MM + 4.0, room.max.r - 22.0 - 10.0 * ROW_MM));
    page.part = Some(view);
    Ok(vec![page])
}

/// Around the shell, mirrored half included.
fn bounds(subject: &Subject<'_>) -> Bounds {
    let shape = &subject.made.shape;
    let end = shape.outside.segments.last().map_or(shape.base(), Segment::end);
    let most = shape.outside.bounds().map_or(end.r, |b| b.max.r);
    let low = end.z.min(shape.base().z);
    Bounds { min: Point::new(low, -most), max: Point::new(shape.tip().z + shape.thickness, most) }
}

/// The largest scale at which the view has room beside the table.
fn permissible(bounds: Bounds, paper: Paper) -> f64 {
    let room = frame::room(paper);
    let size = bounds.max - bounds.min;
    let wide = (room.max.z - room.min.z - TABLE_MM - 2.0 * ASIDE_MM) / size.x.max(1e-9);
    let high = (room.max.r - room.min.r - 2.0 * ASIDE_MM) / size.y.max(1e-9);
    wide.min(high)
}

fn fitted(bounds: Bounds, choice: DrawingChoice) -> Result<(Paper, Scale), Diagnostic> {
    let least = choice.scale.unwrap_or(1.0);
    let by_itself = || {
        let holds = |least: f64| Paper::ALL.into_iter().find(|paper| permissible(bounds, *paper) >= least);
        let small = [Paper::A4, Paper::A3].into_iter().find(|paper| permissible(bounds, *paper) >= least);
        small.or_else(|| holds(least.min(0.5))).unwrap_or(Paper::A0)
    };
    let paper = choice.paper.unwrap_or_else(by_itself);
    let limit = permissible(bounds, paper);
    let factor = match choice.scale {
        Some(asked) if asked > 0.0 && asked <= limit => asked,
        Some(asked) => return Err(too_large(asked, limit, paper)),
        None => SCALES.into_iter().map(|s| s.factor).find(|f| *f <= limit).unwrap_or(limit),
    };
    Ok((paper, Scale { factor }))
}

fn too_large(asked: f64, limit: f64, paper: Paper) -> Diagnostic {
    let message =
        format!("The scale {asked} does not fit on {}; it must be more than 0 and at most {limit:.2}.", paper.name());
    Diagnostic::error("drawing-scale", Place::Document, message).with_hint("Choose a larger paper or a smaller scale.")
}

fn placed(bounds: Bounds, paper: Paper, scale: Scale) -> View {
    let room = frame::room(paper);
    let middle = Point::new(f64::midpoint(room.min.z, room.max.z - TABLE_MM), f64::midpoint(room.min.r, room.max.r));
    let of_shell = f64::midpoint(bounds.min.z, bounds.max.z);
    View { origin: Point::new(middle.z - of_shell * scale.factor, middle.r), scale: scale.factor }
}

fn block(subject: &Subject<'_>, scale: &str) -> Block {
    let shell = subject.shell();
    let blank = format!(
        "disc Ø {} × {}",
        subject.figure(2.0 * subject.made.shape.blank_radius),
        subject.figure(shell.blank.thickness)
    );
    Block {
        name: subject.document.name.clone(),
        upper: vec![
            Field::new("Material", shell.material.clone()),
            Field::new("Blank", blank),
            Field::new("Tolerance of the gap", format!("± {}", subject.figure(shell.gap_tolerance))),
            Field::new("Dimensions in", subject.unit().symbol().to_owned()),
        ],
        scale: scale.to_owned(),
        sheet: (1, 1),
    }
}

/// Both halves of the wall with the tip between them, cut and hatched, and the edge of the base behind the cut.
fn section(page: &mut Page, subject: &Subject<'_>, view: &View) {
    let half = wall_ring(subject);
    let upper = view.segments(&half);
    let lower: Vec<Segment> = half.iter().map(|s| view.segment(&mirrored(s))).collect();
    hatch(page, std::slice::from_ref(&upper), HATCH_MM);
    hatch(page, std::slice::from_ref(&lower), HATCH_MM);
    for ring in [upper, lower] {
        // The line on the axis is none of the shell's edges.
        let on_axis = |s: &Segment| [s.start(), s.end()].iter().all(|p| (p.r - view.origin.r).abs() < 1e-9);
        page.path(ring.into_iter().filter(|s| !on_axis(s)).collect(), Pen::EDGE);
    }
    let base = subject.made.shape.base();
    let edge = |side: f64| view.place(Point::new(base.z, side * base.r));
    page.line(edge(1.0), edge(-1.0), Pen::EDGE);
    let bounds = bounds(subject);
    view.axis(page, bounds.min.z, bounds.max.z);
}

/// The closed ring round the upper half of the wall.
fn wall_ring(subject: &Subject<'_>) -> Vec<Segment> {
    let shape = &subject.made.shape;
    let tip = shape.tip();
    let mut ring = vec![Segment::line(Point::new(tip.z, 0.0), tip)];
    let to = |ring: &mut Vec<Segment>, p: Point| {
        let from = ring.last().map_or(p, Segment::end);
        if from.distance(p) > 1e-9 {
            ring.push(Segment::line(from, p));
        }
    };
    ring.extend(shape.inside.segments.iter().copied());
    let outside: Vec<Segment> = shape.outside.segments.iter().rev().map(Segment::reversed).collect();
    outside.first().into_iter().for_each(|first| to(&mut ring, first.start()));
    ring.extend(outside);
    let face = tip.z + shape.thickness;
    for corner in [Point::new(face, tip.r), Point::new(face, 0.0), Point::new(tip.z, 0.0)] {
        to(&mut ring, corner);
    }
    Contour::new(ring).segments
}

/// Inside diameters of base and tip, inside and whole length, thickness of the tip.
fn dimensions(page: &mut Page, subject: &Subject<'_>, view: &View, bounds: Bounds) {
    let (tip, base) = (subject.made.shape.tip(), subject.made.shape.base());
    let (min, max) = (view.place(bounds.min), view.place(bounds.max));
    upright(page, view, base, min.z - DIMENSION_MM, &format!("Ø {}", subject.figure(2.0 * base.r)));
    upright(page, view, tip, max.z + DIMENSION_MM, &format!("Ø {}", subject.figure(2.0 * tip.r)));
    let low = min.r - DIMENSION_MM;
    let across = |from: Point, to: Point, r: f64, page: &mut Page| {
        for p in [from, to] {
            page.line(Point::new(p.z, p.r - 0.8), Point::new(p.z, r - 1.5), Pen::THIN);
        }
        let (a, b) = (Point::new(from.z, r), Point::new(to.z, r));
        page.line(a, b, Pen::THIN);
        arrow::head(page, a, a - b);
        arrow::head(page, b, b - a);
        let text = subject.figure((to.z - from.z).abs() / view.scale);
        page.text(Point::new(f64::midpoint(a.z, b.z), r + 1.2), TEXT_MM, Align::Middle, text);
    };
    let below = |p: Point| view.place(Point::new(p.z, -p.r));
    across(below(base), below(tip), low, page);
    let end = Point::new(bounds.min.z, bounds.max.r);
    let face = Point::new(bounds.max.z, tip.r);
    across(below(end), below(face), low - DIMENSION_MM, page);
}

/// A diameter at a line beside the view.
fn upright(page: &mut Page, view: &View, at: Point, z: f64, text: &str) {
    let (top, bottom) = (view.place(at), view.place(Point::new(at.z, -at.r)));
    let beyond = (z - top.z).signum();
    for from in [top, bottom] {
        page.line(Point::new(from.z + 0.8 * beyond, from.r), Point::new(z + 1.5 * beyond, from.r), Pen::THIN);
    }
    let (a, b) = (Point::new(z, bottom.r), Point::new(z, top.r));
    page.line(a, b, Pen::THIN);
    arrow::head(page, b, Vector::new(0.0, 1.0));
    arrow::head(page, a, Vector::new(0.0, -1.0));
    page.upright_text(Point::new(z - 1.2, view.origin.r + 3.0), TEXT_MM, Align::Start, text);
}

/// Numbers of the listed places, outside the wall.
fn numbers(page: &mut Page, view: &View, walls: &[Wall]) {
    let mut last: Option<Point> = None;
    for wall in walls {
        let (inside, outside) = (view.place(wall.inside), view.place(wall.outside));
        let Some(outward) = (outside - inside).try_normalize(1e-9) else { continue };
        let at = outside + outward * NUMBER_MM;
        if last.is_some_and(|p| p.distance(at) < 1.5 * TEXT_MM) {
            continue;
        }
        last = Some(at);
        page.line(inside, at - outward * (0.8 * TEXT_MM), Pen::THIN);
        page.text(at - Vector::new(0.0, TEXT_MM / 2.0), TEXT_MM, Align::Middle, wall.number.to_string());
    }
}

/// The table of the wall from its upper left corner.
fn table(page: &mut Page, corner: Point, walls: &[Wall]) {
    let width: f64 = COLUMNS_MM.iter().sum();
    page.heading(Point::new(corner.z + 2.0, corner.r), 3.0, "Wall along the shell");
    let head = ["no.", "from tip", "inside Ø", "angle", "wall", "reduction"].map(str::to_owned);
    let top = corner.r - 8.0;
    row(page, Point::new(corner.z, top), &head, Ink::Grey);
    page.line(Point::new(corner.z, top - 1.8), Point::new(corner.z + width, top - 1.8), Pen::THIN);
    for (k, wall) in (1..).zip(walls) {
        let [from, diameter, angle, thickness, reduction] = wall.cells.clone();
        let cells = [wall.number.to_string(), from, diameter, angle, thickness, reduction];
        row(page, Point::new(corner.z, top - f64::from(k) * ROW_MM), &cells, Ink::Black);
    }
}

fn row(page: &mut Page, at: Point, cells: &[String; 6], ink: Ink) {
    let mut left = at.z;
    for (cell, width) in cells.iter().zip(COLUMNS_MM) {
        page.ink_text(Point::new(left + width - 2.0, at.r), TEXT_MM, Align::End, ink, cell.clone());
        left += width;
    }
}

/// What the contour is, and where the shell differs from the former.
fn remarks(page: &mut Page, subject: &Subject<'_>, at: Point) {
    let mut lines = vec![format!("Inside: {}", subject.contour())];
    lines.extend(subject.made.shape.hollows.iter().filter(|h| h.stands_off > subject.shell().gap_tolerance).map(|h| {
        format!(
            "Spanned {} from the tip: inside R {}, {} off the former",
            subject.figure(subject.made.shape.tip().z - h.at.z),
            subject.figure(h.shell_radius),
            subject.figure(h.stands_off)
        )
    }));
    for (k, text) in (0..6).zip(lines) {
        page.ink_text(Point::new(at.z, at.r - f64::from(k) * ROW_MM), TEXT_MM, Align::Start, Ink::Grey, text);
    }
}
