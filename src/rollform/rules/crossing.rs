//! Two pieces of the strip cannot be in the same place: neither in the finished section nor on the way to it.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Intersection, Point, Segment};
use crate::rollform::bends::Stage;
use crate::rollform::strip::Strip;

/// Points of faces closer than this are the same, mm: far below what a strip is made to.
const SAME_PLACE_MM: f64 = 1e-6;

/// Stages at which the outline of the strip crosses or touches itself.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    if subject.set.section.thickness <= 0.0 {
        return Vec::new();
    }
    let finished = subject.flower.shapes.iter().filter(|shape| shape.stage == Stage::Finished);
    let shapes = finished.chain(subject.flower.stations());
    shapes.filter_map(|shape| Some(report(subject, shape.stage, &meeting(&shape.strip)?))).collect()
}

fn report(subject: &Subject<'_>, stage: Stage, meeting: &Meeting) -> Diagnostic {
    let [one, other] = meeting.elements;
    let (at, place) = match stage {
        Stage::Station(index) => (subject.station(index), "The strip".to_owned()),
        _ => (subject.element(other), "The finished section".to_owned()),
    };
    let at_point = format!("at {}, {}", subject.length(meeting.point.z), subject.length(meeting.point.r));
    let names =
        if one == other { subject.name(one) } else { format!("{} and {}", subject.name(one), subject.name(other)) };
    let found = if meeting.crosses {
        let message = format!("{place} crosses itself {at_point} ({names}).");
        Diagnostic::error("strip-crosses-itself", at, message).with_hint("Change an angle or a length there.")
    } else {
        let message = format!("{place} touches itself {at_point} ({names}): the clearance is 0.");
        Diagnostic::warning("strip-touches-itself", at, message)
    };
    [one, other]
        .into_iter()
        .map(|id| subject.element(id))
        .filter(|p| *p != Place::Document)
        .fold(found, Diagnostic::with_related)
}

/// Where the outline meets itself.
struct Meeting {
    crosses: bool,
    point: Point,
    elements: [u32; 2],
}

/// The worst place at which the outline of a strip meets itself.
fn meeting(strip: &Strip) -> Option<Meeting> {
    let mut edges = edges(strip);
    edges.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut touching = None;
    for (index, a) in edges.iter().enumerate() {
        let beside = edges.iter().skip(index + 1).take_while(|b| b.from <= a.to + SAME_PLACE_MM);
        for b in beside.filter(|b| a.is_near(b) && !a.is_next_to(b)) {
            match a.meets(b) {
                Some(found) if found.crosses => return Some(found),
                found => touching = touching.or(found),
            }
        }
    }
    touching
}

/// A line or arc of the outline.
struct Edge {
    segment: Segment,
    element: u32,
    from: f64,
    to: f64,
    low: f64,
    high: f64,
}

/// Both faces and both ends of a strip, without what has no length.
fn edges(strip: &Strip) -> Vec<Edge> {
    let faces = strip.pieces.iter().flat_map(|piece| [(piece.bottom, piece.element), (piece.top, piece.element)]);
    let first = strip.pieces.first().map(|p| (Segment::line(p.bottom.start(), p.top.start()), p.element));
    let last = strip.pieces.last().map(|p| (Segment::line(p.bottom.end(), p.top.end()), p.element));
    let all = faces.chain(first).chain(last).filter(|(segment, _)| segment.length() > SAME_PLACE_MM);
    all.map(|(segment, element)| {
        let bounds = segment.bounds();
        Edge { segment, element, from: bounds.min.z, to: bounds.max.z, low: bounds.min.r, high: bounds.max.r }
    })
    .collect()
}

impl Edge {
    fn is_near(&self, other: &Self) -> bool {
        self.low <= other.high + SAME_PLACE_MM && other.low <= self.high + SAME_PLACE_MM
    }

    /// True if they share an end, as neighbours do.
    fn is_next_to(&self, other: &Self) -> bool {
        let ends = |s: &Segment| [s.start(), s.end()];
        ends(&self.segment).iter().any(|p| ends(&other.segment).iter().any(|q| p.distance(*q) <= SAME_PLACE_MM))
    }

    fn meets(&self, other: &Self) -> Option<Meeting> {
        let found = self.segment.intersection(&other.segment, SAME_PLACE_MM);
        let point = found.points().first().copied()?;
        let at_an_end = |s: &Segment| [s.start(), s.end()].iter().any(|p| p.distance(point) <= SAME_PLACE_MM);
        let crosses = match found {
            Intersection::Crossing(_) => !at_an_end(&self.segment) && !at_an_end(&other.segment),
            Intersection::TwoPoints(..) => true,
            _ => false,
        };
        let elements = [self.element.min(other.element), self.element.max(other.element)];
        Some(Meeting { crosses, point, elements })
    }
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::document::{Origin, RollSet};
    use crate::rollform::fixtures::{bend, line, set, station};

    /// A leg of 20 mm, a web, another leg, closed by as much as `angle` at every corner.
    fn curl(angle: f64, leg: f64) -> RollSet {
        let elements = vec![
            line(1, 20.0),
            bend(2, 2.0, angle),
            line(3, 20.0),
            bend(4, 2.0, angle),
            line(5, 20.0),
            bend(6, 2.0, angle),
            line(7, leg),
        ];
        set(1.0, Origin::LeftToRight, elements, vec![station(1, &[(2, angle), (4, angle), (6, angle)])])
    }

    #[test]
    fn fires_where_the_section_runs_through_itself() {
        // Three bends of 100 degrees lead the last leg through the first.
        let found = found(check, &curl(100.0, 40.0));
        assert_eq!(found.iter().map(|d| d.code.as_str()).collect::<Vec<_>>(), ["strip-crosses-itself"; 2]);
        assert!(matches!(found[0].at, Place::Element { .. }));
        assert_eq!(found[1].at.to_string(), "station 1");
    }

    #[test]
    fn says_nothing_about_a_section_that_stays_apart() {
        assert!(found(check, &curl(90.0, 10.0)).is_empty());
    }

    #[test]
    fn closed_hem_is_no_crossing() {
        let elements = vec![line(1, 20.0), bend(2, 0.0, 180.0), line(3, 10.0)];
        let hem = set(1.0, Origin::LeftToRight, elements, vec![]);
        assert!(found(check, &hem).iter().all(|d| d.code != "strip-crosses-itself"), "{:?}", found(check, &hem));
    }
}
