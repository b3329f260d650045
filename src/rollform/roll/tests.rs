//! Rolls of other stations and sections: what must hold for any.

use super::*;
use crate::document::{DriveSurface, ExtensionContour, ExtensionKind, Face, Origin, Pinch, SideEnd, SideRoll};
use crate::geometry::Location;
use crate::rollform::design;
use crate::rollform::fixtures::{bend, line, published_rolls, set, station};
use proptest::prelude::*;

fn designed(set: &RollSet, index: usize, kind: RollKind) -> DesignedRoll {
    let station = station_rolls(set, index).unwrap();
    station.rolls.into_iter().find(|r| r.kind == kind).unwrap()
}

fn radii(roll: &DesignedRoll) -> Vec<f64> {
    roll.elements.iter().filter_map(|e| e.segment.radius()).map(|r| (r * 1000.0).round() / 1000.0).collect()
}

fn width(roll: &DesignedRoll) -> f64 {
    roll.contour().bounds().unwrap().max.z
}

#[test]
fn station_1_follows_from_the_same_rules() {
    let set = published_rolls();
    let (top, bottom) = (designed(&set, 0, RollKind::Top), designed(&set, 0, RollKind::Bottom));
    assert_eq!(radii(&top), [2.440, 1.855, 1.855, 2.440]);
    assert_eq!(radii(&bottom), [3.000, 1.500, 1.500, 3.000]);
    assert!((width(&top) - 149.603).abs() < 0.001 && (width(&bottom) - width(&top)).abs() < 1e-9);
}

#[test]
fn station_3_follows_from_the_same_rules() {
    let set = published_rolls();
    let bottom = designed(&set, 2, RollKind::Bottom);
    assert_eq!(radii(&bottom), [0.434, 2.420, 3.000, 1.500, 1.500, 3.000, 2.420, 0.434]);
    let side = designed(&set, 2, RollKind::Right);
    assert_eq!(radii(&side), [0.994, 1.860, 2.440, 1.958, 2.030]);
    assert_eq!(radii(&designed(&set, 2, RollKind::Left)), radii(&side));
    let flat = designed(&set, 2, RollKind::Top).elements[1].segment.start().r;
    assert!((flat - 55.566).abs() < 1e-9);
}

#[test]
fn frames_lead_there_and_back() {
    let set = published_rolls();
    for index in 0..3 {
        for roll in station_rolls(&set, index).unwrap().rolls {
            for element in &roll.elements {
                let there = roll.frame.to_roll(&roll.frame.to_strip(&element.segment));
                assert!(there.start().distance(element.segment.start()) < 1e-9);
                assert!((there.sweep() - element.segment.sweep()).abs() < 1e-9);
            }
        }
    }
}

/// A lipped channel of 1 mm strip: base 40, bends up, legs 25, bends inwards, lips 8.
fn lipped(leg_deg: f64, lip_deg: f64) -> RollSet {
    let elements = vec![line(1, 20.0), bend(2, 1.5, 90.0), line(3, 25.0), bend(4, 1.5, 90.0), line(5, 8.0)];
    let mut set = set(1.0, Origin::Symmetrical, elements, vec![station(1, &[(2, leg_deg), (4, lip_deg)])]);
    set.stations[0].extension_right =
        vec![ExtensionContour { kind: ExtensionKind::SpigotA, lengths: [5.0, 6.0, 4.0, 8.0] }];
    set
}

#[test]
fn what_lies_under_a_lip_becomes_an_upright_line_at_its_edge() {
    let set = lipped(90.0, 90.0);
    let top = designed(&set, 0, RollKind::Top);
    let name = ElementName::Unreached { element: 5, side: crate::document::Side::Right };
    let upright = top.elements.iter().find(|e| e.has(name)).unwrap().segment;
    // From the lip's edge: leg at 20 + 1.5 + ..., lip 8 inwards; the line runs from the base to the lip's top.
    let edge = station_rolls(&set, 0).unwrap().strip.pieces.last().unwrap().top.end();
    assert!((top.frame.to_strip(&upright).start().z - edge.z).abs() < 1e-6);
    assert!(upright.length() > 25.0 && (upright.start().z - upright.end().z).abs() < 1e-6);
    for roll in station_rolls(&set, 0).unwrap().rolls {
        assert!(roll.elements.windows(2).all(|w| w[1].segment.end().z >= w[0].segment.end().z - 1e-6));
    }
}

#[test]
fn a_side_roll_takes_the_leg_and_the_top_roll_keeps_the_lip() {
    let mut set = lipped(90.0, 90.0);
    set.stations[0].extension_right.clear();
    set.stations[0].side_right = Some(SideRoll {
        axis_distance: 70.0,
        from: SideEnd { element: 3, face: Face::Bottom },
        to: SideEnd { element: 3, face: Face::Bottom },
        extensions: Vec::new(),
    });
    let design = design("c", &set);
    assert_eq!(design.rolls().map(|r| r.roll.kind).collect::<Vec<_>>(), RollKind::ALL);
    assert_eq!(design.diagnostics, []);
    let side = design.rolls().nth(3).unwrap();
    assert_eq!(side.elements.len(), 3);
    let (top, strip) = (design.rolls().next().unwrap(), &design.stations[0].strip);
    assert!((top.outline().bounds().unwrap().max.z - strip.outline().bounds().unwrap().max.z).abs() < 1e-6);
}

/// Sections with bends of both senses, of which some turn back far, at any stage.
fn sections() -> impl Strategy<Value = RollSet> {
    let side = || {
        proptest::collection::vec(
            (2.0..30.0_f64, 0.0..4.0_f64, prop_oneof![-150.0..-5.0_f64, 5.0..150.0_f64], 0.0..1.0_f64),
            1..5,
        )
    };
    let gaps = prop_oneof![
        Just(Pinch::None),
        (1.0..1.05_f64, 1.05..1.3_f64).prop_map(|(drive, clearance)| Pinch::Gaps { drive, clearance }),
        Just(Pinch::Clearance { added: 0.02 }),
    ];
    let origin = prop_oneof![
        Just(Origin::Symmetrical),
        Just(Origin::LeftToRight),
        Just(Origin::RightToLeft),
        Just(Origin::CentreRightFirst),
        Just(Origin::CentreLeftFirst)
    ];
    (side(), side(), gaps, origin, any::<bool>()).prop_map(|(right, left, pinch, origin, spigot)| {
        let mut id = 0;
        let mut bends = Vec::new();
        let mut list = |parts: &[(f64, f64, f64, f64)]| {
            let mut elements = Vec::new();
            for &(length, radius, angle, share) in parts {
                elements.push(line(id + 1, length));
                elements.push(bend(id + 2, radius, angle));
                bends.push((id + 2, angle * share.round().max(share)));
                id += 2;
            }
            id += 1;
            elements.push(line(id, 6.0));
            elements
        };
        let elements = list(&right);
        let other = if origin.has_other_side() { list(&left) } else { Vec::new() };
        let mut set = set(1.0, origin, elements, vec![station(1, &bends)]);
        set.section.other_side = other;
        let here = &mut set.stations[0];
        (here.pass_height, here.centre_distance, here.pinch) = (300.0, 600.0, pinch);
        (here.tolerance_left, here.tolerance_right) = (0.2, 0.3);
        here.drive_right = Some(DriveSurface { first: 1, last: 1 });
        if spigot {
            let contour = ExtensionContour { kind: ExtensionKind::SpigotA, lengths: [3.0, 5.0, 2.0, 6.0] };
            (here.extension_left, here.extension_right) = (vec![contour], vec![contour]);
        }
        set
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn no_roll_stands_in_the_strip_or_turns_back(set in sections()) {
        let station = station_rolls(&set, 0).unwrap();
        let outline = station.strip.outline();
        for roll in &station.rolls {
            let contour = roll.contour();
            prop_assert!(contour.largest_gap() < 1e-6, "{:?} gap {}", roll.kind, contour.largest_gap());
            for element in &contour.segments {
                prop_assert!(element.end().z >= element.start().z - 1e-6, "{:?} turns back: {element:?}", roll.kind);
            }
            let mut closed = roll.in_strip_space();
            closed.segments.push(Segment::line(closed.segments.last().unwrap().end(), closed.segments[0].start()));
            for p in outline.polyline(0.05) {
                let inside = closed.locate(p, 0.002) == Location::Inside;
                prop_assert!(!inside, "{:?} stands in the strip at {p:?} by {}", roll.kind, closed.distance_to(p));
            }
        }
    }

    #[test]
    fn top_and_bottom_roll_do_not_overlap(set in sections()) {
        let found = design("x", &set).diagnostics;
        prop_assert!(found.iter().all(|d| d.code != "roll-overlap"), "{found:?}");
    }
}
