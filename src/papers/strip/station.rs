//! Drawings of the stations: the rolls as they stand in the line, apart by the gap that drawings have, and the strip between them.

use super::{Subject, placed_within, remark};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::RollKind;
use crate::geometry::{Bounds, Point, Segment, Vector};
use crate::papers::drawing::DrawingChoice;
use crate::papers::page::{Align, Ink, Page, Pen};
use crate::papers::view::View;
use crate::regen::Derived;
use crate::rollform::{Roll, StationDesign};

/// Largest scale of a station.
const MOST: f64 = 5.0;
/// Height of names and remarks, mm.
const TEXT_MM: f64 = 3.5;

/// One page for every station that has rolls.
///
/// # Errors
/// A diagnostic if no station has rolls, or the scale asked for does not fit, with the largest that does.
pub(in crate::papers) fn stations(derived: &Derived, choice: DrawingChoice) -> Result<Vec<Page>, Diagnostic> {
    let subject = Subject::of(derived)?;
    let with_rolls: Vec<&StationDesign> =
        subject.derived.design.stations.iter().filter(|station| !station.rolls.is_empty()).collect();
    if with_rolls.is_empty() {
        let message = "There is no station to draw: 0 stations have rolls.";
        return Err(Diagnostic::error("nothing-to-draw", Place::Document, message));
    }
    let gap = subject.set.line.drawn_gap * subject.unit().in_mm();
    let count = with_rolls.len();
    (1..).zip(with_rolls).map(|(number, station)| page(&subject, station, gap, choice, (number, count))).collect()
}

fn page(
    subject: &Subject<'_>,
    station: &StationDesign,
    gap: f64,
    choice: DrawingChoice,
    sheet: (usize, usize),
) -> Result<Page, Diagnostic> {
    let outlines: Vec<(&Roll, Vec<Segment>)> = station.rolls.iter().map(|roll| (roll, outline(roll, gap))).collect();
    let strip = station.strip.outline();
    let all = outlines.iter().flat_map(|(_, segments)| segments).chain(&strip.segments);
    let bounds = all.map(Segment::bounds).reduce(Bounds::union);
    let placed = placed_within(bounds, choice, MOST)?;
    let name = format!("{} station {}", subject.document.name, station.number);
    let mut page = subject.page(name, &placed.scale.name(), placed.paper, sheet);
    for (roll, segments) in &outlines {
        draw_roll(&mut page, &placed.view, roll, segments);
    }
    // The strip lies behind the rolls of which the drawing shows the halves towards it.
    page.area(placed.view.segments(&strip.segments), Ink::Sand, Some(Pen::DASHED));
    remark(&mut page, placed.paper, &told(subject, station));
    page.part = Some(placed.view);
    Ok(page)
}

/// Half of a roll in strip space, the top one lifted by the gap.
fn outline(roll: &Roll, gap: f64) -> Vec<Segment> {
    let lift = Vector::new(0.0, if roll.roll.kind == RollKind::Top { gap } else { 0.0 });
    roll.outline().segments.iter().map(|segment| segment.translated(lift)).collect()
}

fn draw_roll(page: &mut Page, view: &View, roll: &Roll, segments: &[Segment]) {
    let Some((axis, surface)) = segments.split_last() else { return };
    page.area(view.segments(segments), Ink::Pale, None);
    page.path(view.segments(surface), Pen::EDGE);
    let (from, to) = (view.place(axis.start()), view.place(axis.end()));
    let beyond = (to - from).try_normalize(0.0).unwrap_or_default() * 5.0;
    page.line(from - beyond, to + beyond, Pen::CENTRE);
    let short = roll.name.rsplit('-').next().unwrap_or(&roll.name);
    let upright = matches!(roll.roll.kind, RollKind::Left | RollKind::Right);
    let inwards = match roll.roll.kind {
        RollKind::Top => Vector::new(0.0, -2.0 * TEXT_MM),
        RollKind::Bottom => Vector::new(0.0, TEXT_MM),
        RollKind::Left => Vector::new(3.0 * TEXT_MM, 0.0),
        RollKind::Right => Vector::new(-3.0 * TEXT_MM, 0.0),
    };
    let middle = Point::new(f64::midpoint(from.z, to.z), f64::midpoint(from.r, to.r));
    let largest = format!("{short}  \u{2300} {:.3}", 2.0 * roll.contour().bounds().map_or(0.0, |b| b.max.r));
    let at = middle + inwards;
    if upright {
        page.upright_text(at, TEXT_MM, Align::Middle, largest);
    } else {
        page.text(at, TEXT_MM, Align::Middle, largest);
    }
}

/// What a station is set up by.
fn told(subject: &Subject<'_>, station: &StationDesign) -> String {
    let in_mm = subject.unit().in_mm();
    let length = |value: f64| subject.length(value * in_mm);
    let mut parts = vec![format!("Station {}", station.number)];
    if let Some((_, of_document)) = subject.set.station(station.station) {
        parts.push(format!("pass height {}", length(of_document.pass_height)));
        parts.push(format!("axes {} apart", length(of_document.centre_distance)));
    }
    let openings = station.openings;
    parts.push(format!("openings {} and {}", subject.length(openings.drive), subject.length(openings.clearance)));
    let gap = Some(subject.set.line.drawn_gap).filter(|gap| *gap > 0.0);
    parts.extend(gap.map(|gap| format!("drawn {} apart", length(gap))));
    parts.join(" · ")
}
