//! The set-up to scale: stock, part, chuck, mandrel, tailstock and program zero.

use super::Subject;
use super::writer::{LEFT_MM, RIGHT_MM, TEXT_MM, Writer};
use crate::geometry::{Bounds, Contour, Point, Segment, Vector};
use crate::papers::arrow;
use crate::papers::body::{Body, finished};
use crate::papers::crop::within;
use crate::papers::page::{Align, Ink, Page, Pen};
use crate::papers::view::{View, mirrored};

/// Height of the picture with its dimensions, mm.
const PICTURE_MM: f64 = 64.0;
/// Room for the dimensions below it, mm.
const DIMENSIONS_MM: f64 = 14.0;
/// Room at the sides, mm.
const SIDE_MM: f64 = 12.0;
/// Jaws and centres are shown up to this many times the stock's radius.
const SHOWN_RADII: f64 = 1.6;
/// Jaws and centres are shown up to this many times the stock's length beside it.
const SHOWN_LENGTHS: f64 = 0.45;
/// Width of the part's edges, mm: the picture is small.
const EDGE_MM: f64 = 0.3;
/// Radius of the sign of the program zero, mm.
const ZERO_MM: f64 = 2.0;

/// Draws the set-up, as large as the page allows.
pub(super) fn picture(subject: &Subject<'_>, to: &mut Writer) {
    let setup = &subject.item.setup;
    let Some(stock) = setup.stock.bounds() else { return };
    to.need(PICTURE_MM + 6.0);
    let (low, high) = (to.r - PICTURE_MM, to.r - 4.0);
    let shown = shown(subject, stock);
    let (width, height) = (shown.max.z - shown.min.z, 2.0 * shown.max.r);
    let scale = ((RIGHT_MM - LEFT_MM - 2.0 * SIDE_MM) / width).min((high - low - DIMENSIONS_MM) / height);
    if !(scale.is_finite() && scale > 0.0) {
        return;
    }
    let left = f64::midpoint(LEFT_MM, RIGHT_MM) - f64::midpoint(shown.min.z, shown.max.z) * scale;
    let view = View { origin: Point::new(left, f64::midpoint(low + DIMENSIONS_MM, high)), scale };
    draw_holding(subject, &mut to.page, view, shown);
    draw_work(subject, &mut to.page, view);
    view.axis(&mut to.page, shown.min.z, shown.max.z);
    let zero = Point::new(subject.item.path.program_zero_z, 0.0);
    draw_zero(&mut to.page, view.place(zero));
    dimensions(subject, &mut to.page, view, stock, view.place(Point::new(0.0, -shown.max.r)).r);
    to.r = low;
}

/// What of stock and holding the picture shows.
fn shown(subject: &Subject<'_>, stock: Bounds) -> Bounds {
    let setup = &subject.item.setup;
    let beside = SHOWN_LENGTHS * (stock.max.z - stock.min.z);
    let mandrel = setup.mandrel.as_ref().and_then(Contour::bounds);
    let tailstock = setup.tailstock.as_ref().and_then(Contour::bounds);
    let jaws = subject.machine.map_or(0.0, |m| m.chuck.depth_mm);
    let left = mandrel.map_or(setup.chuck_face_z - jaws, |b| b.min.z).min(stock.min.z);
    let right = tailstock.map_or(stock.max.z, |b| b.max.z);
    let chuck = subject.machine.filter(|_| mandrel.is_none()).map_or(0.0, |m| m.chuck.radius_mm);
    let held = [mandrel, tailstock].into_iter().flatten().map(|b| b.max.r).fold(chuck, f64::max);
    let radius = stock.max.r.max(held.min(SHOWN_RADII * stock.max.r));
    Bounds {
        min: Point::new(left.max(stock.min.z.min(setup.chuck_face_z) - beside), 0.0),
        max: Point::new(right.min(stock.max.z + beside), radius),
    }
}

fn draw_work(subject: &Subject<'_>, page: &mut Page, view: View) {
    let outside = finished(&subject.item.contour.contour.segments);
    let bore = subject.item.bore.as_ref().as_ref().map(|b| finished(&b.contour.segments)).unwrap_or_default();
    let both = |segments: &[Segment]| -> [Vec<Segment>; 2] {
        [view.segments(segments), segments.iter().map(|s| view.segment(&mirrored(s))).collect()]
    };
    for half in both(&subject.item.setup.stock.segments) {
        page.area(half, Ink::Sand, None);
    }
    let pen = Pen { width_mm: EDGE_MM, ..Pen::EDGE };
    let body = Body { view, outside: &outside, bore: &bore, pen };
    body.fill(page, Ink::Pale);
    if bore.is_empty() {
        body.edges(page, &[]);
    } else {
        body.bore_in_full(page);
    }
    body.outlines(page);
    // Only the outside of the stock: its line on the axis is none of its edges.
    let off_axis: Vec<Segment> =
        subject.item.setup.stock.segments.iter().filter(|s| s.start().r.max(s.end().r) > 0.0).copied().collect();
    for segment in both(&off_axis).into_iter().flatten() {
        page.path(vec![segment], Pen::DASHED);
    }
}

/// Chuck, mandrel and tailstock, cut off where the picture ends.
fn draw_holding(subject: &Subject<'_>, page: &mut Page, view: View, shown: Bounds) {
    let setup = &subject.item.setup;
    let bodies = match (&setup.mandrel, subject.machine) {
        (Some(mandrel), _) => vec![mandrel.clone()],
        (None, Some(machine)) => {
            let (back, face) = (setup.chuck_face_z - machine.chuck.depth_mm, setup.chuck_face_z);
            let (inner, outer) = (gripped_radius(&setup.stock, face), machine.chuck.radius_mm);
            vec![Contour::polygon(&[
                Point::new(back, inner),
                Point::new(face, inner),
                Point::new(face, outer),
                Point::new(back, outer),
            ])]
        }
        (None, None) => Vec::new(),
    };
    let grey = Pen { ink: Ink::Grey, ..Pen::THIN };
    for body in bodies.iter().chain(&setup.tailstock) {
        let seen = within(&body.polyline(0.05), shown);
        for side in [1.0, -1.0] {
            let corners: Vec<Point> = seen.iter().map(|p| view.place(Point::new(p.z, side * p.r))).collect();
            if corners.len() > 2 {
                let edges = Contour::polygon(&corners).segments;
                page.area(edges.clone(), Ink::Pale, None);
                // Only the axis itself is drawn on the axis.
                let axis = view.origin.r;
                for edge in edges.into_iter().filter(|e| e.start().r != axis || e.end().r != axis) {
                    page.path(vec![edge], grey);
                }
            }
        }
    }
}

/// Largest radius of the stock to the left of the chuck's face, mm.
fn gripped_radius(stock: &Contour, face: f64) -> f64 {
    let shown = Bounds { min: Point::new(f64::MIN, 0.0), max: Point::new(face, f64::MAX) };
    within(&stock.polyline(0.05), shown).into_iter().map(|p| p.r).fold(0.0, f64::max)
}

/// The sign for the zero of the coordinates: a circle with two of its quarters filled.
fn draw_zero(page: &mut Page, at: Point) {
    let on = |quarter: f64| {
        let angle = quarter * std::f64::consts::FRAC_PI_2;
        Point::new(at.z + ZERO_MM * angle.cos(), at.r + ZERO_MM * angle.sin())
    };
    let arc = |from: f64| Segment::Arc { start: on(from), end: on(from + 1.0), center: at, ccw: true };
    for quarter in [0.0, 2.0] {
        let sides = vec![Segment::line(at, on(quarter)), arc(quarter), Segment::line(on(quarter + 1.0), at)];
        page.area(sides, Ink::Black, Some(Pen::THIN));
    }
    page.path((0..4).map(|k| arc(f64::from(k))).collect(), Pen::THIN);
}

/// From the chuck's face, or the clamped end between centres, to the program zero and to the end of the stock.
fn dimensions(subject: &Subject<'_>, page: &mut Page, view: View, stock: Bounds, low: f64) {
    let setup = &subject.item.setup;
    let from = if setup.mandrel.is_some() { stock.min.z.max(0.0) } else { setup.chuck_face_z };
    let mut ends = vec![subject.item.path.program_zero_z, stock.max.z];
    ends.dedup_by(|a, b| (*a - *b).abs() < 5e-4);
    ends.retain(|to| (to - from).abs() * view.scale > 2.0 * arrow::LENGTH_MM);
    for (to, below) in ends.into_iter().zip([5.0, 11.0]) {
        let at = |z: f64, r: f64| Point::new(view.place(Point::new(z, 0.0)).z, r);
        let line = low - below;
        for z in [from, to] {
            page.line(at(z, low - 1.0), at(z, line - 1.5), Pen::THIN);
        }
        page.line(at(from, line), at(to, line), Pen::THIN);
        let along = Vector::new((to - from).signum(), 0.0);
        arrow::head(page, at(to, line), along);
        arrow::head(page, at(from, line), -along);
        let middle = at(f64::midpoint(from, to), line + 1.0);
        page.text(middle, TEXT_MM, Align::Middle, subject.length((to - from).abs()));
    }
}
