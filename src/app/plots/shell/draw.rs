//! Former, shell, blank, what holds them, and the roller.

use super::{ShellPlot, ShellScene};
use crate::app::plots::canvas::Screen;
use crate::app::plots::lines::{DASHED, dashed, faded};
use crate::app::plots::profile::draw::{EDGE, centre_line, chuck, on_screen};
use crate::app::plots::regions::{Triangles, mirrored};
use crate::geometry::{Point, Vector};
use crate::regen::ShellDerived;
use crate::spinning::roller;
use crate::spinning::{Roller, ShellShape};
use egui::{Color32, Painter, Shape, Stroke};
use std::sync::Arc;

/// Chords of outlines stay within this, mm.
const CHORD_MM: f64 = 0.01;

/// The regions of one shell ready to be drawn.
#[derive(Debug, Default)]
pub(super) struct Regions {
    made_for: Option<Arc<ShellShape>>,
    former: Triangles,
    former_edge: Vec<Point>,
    shell: Triangles,
    shell_edge: Vec<Point>,
}

impl Regions {
    pub(super) fn update(&mut self, made: &ShellDerived) {
        if self.made_for.as_ref().is_some_and(|shape| Arc::ptr_eq(shape, &made.shape)) {
            return;
        }
        let counter_clockwise = |mut outline: Vec<Point>| {
            if area(&outline) < 0.0 {
                outline.reverse();
            }
            outline
        };
        self.former_edge = counter_clockwise(made.shape.former_outline(CHORD_MM));
        self.shell_edge = counter_clockwise(made.shape.shell_outline(CHORD_MM));
        self.former = Triangles::of(std::slice::from_ref(&self.former_edge));
        self.shell = Triangles::of(std::slice::from_ref(&self.shell_edge));
        self.made_for = Some(Arc::clone(&made.shape));
    }
}

fn area(outline: &[Point]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a.z * b.r - b.z * a.r).sum::<f64>() / 2.0
}

/// Draws everything that cannot be taken hold of.
pub(super) fn scenery(painter: &Painter, screen: &Screen, view: &ShellPlot, scene: &ShellScene<'_>) {
    let (palette, shape) = (scene.palette, &scene.made.shape);
    let both = !view.half;
    if let Some(machine) = scene.machine {
        chuck(painter, screen, 0.0, &machine.chuck, palette);
    }
    let steel = Stroke::new(1.0, palette.steel_edge);
    fill(painter, screen, &view.regions.former, palette.steel, both);
    edge(painter, screen, &view.regions.former_edge, steel, both);
    holders(painter, screen, scene, both);
    blank(painter, screen, scene, both);
    fill(painter, screen, &view.regions.shell, palette.part, both);
    edge(painter, screen, &view.regions.shell_edge, Stroke::new(EDGE, palette.edge), false);
    if both {
        let below: Vec<Point> = view.regions.shell_edge.iter().copied().map(mirrored).collect();
        closed(painter, screen, &below, Stroke::new(1.0, palette.edge_mirror));
    }
    if !view.without_path {
        path(painter, screen, scene);
    }
    let centre = scene.roller.or_else(|| scene.made.path.last().map(|p| p.approach));
    if let Some(centre) = centre.filter(|_| shape.blank_radius > 0.0) {
        draw_roller(painter, screen, scene, centre);
    }
    centre_line(painter, screen, palette);
}

fn fill(painter: &Painter, screen: &Screen, region: &Triangles, color: Color32, both: bool) {
    region.fill(painter, screen, color);
    if both {
        region.fill_mirrored(painter, screen, faded(color, 0.5));
    }
}

fn edge(painter: &Painter, screen: &Screen, outline: &[Point], stroke: Stroke, both: bool) {
    closed(painter, screen, outline, stroke);
    if both {
        let below: Vec<Point> = outline.iter().copied().map(mirrored).collect();
        closed(painter, screen, &below, Stroke::new(stroke.width, faded(stroke.color, 0.6)));
    }
}

fn closed(painter: &Painter, screen: &Screen, outline: &[Point], stroke: Stroke) {
    painter.add(Shape::closed_line(on_screen(screen, outline), stroke));
}

/// Follower and tailstock.
fn holders(painter: &Painter, screen: &Screen, scene: &ShellScene<'_>, both: bool) {
    let (shape, blank) = (&scene.made.shape, &scene.made.shell.blank);
    let face = shape.tip().z + shape.thickness;
    let behind = face + blank.follower_length;
    let r = blank.follower_diameter / 2.0;
    let low = if both { -r } else { 0.0 };
    let block = [(face, low), (behind, low), (behind, r), (face, r)].map(|(z, r)| Point::new(z, r));
    let stroke = Stroke::new(1.0, scene.palette.steel_edge);
    painter.add(Shape::convex_polygon(on_screen(screen, &block), scene.palette.steel, stroke));
    if let Some(tailstock) = scene.machine.and_then(|m| m.tailstock.as_ref()) {
        let outline: Vec<Point> = tailstock.outline.iter().map(|[z, r]| Point::new(z + behind, *r)).collect();
        fill(painter, screen, &Triangles::of(std::slice::from_ref(&outline)), scene.palette.steel, both);
        edge(painter, screen, &outline, stroke, both);
    }
}

/// The flat disc before it is formed.
fn blank(painter: &Painter, screen: &Screen, scene: &ShellScene<'_>, both: bool) {
    let shape = &scene.made.shape;
    let (z1, z2, r) = (shape.tip().z, shape.tip().z + shape.thickness, shape.blank_radius);
    let low = if both { -r } else { 0.0 };
    let disc = [(z1, low), (z2, low), (z2, r), (z1, r), (z1, low)].map(|(z, r)| Point::new(z, r));
    painter.add(Shape::convex_polygon(
        on_screen(screen, disc.get(..4).unwrap_or_default()),
        faded(scene.palette.stock, 0.55),
        Stroke::NONE,
    ));
    dashed(painter, &on_screen(screen, &disc), DASHED, Stroke::new(1.0, scene.palette.stock_edge));
}

/// Passes of the nose's centre: the last in the accent colour, the ones before it quiet, free travel dashed.
fn path(painter: &Painter, screen: &Screen, scene: &ShellScene<'_>) {
    let palette = scene.palette;
    let count = scene.made.path.passes.len();
    for (index, pass) in scene.made.path.passes.iter().enumerate() {
        let color = if index + 1 == count { palette.accent } else { palette.construction };
        let line = pass.contour.polyline(screen.tolerance());
        let (Some(start), Some(end)) = (line.first().copied(), line.last().copied()) else { continue };
        painter.add(Shape::line(on_screen(screen, &line), Stroke::new(1.4, color)));
        let travel = Stroke::new(1.0, faded(color, 0.7));
        dashed(painter, &on_screen(screen, &[pass.approach, start]), DASHED, travel);
        dashed(painter, &on_screen(screen, &[end, pass.retreat]), DASHED, travel);
    }
}

fn draw_roller(painter: &Painter, screen: &Screen, scene: &ShellScene<'_>, centre: Point) {
    let palette = scene.palette;
    let shape: &Roller = &scene.made.shell.roller;
    let by: Vector = centre - Point::default();
    let body: Vec<Point> = roller::body(shape).into_iter().map(|p| p + by).collect();
    let stroke = Stroke::new(1.0, palette.steel_edge);
    let color = faded(palette.insert, 0.85);
    painter.add(Shape::convex_polygon(on_screen(screen, &body), color, stroke));
    #[allow(clippy::cast_possible_truncation, reason = "sizes on the screen are f32 in egui")]
    let radius = (shape.nose_radius * screen.scale()) as f32;
    painter.circle(screen.pos(centre), radius, palette.insert, stroke);
    painter.circle_filled(screen.pos(centre), 2.0, palette.text);
}
