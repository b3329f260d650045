//! A leg of the strip turned about the bend that holds it.

use super::{FlowerEvent, FlowerScene};
use crate::app::plots::coordinates::snapped;
use crate::app::plots::profile::Phase;
use crate::geometry::Point;
use crate::rollform::strip::{PieceKind, Strip};

/// Step of an angle that is dragged, degrees; with Alt it is free.
const STEP_DEG: f64 = 0.5;
/// A line is level if it deviates less than this, radians.
const LEVEL_RAD: f64 = 0.01;

/// A drag that is under way.
#[derive(Debug, Clone)]
pub(super) struct Drag {
    element: u32,
    pivot: Point,
    grip: Point,
    /// 1 if the leg turns counter-clockwise as its bend turns upwards, else −1.
    sense: f64,
    from_deg: f64,
    last: Option<f64>,
}

/// The piece of a strip that lies nearest to a point, within `reach` mm.
pub(super) fn piece_at(strip: &Strip, point: Point, reach: f64) -> Option<usize> {
    let reach = reach.max(strip.thickness);
    let distances = strip.pieces.iter().map(|piece| piece.mean.distance_to(point));
    let nearest = distances.enumerate().min_by(|(_, a), (_, b)| a.total_cmp(b))?;
    (nearest.1 <= reach).then_some(nearest.0)
}

impl Drag {
    /// Takes hold of a piece at a point; `None` if no bend holds it.
    pub(super) fn begin(scene: &FlowerScene<'_>, piece: usize, grip: Point) -> Option<Self> {
        let strip = scene.shown;
        let base = base(strip);
        let right = piece >= base;
        let is_bend = |index: &usize| strip.pieces.get(*index).is_some_and(|p| p.kind != PieceKind::Line);
        let bend = if right { (base..=piece).rev().find(is_bend)? } else { (piece..base).find(is_bend)? };
        let held = strip.pieces.get(bend)?;
        let pivot = if right { held.mean.start() } else { held.mean.end() };
        let from_deg = (scene.angle_of)(held.element)?;
        let sense = if right { 1.0 } else { -1.0 };
        (grip.distance(pivot) > strip.thickness).then_some(Self {
            element: held.element,
            pivot,
            grip,
            sense,
            from_deg,
            last: None,
        })
    }

    /// The event of the pointer being at a point.
    pub(super) fn to(&mut self, point: Point, free: bool) -> Option<FlowerEvent> {
        let (from, to) = (self.grip - self.pivot, point - self.pivot);
        let turn = from.perp(&to).atan2(from.dot(&to)).to_degrees() * self.sense;
        let angle_deg = snapped(self.from_deg + turn, (!free).then_some(STEP_DEG));
        let phase = if self.last.is_some() { Phase::Move } else { Phase::Begin };
        if self.last.is_none() && (angle_deg - self.from_deg).abs() < f64::EPSILON {
            return None;
        }
        self.last = Some(angle_deg);
        Some(FlowerEvent::Bend { element: self.element, angle_deg, phase })
    }

    /// The event of the drag being over.
    pub(super) fn end(&self) -> Option<FlowerEvent> {
        Some(FlowerEvent::Bend { element: self.element, angle_deg: self.last?, phase: Phase::End })
    }
}

/// Index of the piece that stays where it is: the first right of the origin, or the longest level line if the origin is at
/// an edge.
fn base(strip: &Strip) -> usize {
    if strip.left_of_origin > 0 && strip.left_of_origin < strip.pieces.len() {
        return strip.left_of_origin;
    }
    let level =
        strip.pieces.iter().enumerate().filter(|(_, p)| p.kind == PieceKind::Line && p.heading_rad.abs() < LEVEL_RAD);
    level.max_by(|(_, a), (_, b)| a.mean.length().total_cmp(&b.mean.length())).map_or(strip.left_of_origin, |(i, _)| i)
}
