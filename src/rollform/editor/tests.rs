use super::*;
use crate::document::{NewElement, RollPoint, Side, TangentSide};
use crate::geometry::{Point, Segment};

/// A roll 40 mm wide: face, 30 mm radius, wall at 20 to 50 mm, face.
fn step() -> Vec<RollElement> {
    let p = Point::new;
    let line = |a, b, name| RollElement::new(Segment::line(a, b), name);
    vec![
        line(p(0.0, 0.0), p(0.0, 30.0), ElementName::Flank { side: Side::Left }),
        line(p(0.0, 30.0), p(20.0, 30.0), strip(1)),
        line(p(20.0, 30.0), p(20.0, 50.0), strip(2)),
        line(p(20.0, 50.0), p(40.0, 50.0), strip(3)),
        line(p(40.0, 50.0), p(40.0, 0.0), ElementName::Flank { side: Side::Right }),
    ]
}

fn strip(element: u32) -> ElementName {
    ElementName::Strip { element, side: Side::Right, kind: crate::document::PieceKind::Line }
}

fn run(action: EditAction) -> Edited {
    edited(&step(), &[RollEdit { id: 1, action }])
}

fn code(action: EditAction) -> &'static str {
    let done = run(action);
    assert_eq!(done.elements, step());
    done.faults[0].code
}

const fn at(z: f64, diameter: f64) -> RollPoint {
    RollPoint { z, diameter }
}

fn gapless(elements: &[RollElement]) -> bool {
    super::super::roll::contour(elements).largest_gap() < 1e-9
}

#[test]
fn chamfer_takes_its_depth_off_both_lines() {
    let done = run(EditAction::Chamfer { after: strip(2), depth: 4.0 });
    assert_eq!(done.faults, []);
    assert_eq!(done.elements[3].segment, Segment::line(Point::new(20.0, 46.0), Point::new(24.0, 50.0)));
    assert!(gapless(&done.elements) && done.elements.len() == 6);
    assert_eq!(done.elements[3].names, [ElementName::Edit { edit: 1 }]);
}

#[test]
fn blend_touches_both_lines_of_a_hollow_corner_too() {
    let done = run(EditAction::Blend { after: strip(1), radius: 5.0 });
    let arc = done.elements[2].segment;
    assert!((arc.radius().unwrap() - 5.0).abs() < 1e-12 && arc.sweep() > 0.0);
    assert!(arc.start().distance(Point::new(15.0, 30.0)) < 1e-9 && arc.end().distance(Point::new(20.0, 35.0)) < 1e-9);
    assert!(gapless(&done.elements));
}

#[test]
fn corners_keep_the_published_conditions() {
    // 60 % of 20 mm is 12 mm.
    assert_eq!(code(EditAction::Chamfer { after: strip(1), depth: 12.1 }), "edit-corner-size");
    assert_eq!(run(EditAction::Chamfer { after: strip(1), depth: 12.0 }).faults, []);
    assert_eq!(code(EditAction::Blend { after: strip(1), radius: 0.0 }), "edit-figure");
    assert_eq!(code(EditAction::Blend { after: strip(1), radius: f64::NAN }), "edit-figure");
    assert_eq!(code(EditAction::Blend { after: strip(9), radius: 1.0 }), "edit-lost");
    assert_eq!(
        code(EditAction::Blend { after: ElementName::Flank { side: Side::Right }, radius: 1.0 }),
        "edit-corner-lines"
    );
    let mut flat = step();
    flat[3].segment = Segment::line(Point::new(20.0, 50.0), Point::new(40.0, 71.0));
    let edit = |action| edited(&flat, &[RollEdit { id: 1, action }]).faults;
    // The lines include 133.6 degrees at the wall's top...
    assert_eq!(edit(EditAction::Chamfer { after: strip(2), depth: 1.0 })[0].code, "edit-corner-angle");
    let rounded = [
        RollEdit { id: 1, action: EditAction::Blend { after: strip(1), radius: 2.0 } },
        RollEdit { id: 2, action: EditAction::Chamfer { after: strip(1), depth: 1.0 } },
    ];
    assert_eq!(edited(&step(), &rounded).faults[0].code, "edit-corner-lines");
}

#[test]
fn an_element_is_inserted_between_its_meetings() {
    let shape = NewElement::LineTwoPoints { first: at(15.0, 60.0), second: at(20.0, 70.0) };
    let done = run(EditAction::Insert { after: strip(1), shape });
    assert!(done.elements[2].segment.start().distance(Point::new(15.0, 30.0)) < 1e-9);
    assert!(done.elements[2].segment.end().distance(Point::new(20.0, 35.0)) < 1e-9);
    let shape = NewElement::LineAngle { point: at(15.0, 60.0), angle_deg: 45.0 };
    let angle = run(EditAction::Insert { after: strip(1), shape });
    assert!(angle.elements[2].segment.end().distance(Point::new(20.0, 35.0)) < 1e-9);
    let shape = NewElement::CircleTangent { radius: 5.0, before: TangentSide::Above, after: TangentSide::Above };
    let tangent = run(EditAction::Insert { after: strip(1), shape });
    let blend = run(EditAction::Blend { after: strip(1), radius: 5.0 }).elements[2].segment;
    let arc = tangent.elements[2].segment;
    assert!(arc.start().distance(blend.start()) < 1e-9 && arc.end().distance(blend.end()) < 1e-9);
    assert!(arc.sweep() * blend.sweep() > 0.0);
    let shape = NewElement::CircleRadius { center: at(20.0, 60.0), radius: 5.0 };
    let notch = run(EditAction::Insert { after: strip(1), shape });
    assert!(gapless(&notch.elements) && notch.faults.is_empty());
}

#[test]
fn a_circle_is_given_by_its_radius_or_by_a_point_of_it() {
    let center = at(20.0, 60.0);
    let insert = |shape| {
        let done = run(EditAction::Insert { after: strip(1), shape });
        assert_eq!(done.faults, []);
        done.elements.into_iter().map(|e| e.segment).collect::<Vec<_>>()
    };
    let by_point = insert(NewElement::CirclePoint { center, point: at(25.0, 60.0) });
    assert_eq!(by_point, insert(NewElement::CircleRadius { center, radius: 5.0 }));
    assert_eq!(by_point.len(), 6);
    assert_eq!(
        code(EditAction::Insert { after: strip(1), shape: NewElement::CirclePoint { center, point: center } }),
        "edit-figure"
    );
}

#[test]
fn an_element_is_replaced_and_deleted() {
    let shape = NewElement::LineParallel { point: at(25.0, 60.0), to: strip(2) };
    let done = run(EditAction::Replace { element: strip(2), shape });
    assert_eq!(done.elements[2].segment, Segment::line(Point::new(25.0, 30.0), Point::new(25.0, 50.0)));
    assert!(gapless(&done.elements));
    // A wall and the face beside it never meet.
    assert_eq!(code(EditAction::Delete { element: strip(1) }), "edit-no-meeting");
    let slanted = NewElement::LineTwoPoints { first: at(0.0, 40.0), second: at(20.0, 60.0) };
    let edits = [
        RollEdit { id: 1, action: EditAction::Replace { element: strip(1), shape: slanted } },
        RollEdit { id: 2, action: EditAction::Delete { element: strip(2) } },
    ];
    let done = edited(&step(), &edits);
    assert_eq!(done.faults.len(), 1);
    assert_eq!((done.faults[0].edit, done.faults[0].code), (2, "edit-turns-back"));
}

#[test]
fn a_circle_can_be_another_one_moved() {
    let edits = [
        RollEdit { id: 1, action: EditAction::Blend { after: strip(2), radius: 4.0 } },
        RollEdit {
            id: 2,
            action: EditAction::Replace {
                element: ElementName::Edit { edit: 1 },
                shape: NewElement::CircleMoved { of: ElementName::Edit { edit: 1 }, dz: -0.5, dr: 0.5 },
            },
        },
    ];
    let done = edited(&step(), &edits);
    assert_eq!(done.faults, []);
    let arc = done.elements.iter().find(|e| e.has(ElementName::Edit { edit: 2 })).unwrap().segment;
    assert!((arc.radius().unwrap() - 4.0).abs() < 1e-9 && gapless(&done.elements));
}

#[test]
fn an_edit_that_no_longer_fits_leaves_the_others() {
    let edits = [
        RollEdit { id: 1, action: EditAction::Chamfer { after: strip(7), depth: 1.0 } },
        RollEdit { id: 2, action: EditAction::Chamfer { after: strip(2), depth: 1.0 } },
    ];
    let done = edited(&step(), &edits);
    assert_eq!((done.faults.len(), done.faults[0].edit, done.elements.len()), (1, 1, 6));
}
