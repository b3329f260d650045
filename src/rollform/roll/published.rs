//! Stage 2 of the published section, element by element against the printed lists.

use super::*;
use crate::document::{EditAction, PieceKind, RollEdit, Side};
use crate::geometry::Point;
use crate::rollform::editor::edited;
use crate::rollform::fixtures::published_rolls;

const TOP: &str = include_str!("../../../tests/cases/1470b/E1470b-2T.txt");
const BOTTOM: &str = include_str!("../../../tests/cases/1470b/E1470b-2B.txt");

/// Points and centres may differ by so much, mm.
const LIMIT_MM: f64 = 0.005;

fn part(side: Side, part: u32) -> ElementName {
    ElementName::Extension { side, part }
}

/// The edits that the published lists show beside the design: they are not the same left and right.
fn edits(kind: RollKind) -> Vec<RollEdit> {
    let (left, right) = (Side::Left, Side::Right);
    let chamfer = |after, depth| EditAction::Chamfer { after, depth };
    let blend = |after, radius| EditAction::Blend { after, radius };
    let last = ElementName::Strip { element: 21, side: right, kind: PieceKind::Line };
    let actions = if kind == RollKind::Top {
        vec![
            chamfer(ElementName::Flank { side: left }, 2.0),
            blend(part(left, 3), 2.0),
            blend(part(left, 2), 3.0),
            blend(last, 3.0),
            blend(part(right, 2), 3.0),
            chamfer(part(right, 4), 2.0),
        ]
    } else {
        vec![
            blend(ElementName::Flank { side: left }, 2.0),
            blend(part(left, 4), 2.0),
            blend(part(right, 3), 2.0),
            blend(part(right, 4), 2.0),
        ]
    };
    (1..).zip(actions).map(|(id, action)| RollEdit { id, action }).collect()
}

struct Printed {
    start: Point,
    end: Point,
    /// Centre, radius, counter-clockwise.
    arc: Option<(Point, f64, bool)>,
}

fn printed(text: &str) -> Vec<Printed> {
    let rows = text.lines().map(|line| line.split_whitespace().map(|w| w.parse::<f64>().unwrap()).collect::<Vec<_>>());
    rows.take_while(|row| row[0] > 0.0)
        .map(|row| Printed {
            start: Point::new(row[2], row[3]),
            end: Point::new(row[4], row[5]),
            arc: (row[1] == 2.0).then(|| (Point::new(row[6], row[7]), row[8], row[9] > 0.0)),
        })
        .collect()
}

fn compare(kind: RollKind, text: &str) -> Vec<f64> {
    let station = station_rolls(&published_rolls(), 1).unwrap();
    let designed = station.rolls.iter().find(|r| r.kind == kind).unwrap();
    let done = edited(&designed.elements, &edits(kind));
    assert_eq!(done.faults, []);
    let printed = printed(text);
    assert_eq!(done.elements.len(), printed.len());
    let mut differences = Vec::new();
    for (number, (made, printed)) in (1..).zip(done.elements.iter().zip(&printed)) {
        let (start, end) = (made.segment.start(), made.segment.end());
        let mut here = vec![start.distance(printed.start), end.distance(printed.end)];
        match (made.segment, printed.arc) {
            (Segment::Line { .. }, None) => {}
            (Segment::Arc { center, ccw, .. }, Some((wanted, radius, sense))) => {
                assert_eq!(ccw, sense, "element {number}");
                assert!((start.distance(center) - radius).abs() < LIMIT_MM, "element {number}");
                here.push(center.distance(wanted));
            }
            _ => panic!("element {number} is of the other type"),
        }
        assert!(here.iter().all(|&d| d <= LIMIT_MM), "element {number}: {here:?}");
        differences.extend(here);
    }
    differences.sort_by(f64::total_cmp);
    println!(
        "{kind:?}: {} elements, {} points and centres, largest {:.4}, median {:.4}",
        printed.len(),
        differences.len(),
        differences.last().unwrap(),
        differences[differences.len() / 2]
    );
    differences
}

#[test]
fn stage_2_is_the_published_one_element_by_element() {
    assert_eq!(compare(RollKind::Top, TOP).len(), 2 * 38 + 14);
    assert_eq!(compare(RollKind::Bottom, BOTTOM).len(), 2 * 36 + 12);
}

/// The design changes, the edits stay: they are carried out again where their corners are now.
#[test]
fn the_edits_are_replayed_when_the_flower_changes() {
    let made = |angle_deg: f64| {
        let mut set = published_rolls();
        set.stations[1].bends.iter_mut().filter(|b| b.element == 20).for_each(|b| b.angle_deg = angle_deg);
        let station = station_rolls(&set, 1).unwrap();
        let designed = station.rolls.into_iter().find(|r| r.kind == RollKind::Top).unwrap();
        let done = edited(&designed.elements, &edits(RollKind::Top));
        assert_eq!(done.faults, [], "at {angle_deg} degrees");
        let by_edit = |e: &&RollElement| e.names.iter().any(|n| matches!(n, ElementName::Edit { .. }));
        done.elements.iter().filter(by_edit).map(|e| e.segment).collect::<Vec<_>>()
    };
    let (before, after) = (made(-50.0), made(-35.0));
    assert_eq!((before.len(), after.len()), (6, 6));
    for (a, b) in before.iter().zip(&after) {
        let same_radius = match (a.radius(), b.radius()) {
            (Some(a), Some(b)) => (a - b).abs() < 1e-9,
            (a, b) => a.is_none() && b.is_none(),
        };
        assert!(same_radius, "{a:?} {b:?}");
    }
    // The strip ends elsewhere, and what was rounded there with it.
    assert!(before[3].start().distance(after[3].start()) > 0.1, "{:?} {:?}", before[3], after[3]);
}
