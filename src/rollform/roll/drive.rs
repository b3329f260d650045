//! Which pieces of the strip drive it, and where on them the speed of the rolls is reckoned.

use crate::document::{DriveSurface, Origin, Side, Station};
use crate::rollform::strip::{Piece, PieceKind, Strip};
use std::ops::Range;

/// A line within this of the horizontal is level, radians: half a degree.
const LEVEL_RAD: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// Straight pieces whose directions differ by less are one, radians.
const STRAIGHT_ON_RAD: f64 = 1e-9;

/// The part of the drive surface that the speed of the rolls is reckoned at: the one that is widest and most level, that is,
/// reaches furthest across the line. Strip space, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveZone {
    /// Its left end.
    pub from: f64,
    /// Its right end.
    pub to: f64,
}

impl DriveZone {
    /// Its middle.
    #[must_use]
    pub const fn middle(&self) -> f64 {
        f64::midpoint(self.from, self.to)
    }

    fn width(&self) -> f64 {
        self.to - self.from
    }
}

/// The zone of a station; `None` without strip. Straight pieces that go on in one direction count as one.
pub(in crate::rollform) fn drive_zone(strip: &Strip, station: &Station, origin: Origin) -> Option<DriveZone> {
    let driving = strip.pieces.get(drive_run(strip, station, origin))?;
    let goes_on =
        |a: &Piece, b: &Piece| !a.is_bent() && !b.is_bent() && (a.heading_rad - b.heading_rad).abs() <= STRAIGHT_ON_RAD;
    let zones = driving.chunk_by(goes_on).filter_map(|pieces| {
        let (from, to) = (pieces.first()?.bottom.start().z, pieces.last()?.bottom.end().z);
        Some(DriveZone { from: from.min(to), to: from.max(to) })
    });
    zones.max_by(|a, b| a.width().total_cmp(&b.width()))
}

/// The pieces of the drive surface, by index.
pub(super) fn drive_run(strip: &Strip, station: &Station, origin: Origin) -> Range<usize> {
    let right = station.drive_right;
    let left = if origin == Origin::Symmetrical { station.drive_left.or(right) } else { station.drive_left };
    let named = [(left, Side::Left), (right, Side::Right)]
        .into_iter()
        .filter_map(|(surface, side)| run(strip, surface?, side))
        .reduce(|a, b| a.start.min(b.start)..a.end.max(b.end));
    named.unwrap_or_else(|| base(&strip.pieces))
}

/// The pieces from the first to the last element of a drive surface on a side.
fn run(strip: &Strip, surface: DriveSurface, side: Side) -> Option<Range<usize>> {
    let indices = |element: u32| {
        let hits = strip.pieces.iter().enumerate().filter(move |(_, p)| p.element == element && p.side == side);
        hits.map(|(index, _)| index)
    };
    let all = || indices(surface.first).chain(indices(surface.last));
    Some(all().min()?..all().max()?.saturating_add(1))
}

/// The longest level line, or the longest of all if none is level.
fn base(pieces: &[Piece]) -> Range<usize> {
    let longest = |level: bool| {
        let lines = pieces
            .iter()
            .enumerate()
            .filter(move |(_, p)| p.kind == PieceKind::Line && (!level || p.heading_rad.abs() <= LEVEL_RAD));
        lines.max_by(|(_, a), (_, b)| a.mean.length().total_cmp(&b.mean.length())).map(|(index, _)| index)
    };
    let index = longest(true).or_else(|| longest(false)).unwrap_or_default();
    // The halves of a symmetrical base are two pieces.
    let level_line =
        |index: usize| pieces.get(index).is_some_and(|p| p.kind == PieceKind::Line && p.heading_rad.abs() <= LEVEL_RAD);
    let before = index.checked_sub(1).filter(|&i| level_line(i)).unwrap_or(index);
    let after = if level_line(index.saturating_add(1)) { index.saturating_add(1) } else { index };
    before..after.saturating_add(1)
}
