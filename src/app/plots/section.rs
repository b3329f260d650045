//! The finished cross-section: the strip in its thickness with the numbers of its elements.
//!
//! It takes data in and gives [`SectionEvent`]s out; it never edits the document.

use super::canvas::{self, CanvasView, Screen};
use super::lines::{CENTRE_LINE, dashed, distance_to_polyline, faded, thinned};
use super::palette::Palette;
use super::profile::draw::LIT;
use super::regions::Triangles;
use super::tip::tip;
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::rollform::strip::{Piece, Strip};
use egui::{Align2, FontId, Painter, Pos2, Rect, Shape, Stroke, Ui, pos2, vec2};

/// A click this near to a piece of the strip means it, points.
const NEAR: f32 = 8.0;
/// Room around the section in a fitted view, as a share of its size.
const ROOM: f64 = 0.12;
/// Size of the numbers, points.
const TEXT: f32 = 11.0;
/// Distance of a number from the middle of the strip, points.
const ASIDE: f32 = 13.0;

/// What the plot shows.
pub struct SectionScene<'a> {
    /// The finished strip, mm.
    pub strip: &'a Strip,
    /// Element that is selected.
    pub selected: Option<u32>,
    /// The number of an element as the table has it.
    pub number_of: &'a dyn Fn(u32) -> String,
    /// What an element is, in lines.
    pub told: &'a dyn Fn(u32) -> Vec<String>,
    /// Colours.
    pub palette: &'a Palette,
}

/// What a person does in the plot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SectionEvent {
    /// An element was clicked.
    Select(u32),
    /// Where the pointer is: across the line and height, mm.
    Pointer(Point),
}

/// Shows the plot in the room that is left in `ui`.
pub fn section_plot(ui: &mut Ui, view: &mut CanvasView, scene: &SectionScene<'_>) -> Vec<SectionEvent> {
    let size = ui.available_size().max(vec2(40.0, 40.0));
    let canvas = canvas::canvas(ui, view, size, bounds(scene.strip), "Cross-section", false);
    let painter = ui.painter_at(canvas.response.rect);
    draw(&painter, &canvas.screen, scene);
    canvas::overlay(ui, view, &canvas, scene.palette);
    let mut events: Vec<SectionEvent> = canvas.pointer.map(SectionEvent::Pointer).into_iter().collect();
    let under = canvas.response.hover_pos().and_then(|pos| Some((pos, nearest(&canvas.screen, scene.strip, pos)?)));
    if let Some((pos, element)) = under {
        if canvas.response.clicked() {
            events.push(SectionEvent::Select(element));
        }
        tip(&painter, scene.palette, pos, &(scene.told)(element), &[]);
    }
    events
}

fn bounds(strip: &Strip) -> Bounds {
    let all = strip.outline().bounds().filter(|b| b.min.is_finite() && b.max.is_finite());
    let all = all.unwrap_or(Bounds { min: Point::new(-1.0, -1.0), max: Point::new(1.0, 1.0) });
    let room = ROOM * (all.max.z - all.min.z).max(all.max.r - all.min.r);
    Bounds { min: Point::new(all.min.z - room, all.min.r - room), max: Point::new(all.max.z + room, all.max.r + room) }
}

fn draw(painter: &Painter, screen: &Screen, scene: &SectionScene<'_>) {
    let (palette, strip) = (scene.palette, scene.strip);
    let x = screen.pos(strip.origin()).x;
    let ends = [pos2(x, screen.rect.top() + 6.0), pos2(x, screen.rect.bottom() - 6.0)];
    dashed(painter, &ends, CENTRE_LINE, Stroke::new(1.0, palette.construction));
    let outline = strip.outline();
    let mut ring = outline.polyline(screen.tolerance());
    ring.pop();
    Triangles::of(&[ring]).fill(painter, screen, faded(palette.wrong, 0.35));
    painter.add(Shape::line(on_screen(screen, outline.segments.iter().copied()), Stroke::new(1.2, palette.wrong)));
    for piece in strip.pieces.iter().filter(|piece| Some(piece.element) == scene.selected) {
        for face in [piece.bottom, piece.top] {
            painter.add(Shape::line(on_screen(screen, std::iter::once(face)), Stroke::new(LIT, palette.accent)));
        }
    }
    numbers(painter, screen, scene);
}

/// The numbers of the elements beside the strip, each where there is room for it; that of the selected one in any case.
fn numbers(painter: &Painter, screen: &Screen, scene: &SectionScene<'_>) {
    let is_selected = |piece: &&Piece| Some(piece.element) == scene.selected;
    let (first, others): (Vec<&Piece>, Vec<&Piece>) = scene.strip.pieces.iter().partition(is_selected);
    // Long pieces before short ones, which stand close.
    let mut others = others;
    others.sort_by(|a, b| b.mean.length().total_cmp(&a.mean.length()));
    let mut taken: Vec<Rect> = Vec::new();
    for piece in first.into_iter().chain(others) {
        let selected = is_selected(&piece);
        let color = if selected { scene.palette.accent } else { scene.palette.text };
        let galley = painter.layout_no_wrap((scene.number_of)(piece.element), FontId::proportional(TEXT), color);
        let middle = screen.pos(piece.mean.point_at(0.5));
        let heading = piece.heading_rad + piece.angle_rad / 2.0;
        #[allow(clippy::cast_possible_truncation, reason = "screen positions are f32 in egui")]
        let aside = vec2(heading.sin() as f32, heading.cos() as f32) * ASIDE;
        let places =
            [aside, -aside].map(|by| Align2::CENTER_CENTER.anchor_size(middle + by, galley.size()).expand(1.0));
        let free = places.into_iter().find(|place| !taken.iter().any(|other| other.intersects(*place)));
        if let Some(place) = free {
            painter.galley(place.shrink(1.0).min, galley, color);
            taken.push(place);
        }
    }
}

fn on_screen(screen: &Screen, segments: impl Iterator<Item = Segment>) -> Vec<Pos2> {
    let points = Contour::new(segments.collect()).polyline(screen.tolerance());
    thinned(points.into_iter().map(|p| screen.pos(p)))
}

/// The element under the pointer.
fn nearest(screen: &Screen, strip: &Strip, pos: Pos2) -> Option<u32> {
    let near = strip
        .pieces
        .iter()
        .map(|piece| (distance_to_polyline(pos, &on_screen(screen, std::iter::once(piece.mean))), piece.element));
    near.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(distance, _)| *distance <= NEAR).map(|(_, element)| element)
}
