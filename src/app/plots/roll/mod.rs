//! The plot of one roll: its half section with the designed contour behind, and what is chosen on it.
//!
//! It takes data in and gives [`RollPlotEvent`]s out; it never edits the document.

use super::canvas::{self, CanvasView, Screen};
use super::lines::{CENTRE_LINE, DASHED, dashed, distance_to_polyline, thinned};
use super::palette::Palette;
use super::profile::draw::{EDGE, LIT};
use super::regions::Triangles;
use crate::document::ElementName;
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::rollform::roll::RollElement;
use egui::{Painter, Pos2, Shape, Stroke, Ui, pos2};

/// A click this near to an element means it, points.
const NEAR: f32 = 9.0;
/// Room around the contour in a fitted view, as a share of its width.
const ROOM: f64 = 0.03;
/// Radius of a corner's mark, points.
const CORNER: f32 = 4.0;

/// What the plot of a roll shows.
pub struct RollScene<'a> {
    /// The elements with their edits.
    pub elements: &'a [RollElement],
    /// The elements as designed.
    pub designed: &'a [RollElement],
    /// The elements as they would be with the edit that is being prepared.
    pub preview: Option<&'a [RollElement]>,
    /// The element that is chosen; the corner behind it is marked.
    pub chosen: Option<ElementName>,
    /// Colours.
    pub palette: &'a Palette,
}

/// What a person does in the plot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RollPlotEvent {
    /// An element was clicked, by its index.
    Clicked(usize),
    /// A place was clicked.
    At(Point),
    /// Where the pointer is: along the roll and radius, mm.
    Pointer(Point),
}

/// Shows the plot in the room that is left in `ui`.
pub fn roll_plot(ui: &mut Ui, view: &mut CanvasView, scene: &RollScene<'_>) -> Vec<RollPlotEvent> {
    let size = ui.available_size();
    let canvas = canvas::canvas(ui, view, size, bounds(scene.elements), "Roll contour", false);
    let painter = ui.painter_at(canvas.response.rect);
    draw(&painter, &canvas.screen, scene);
    canvas::overlay(ui, view, &canvas, scene.palette);
    let mut events: Vec<RollPlotEvent> = canvas.pointer.map(RollPlotEvent::Pointer).into_iter().collect();
    if let Some(pos) = canvas.response.interact_pointer_pos().filter(|_| canvas.response.clicked()) {
        // The element first: a place that was asked for is taken last, so that it chooses no element besides.
        events.extend(nearest(&canvas.screen, scene.elements, pos).map(RollPlotEvent::Clicked));
        events.push(RollPlotEvent::At(canvas.screen.point(pos)));
    }
    events
}

/// What a fitted view shows: the contour without its side faces.
fn bounds(elements: &[RollElement]) -> Bounds {
    let inner = elements.get(1..elements.len().saturating_sub(1)).unwrap_or_default();
    let all = inner.iter().map(|e| e.segment.bounds()).reduce(Bounds::union);
    let all = all.unwrap_or(Bounds { min: Point::new(0.0, 0.0), max: Point::new(1.0, 1.0) });
    let room = ROOM * (all.max.z - all.min.z);
    Bounds { min: Point::new(all.min.z - room, all.min.r - room), max: Point::new(all.max.z + room, all.max.r + room) }
}

fn draw(painter: &Painter, screen: &Screen, scene: &RollScene<'_>) {
    let palette = scene.palette;
    let ring: Vec<Point> = crate::rollform::roll::contour(scene.elements).polyline(screen.tolerance());
    Triangles::of(&[ring]).fill(painter, screen, palette.part);
    if scene.designed != scene.elements {
        let points = on_screen(screen, scene.designed.iter().map(|e| e.segment));
        dashed(painter, &points, DASHED, Stroke::new(1.0, palette.construction));
    }
    let points = on_screen(screen, scene.elements.iter().map(|e| e.segment));
    painter.add(Shape::line(points, Stroke::new(EDGE, palette.edge)));
    for element in scene.elements {
        if element.names.iter().any(|n| matches!(n, ElementName::Edit { .. })) {
            let points = on_screen(screen, std::iter::once(element.segment));
            painter.add(Shape::line(points, Stroke::new(EDGE, palette.unreachable)));
        }
    }
    let axis = screen.pos(Point::default()).y;
    let ends = [pos2(screen.rect.left(), axis), pos2(screen.rect.right(), axis)];
    dashed(painter, &ends, CENTRE_LINE, Stroke::new(1.0, palette.construction));
    if let Some(preview) = scene.preview {
        let is_new = |name: &ElementName| {
            matches!(name, ElementName::Edit { .. }) && !scene.elements.iter().any(|e| e.has(*name))
        };
        let new = preview.iter().filter(|e| e.names.iter().any(is_new));
        for element in new {
            let points = on_screen(screen, std::iter::once(element.segment));
            dashed(painter, &points, DASHED, Stroke::new(LIT, palette.accent));
        }
    }
    let chosen = scene.chosen.and_then(|name| scene.elements.iter().rfind(|e| e.has(name)));
    if let Some(element) = chosen {
        let points = on_screen(screen, std::iter::once(element.segment));
        painter.add(Shape::line(points, Stroke::new(LIT, palette.accent)));
        painter.circle(screen.pos(element.segment.end()), CORNER, palette.ground, Stroke::new(1.5, palette.accent));
    }
}

fn on_screen(screen: &Screen, segments: impl Iterator<Item = Segment>) -> Vec<Pos2> {
    let points = Contour::new(segments.collect()).polyline(screen.tolerance());
    thinned(points.into_iter().map(|p| screen.pos(p)))
}

/// The element under the pointer.
fn nearest(screen: &Screen, elements: &[RollElement], pos: Pos2) -> Option<usize> {
    let distances = elements.iter().enumerate().map(|(index, element)| {
        (index, distance_to_polyline(pos, &on_screen(screen, std::iter::once(element.segment))))
    });
    distances.filter(|(_, d)| *d <= NEAR).min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
}
