use super::*;
use crate::geometry::Segment;

/// Tool 1 of the machine of today: nose radius 0.8, centre at (0.8, 0.8) from the programmed point. Turning towards the chuck
/// is G42: the tool is on the right.
fn nose_path(contour: &str) -> Vec<Segment> {
    let text = format!("O1\nG21 T0101\nG97 S1000 M03\nG0 X60. Z5.\n{contour}\nM30");
    let nose = crate::geometry::Vector::new(0.8, 0.8);
    good("fanuc-0i", &text).paths().iter().map(|p| p.translated(nose)).collect()
}

#[test]
fn lines_arcs_and_corners_touch_the_programmed_contour() {
    let contour = "G42 G1 X20. Z2. F.1\nZ-10.\nG2 X24. Z-12. R2.\nG1 X30.\nX40. Z-20.\nG3 X46. Z-23. R3.\nG1 Z-30.\nG40 X60. Z-31.";
    let paths = nose_path(contour);
    // The programmed contour; the nose circle touches it from above all along.
    let p = |z: f64, d: f64| Point::new(z, d / 2.0);
    let contour = [
        Segment::line(p(2.0, 20.0), p(-10.0, 20.0)),
        Segment::Arc { start: p(-10.0, 20.0), end: p(-12.0, 24.0), center: Point::new(-10.0, 12.0), ccw: false },
        Segment::line(p(-12.0, 24.0), p(-12.0, 30.0)),
        Segment::line(p(-12.0, 30.0), p(-20.0, 40.0)),
        Segment::Arc { start: p(-20.0, 40.0), end: p(-23.0, 46.0), center: Point::new(-23.0, 20.0), ccw: true },
        Segment::line(p(-23.0, 46.0), p(-30.0, 46.0)),
    ];
    let compensated = &paths[2..paths.len() - 1];
    assert!(compensated.len() >= contour.len());
    let mut from = paths[1].end();
    for path in compensated {
        assert!(path.start().distance(from) < 2e-3, "{path:?} does not begin at {from:?}");
        for k in 0..=20 {
            let c = path.point_at(f64::from(k) / 20.0);
            let distance = contour.iter().map(|s| s.distance_to(c)).fold(f64::INFINITY, f64::min);
            assert!((distance - 0.8).abs() < 2e-3, "{distance} at {c:?}");
        }
        from = path.end();
    }
    // The last move ends on the uncompensated point again.
    assert!(paths.last().unwrap().end().distance(Point::new(-31.0 + 0.8, 30.8)) < 1e-9);
}

#[test]
fn an_arc_tighter_than_the_nose_is_an_alarm() {
    let text = "O1\nG21 T0101\nG97 S1000 M03\nG0 X60. Z5.\nG42 G1 X20. Z2. F.1\nZ-10.\nG2 X21. Z-10.5 R.5\nG1 X30.\nG40 X60.\nM30";
    assert!(said("fanuc-0i", text).iter().any(|m| m.contains("interference")));
}

#[test]
fn sides_are_turned_over_on_the_6t() {
    let text = "O201\nG21\nG50X-455.000Z320.000\nT0202M41\nG97S200M03\nG0X-60.000Z5.000\nG41G1X-20.000Z2.000F0.1\nZ-10.000\nG40X-60.000\nM30";
    let paths = good("mori-fanuc-6t", text).paths();
    // The nose centre is at (0.8, 0.8) from the point: above a line at radius 10 the point itself runs at radius 10.
    assert!((paths[2].start().r - 10.0).abs() < 1e-9 && (paths[2].end().r - 10.0).abs() < 1e-9, "{paths:?}");
}
