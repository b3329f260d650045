//! The published roughing of QUEEN: read, run and cut from a bar of 26.2 mm.

use super::*;
use crate::machine::{Catalog, outlines};
use std::sync::Arc;

/// The published listing after OPTIMIZE.
const LISTING: &str = include_str!("../../../tests/cases/queen/QUEEN1.bnc");

/// Length of QUEEN, mm.
const QUEEN_LENGTH: f64 = 56.0;

/// QUEEN's sections from the clamped end: line and arcs as published.
fn contour() -> (Contour, Vec<u32>) {
    // z1, d1, z2, d2, radius: 0 a line, negative concave, positive convex.
    let rows = [
        (0.0, 25.4, 2.0, 25.4, 0.0),
        (2.0, 24.0, 4.0, 25.0, 2.0),
        (4.0, 25.0, 14.0, 16.2, -10.0),
        (14.0, 16.2, 34.0, 7.5, -30.0),
        (34.0, 7.5, 36.0, 13.5, 5.0),
        (36.0, 17.5, 38.6, 10.2, 5.0),
        (38.6, 10.2, 41.0, 10.2, 0.0),
        (41.0, 10.2, 41.8, 11.5, 2.0),
        (41.8, 11.5, 42.7, 10.2, 2.0),
        (42.7, 10.2, 50.4, 16.2, -10.0),
        (50.4, 16.2, 53.5, 12.9, 0.0),
        (53.5, 4.0, 56.0, 1.0, 4.0),
    ];
    let (mut segments, mut sections, mut last): (Vec<Segment>, Vec<u32>, Option<Point>) = (vec![], vec![], None);
    for (id, (z1, d1, z2, d2, radius)) in (1..).zip(rows) {
        let (start, end) = (Point::new(z1, d1 / 2.0), Point::new(z2, d2 / 2.0));
        if let Some(face) = last.filter(|p| p.distance(start) > 1e-9) {
            segments.push(Segment::line(face, start));
            sections.push(id);
        }
        segments.push(if radius == 0.0 { Segment::line(start, end) } else { arc(start, end, radius) });
        sections.push(id);
        last = Some(end);
    }
    (Contour::new(segments), sections)
}

/// The arc whose centre lies on the spindle's side (convex, radius above 0) or outside.
fn arc(start: Point, end: Point, radius: f64) -> Segment {
    let chord = end - start;
    let height = (radius * radius - chord.norm_squared() / 4.0).sqrt();
    let up = crate::geometry::Vector::new(-chord.y, chord.x).normalize();
    let center = start + chord / 2.0 - up * height * radius.signum();
    Segment::Arc { start, end, center, ccw: radius < 0.0 }
}

fn work() -> Work {
    let (contour, sections) = contour();
    Work {
        stock: polygon(&[(-40.0, 0.0), (QUEEN_LENGTH, 0.0), (QUEEN_LENGTH, 13.1), (-40.0, 13.1)]),
        target: Target {
            contour,
            sections,
            names: std::collections::BTreeMap::new(),
            machined_from_z: 0.0,
            bore: None,
        },
        program_zero_z: QUEEN_LENGTH,
        chuck_face_z: -10.0,
        mandrel: None,
        tailstock: None,
        material: None,
        form_tolerance_mm: 0.05,
        may_cut: Vec::new(),
    }
}

/// Proves with a needle, which is next to a point: upright in front, almost upright behind.
fn prove_listing(text: &str) -> ProofReport {
    let insert = polygon(&[(0.0, 0.0), (1.0, 15.0), (0.0, 15.0)]);
    let holder = polygon(&[(0.0, 15.0), (1.0, 15.0), (1.0, 60.0), (0.0, 60.0)]);
    let tools =
        std::collections::BTreeMap::from([(1, crate::machine::ToolOutline { insert, holder, ..Default::default() })]);
    prove_input(&ProofInput { tools: Arc::new(tools), ..with_work(&[text], work()) })
}

#[test]
fn the_listing_is_read_and_runs_without_a_fault() {
    let report = prove_listing(LISTING);
    assert!(report.passed && report.errors().count() == 0, "{:?}", report.errors().next());
    assert_eq!(report.blocks.len(), 91);
    assert_eq!(report.blocks.iter().map(|b| b.runs).sum::<u32>(), 91 + 4 * 4);
    assert!(report.deepest_gouge_mm < 0.001, "{}", report.deepest_gouge_mm);
}

/// The area above the contour plus allowance that the strokes cover: what stays of the bar between z = 0 and the end is the
/// union of the strokes' rectangles away.
#[test]
fn roughing_with_a_sharp_tool_takes_the_strokes_away() {
    let report = prove_listing(LISTING);
    let cut = area(&report.stock.first().unwrap()) - area(&report.stock.last().unwrap());
    let mut lowest = vec![13.1_f64; 5600];
    for m in report.moves.iter().filter(|m| m.motion == Motion::Feed) {
        let (a, b) = (m.path.start(), m.path.end());
        for (column, low) in lowest.iter_mut().enumerate() {
            let z = (column as f64 + 0.5) / 100.0;
            if z > a.z.min(b.z) && z < a.z.max(b.z) {
                *low = low.min(a.r + (b.r - a.r) * (z - a.z) / (b.z - a.z));
            }
        }
    }
    let strokes: f64 = lowest.iter().map(|low| (13.1 - low) / 100.0).sum();
    // The needle's back takes a little from the walls where it goes down.
    assert!((cut - strokes).abs() < 0.005 * strokes, "{cut} {strokes}");
}

#[test]
fn the_true_tools_of_the_lathe_prove_it_too() {
    let catalog = Catalog::shipped();
    let machine = catalog.machine("orac").unwrap().clone();
    let tools = outlines(&machine, &catalog);
    let input = ProofInput { machine: Arc::new(machine), tools: Arc::new(tools), ..with_work(&[LISTING], work()) };
    let report = prove_input(&input);
    // The generator takes the tool as a point: with the true insert two plunges come close to the tolerance, or past it, but
    // nothing else is wrong.
    assert!(report.errors().all(|f| f.kind == FindingKind::Gouge), "{:?}", report.errors().collect::<Vec<_>>());
    assert!(report.deepest_gouge_mm > 0.01 && report.deepest_gouge_mm < 0.1);
}

#[test]
fn one_changed_z_names_its_block_and_how_much() {
    // Block 42 goes 2 mm too far: the stroke runs through the contour.
    let changed = LISTING.replace("0.000  -16.994", "0.000  -18.994");
    let changes = compare(LISTING, &changed, crate::machine::Dialect::Orac);
    assert_eq!((changes.len(), changes[0].block, changes[0].difference), (1, 42, Some(-2.0)));
    let report = prove_listing(&changed);
    assert_eq!(report.first_wrong_block(), Some(("TEST1", 42)));
    let closing = report.findings.iter().find(|f| f.kind == FindingKind::NotClosed).unwrap();
    assert!((closing.value - 2.0).abs() < 0.002, "{closing:?}");
}
