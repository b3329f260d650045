//! What is drawn under the handles: stock, chuck, part, threads, centre line.

use super::hatch::hatches;
use super::{Frame, ProfileScene, ProfileView};
use crate::app::plots::canvas::Screen;
use crate::app::plots::lines::{CENTRE_LINE, DASHED, dashed, faded, thinned};
use crate::app::plots::palette::Palette;
use crate::app::plots::regions::{Triangles, from_axis_to_axis, mirrored};
use crate::geometry::{Bounds, Contour, Point};
use crate::machine::Chuck;
use crate::part::Setup;
use crate::regen::SetupDerived;
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
/// Points nearer than this are at the same place, mm.
const SAME_MM: f64 = 1e-6;
/// Share of the part's length that the chuck takes in a fitted view.
const CHUCK_SHOWN: f64 = 0.12;
/// Share of the part's length that the tailstock takes in a fitted view.
const TAILSTOCK_SHOWN: f64 = 0.22;
/// Dashes of lines that the part hides, points.
const HIDDEN: [f32; 2] = [4.0, 3.0];

/// What a fitted view of `setup` shows; with the lower half or without.
pub(in crate::app::plots) fn shown_bounds(setup: &Setup, full_section: bool) -> Bounds {
    let radius = setup.bar_radius.max(setup.length * 0.02);
    let from = setup.chuck_face_z.min(0.0) - CHUCK_SHOWN * setup.length;
    let end = setup.stock.bounds().map_or(setup.length, |b| b.max.z.max(setup.length));
    let beyond = if setup.tailstock.is_some() { TAILSTOCK_SHOWN } else { 0.08 };
    let below = if full_section { -1.2 * radius } else { -0.1 * radius };
    Bounds { min: Point::new(from, below), max: Point::new(end + beyond * setup.length, 1.12 * radius) }
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
    for holder in [&setup.mandrel, &setup.tailstock].into_iter().flatten() {
        body(painter, screen, holder, scene.palette);
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
    let Lines { outside, bore } = Lines::of(scene.derived, screen.tolerance());
    if full_section {
        // The lower half is seen from outside: the bore is behind it.
        Triangles::between(&outside, &[]).fill_mirrored(painter, screen, palette.part_mirror);
        let below = |line: &[Point]| on_screen(screen, &line.iter().copied().map(mirrored).collect::<Vec<_>>());
        let stroke = Stroke::new(1.0, palette.edge_mirror);
        painter.add(Shape::line(below(&with_ends_on_axis(&outside)), stroke));
        dashed(painter, &below(&bore), &HIDDEN, stroke);
    }
    Triangles::between(&outside, &bore).fill(painter, screen, palette.part);
    let closed = outline(&outside, &bore);
    painter.add(Shape::line(on_screen(screen, &closed), Stroke::new(EDGE, palette.edge)));
}

/// The finished part as points: its outside, and its bore if it has one.
pub(in crate::app::plots) struct Lines {
    /// From the clamped end to the free end.
    pub(in crate::app::plots) outside: Vec<Point>,
    /// From the clamped end to the free end; empty in a solid part.
    pub(in crate::app::plots) bore: Vec<Point>,
}

impl Lines {
    /// The points of a set-up's part, no chord further than `tolerance` mm from its arc.
    pub(in crate::app::plots) fn of(derived: &SetupDerived, tolerance: f64) -> Self {
        let bore = derived.bore.as_ref().as_ref().map(|bore| bore.contour.polyline(tolerance));
        Self { outside: derived.contour.contour.polyline(tolerance), bore: bore.unwrap_or_default() }
    }

    /// The edge of the section above the axis; see [`outline`].
    pub(in crate::app::plots) fn outline(&self) -> Vec<Point> {
        outline(&self.outside, &self.bore)
    }
}

/// The edge of the section above the axis, the material on its right hand: along the outside and back along the bore. It
/// begins and ends on the axis, or where it began in a part with a hole from end to end.
fn outline(outside: &[Point], bore: &[Point]) -> Vec<Point> {
    let (Some(&first), Some(&last)) = (outside.first(), outside.last()) else { return Vec::new() };
    let open = |end: Option<&Point>, z: f64| end.is_some_and(|p| (p.z - z).abs() <= SAME_MM && p.r > SAME_MM);
    let (open_behind, open_in_front) = (open(bore.first(), first.z), open(bore.last(), last.z));
    let back = || bore.iter().rev().copied();
    let foot = |p: Point| Point::new(p.z, 0.0);
    let mut line = Vec::with_capacity(outside.len() + bore.len() + 2);
    match (open_behind, open_in_front) {
        (true, false) => line.extend(back()),
        (true, true) => line.extend(bore.first()),
        (false, _) => line.push(foot(first)),
    }
    line.extend(outside);
    if open_in_front {
        line.extend(back());
    } else {
        line.push(foot(last));
    }
    line
}

/// The line with both ends led down to the spindle axis.
pub(in crate::app::plots) fn with_ends_on_axis(line: &[Point]) -> Vec<Point> {
    outline(line, &[])
}

/// Draws something that holds the work, both halves of it.
pub(in crate::app::plots) fn body(painter: &Painter, screen: &Screen, outline: &Contour, palette: &Palette) {
    let mut ring = outline.polyline(STOCK_CHORDS_MM);
    ring.pop();
    let region = Triangles::of(std::slice::from_ref(&ring));
    region.fill(painter, screen, palette.steel);
    region.fill_mirrored(painter, screen, palette.steel);
    let stroke = Stroke::new(1.0, palette.steel_edge);
    let above = from_axis_to_axis(&ring);
    painter.add(Shape::line(on_screen(screen, &above), stroke));
    let below: Vec<Point> = above.into_iter().map(mirrored).collect();
    painter.add(Shape::line(on_screen(screen, &below), stroke));
}

fn threads(painter: &Painter, screen: &Screen, setup: &Setup, palette: &Palette, full_section: bool) {
    for thread in setup.threads.iter().chain(&setup.bore_threads) {
        let root = [Point::new(thread.z1, thread.base_radius), Point::new(thread.z2, thread.base_radius)];
        painter.line_segment(root.map(|p| screen.pos(p)), Stroke::new(1.0, palette.edge));
        let outside = thread.base_radius < thread.crest_radius;
        if full_section && outside {
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
