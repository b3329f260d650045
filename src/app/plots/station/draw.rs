//! What the station plot draws, and what lies under the pointer.

use super::clearance::Opening;
use super::{StationEvent, StationScene, lift};
use crate::app::plots::canvas::Screen;
use crate::app::plots::coordinates::fixed;
use crate::app::plots::lines::{CENTRE_LINE, dashed, distance_to_polyline, thinned};
use crate::app::plots::profile::draw::{EDGE, LIT};
use crate::app::plots::regions::Triangles;
use crate::document::RollKind;
use crate::geometry::{Contour, Point, Segment};
use crate::rollform::Roll;
use egui::{Align2, FontId, Painter, Pos2, Shape, Stroke};

/// A click this near to a piece of the strip means it, points.
const NEAR: f32 = 7.0;
/// Width of the line that tells the opening, points.
const OPENING: f32 = 3.0;
/// Least distance between two places whose opening is measured, points on the screen.
const STEP: f64 = 3.0;
/// Size of the names of rolls, points.
const TEXT: f32 = 11.0;

/// One frame of the plot.
pub(super) struct Drawn<'a> {
    pub(super) scene: &'a StationScene<'a>,
    pub(super) screen: &'a Screen,
    pub(super) clearance: bool,
}

impl Drawn<'_> {
    /// Draws everything.
    pub(super) fn all(&self, painter: &Painter) {
        for roll in &self.scene.station.rolls {
            self.roll(painter, roll);
        }
        self.strip(painter);
        if self.clearance {
            for roll in &self.scene.station.rolls {
                self.opening(painter, roll);
            }
        }
        for roll in &self.scene.station.rolls {
            self.name(painter, roll);
        }
        self.middle(painter);
    }

    /// A roll in strip space as it is drawn.
    fn raised(&self, roll: &Roll, segment: &Segment) -> Segment {
        let lift = lift(roll.roll.kind, self.scene.drawn_gap_mm);
        segment.translated(Point::new(0.0, lift) - Point::default())
    }

    fn roll(&self, painter: &Painter, roll: &Roll) {
        let palette = self.scene.palette;
        let outline = roll.outline();
        let ring: Contour = Contour::new(outline.segments.iter().map(|s| self.raised(roll, s)).collect());
        let mut points = ring.polyline(self.screen.tolerance());
        points.pop();
        let shown = self.scene.roll == Some(roll.roll);
        let fill = if shown { palette.part } else { palette.part_mirror };
        Triangles::of(&[points]).fill(painter, self.screen, fill);
        let lines = roll.elements.iter().map(|e| self.raised(roll, &roll.frame.to_strip(&e.segment)));
        let width = if shown { EDGE } else { EDGE * 0.7 };
        self.line(painter, lines, Stroke::new(width, palette.edge));
    }

    fn strip(&self, painter: &Painter) {
        let (palette, strip) = (self.scene.palette, &self.scene.station.strip);
        let mut ring = strip.outline().polyline(self.screen.tolerance());
        ring.pop();
        Triangles::of(&[ring]).fill(painter, self.screen, palette.wrong);
        self.line(painter, strip.outline().segments.into_iter(), Stroke::new(1.0, palette.wrong));
        let selected = strip.pieces.iter().filter(|piece| Some(piece.element) == self.scene.element);
        for piece in selected {
            let faces = [piece.bottom, piece.top];
            for face in faces {
                self.line(painter, std::iter::once(face), Stroke::new(LIT, palette.accent));
            }
        }
    }

    /// Colours a roll by its opening to the strip.
    fn opening(&self, painter: &Painter, roll: &Roll) {
        let station = self.scene.station;
        let outline = station.strip.outline();
        for element in &roll.elements {
            let segment = roll.frame.to_strip(&element.segment);
            let steps = (segment.length() * self.screen.scale() / STEP).ceil().clamp(1.0, 400.0);
            let color =
                |t: f64| Opening::at(segment.point_at(t), &outline, station.strip.thickness).color(self.scene.palette);
            let lifted = self.raised(roll, &segment);
            let mut at = 0.0;
            while at < steps {
                let ends = [at / steps, (at + 1.0) / steps].map(|t| self.screen.pos(lifted.point_at(t)));
                if let Some(color) = color((at + 0.5) / steps) {
                    painter.line_segment(ends, Stroke::new(OPENING, color));
                }
                at += 1.0;
            }
        }
    }

    fn name(&self, painter: &Painter, roll: &Roll) {
        let palette = self.scene.palette;
        let lines = roll.elements.iter().map(|e| self.raised(roll, &roll.frame.to_strip(&e.segment)));
        let Some(bounds) = lines.map(|s| s.bounds()).reduce(crate::geometry::Bounds::union) else { return };
        let widest = roll.elements.iter().map(|e| e.segment.bounds().max.r).fold(0.0, f64::max);
        let unit = self.scene.unit;
        let told = fixed(2.0 * widest / unit.in_mm(), unit.decimals());
        let short = roll.name.rsplit('-').next().unwrap_or(&roll.name);
        let text = format!("{} {short} · ⌀ {told} {}", roll.roll.kind.name(), unit.symbol());
        let rect = self.screen.rect.shrink(8.0);
        let (low, high) = (self.screen.pos(bounds.min), self.screen.pos(bounds.max));
        let middle = Pos2::new(f32::midpoint(low.x, high.x), f32::midpoint(low.y, high.y));
        let (at, align) = match roll.roll.kind {
            RollKind::Top => (Pos2::new(rect.left(), rect.top()), Align2::LEFT_TOP),
            RollKind::Bottom => (Pos2::new(rect.left(), rect.bottom()), Align2::LEFT_BOTTOM),
            RollKind::Left => (Pos2::new(rect.left(), middle.y.clamp(rect.top(), rect.bottom())), Align2::LEFT_CENTER),
            RollKind::Right => {
                (Pos2::new(rect.right(), middle.y.clamp(rect.top(), rect.bottom())), Align2::RIGHT_CENTER)
            }
        };
        let color = if self.scene.roll == Some(roll.roll) { palette.text } else { palette.quiet };
        let galley = painter.layout_no_wrap(text, FontId::proportional(TEXT), color);
        let place = align.anchor_size(at, galley.size());
        painter.rect_filled(place.expand2(egui::vec2(5.0, 2.0)), 4.0, palette.ground.gamma_multiply(0.8));
        painter.galley(place.min, galley, color);
    }

    /// The middle of the section.
    fn middle(&self, painter: &Painter) {
        let rect = self.screen.rect;
        let x = self.screen.pos(self.scene.station.strip.origin()).x;
        let ends = [Pos2::new(x, rect.top()), Pos2::new(x, rect.bottom())];
        dashed(painter, &ends, CENTRE_LINE, Stroke::new(1.0, self.scene.palette.construction));
    }

    fn line(&self, painter: &Painter, segments: impl Iterator<Item = Segment>, stroke: Stroke) {
        let points = segments.flat_map(|s| self.on_screen(&s));
        painter.add(Shape::line(thinned(points), stroke));
    }

    fn on_screen(&self, segment: &Segment) -> Vec<Pos2> {
        Contour::new(vec![*segment]).polyline(self.screen.tolerance()).into_iter().map(|p| self.screen.pos(p)).collect()
    }

    /// What was clicked.
    pub(super) fn at(&self, pos: Pos2) -> Option<StationEvent> {
        let station = self.scene.station;
        let near = station.strip.pieces.iter().map(|piece| {
            let distance = distance_to_polyline(pos, &self.on_screen(&piece.mean));
            (distance, piece.element)
        });
        let nearest = near.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(distance, _)| *distance <= NEAR);
        if let Some((_, element)) = nearest {
            return Some(StationEvent::SelectElement(element));
        }
        let p = self.screen.point(pos);
        let hit = station.rolls.iter().find(|roll| {
            let segments = roll.outline().segments.iter().map(|s| self.raised(roll, s)).collect();
            Contour::new(segments).locate(p, 1e-6) == crate::geometry::Location::Inside
        });
        hit.map(|roll| StationEvent::SelectRoll(roll.roll))
    }
}
