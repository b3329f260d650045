//! The tool at the slider: its true outline with holder, and what its insert swept since the last stock state.

use crate::app::plots::canvas::Screen;
use crate::app::plots::palette::Palette;
use crate::app::plots::profile::draw::on_screen;
use crate::app::plots::regions::Triangles;
use crate::geometry::{Contour, Point, Segment, Vector};
use crate::machine::ToolOutline;
use crate::proof::{Motion, Move};
use egui::{Color32, Painter, Pos2, Shape, Stroke};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Chords that the path of a part-done arc is taken for.
const SWEEP_CHORDS: u8 = 12;
/// Chords of a tool's outline are this near to its arcs, mm: a nose of 0.2 mm stays round at any zoom that shows it.
const CHORDS_MM: f64 = 0.001;

/// Tools ready to be drawn, made once for a set of outlines.
#[derive(Debug, Default)]
pub(super) struct Tools {
    made_for: Option<Arc<BTreeMap<u32, ToolOutline>>>,
    ready: BTreeMap<u32, [Outline; 2]>,
}

/// An outline as a ring and as triangles, in tool space.
#[derive(Debug)]
struct Outline {
    ring: Vec<Point>,
    region: Triangles,
}

impl Outline {
    fn of(contour: &Contour) -> Self {
        let mut ring = contour.polyline(CHORDS_MM);
        ring.pop();
        let region = Triangles::of(std::slice::from_ref(&ring));
        Self { ring, region }
    }

    fn draw(&self, painter: &Painter, screen: &Screen, at: Vector, fill: Color32, edge: Color32) {
        self.region.fill_moved(painter, screen, at, fill);
        let ring: Vec<Point> = self.ring.iter().map(|&p| p + at).collect();
        painter.add(Shape::closed_line(on_screen(screen, &ring), Stroke::new(1.0, edge)));
    }
}

impl Tools {
    /// Makes `tools` ready if they are not.
    pub(super) fn update(&mut self, tools: &Arc<BTreeMap<u32, ToolOutline>>) {
        if self.made_for.as_ref().is_some_and(|made| Arc::ptr_eq(made, tools)) {
            return;
        }
        let outlines = |t: &ToolOutline| [Outline::of(&t.holder), Outline::of(&t.insert)];
        self.ready = tools.iter().map(|(&station, tool)| (station, outlines(tool))).collect();
        self.made_for = Some(Arc::clone(tools));
    }

    /// Draws the tool of a station with its programmed point at `at`.
    pub(super) fn draw(&self, painter: &Painter, screen: &Screen, palette: &Palette, station: u32, at: Point) {
        let Some([holder, insert]) = self.ready.get(&station) else { return };
        let by = Vector::new(at.z, at.r);
        holder.draw(painter, screen, by, palette.steel, palette.steel_edge);
        insert.draw(painter, screen, by, palette.insert, palette.edge);
        painter.circle_filled(screen.pos(at), 1.8, palette.edge);
    }

    /// Paints what the insert has swept of the running move in the colour of the ground, so that stock goes as it is cut.
    ///
    /// The insert is taken for its convex hull, which all shapes of insert of the tool table are.
    pub(super) fn swept(&self, painter: &Painter, screen: &Screen, palette: &Palette, running: &Move, share: f64) {
        let Some([_, insert]) = self.ready.get(&running.tool) else { return };
        if running.motion == Motion::Pause || share >= 1.0 || share <= 0.0 {
            return;
        }
        let steps = if matches!(running.path, Segment::Arc { .. }) { SWEEP_CHORDS } else { 1 };
        let stop = |k: u8| running.path.point_at(share * f64::from(k) / f64::from(steps));
        for k in 0..steps {
            let both = [stop(k), stop(k + 1)].map(|p| Vector::new(p.z, p.r));
            let corners: Vec<Pos2> =
                both.iter().flat_map(|&by| insert.ring.iter().map(move |&p| screen.pos(p + by))).collect();
            painter.add(Shape::convex_polygon(hull(corners), palette.ground, Stroke::NONE));
        }
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
