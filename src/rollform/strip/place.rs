//! Placing the chain of pieces: by its origin, or by its base.

use super::chain::{Chain, Link, chain};
use super::{Piece, PieceKind, Side, Strip, along, normal};
use crate::document::{Origin, RollSet};
use crate::geometry::{Point, Segment};
use crate::rollform::bends::{BendState, Stage, bend_states};
use std::collections::BTreeMap;

/// A line of the finished section that deviates less than this from the horizontal can be its base, radians: half a degree.
const LEVEL_RAD: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// An arc of a face with a smaller radius than this is a corner, mm.
const CORNER_MM: f64 = 1e-9;

/// Where a chain is held: at the left end of the link with this index.
struct Hold {
    index: usize,
    point: Point,
    heading_rad: f64,
}

/// The strip of a set with these bends.
pub(super) fn placed(set: &RollSet, bends: &BTreeMap<u32, BendState>) -> Strip {
    let thickness = set.section.thickness;
    let chain = chain(set, bends);
    let hold = base(set).and_then(|base| base.hold(&chain)).unwrap_or_else(|| by_origin(&chain, thickness));
    Strip { thickness, pieces: pieces(&chain, &hold, thickness), left_of_origin: chain.left_of_origin }
}

fn by_origin(chain: &Chain, thickness: f64) -> Hold {
    let point = Point::new(0.0, thickness / 2.0);
    Hold { index: chain.left_of_origin, point, heading_rad: chain.origin_heading_rad }
}

/// The line that holds a strip with its origin at an edge.
struct Base {
    element: u32,
    side: Side,
    /// Middle of its mean line.
    middle: Point,
    heading_rad: f64,
}

impl Base {
    fn hold(&self, chain: &Chain) -> Option<Hold> {
        let index = chain.links.iter().position(|l| l.element == self.element && l.side == self.side)?;
        let half = chain.links.get(index)?.length / 2.0;
        Some(Hold { index, point: self.middle - along(self.heading_rad) * half, heading_rad: self.heading_rad })
    }
}

/// The longest horizontal line of a finished section with its origin at an edge.
fn base(set: &RollSet) -> Option<Base> {
    let thickness = set.section.thickness;
    if !matches!(set.section.origin, Origin::LeftToRight | Origin::RightToLeft) {
        return None;
    }
    let finished = chain(set, &bend_states(set, Stage::Finished));
    let all = pieces(&finished, &by_origin(&finished, thickness), thickness);
    let level = all.iter().filter(|p| p.kind == PieceKind::Line && p.heading_rad.abs() <= LEVEL_RAD);
    // Of equal lines the first one counts.
    let longest = level.fold(None, |best: Option<&Piece>, piece| match best {
        Some(best) if piece.mean.length() <= best.mean.length() => Some(best),
        _ => Some(piece),
    })?;
    let middle = Point::new(longest.mean.point_at(0.5).z, thickness / 2.0);
    Some(Base { element: longest.element, side: longest.side, middle, heading_rad: longest.heading_rad })
}

/// The pieces of a chain from left to right.
fn pieces(chain: &Chain, hold: &Hold, thickness: f64) -> Vec<Piece> {
    let (left, right) = chain.links.split_at(hold.index.min(chain.links.len()));
    let mut all = Vec::with_capacity(chain.links.len());
    let (mut point, mut heading) = (hold.point, hold.heading_rad);
    for link in left.iter().rev() {
        heading -= link.angle_rad;
        let start = point - step(link, heading, thickness);
        all.push(piece(link, start, point, heading, thickness));
        point = start;
    }
    all.reverse();
    (point, heading) = (hold.point, hold.heading_rad);
    for link in right {
        let end = point + step(link, heading, thickness);
        all.push(piece(link, point, end, heading, thickness));
        (point, heading) = (end, heading + link.angle_rad);
    }
    all
}

/// From the left to the right end of a link on the mean line.
fn step(link: &Link, heading: f64, thickness: f64) -> crate::geometry::Vector {
    if link.kind != PieceKind::Arc {
        return along(heading) * link.length;
    }
    let to_center = link.angle_rad.signum() * (link.inside_radius + thickness / 2.0);
    (normal(heading) - normal(heading + link.angle_rad)) * to_center
}

fn piece(link: &Link, start: Point, end: Point, heading_rad: f64, thickness: f64) -> Piece {
    let end_heading = heading_rad + link.angle_rad;
    let turn = link.angle_rad.signum();
    let mean_radius = link.inside_radius + thickness / 2.0;
    let center = start + normal(heading_rad) * (turn * mean_radius);
    // At a height above the mean line.
    let face = |height: f64| {
        let (from, to) = (start + normal(heading_rad) * height, end + normal(end_heading) * height);
        if link.kind == PieceKind::Arc && mean_radius - turn * height > CORNER_MM {
            Segment::Arc { start: from, end: to, center, ccw: turn > 0.0 }
        } else {
            Segment::line(from, to)
        }
    };
    Piece {
        element: link.element,
        side: link.side,
        kind: link.kind,
        inside_radius: link.inside_radius,
        angle_rad: link.angle_rad,
        heading_rad,
        mean: face(0.0),
        bottom: face(-thickness / 2.0),
        top: face(thickness / 2.0),
    }
}
