//! What must hold for any geometry: reversing, moving and mirroring change no distance and no meeting.

use super::{Contour, Intersection, Location, Point, Segment, Vector};
use proptest::prelude::*;

const TOLERANCE: f64 = 1e-7;

fn point() -> impl Strategy<Value = Point> {
    // Whole and half figures, so that touching and overlapping happen.
    prop_oneof![
        (-20..20_i32, -20..20_i32).prop_map(|(z, r)| Point::new(f64::from(z) / 2.0, f64::from(r) / 2.0)),
        (-10.0..10.0_f64, -10.0..10.0_f64).prop_map(|(z, r)| Point::new(z, r)),
    ]
}

fn segment() -> impl Strategy<Value = Segment> {
    let line = (point(), point()).prop_map(|(a, b)| Segment::line(a, b));
    let arc = (point(), 0.5..10.0_f64, 0.0..6.2_f64, 0.1..6.2_f64, any::<bool>()).prop_map(
        |(center, radius, from, sweep, ccw)| {
            let at = |angle: f64| center + Vector::new(angle.cos(), angle.sin()) * radius;
            let to = if ccw { from + sweep } else { from - sweep };
            Segment::Arc { start: at(from), end: at(to), center, ccw }
        },
    );
    prop_oneof![line, arc]
}

/// The case without its points.
fn case(found: &Intersection) -> std::mem::Discriminant<Intersection> {
    std::mem::discriminant(found)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn common_points_lie_on_both_segments(a in segment(), b in segment()) {
        for p in a.intersection(&b, TOLERANCE).points() {
            prop_assert!(a.distance_to(p) <= 2.0 * TOLERANCE && b.distance_to(p) <= 2.0 * TOLERANCE);
        }
    }

    #[test]
    fn meetings_survive_exchange_reversal_and_mirroring(a in segment(), b in segment(), z in -5.0..5.0_f64) {
        let found = a.intersection(&b, TOLERANCE);
        prop_assert_eq!(case(&found), case(&b.intersection(&a, TOLERANCE)));
        prop_assert_eq!(case(&found), case(&a.reversed().intersection(&b, TOLERANCE)));
        let mirrored = a.mirrored_at_z(z).intersection(&b.mirrored_at_z(z), TOLERANCE);
        prop_assert_eq!(found.points().len(), mirrored.points().len());
    }

    #[test]
    fn distance_survives_reversal_moving_and_mirroring(s in segment(), p in point(), dz in -5.0..5.0_f64, dr in -5.0..5.0_f64) {
        let distance = s.distance_to(p);
        let v = Vector::new(dz, dr);
        prop_assert!((s.reversed().distance_to(p) - distance).abs() < TOLERANCE);
        prop_assert!((s.translated(v).distance_to(p + v) - distance).abs() < TOLERANCE);
        prop_assert!((s.mirrored_at_z(dz).distance_to(p.mirrored_at_z(dz)) - distance).abs() < TOLERANCE);
        prop_assert!(distance <= s.start().distance(p) + TOLERANCE && distance <= s.end().distance(p) + TOLERANCE);
    }

    #[test]
    fn no_sampled_point_is_nearer_than_the_nearest(s in segment(), p in point()) {
        let distance = s.distance_to(p);
        for k in 0..=50 {
            prop_assert!(s.point_at(f64::from(k) / 50.0).distance(p) >= distance - TOLERANCE);
        }
    }

    #[test]
    fn location_survives_reversal_moving_and_mirroring(
        corners in proptest::collection::vec(point(), 3..7), p in point(), dz in -5.0..5.0_f64,
    ) {
        let contour = Contour::polygon(&corners);
        let location = contour.locate(p, TOLERANCE);
        let mirrored: Vec<Point> = corners.iter().map(|c| c.mirrored_at_z(dz)).collect();
        // Within a rounding of the border the answer may change.
        prop_assume!((contour.distance_to(p) - TOLERANCE).abs() > 1e-9);
        prop_assert_eq!(contour.reversed().locate(p, TOLERANCE), location);
        prop_assert_eq!(Contour::polygon(&mirrored).locate(p.mirrored_at_z(dz), TOLERANCE), location);
        if location == Location::Inside {
            prop_assert!(contour.bounds().is_some_and(|b| b.including(p) == b));
        }
    }
}
