//! What a drag of a node or of an arc's middle makes of the pointer's position.

use super::nodes::NodeMove;
use crate::app::plots::coordinates::snapped;
use crate::geometry::Point;

/// Flattest arc that a drag makes: its radius over half its chord.
const FLATTEST: f64 = 500.0;

/// A drag that is under way.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Drag {
    /// Of a node.
    Node {
        /// The node as it was when taken hold of.
        from: NodeMove,
        /// Where the pointer took hold of it: z and diameter.
        grip: (f64, f64),
        /// The last position given out, if any.
        last: Option<(f64, f64)>,
    },
    /// Of the middle of an arc.
    Radius {
        /// Row of the arc.
        section: u32,
        /// The last radius given out, if any.
        last: Option<f64>,
    },
}

/// How a drag is held to round figures and axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Guide {
    /// Only the axis with the larger movement moves.
    pub(super) one_axis: bool,
    /// Step of z and diameter; `None` leaves them free.
    pub(super) step: Option<f64>,
}

/// Where a node goes that was at `from`, taken hold of at `grip`, when the pointer is at `pointer`; z and diameter each.
///
/// A coordinate that moved less than half a step keeps its figure, so that dragging along z does not round a diameter.
pub(super) fn dragged(from: &NodeMove, grip: (f64, f64), pointer: (f64, f64), guide: Guide) -> (f64, f64) {
    let (mut dz, mut dd) = (pointer.0 - grip.0, pointer.1 - grip.1);
    if guide.one_axis {
        // On the screen a change of diameter moves the node by half of it.
        if dz.abs() >= dd.abs() / 2.0 {
            dd = 0.0;
        } else {
            dz = 0.0;
        }
    }
    let place = |start: f64, by: f64| match guide.step {
        Some(step) if by.abs() < step / 2.0 => start,
        step => snapped(start + by, step),
    };
    (place(from.z, dz), place(from.diameter, dd).max(0.0))
}

/// Radius of the arc from `start` to `end` whose middle is brought to the height of `pointer`; all in mm.
///
/// By the sagitta s and half chord h: R = (h² + s²) / 2s. The middle stays on the side of `bulges_out` and the arc below
/// half a turn. `None` if the ends coincide.
pub(super) fn radius_through(start: Point, end: Point, pointer: Point, bulges_out: bool) -> Option<f64> {
    let chord = end - start;
    let half = chord.norm() / 2.0;
    let middle = start + chord / 2.0;
    let side = if bulges_out { 1.0 } else { -1.0 };
    let height = side * chord.perp(&(pointer - middle)) / chord.norm();
    // R/h grows to FLATTEST as s/h falls to about half its inverse.
    let sagitta = height.clamp(half / (2.0 * FLATTEST), half);
    let radius = (half * half + sagitta * sagitta) / (2.0 * sagitta);
    (half > 0.0 && radius.is_finite()).then_some(radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FREE: Guide = Guide { one_axis: false, step: None };

    fn node() -> NodeMove {
        NodeMove { ends: Vec::new(), follow_z: Vec::new(), z: 36.0, diameter: 17.53 }
    }

    #[test]
    fn a_free_drag_follows_the_pointer() {
        let (z, d) = dragged(&node(), (36.2, 17.0), (37.2, 18.0), FREE);
        assert!((z - 37.0).abs() < 1e-12 && (d - 18.53).abs() < 1e-12);
    }

    #[test]
    fn one_axis_keeps_the_other_exactly() {
        let guide = Guide { one_axis: true, step: Some(0.1) };
        assert_eq!(dragged(&node(), (36.0, 17.5), (38.04, 18.0), guide), (38.0, 17.53));
        assert_eq!(dragged(&node(), (36.0, 17.5), (36.3, 20.0), guide), (36.0, 20.0));
    }

    #[test]
    fn a_coordinate_that_hardly_moved_is_not_rounded() {
        let guide = Guide { one_axis: false, step: Some(0.5) };
        assert_eq!(dragged(&node(), (36.0, 17.5), (39.1, 17.6), guide), (39.0, 17.53));
    }

    #[test]
    fn a_diameter_never_falls_below_the_axis() {
        assert_eq!(dragged(&node(), (36.0, 17.5), (36.0, -40.0), FREE).1, 0.0);
    }

    #[test]
    fn a_half_circle_is_the_smallest_radius() {
        let (a, b) = (Point::new(0.0, 5.0), Point::new(10.0, 5.0));
        assert_eq!(radius_through(a, b, Point::new(5.0, 30.0), true), Some(5.0));
        assert_eq!(radius_through(a, a, Point::new(5.0, 30.0), true), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn the_arc_passes_through_the_pointer(h in 0.5..20.0_f64, share in 0.05..1.0_f64, out: bool) {
            let (a, b) = (Point::new(0.0, 50.0), Point::new(2.0 * h, 50.0));
            let height = share * h;
            let pointer = Point::new(h, if out { 50.0 + height } else { 50.0 - height });
            let radius = radius_through(a, b, pointer, out).unwrap();
            // The sagitta of that radius over the chord is the height again.
            prop_assert!((radius - (radius * radius - h * h).max(0.0).sqrt() - height).abs() < 1e-6);
        }
    }
}
