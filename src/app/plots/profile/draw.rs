//! What is drawn under the handles: stock, chuck, part, threads, centre line.

use super::hatch::hatches;
use super::{Frame, ProfileScene, ProfileView};
use crate::app::plots::canvas::Screen;
use crate::app::plots::lines::{CENTRE_LINE, DASHED, dashed, faded, thinned};
use crate::app::plots::palette::Palette;
use crate::app::plots::regions::{Triangles, from_axis_to_axis, mirrored};
use crate::geometry::{Bounds, Point};
use crate::machine::Chuck;
use crate::part::Setup;
use egui::{Painter, Rect, Shape, Stroke};
use std::sync::Arc;

/// Width of the part's edge, points.
pub(in crate::app::plots) const EDGE: f32 = 1.8;
/// Width of the line of a section that is selected or under the pointer, points.
pub(in crate::app::plots) const LIT: f32 = 3.0;
/// Strength of the line of a section that is under the pointer and not selected.
pub(in crate::app::plots) const LIT_STRENGTH: f32 = 0.55;
/// Chords of the stock's outline are this near to its arcs, mm.
const STOCK_CHORDS_MM: f64 = 0.005;
/// Share of the part's length that the chuck takes in a fitted view.
const CHUCK_SHOWN: f64 = 0.12;

/// What a fitted view of `setup` shows; with the lower half or without.
pub(in crate::app::plots) fn shown_bounds(setup: &Setup, full_section: bool) -> Bounds {
    let radius = setup.bar_radius.max(setup.length * 0.02);
    let from = setup.chuck_face_z.min(0.0) - CHUCK_SHOWN * setup.length;
    let below = if full_section { -1.2 * radius } else { -0.1 * radius };
    Bounds { min: Point::new(from, below), max: Point::new(setup.length * 1.08, 1.12 * radius) }
}

/// Draws everything that cannot be taken hold of.
pub(super) fn scenery(painter: &Painter, frame: &Frame<'_>, view: &mut ProfileView) {
    let full_section = view.full_section;
    let (scene, screen) = (frame.scene, &frame.screen);
    let setup = &scene.derived.setup;
    view.stock.update(setup);
    view.stock.draw(painter, screen, scene.palette, full_section);
    part(painter, screen, scene, full_section);
    hatches(painter, frame);
    threads(painter, screen, setup, scene.palette, full_section);
    if let Some(machine) = scene.machine {
        chuck(painter, screen, setup.chuck_face_z, &machine.chuck, scene.palette);
    }
    centre_line(painter, screen, scene.palette);
    for &id in scene.lit {
        lit_section(painter, frame, id, LIT_STRENGTH);
    }
    if let Some(id) = scene.selected {
        lit_section(painter, frame, id, 1.0);
    }
}

/// Draws the line of a section in the accent colour.
fn lit_section(painter: &Painter, frame: &Frame<'_>, id: u32, strength: f32) {
    let stroke = Stroke::new(LIT, faded(frame.scene.palette.accent, strength));
    for segment in frame.segments_of(id) {
        painter.add(Shape::line(thinned(frame.polyline(segment)), stroke));
    }
}

/// The stock of one set-up ready to be drawn.
#[derive(Debug, Default)]
pub(super) struct Stock {
    made_for: Option<Arc<Setup>>,
    region: Triangles,
    /// Its outline from the axis to the axis.
    outline: Vec<Point>,
}

impl Stock {
    fn update(&mut self, setup: &Arc<Setup>) {
        if self.made_for.as_ref().is_some_and(|made| Arc::ptr_eq(made, setup)) {
            return;
        }
        let mut ring = setup.stock.polyline(STOCK_CHORDS_MM);
        ring.pop();
        self.region = Triangles::of(std::slice::from_ref(&ring));
        self.outline = from_axis_to_axis(&ring);
        self.made_for = Some(Arc::clone(setup));
    }

    fn draw(&self, painter: &Painter, screen: &Screen, palette: &Palette, full_section: bool) {
        let edge = Stroke::new(1.0, palette.stock_edge);
        // The stock explains the part and stays behind it.
        let fill = faded(palette.stock, 0.6);
        self.region.fill(painter, screen, fill);
        dashed(painter, &on_screen(screen, &self.outline), DASHED, edge);
        if full_section {
            self.region.fill_mirrored(painter, screen, fill);
            let below: Vec<Point> = self.outline.iter().copied().map(mirrored).collect();
            dashed(painter, &on_screen(screen, &below), DASHED, edge);
        }
    }
}

fn part(painter: &Painter, screen: &Screen, scene: &ProfileScene<'_>, full_section: bool) {
    let palette = scene.palette;
    let line = scene.derived.contour.contour.polyline(screen.tolerance());
    let region = Triangles::under(&line);
    let closed = with_ends_on_axis(&line);
    if full_section {
        region.fill_mirrored(painter, screen, palette.part_mirror);
        let below: Vec<Point> = closed.iter().copied().map(mirrored).collect();
        painter.add(Shape::line(on_screen(screen, &below), Stroke::new(1.0, palette.edge_mirror)));
    }
    region.fill(painter, screen, palette.part);
    painter.add(Shape::line(on_screen(screen, &closed), Stroke::new(EDGE, palette.edge)));
}

/// The line with both ends led down to the spindle axis.
pub(in crate::app::plots) fn with_ends_on_axis(line: &[Point]) -> Vec<Point> {
    let foot = |p: Option<&Point>| p.map(|p| Point::new(p.z, 0.0));
    foot(line.first()).into_iter().chain(line.iter().copied()).chain(foot(line.last())).collect()
}

fn threads(painter: &Painter, screen: &Screen, setup: &Setup, palette: &Palette, full_section: bool) {
    for thread in &setup.threads {
        let root = [Point::new(thread.z1, thread.base_radius), Point::new(thread.z2, thread.base_radius)];
        painter.line_segment(root.map(|p| screen.pos(p)), Stroke::new(1.0, palette.edge));
        if full_section {
            let below = root.map(|p| screen.pos(mirrored(p)));
            painter.line_segment(below, Stroke::new(1.0, palette.edge_mirror));
        }
    }
}

/// Draws the jaws of a chuck whose face is at `face_z`.
pub(in crate::app::plots) fn chuck(painter: &Painter, screen: &Screen, face_z: f64, chuck: &Chuck, palette: &Palette) {
    let (r, back) = (chuck.radius_mm, face_z - chuck.depth_mm);
    let rect = Rect::from_two_pos(screen.pos(Point::new(back, r)), screen.pos(Point::new(face_z, -r)));
    painter.rect(rect, 0.0, palette.steel, Stroke::new(1.0, palette.steel_edge), egui::StrokeKind::Middle);
}

/// Draws the spindle axis across the canvas.
pub(in crate::app::plots) fn centre_line(painter: &Painter, screen: &Screen, palette: &Palette) {
    let y = painter.round_to_pixel_center(screen.pos(Point::default()).y);
    let clip = painter.clip_rect();
    let line = [egui::pos2(clip.left(), y), egui::pos2(clip.right(), y)];
    dashed(painter, &line, CENTRE_LINE, Stroke::new(1.0, palette.construction));
}

/// Points on the screen, thinned.
pub(in crate::app::plots) fn on_screen(screen: &Screen, points: &[Point]) -> Vec<egui::Pos2> {
    thinned(points.iter().map(|&p| screen.pos(p)))
}
