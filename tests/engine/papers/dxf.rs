//! DXF: the part in its true size, read by the library that writes it, compared with the part's own contour.

use super::{Derived, derived, drawing};
use dxf::Drawing;
use dxf::entities::EntityType;
use turnwright::geometry::{Point, Segment};
use turnwright::papers::{Page, dxf};

/// What a line of the file may differ from the part's contour, mm.
const TOLERANCE_MM: f64 = 0.001;

/// The lines and arcs of a layer.
fn segments(page: &Page, layer: &str) -> Vec<Segment> {
    let file = dxf(page).unwrap();
    let read = Drawing::load(&mut file.as_bytes()).unwrap();
    let on_layer = read.entities().filter(|e| e.common.layer == layer);
    let made = on_layer.filter_map(|entity| match &entity.specific {
        EntityType::Line(line) => {
            Some(Segment::line(Point::new(line.p1.x, line.p1.y), Point::new(line.p2.x, line.p2.y)))
        }
        EntityType::Arc(arc) => {
            let center = Point::new(arc.center.x, arc.center.y);
            let on = |degrees: f64| {
                let (sin, cos) = degrees.to_radians().sin_cos();
                Point::new(center.z + arc.radius * cos, center.r + arc.radius * sin)
            };
            Some(Segment::Arc { start: on(arc.start_angle), end: on(arc.end_angle), center, ccw: true })
        }
        _ => None,
    });
    made.collect()
}

fn same(a: &Segment, b: &Segment) -> bool {
    let near = |a: &Segment, b: &Segment| {
        [0.0, 0.5, 1.0].into_iter().all(|t| a.point_at(t).distance(b.point_at(t)) < TOLERANCE_MM)
    };
    a.radius().is_some() == b.radius().is_some() && (near(a, b) || near(a, &b.reversed()))
}

/// The finished outside and bore, without what is cut away behind the part.
fn contour(derived: &Derived) -> (Vec<Segment>, Vec<Segment>) {
    let first = &derived.setups[0];
    let finished = |s: &&Segment| s.start().z.min(s.end().z) > -TOLERANCE_MM;
    let outside = first.contour.contour.segments.iter().filter(finished).copied().collect();
    let bore = first.bore.as_ref().as_ref().map(|b| b.contour.segments.iter().filter(finished).copied().collect());
    (outside, bore.unwrap_or_default())
}

#[test]
fn the_part_comes_back_in_its_true_size() {
    for name in ["QUEEN", "MASTER", "SPIGOT", "1470b-2T", "BEARING-HOUSING"] {
        let read = segments(&drawing(name, None)[0], "EDGES");
        let (outside, bore) = contour(&derived(name).0);
        let below = |s: &Segment| {
            let p = |p: Point| Point::new(p.z, -p.r);
            match *s {
                Segment::Line { start, end } => Segment::line(p(start), p(end)),
                Segment::Arc { start, end, center, ccw } => {
                    Segment::Arc { start: p(start), end: p(end), center: p(center), ccw: !ccw }
                }
            }
        };
        for wanted in outside.iter().copied().chain(outside.iter().map(below)).chain(bore.iter().map(below)) {
            assert!(read.iter().any(|s| same(s, &wanted)), "{name}: {wanted:?} is missing");
        }
        assert!(outside.len() > 3 && (name != "BEARING-HOUSING" || bore.len() > 3), "{name}");
    }
}

#[test]
fn arrow_heads_are_there_though_areas_stay_empty() {
    let thin = segments(&drawing("KNOB", None)[0], "THIN");
    let view = drawing("KNOB", None)[0].part.unwrap();
    // The dimension line of the ball's diameter ends in a head at either end: three edges each, 2.5 mm long on paper.
    let ends = thin.iter().filter(|s| (s.length() * view.scale - 2.5f64.hypot(0.5)).abs() < 1e-3);
    let at_ball = ends
        .filter(|s| (s.start().r.abs() - 13.0).abs() < TOLERANCE_MM || (s.end().r.abs() - 13.0).abs() < TOLERANCE_MM);
    assert!(at_ball.count() >= 4);
}

#[test]
fn the_axis_is_on_a_layer_of_its_own_and_the_figures_are_texts() {
    let page = &drawing("MASTER", None)[0];
    let axis = segments(page, "CENTRE");
    assert_eq!(axis.len(), 1);
    assert!(axis[0].start().r.abs() < TOLERANCE_MM && axis[0].end().z - axis[0].start().z > 40.0);
    let file = dxf(page).unwrap();
    let read = Drawing::load(&mut file.as_bytes()).unwrap();
    let texts: Vec<String> = read
        .entities()
        .filter_map(|e| if let EntityType::Text(t) = &e.specific { Some(t.value.clone()) } else { None })
        .collect();
    for figure in ["%%c 25", "R 7", "40", "MASTER"] {
        assert!(texts.iter().any(|t| t == figure), "{figure} in {texts:?}");
    }
}
