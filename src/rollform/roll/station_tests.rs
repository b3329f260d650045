//! What the figures of a station do to its rolls, each against figures worked out by hand.

use super::*;
use crate::document::{DriveSurface, ExtensionContour, ExtensionKind, Face, Origin, Pinch, Side, SideEnd, SideRoll};
use crate::geometry::Point;
use crate::rollform::design;
use crate::rollform::fixtures::{bend, line, published_rolls, set, station};

const RIGHT: Side = Side::Right;

fn designed(set: &RollSet, index: usize, kind: RollKind) -> DesignedRoll {
    let station = station_rolls(set, index).unwrap();
    station.rolls.into_iter().find(|r| r.kind == kind).unwrap()
}

/// A symmetrical strip of 1 mm: base 40, bends of 1.5 mm to this angle, legs 25.
fn channel(angle_deg: f64) -> RollSet {
    let elements = vec![line(1, 20.0), bend(2, 1.5, angle_deg), line(3, 25.0)];
    set(1.0, Origin::Symmetrical, elements, vec![station(1, &[(2, angle_deg)])])
}

/// The end of the part of an extension contour at the right, in strip space.
fn part_end(roll: &DesignedRoll, part: u32) -> Option<Point> {
    let name = ElementName::Extension { side: RIGHT, part };
    let element = roll.elements.iter().rfind(|e| e.has(name))?;
    // A top roll's contour runs to the right in both spaces.
    Some(roll.frame.to_strip(&element.segment).end())
}

fn is_at(found: Option<Point>, wanted: Point) {
    let found = found.unwrap();
    assert!(found.distance(wanted) < 1e-9, "{found:?} for {wanted:?}");
}

/// Spigots of both kinds with their four lengths, from a strip that ends downwards and one that ends upwards.
#[test]
fn a_spigot_runs_along_the_strip_out_back_and_out() {
    for (angle, kind, third) in [
        (-20.0, ExtensionKind::SpigotA, 4.0),
        (-20.0, ExtensionKind::SpigotB, -4.0),
        (20.0, ExtensionKind::SpigotA, -4.0),
        (20.0, ExtensionKind::SpigotB, 4.0),
    ] {
        let mut set = channel(angle);
        set.stations[0].tolerance_right = 0.5;
        set.stations[0].extension_right = vec![ExtensionContour { kind, lengths: [8.0, 6.0, 4.0, 3.0] }];
        let strip = station_rolls(&set, 0).unwrap().strip;
        let last = strip.pieces.last().unwrap();
        let edge = if angle < 0.0 { last.top.end() } else { last.bottom.end() };
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let one = Point::new(edge.z + 8.5 * cos, edge.r + 8.5 * sin);
        let two = Point::new(one.z + 6.0, one.r);
        let three = Point::new(two.z, two.r + third);
        for roll in [RollKind::Top, RollKind::Bottom].map(|roll| designed(&set, 0, roll)) {
            let ends = [one, two, three, Point::new(three.z + 3.0, three.r)];
            for (part, end) in (1..).zip(ends) {
                is_at(part_end(&roll, part), end);
            }
        }
        set.stations[0].extension_right[0].lengths = [8.0, 0.0, 4.0, 3.0];
        let without = designed(&set, 0, RollKind::Top);
        assert_eq!(part_end(&without, 2), None, "a part of no length is left out");
        is_at(part_end(&without, 3), Point::new(one.z, one.r + third));
    }
}

/// A leg of 25 mm upright at 20 + 1.5 + 1 mm, a roll at 70 mm.
fn with_side_roll(from: SideEnd, to: SideEnd, extensions: Vec<ExtensionContour>) -> RollSet {
    let mut set = channel(90.0);
    set.stations[0].side_right = Some(SideRoll { axis_distance: 70.0, from, to, extensions });
    set
}

const fn end(element: u32, face: Face) -> SideEnd {
    SideEnd { element, face }
}

#[test]
fn a_side_roll_goes_on_with_its_four_lengths_below_and_above() {
    let contour = |lengths| ExtensionContour { kind: ExtensionKind::SideRoll, lengths };
    let extensions = vec![contour([2.0, 3.0, 4.0, 5.0]), contour([1.0, 6.0, 7.0, 8.0])];
    let roll = designed(&with_side_roll(end(3, Face::Bottom), end(3, Face::Bottom), extensions), 0, RollKind::Right);
    let on_the_leg = 70.0 - 22.5;
    let corners: Vec<Point> = roll.elements.iter().skip(1).map(|e| e.segment.start()).collect();
    let wanted = [
        (0.0, on_the_leg - 4.0),
        (5.0, on_the_leg - 4.0),
        (5.0, on_the_leg),
        (5.0 + 5.0 + 25.0 + 7.0, on_the_leg),
        (42.0, on_the_leg - 7.0),
        (50.0, on_the_leg - 7.0),
    ];
    assert_eq!(corners.len(), wanted.len(), "{corners:?}");
    for (corner, (z, r)) in corners.iter().zip(wanted) {
        assert!(corner.distance(Point::new(z, r)) < 1e-9, "{corner:?} for {z}, {r}");
    }
}

/// Which elements a side roll has follows from the faces at which it is bounded.
#[test]
fn a_side_roll_is_bounded_by_faces_1_to_4() {
    // Without a contour above, the roll's face would lie in the edge.
    let contours =
        || [[0.0; 4], [0.0, 6.0, 0.0, 0.0]].map(|lengths| ExtensionContour { kind: ExtensionKind::SideRoll, lengths });
    let has = |from: SideEnd, to: SideEnd| {
        let roll = designed(&with_side_roll(from, to, contours().to_vec()), 0, RollKind::Right);
        let arc = roll.elements.iter().any(|e| e.segment.radius().is_some());
        let edge = roll.elements.iter().any(|e| e.has(ElementName::Edge { side: RIGHT }));
        let leg = roll
            .elements
            .iter()
            .any(|e| e.has(ElementName::Strip { element: 3, side: RIGHT, kind: crate::document::PieceKind::Line }));
        (arc, leg, edge)
    };
    let bottom = Face::Bottom;
    assert_eq!(has(end(2, bottom), end(3, bottom)), (true, true, false));
    assert_eq!(has(end(3, bottom), end(3, bottom)), (false, true, false));
    assert_eq!(has(end(2, Face::Leading), end(3, bottom)), (true, true, false));
    assert_eq!(has(end(2, Face::Trailing), end(3, bottom)), (false, true, false));
    assert_eq!(has(end(2, bottom), end(3, Face::Leading)), (true, false, false));
    assert_eq!(has(end(3, bottom), end(3, Face::Trailing)), (false, true, true));
    assert_eq!(
        has(end(2, Face::Leading), end(3, Face::Trailing)),
        (true, true, true),
        "the outer face between two ends"
    );
    // The inside of the leg, from above a top roll's place: a contour on the other face, 1 mm further in.
    let inside = designed(&with_side_roll(end(3, Face::Top), end(3, Face::Top), Vec::new()), 0, RollKind::Right);
    assert!((inside.elements[1].segment.start().r - (70.0 - 21.5)).abs() < 1e-9);
}

/// The opening between the rolls on the base, which drives, and on the leg, which does not.
#[test]
fn openings_are_those_of_the_published_pinch_differences() {
    for (pinch, wanted) in [
        (Pinch::None, (1.0, 1.0)),
        (Pinch::Gaps { drive: 1.05, clearance: 1.3 }, (1.05, 1.3)),
        (Pinch::Clearance { added: 0.0 }, (1.0, 1.08)),
        (Pinch::Clearance { added: 0.05 }, (1.0, 1.13)),
    ] {
        let mut set = channel(30.0);
        set.stations[0].pinch = pinch;
        set.stations[0].drive_right = Some(DriveSurface { first: 1, last: 1 });
        let rolls = [RollKind::Bottom, RollKind::Top].map(|kind| designed(&set, 0, kind));
        let opening = |element| {
            let name = ElementName::Strip { element, side: RIGHT, kind: crate::document::PieceKind::Line };
            let [bottom, top] = rolls.each_ref().map(|roll| {
                let element = roll.elements.iter().find(|e| e.has(name)).unwrap();
                roll.frame.to_strip(&element.segment)
            });
            top.distance_to(bottom.point_at(0.5))
        };
        let found = (opening(1), opening(3));
        assert!((found.0 - wanted.0).abs() < 1e-9 && (found.1 - wanted.1).abs() < 1e-9, "{pinch:?}: {found:?}");
    }
}

#[test]
fn a_station_without_rolls_leaves_the_others_their_numbers() {
    let names = |set: &RollSet| design("x", set).rolls().map(|r| r.name.clone()).collect::<Vec<_>>();
    let mut set = published_rolls();
    assert_eq!(names(&set), ["x-1T", "x-1B", "x-2T", "x-2B", "x-3T", "x-3B", "x-3L", "x-3R"]);
    set.stations[1].without_rolls = true;
    assert_eq!(names(&set), ["x-1T", "x-1B", "x-3T", "x-3B", "x-3L", "x-3R"]);
    assert_eq!(design("x", &set).diagnostics, []);
}

/// The same set twice as large has rolls twice as large: no length of a set is left out when its unit changes.
#[test]
fn every_length_of_a_set_has_its_unit() {
    let set = published_rolls();
    let (one, two) = (design("x", &set), design("x", &set.scaled(2.0)));
    assert_eq!(one.rolls().count(), 8);
    for (a, b) in one.rolls().zip(two.rolls()) {
        assert_eq!(a.elements.len(), b.elements.len(), "{}", a.name);
        for (a, b) in a.elements.iter().zip(&b.elements) {
            let (p, q) = (a.segment.end(), b.segment.end());
            assert!(Point::new(2.0 * p.z, 2.0 * p.r).distance(q) < 1e-9, "{p:?} {q:?}");
        }
        assert!((2.0 * a.part.stock_bore_diameter - b.part.stock_bore_diameter).abs() < 1e-9);
    }
}

/// A lip that is bent under: what lies above it, seen from the bottom roll, becomes an upright line at its edge.
#[test]
fn what_lies_above_a_lip_becomes_an_upright_line_of_the_bottom_roll() {
    let elements = vec![line(1, 20.0), bend(2, 1.5, -90.0), line(3, 25.0), bend(4, 1.5, -90.0), line(5, 8.0)];
    let set = set(1.0, Origin::Symmetrical, elements, vec![station(1, &[(2, -90.0), (4, -90.0)])]);
    let bottom = designed(&set, 0, RollKind::Bottom);
    let name = ElementName::Unreached { element: 5, side: RIGHT };
    let upright = bottom.frame.to_strip(&bottom.elements.iter().find(|e| e.has(name)).unwrap().segment);
    // The leg's middle is at 20 + 2, the lip's edge 2 + 8 mm further in.
    assert!((upright.start().z - 12.0).abs() < 1e-9 && (upright.end().z - 12.0).abs() < 1e-9, "{upright:?}");
    assert!(upright.length() > 25.0);
}

/// A flange that slopes down outwards hides the root of its leg from the side roll: there it has a level line.
#[test]
fn what_a_side_roll_cannot_reach_becomes_a_level_line() {
    let elements = vec![
        line(1, 20.0),
        bend(2, 1.5, 90.0),
        line(3, 15.0),
        bend(4, 1.5, -110.0),
        line(5, 12.0),
        bend(6, 1.5, 110.0),
        line(7, 10.0),
    ];
    let mut set = set(1.0, Origin::Symmetrical, elements, vec![station(1, &[(2, 90.0), (4, -110.0), (6, 110.0)])]);
    let (from, to) = (end(3, Face::Bottom), end(7, Face::Bottom));
    set.stations[0].side_right = Some(SideRoll { axis_distance: 90.0, from, to, extensions: Vec::new() });
    let roll = designed(&set, 0, RollKind::Right);
    let unreached = |e: &&RollElement| e.names.iter().any(|n| matches!(n, ElementName::Unreached { .. }));
    let level: Vec<Segment> = roll.elements.iter().filter(unreached).map(|e| roll.frame.to_strip(&e.segment)).collect();
    let [level] = level.as_slice() else { panic!("{level:?}") };
    let strip = station_rolls(&set, 0).unwrap().strip;
    let lowest = strip.pieces.iter().filter(|p| p.element == 6 && p.side == RIGHT).map(|p| p.bottom.bounds().min.r);
    let lowest = lowest.fold(f64::INFINITY, f64::min);
    assert!((level.start().r - lowest).abs() < 1e-6 && (level.end().r - lowest).abs() < 1e-6, "{level:?} at {lowest}");
    let on_leg = level.start().z.min(level.end().z);
    assert!((on_leg - 22.5).abs() < 1e-6, "it begins on the leg: {level:?}");
}
