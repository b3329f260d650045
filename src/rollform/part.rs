//! A roll as a turned part: its elements are the rows of the section table.

use super::roll::{RollElement, contour};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Ends, Holding, RollKind, RollSet, RollWork, TurnedPart};
use crate::geometry::{Point, Segment};
use crate::part::{Section, SectionKind};
use crate::turning::cycles::{BLANK_ALLOWANCE_MM, standard_blank_mm};

/// Figures of rows have this many decimals; less is rounding of the arithmetic.
const DECIMALS: i32 = 6;

/// The part of a roll, in mm, and what is to be said about its blank.
///
/// It is turned on a mandrel from a bored blank, in both directions; rows are numbered from 1 as the elements are. The blank is
/// the next standard one, 10 mm larger than the roll, unless one was chosen.
pub(super) fn turned_part(
    set: &RollSet,
    work: &RollWork,
    elements: &[RollElement],
    at: &Place,
) -> (TurnedPart, Vec<Diagnostic>) {
    let bounds = contour(elements).bounds();
    let largest = bounds.map_or(0.0, |b| 2.0 * b.max.r);
    let bore = bore_diameter(set, work.roll.kind);
    let (bar_diameter, diagnostics) = blank(work, largest, at);
    let sections: Vec<Section> = (1..).zip(elements).map(|(id, e)| section(id, &e.segment, bore)).collect();
    let mut part = TurnedPart {
        machine: set.machine.clone(),
        material: set.material_of(work.roll).to_owned(),
        bar_diameter,
        length: sections.iter().map(|s| s.z2).fold(0.0, f64::max),
        ends: Ends::One,
        holding: Holding::BetweenCentres,
        stock_bore_diameter: bore,
        form_tolerance: set.form_tolerance,
        sections,
        ..TurnedPart::default()
    };
    work.put_into(&mut part);
    (part, diagnostics)
}

/// Diameter of the bore of a roll, mm: that of its shaft.
#[must_use]
pub const fn bore_diameter(set: &RollSet, kind: RollKind) -> f64 {
    match kind {
        RollKind::Top | RollKind::Bottom => set.line.shaft_diameter,
        RollKind::Left | RollKind::Right => set.line.side_shaft_diameter,
    }
}

fn blank(work: &RollWork, largest: f64, at: &Place) -> (f64, Vec<Diagnostic>) {
    if let Some(chosen) = work.blank_diameter {
        return (chosen, Vec::new());
    }
    if let Some(standard) = standard_blank_mm(largest) {
        return (standard, Vec::new());
    }
    let needed = largest + BLANK_ALLOWANCE_MM;
    let message = format!(
        "The roll's largest diameter is {largest:.3} mm; no standard blank is {BLANK_ALLOWANCE_MM} mm larger. A bar of \
         {needed:.3} mm is taken."
    );
    (needed, vec![Diagnostic::warning("roll-blank", at.clone(), message).with_hint("Enter the diameter of the blank.")])
}

/// The row of an element. Side faces begin at the bore.
fn section(id: u32, segment: &Segment, bore: f64) -> Section {
    let (start, end) = (segment.start(), segment.end());
    let diameter = |p: Point| rounded((2.0 * p.r).max(bore));
    let kind = match *segment {
        Segment::Line { .. } => SectionKind::Line,
        Segment::Arc { center, ccw, .. } => {
            let radius = turnable_radius(start, end, start.distance(center));
            if ccw { SectionKind::Concave { radius } } else { SectionKind::Convex { radius } }
        }
    };
    let (z1, z2) = (rounded(start.z), rounded(end.z));
    Section { id, z1, d1: diameter(start), z2, d2: diameter(end), kind }
}

/// The radius with which a row can have an arc: at least half its chord, and where the arc ends square to the axis, the one
/// with which it does so exactly, chord² / (2 · width), for a row cannot run back under itself. Arcs that were merged over a
/// line of 0.001 mm miss that by as much.
fn turnable_radius(start: Point, end: Point, radius: f64) -> f64 {
    /// Largest difference that is taken for rounding, mm.
    const ROUNDING_MM: f64 = 0.0025;
    let along = end - start;
    let square = along.norm_squared() / (2.0 * along.x.abs());
    let possible = radius.max(along.norm() / 2.0);
    if (possible..=possible + ROUNDING_MM).contains(&square) { square } else { possible }
}

fn rounded(value: f64) -> f64 {
    let scale = 10_f64.powi(DECIMALS);
    (value * scale).round() / scale
}
