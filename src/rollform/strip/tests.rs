use super::*;
use crate::document::{Element, Origin};
use crate::rollform::fixtures::{bend, line, published, set, station};

/// The published half flat is printed with three decimals and drifts by up to 0.0025 mm.
const PRINTED_MM: f64 = 0.0025;

fn at(set: &RollSet, station: usize) -> Strip {
    Strip::at(set, Stage::Station(station))
}

#[test]
fn flat_of_the_published_stage_ends_where_its_rolls_have_it() {
    let strip = at(&published(), 1);
    let bent = strip.pieces.iter().find(|p| p.side == Side::Right && p.is_bent()).unwrap();
    assert_eq!(bent.element, 8);
    // Half of (122.533 - 36.770).
    assert!((bent.bottom.start().z - 42.8815).abs() < PRINTED_MM);
    assert_eq!(bent.bottom.start().r, 0.0);
}

#[test]
fn pieces_follow_one_another_smoothly_and_the_length_never_changes() {
    let set = published();
    let flat = Strip::at(&set, Stage::Flat).mean_length();
    for stage in [Stage::Station(0), Stage::Station(1), Stage::Station(2), Stage::Finished] {
        let strip = Strip::at(&set, stage);
        assert!((strip.mean_length() - flat).abs() < 1e-9);
        for face in [strip.mean(), strip.bottom(), strip.top()] {
            assert!(face.largest_gap() < 1e-9, "{stage:?}");
        }
        assert!(strip.pieces.windows(2).all(|w| (w[0].end_heading_rad() - w[1].heading_rad).abs() < 1e-12));
    }
}

#[test]
fn a_symmetrical_strip_is_its_own_mirror_image() {
    let strip = at(&published(), 2);
    for (left, right) in strip.pieces.iter().zip(strip.pieces.iter().rev()) {
        assert_eq!((left.element, left.kind), (right.element, right.kind));
        assert!(left.top.mirrored_at_z(0.0).start().distance(right.top.end()) < 1e-9);
        assert!((left.angle_rad - right.angle_rad).abs() < 1e-12);
    }
}

#[test]
fn faces_lie_half_the_thickness_from_the_mean_line() {
    let strip = at(&published(), 1);
    for piece in &strip.pieces {
        for t in [0.0, 0.3, 1.0] {
            let p = piece.mean.point_at(t);
            assert!((piece.top.distance_to(p) - 0.25).abs() < 1e-9);
            assert!((piece.bottom.distance_to(p) - 0.25).abs() < 1e-9);
        }
    }
    let arc = strip.pieces.iter().find(|p| p.element == 16 && p.side == Side::Right).unwrap();
    assert!((arc.top.radius().unwrap() - 2.5).abs() < 1e-9 && (arc.bottom.radius().unwrap() - 3.0).abs() < 1e-9);
}

/// A channel of 1 mm: leg 20, base 40, leg 20.
fn channel(origin: Origin, first_angle_deg: f64) -> RollSet {
    let elements: Vec<Element> =
        vec![line(1, 20.0), bend(2, 2.0, 90.0), line(3, 40.0), bend(4, 2.0, 90.0), line(5, 20.0)];
    let stations = vec![station(1, &[(2, 30.0), (4, 30.0)]), station(2, &[(2, 90.0), (4, 90.0)])];
    let mut set = set(1.0, origin, elements, stations);
    set.section.first_angle_deg = first_angle_deg;
    set
}

#[test]
fn a_section_that_begins_at_its_edge_is_held_by_its_base() {
    for origin in [Origin::LeftToRight, Origin::RightToLeft] {
        let set = channel(origin, -90.0);
        for stage in [Stage::Flat, Stage::Station(0), Stage::Station(1), Stage::Finished] {
            let strip = Strip::at(&set, stage);
            let base = strip.pieces.iter().find(|p| p.element == 3).unwrap();
            assert!(base.heading_rad.abs() < 1e-12, "{origin:?} {stage:?}");
            let middle = base.bottom.point_at(0.5);
            assert!(middle.r.abs() < 1e-12 && (middle.z.abs() - 22.5).abs() < 1e-9, "{middle:?}");
        }
    }
}

#[test]
fn both_edges_give_the_same_channel() {
    let (a, b) = (at(&channel(Origin::LeftToRight, -90.0), 0), at(&channel(Origin::RightToLeft, -90.0), 0));
    let shift = b.pieces[0].mean.start() - a.pieces[0].mean.start();
    for (p, q) in a.pieces.iter().zip(&b.pieces) {
        assert!((p.mean.start() + shift).distance(q.mean.start()) < 1e-9);
    }
}

#[test]
fn two_lists_run_outwards_from_an_inclined_middle() {
    let mut set = channel(Origin::CentreRightFirst, 10.0);
    set.section.elements = vec![line(1, 10.0), bend(2, 1.0, 40.0), line(3, 10.0)];
    set.section.other_side = vec![line(4, 15.0), bend(5, 1.0, -20.0), line(6, 5.0)];
    set.stations = vec![station(1, &[(2, 40.0), (5, -20.0)])];
    let right = at(&set, 0);
    assert_eq!(right.pieces.iter().map(|p| p.element).collect::<Vec<_>>(), [6, 5, 4, 1, 2, 3]);
    let slope =
        |strip: &Strip, element| strip.pieces.iter().find(|p| p.element == element).unwrap().heading_rad.to_degrees();
    assert!((slope(&right, 3) - 50.0).abs() < 1e-9 && (slope(&right, 6) - 30.0).abs() < 1e-9);
    assert!(right.origin().distance(Point::new(0.0, 0.5)) < 1e-12);
    set.section.origin = Origin::CentreLeftFirst;
    let left = at(&set, 0);
    let mirrored = left.pieces.last().unwrap().mean.end().mirrored_at_z(0.0);
    assert!(mirrored.distance(right.pieces[0].mean.start()) < 1e-9);
}

#[test]
fn the_outline_is_closed_and_sharp_corners_are_points() {
    let mut set = channel(Origin::LeftToRight, -90.0);
    set.section.elements[1] = bend(2, 0.0, 90.0);
    let strip = Strip::at(&set, Stage::Finished);
    let corner = strip.pieces.iter().find(|p| p.element == 2).unwrap();
    assert!(corner.top.length() < 1e-9 && corner.top.radius().is_none());
    let outline = strip.outline();
    assert!(outline.largest_gap() < 1e-9);
    assert!(outline.segments[0].start().distance(outline.segments.last().unwrap().end()) < 1e-9);
    assert!(Strip { thickness: 1.0, pieces: Vec::new(), left_of_origin: 0 }.outline().segments.is_empty());
}
