//! The tool at the slider: its true outline with holder, and what its insert swept since the last stock state.

use super::playback::Position;
use crate::app::plots::canvas::Screen;
use crate::app::plots::palette::Palette;
use crate::app::plots::profile::draw::on_screen;
use crate::app::plots::regions::Triangles;
use crate::geometry::{Contour, Point, Segment, Vector};
use crate::machine::ToolOutline;
use crate::proof::{Motion, Move};
use egui::{Color32, Painter, Pos2, Shape, Stroke};

/// Chords that the path of a part-done arc is taken for.
const SWEEP_CHORDS: u8 = 12;

/// Draws a tool whose programmed point is at `at`.
pub(super) fn tool(painter: &Painter, screen: &Screen, palette: &Palette, outline: &ToolOutline, at: Point) {
    contour(painter, screen, &outline.holder, at, palette.steel, palette.steel_edge);
    contour(painter, screen, &outline.insert, at, palette.insert, palette.edge);
    painter.circle_filled(screen.pos(at), 1.8, palette.edge);
}

fn contour(painter: &Painter, screen: &Screen, outline: &Contour, at: Point, fill: Color32, edge: Color32) {
    let ring = placed(outline, at, screen.tolerance());
    Triangles::of(std::slice::from_ref(&ring)).fill(painter, screen, fill);
    painter.add(Shape::closed_line(on_screen(screen, &ring), Stroke::new(1.0, edge)));
}

fn placed(outline: &Contour, at: Point, tolerance: f64) -> Vec<Point> {
    let mut ring = outline.polyline(tolerance);
    ring.pop();
    ring.into_iter().map(|p| Point::new(p.z + at.z, p.r + at.r)).collect()
}

/// Paints what the insert has swept of the running move in the colour of the ground, so that stock goes as it is cut.
///
/// The insert is taken for its convex hull, which all shapes of insert of the tool table are.
pub(super) fn swept(
    painter: &Painter,
    screen: &Screen,
    palette: &Palette,
    outline: &ToolOutline,
    running: &Move,
    now: Position,
) {
    if running.motion == Motion::Pause || now.share >= 1.0 || now.share <= 0.0 {
        return;
    }
    let insert = placed(&outline.insert, Point::default(), screen.tolerance());
    let steps = if matches!(running.path, Segment::Arc { .. }) { SWEEP_CHORDS } else { 1 };
    let stop = |k: u8| running.path.point_at(now.share * f64::from(k) / f64::from(steps));
    for k in 0..steps {
        let both = [stop(k), stop(k + 1)].map(|p| Vector::new(p.z, p.r));
        let corners: Vec<Pos2> = both.iter().flat_map(|&by| insert.iter().map(move |&p| screen.pos(p + by))).collect();
        painter.add(Shape::convex_polygon(hull(corners), palette.ground, Stroke::NONE));
    }
}

/// The convex hull of points (Andrew's monotone chain), without points on its edges.
fn hull(mut points: Vec<Pos2>) -> Vec<Pos2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let mut ring = half_hull(points.iter().copied());
    let back = half_hull(points.iter().rev().copied());
    ring.pop();
    ring.extend(back);
    ring.pop();
    ring
}

fn half_hull(points: impl Iterator<Item = Pos2>) -> Vec<Pos2> {
    let mut chain: Vec<Pos2> = Vec::new();
    for p in points {
        while let [.., a, b] = chain[..] {
            let (along, to) = (b - a, p - a);
            if along.x * to.y - along.y * to.x > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(p);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;
    use proptest::prelude::*;

    #[test]
    fn the_hull_of_a_square_with_points_inside_is_the_square() {
        let points = [(0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (2.0, 2.0), (0.0, 2.0), (1.0, 0.0)].map(|(x, y)| pos2(x, y));
        let ring = hull(points.to_vec());
        assert_eq!(ring, [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| pos2(x, y)).to_vec());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn hulls_turn_one_way_and_hold_all_points(
            points in prop::collection::vec((-50..50_i8, -50..50_i8), 3..40),
        ) {
            let points: Vec<Pos2> = points.iter().map(|&(x, y)| pos2(x.into(), y.into())).collect();
            let ring = hull(points.clone());
            prop_assume!(ring.len() > 2);
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                for p in &points {
                    let side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
                    prop_assert!(side >= 0.0);
                }
            }
        }
    }
}
