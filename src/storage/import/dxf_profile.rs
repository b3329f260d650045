//! Lines and arcs of a drawing to rows of the section table.
//!
//! Nowhere on a turned outside does z go back, so the pieces that are not faces, each drawn from left to right, follow one
//! another by their positions alone; the order in the drawing does not matter.

use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Point, Segment};
use crate::part::{Section, SectionKind};
use crate::units::Unit;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The smallest x of the upper half of a drawing, which becomes the clamped end.
pub(super) fn origin(segments: &[Segment], tolerance: f64) -> f64 {
    let (run, _) = upper_half(segments, tolerance);
    run.first().map_or(0.0, |s| s.start().z)
}

/// The rows of the upper half of a drawing, from the clamped end at x = `origin` to the free end, with ids from `first_id`
/// on. Lengths and `tolerance` are in `unit`; ends nearer than `tolerance` are one.
pub(super) fn rows(
    segments: &[Segment],
    origin: f64,
    first_id: u32,
    tolerance: f64,
    unit: Unit,
    at: &Place,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Section> {
    let (run, faces) = upper_half(segments, tolerance);
    let mut rows = Rows { sections: Vec::new(), first_id, last: None, origin, tolerance, unit, at, diagnostics };
    for piece in &run {
        rows.add(piece, &faces);
    }
    rows.sections
}

/// The pieces of the upper half that are no faces, each and all of them from left to right, and the faces.
fn upper_half(segments: &[Segment], tolerance: f64) -> (Vec<Segment>, Vec<Segment>) {
    let pieces: Vec<Segment> = segments.iter().flat_map(split).collect();
    let above = |s: &&Segment| s.point_at(0.5).r > tolerance;
    let mut half: Vec<Segment> = pieces.iter().filter(above).copied().collect();
    if half.is_empty() {
        half = pieces.iter().map(turned_up).filter(|s| above(&s)).collect();
    }
    let (faces, mut run): (Vec<Segment>, Vec<Segment>) = half.into_iter().partition(|s| width(s) <= tolerance);
    run = run.into_iter().map(|s| if s.start().z <= s.end().z { s } else { s.reversed() }).collect();
    run.sort_by(|a, b| a.start().z.total_cmp(&b.start().z).then(a.end().z.total_cmp(&b.end().z)));
    (run, faces)
}

/// Extent along the spindle.
fn width(segment: &Segment) -> f64 {
    (segment.end().z - segment.start().z).abs()
}

fn turned_up(segment: &Segment) -> Segment {
    let up = |p: Point| Point::new(p.z, -p.r);
    match *segment {
        Segment::Line { start, end } => Segment::Line { start: up(start), end: up(end) },
        Segment::Arc { start, end, center, ccw } => {
            Segment::Arc { start: up(start), end: up(end), center: up(center), ccw: !ccw }
        }
    }
}

/// The segment in pieces that cross neither the centre line nor a quadrant of their circle.
fn split(segment: &Segment) -> Vec<Segment> {
    let mut cuts = cuts(segment);
    cuts.retain(|t| *t > 0.0 && *t < 1.0);
    cuts.sort_by(f64::total_cmp);
    let mut from = segment.start();
    let mut pieces = Vec::new();
    for to in cuts.into_iter().map(|t| segment.point_at(t)).chain([segment.end()]) {
        // A cut next to an end leaves a piece of no length.
        if to.distance(from) > f64::EPSILON * (1.0 + to.z.abs() + to.r.abs()) {
            pieces.push(match *segment {
                Segment::Line { .. } => Segment::line(from, to),
                Segment::Arc { center, ccw, .. } => Segment::Arc { start: from, end: to, center, ccw },
            });
            from = to;
        }
    }
    pieces
}

/// Where to cut, as parts of the segment's length; values outside 0 to 1 do not matter.
fn cuts(segment: &Segment) -> Vec<f64> {
    match *segment {
        Segment::Line { start, end } if start.r * end.r < 0.0 => vec![start.r / (start.r - end.r)],
        Segment::Line { .. } => Vec::new(),
        Segment::Arc { start, center, .. } => {
            let sweep = segment.sweep();
            let first = (start.r - center.r).atan2(start.z - center.z);
            let axis = (-center.r / start.distance(center)).asin();
            let quadrants = (0..4).map(|quarter| f64::from(quarter) * FRAC_PI_2);
            let at_axis = [axis, FRAC_PI_2 * 2.0 - axis].into_iter().filter(|a| a.is_finite());
            let angles = quadrants.chain(at_axis);
            // Angles so near the start that rounding may put them behind it belong to the start.
            angles
                .map(|a| (sweep.signum() * (a - first)).rem_euclid(TAU) / sweep.abs())
                .filter(|t| *t > 1e-12)
                .collect()
        }
    }
}

struct Rows<'a> {
    sections: Vec<Section>,
    first_id: u32,
    /// The piece behind the last row.
    last: Option<Segment>,
    /// Position in the drawing that becomes 0.
    origin: f64,
    tolerance: f64,
    unit: Unit,
    at: &'a Place,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Rows<'_> {
    fn add(&mut self, piece: &Segment, faces: &[Segment]) {
        let Some(last) = self.last else {
            return self.push(piece, piece.start());
        };
        let mut start = piece.start();
        let ahead = start.z - last.end().z;
        if ahead < -self.tolerance {
            return self.overlap(&last, piece);
        }
        if ahead > self.tolerance {
            let message = format!(
                "Between {} and {} the profile has a gap of {}.",
                self.shown(last.end()),
                self.shown(start),
                self.length(ahead)
            );
            self.warn("dxf-gap", message);
        } else {
            start.z = last.end().z;
            let step = start.r - last.end().r;
            if step.abs() <= self.tolerance {
                start.r = last.end().r;
            } else if !self.has_face(faces, last.end(), start.r) {
                let message = format!(
                    "At {} the radius changes by {} and no line is drawn there; it is taken as a face.",
                    self.shown(start),
                    self.length(step.abs())
                );
                self.warn("dxf-step", message);
            }
        }
        self.push(piece, start);
    }

    /// Two pieces above one another: one of them was drawn twice, belongs to a bore, or makes an overhang.
    fn overlap(&mut self, last: &Segment, piece: &Segment) {
        let near = |a: Point, b: Point| a.distance(b) <= self.tolerance;
        if near(last.start(), piece.start())
            && near(last.end(), piece.end())
            && near(last.point_at(0.5), piece.point_at(0.5))
        {
            return;
        }
        let (upper, lower) = if piece.point_at(0.5).r > last.point_at(0.5).r { (piece, last) } else { (last, piece) };
        let common = last.end().z.min(piece.end().z) - piece.start().z;
        let message = format!(
            "From {} to {} the profile lies below the piece from {} to {} for {}; an overhang cannot be turned, and a bore \
             belongs on the layer BORE. The lower piece is left out.",
            self.shown(lower.start()),
            self.shown(lower.end()),
            self.shown(upper.start()),
            self.shown(upper.end()),
            self.length(common)
        );
        self.diagnostics.push(Diagnostic::error("dxf-overhang", self.at.clone(), message));
        if std::ptr::eq(upper, piece) {
            self.sections.pop();
            self.push(piece, piece.start());
        }
    }

    /// True if the step at `from` up or down to radius `to` is drawn.
    fn has_face(&self, faces: &[Segment], from: Point, to: f64) -> bool {
        let (low, high) = (from.r.min(to), from.r.max(to));
        let drawn = faces.iter().filter(|f| (f.start().z - from.z).abs() <= self.tolerance).map(|f| {
            let (a, b) = (f.start().r.min(f.end().r), f.start().r.max(f.end().r));
            (b.min(high) - a.max(low)).max(0.0)
        });
        drawn.sum::<f64>() >= high - low - 2.0 * self.tolerance
    }

    fn push(&mut self, piece: &Segment, start: Point) {
        let end = piece.end();
        let kind = match (piece.radius(), piece) {
            (Some(radius), Segment::Arc { ccw: true, .. }) => SectionKind::Concave { radius },
            (Some(radius), _) => SectionKind::Convex { radius },
            (None, _) => SectionKind::Line,
        };
        let id = u32::try_from(self.sections.len()).unwrap_or(u32::MAX).saturating_add(self.first_id);
        let (z1, z2) = (start.z - self.origin, end.z - self.origin);
        self.sections.push(Section { id, z1, d1: 2.0 * start.r.max(0.0), z2, d2: 2.0 * end.r.max(0.0), kind });
        self.last = Some(*piece);
    }

    fn warn(&mut self, code: &str, message: String) {
        self.diagnostics.push(Diagnostic::warning(code, self.at.clone(), message));
    }

    /// A point as the drawing has it.
    fn shown(&self, p: Point) -> String {
        let decimals = self.unit.decimals();
        format!("x {:.decimals$} y {:.decimals$}", p.z, p.r)
    }

    fn length(&self, value: f64) -> String {
        format!("{value:.*} {}", self.unit.decimals(), self.unit.symbol())
    }
}
