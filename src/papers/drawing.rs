//! The dimensioned drawing of a finished part.
//!
//! One view along the axis. Diameters, radii and threads stand in a row above it, positions (running dimensions from the
//! clamped end, ISO 129-1) in a row below it; labels that would stand on one another are moved aside, with kinked leaders.

use super::frame::{self, Field};
use super::labels::spread_within;
use super::page::{Align, Page, Paper, Pen};
use super::view::View;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Content, Document, TurnedPart};
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::part::{Section, SectionKind};
use crate::regen::Derived;
use crate::units::Unit;

/// Scales of technical drawings (ISO 5455), the largest first: mm on paper for one mm of the part.
const SCALES: [(f64, &str); 12] = [
    (50.0, "50:1"),
    (20.0, "20:1"),
    (10.0, "10:1"),
    (5.0, "5:1"),
    (2.0, "2:1"),
    (1.0, "1:1"),
    (0.5, "1:2"),
    (0.2, "1:5"),
    (0.1, "1:10"),
    (0.05, "1:20"),
    (0.02, "1:50"),
    (0.01, "1:100"),
];
/// Height of the capitals of dimensions, mm.
const TEXT_MM: f64 = 2.5;
/// Distance from one label to the next, mm.
const LABEL_GAP_MM: f64 = 4.0;
/// Room for a row of labels with its leaders, mm.
const ROW_MM: f64 = 34.0;
/// Room beside the view for the largest diameter, mm.
const SIDE_MM: f64 = 16.0;
/// Distance of the first kink of a leader from the view, mm.
const CLEAR_MM: f64 = 3.0;
/// Length of the slanting part of a leader, mm.
const SLANT_MM: f64 = 5.0;
/// Two positions closer than this are one, mm of the part.
const SAME_MM: f64 = 0.0005;

/// How a part is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawingChoice {
    /// Sheet, landscape.
    pub paper: Paper,
    /// mm on paper for one mm of the part; the largest usual scale that fits without.
    pub scale: Option<f64>,
}

/// The drawing of the finished part of `derived`.
///
/// # Errors
/// A diagnostic if there is no part to draw, it does not fit on the paper at the scale asked for (with the largest that
/// does), or it has more dimensions than the paper has room for.
pub fn drawing(derived: &Derived, choice: DrawingChoice) -> Result<Page, Diagnostic> {
    let document = &*derived.document;
    let Content::TurnedPart(part) = &document.content;
    let contour = derived.setups.first().map(|s| finished(&s.contour.contour)).unwrap_or_default();
    let Some(bounds) = contour.bounds() else {
        let message = "There is no part to draw: no row of the section table makes a contour.";
        return Err(Diagnostic::error("nothing-to-draw", Place::Document, message));
    };
    let (mut page, inside) = frame::framed(choice.paper, &document.name);
    let room = Bounds {
        min: Point::new(inside.min.z + SIDE_MM, inside.min.r + frame::BLOCK_HEIGHT_MM + ROW_MM),
        max: Point::new(inside.max.z - SIDE_MM, inside.max.r - ROW_MM),
    };
    let (scale, scale_name) = scale(&bounds, &room, choice)?;
    let middle = Point::new(f64::midpoint(room.min.z, room.max.z), f64::midpoint(room.min.r, room.max.r));
    let origin = Point::new(middle.z - f64::midpoint(bounds.min.z, bounds.max.z) * scale, middle.r);
    let view = View { origin, scale };
    view.body(&mut page, &contour);
    view.axis(&mut page, bounds.min.z, bounds.max.z);
    let sheet = Sheet { view, bounds, inside, unit: document.unit };
    sheet.row_above(&mut page, &above(part, document.unit, &contour), choice.paper)?;
    sheet.row_below(&mut page, &positions(&contour), choice.paper)?;
    sheet.largest_diameter(&mut page);
    title(&mut page, inside, document, part, scale_name, choice.paper);
    Ok(page)
}

/// The contour of the part itself, without the groove of parting off at negative positions.
fn finished(contour: &Contour) -> Contour {
    let segments = contour.segments.iter().filter(|s| s.start().z.min(s.end().z) >= -SAME_MM);
    Contour::new(segments.copied().collect())
}

fn scale(bounds: &Bounds, room: &Bounds, choice: DrawingChoice) -> Result<(f64, String), Diagnostic> {
    let (width, height) = (bounds.max.z - bounds.min.z, 2.0 * bounds.max.r);
    let fits = |scale: f64| width * scale <= room.max.z - room.min.z && height * scale <= room.max.r - room.min.r;
    let largest = SCALES.into_iter().find(|(scale, _)| fits(*scale));
    match (choice.scale, largest) {
        (None, Some((scale, name))) => Ok((scale, name.to_owned())),
        (Some(scale), _) if scale > 0.0 && fits(scale) => Ok((scale, name_of(scale))),
        (asked, largest) => Err(too_large(asked, largest, (width, height), choice.paper)),
    }
}

fn name_of(scale: f64) -> String {
    let known = SCALES.into_iter().find(|(s, _)| (s - scale).abs() < 1e-9);
    known.map_or_else(
        || if scale >= 1.0 { format!("{scale}:1") } else { format!("1:{}", 1.0 / scale) },
        |(_, name)| name.to_owned(),
    )
}

fn too_large(asked: Option<f64>, largest: Option<(f64, &str)>, (z, d): (f64, f64), paper: Paper) -> Diagnostic {
    let asked = asked.map_or(String::new(), |scale| format!(" at {}", name_of(scale)));
    let limit =
        largest.map_or("no usual scale does".to_owned(), |(_, name)| format!("{name} is the largest that does"));
    let message =
        format!("A part {z:.1} mm long and {d:.1} mm in diameter does not fit on {}{asked}; {limit}.", paper.name());
    Diagnostic::error("drawing-scale", Place::Document, message).with_hint("Choose a larger paper or a smaller scale.")
}

/// A label with the point of the part that it belongs to.
struct Label {
    of: Point,
    text: String,
}

/// What is said above the view: the diameters, radii and threads of all rows, in order of position.
fn above(part: &TurnedPart, unit: Unit, contour: &Contour) -> Vec<Label> {
    let on_contour = |z: f64| contour.segments.iter().any(|s| s.start().z <= z + SAME_MM && z <= s.end().z + SAME_MM);
    let part_mm = part.scaled(unit.in_mm());
    let mut labels: Vec<Label> = part_mm.sections.iter().flat_map(|s| labels_of(s, unit)).collect();
    labels.retain(|l| l.of.is_finite() && on_contour(l.of.z));
    labels.sort_by(|a, b| a.of.z.total_cmp(&b.of.z));
    labels.dedup_by(|a, b| a.text == b.text && (a.of.z - b.of.z).abs() < SAME_MM);
    labels
}

/// The labels of one row, mm.
fn labels_of(s: &Section, unit: Unit) -> Vec<Label> {
    let label = |z: f64, d: f64, text: String| Label { of: Point::new(z, d / 2.0), text };
    let diameter = |d: f64| format!("Ø {}", number(d, unit));
    let middle = f64::midpoint(s.z1, s.z2);
    let ends = || vec![label(s.z1, s.d1, diameter(s.d1)), label(s.z2, s.d2, diameter(s.d2))];
    match s.kind {
        SectionKind::Line if (s.d1 - s.d2).abs() < SAME_MM => vec![label(middle, s.d1, diameter(s.d1))],
        SectionKind::Line | SectionKind::ParabolaAlongZ { .. } | SectionKind::ParabolaAlongX { .. } => ends(),
        SectionKind::Thread { pitch, .. } => {
            let text = format!("thread {} × {}", number(s.d1, unit), number(pitch, unit));
            vec![label(middle, s.d1, text)]
        }
        SectionKind::Concave { radius } | SectionKind::Convex { radius } => {
            let mut all = ends();
            // The leader of a radius ends at the chord; on an arc of a turned part that is next to the arc itself.
            all.push(label(middle, f64::midpoint(s.d1, s.d2), format!("R {}", number(radius, unit))));
            all
        }
    }
}

/// Every position where the contour changes, in order.
fn positions(contour: &Contour) -> Vec<f64> {
    let mut all: Vec<f64> = contour.segments.iter().flat_map(|s| [s.start().z, s.end().z]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| (*a - *b).abs() < SAME_MM);
    all
}

/// A length in the document's unit without trailing zeros.
fn number(mm: f64, unit: Unit) -> String {
    let text = format!("{:.*}", unit.decimals(), mm / unit.in_mm());
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A page being dimensioned.
struct Sheet {
    view: View,
    bounds: Bounds,
    inside: Bounds,
    unit: Unit,
}

impl Sheet {
    fn places(&self, wanted: &[f64], paper: Paper) -> Result<Vec<f64>, Diagnostic> {
        let (from, to) = (self.inside.min.z + LABEL_GAP_MM, self.inside.max.z - LABEL_GAP_MM);
        spread_within(wanted, LABEL_GAP_MM, from, to).ok_or_else(|| {
            let (count, most) = (wanted.len(), ((to - from) / LABEL_GAP_MM).floor() + 1.0);
            let message = format!("The part has {count} dimensions in one row; {} has room for {most}.", paper.name());
            Diagnostic::error("drawing-crowded", Place::Document, message).with_hint("Choose a larger paper.")
        })
    }

    /// Radial dimensions with leaders from the contour.
    fn row_above(&self, page: &mut Page, labels: &[Label], paper: Paper) -> Result<(), Diagnostic> {
        let wanted: Vec<f64> = labels.iter().map(|l| self.view.place(l.of).z).collect();
        let places = self.places(&wanted, paper)?;
        let top = self.view.place(Point::new(0.0, self.bounds.max.r)).r + CLEAR_MM;
        for (label, x) in labels.iter().zip(places) {
            let from = self.view.place(label.of);
            let text_at = top + SLANT_MM + 2.0;
            page.path(leader(from, top, x, top + SLANT_MM, text_at - 0.7), Pen::THIN);
            page.upright_text(Point::new(x + TEXT_MM / 2.0, text_at), TEXT_MM, Align::Start, label.text.clone());
        }
        Ok(())
    }

    /// Running dimensions from position 0.
    fn row_below(&self, page: &mut Page, positions: &[f64], paper: Paper) -> Result<(), Diagnostic> {
        let wanted: Vec<f64> = positions.iter().map(|z| self.view.place(Point::new(*z, 0.0)).z).collect();
        let places = self.places(&wanted, paper)?;
        let bottom = self.view.place(Point::new(0.0, -self.bounds.max.r)).r - CLEAR_MM;
        for (z, x) in positions.iter().zip(places) {
            // From the largest radius, so that no extension line crosses an edge.
            let from = self.view.place(Point::new(*z, -self.bounds.max.r));
            let text_at = bottom - SLANT_MM - 2.0;
            page.path(leader(from, bottom, x, bottom - SLANT_MM, text_at + 0.7), Pen::THIN);
            page.upright_text(Point::new(x + TEXT_MM / 2.0, text_at), TEXT_MM, Align::End, number(*z, self.unit));
        }
        Ok(())
    }

    /// The largest diameter beside the view.
    fn largest_diameter(&self, page: &mut Page) {
        let corner = self.view.place(Point::new(self.bounds.min.z, self.bounds.max.r));
        let (top, bottom) = (corner.r, 2.0 * self.view.origin.r - corner.r);
        let x = corner.z - 8.0;
        for r in [top, bottom] {
            page.line(Point::new(corner.z - 1.0, r), Point::new(x - 1.5, r), Pen::THIN);
        }
        page.line(Point::new(x, bottom), Point::new(x, top), Pen::THIN);
        arrow(page, Point::new(x, top), 1.0);
        arrow(page, Point::new(x, bottom), -1.0);
        let text = format!("Ø {}", number(2.0 * self.bounds.max.r, self.unit));
        page.upright_text(Point::new(x - 1.2, self.view.origin.r), TEXT_MM, Align::Middle, text);
    }
}

/// From a point straight to height `r1`, slanting to `x` at height `r2`, straight to `r3`.
fn leader(from: Point, r1: f64, x: f64, r2: f64, r3: f64) -> Vec<Segment> {
    let points = [from, Point::new(from.z, r1), Point::new(x, r2), Point::new(x, r3)];
    points.windows(2).map(|w| Segment::line(w[0], w[1])).collect()
}

/// An arrow head that points up (`side` 1) or down (−1).
fn arrow(page: &mut Page, tip: Point, side: f64) {
    let (length, half) = (2.5, 0.4);
    let base = tip.r - side * length;
    let corners = [tip, Point::new(tip.z - half, base), Point::new(tip.z + half, base)];
    page.area(Contour::polygon(&corners).segments, super::page::Ink::Black, None);
}

fn title(page: &mut Page, inside: Bounds, document: &Document, part: &TurnedPart, scale: String, paper: Paper) {
    let unit = document.unit;
    let tolerance = format!("± {} {}", number(part.form_tolerance * unit.in_mm(), unit), unit.symbol());
    let stock = format!("Ø {} {}", number(part.bar_diameter * unit.in_mm(), unit), unit.symbol());
    let fields = [
        Field { name: "Material", value: part.material.clone() },
        Field { name: "Bar", value: stock },
        Field { name: "Form tolerance", value: tolerance },
        Field { name: "Dimensions in", value: unit.symbol().to_owned() },
        Field { name: "Scale", value: scale },
        Field { name: "Sheet", value: paper.name().to_owned() },
    ];
    frame::title_block(page, inside, &document.name, &fields);
}
