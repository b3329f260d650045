//! Top and bottom roll together, and the side rolls that take over from them.

use super::drive::drive_run;
use super::face::{Face, name_of};
use super::frame::{Frame, mapped};
use super::opening::Openings;
use super::wing::{Start, Wing};
use super::{DesignedRoll, RollElement, ends, merge, reach, side};
use crate::document::{ElementName, ExtensionContour, Origin, RollKind, Side, SideRoll, Station};
use crate::geometry::{Point, Segment};
use crate::rollform::strip::{Piece, Strip};

/// A strip that reaches back by less does not reach over the other side, mm.
const REACHES_OVER_MM: f64 = 1e-9;

/// The rolls of a station for this strip.
pub(super) fn rolls(strip: &Strip, station: &Station, origin: Origin, openings: Openings) -> Vec<DesignedRoll> {
    let run = drive_run(strip, station, origin);
    // Both wings start within the drive surface, at the origin if it drives.
    let split = strip.left_of_origin.clamp(run.start, run.end).min(strip.pieces.len());
    let (before, after) = strip.pieces.split_at(split);
    let start = start(strip, split);
    let right = Wing::new(Side::Right, after.to_vec(), run.end.saturating_sub(split), start, openings);
    let mut wings = [left_wing(before, split.saturating_sub(run.start), start, openings), right];
    let top_axis = station.centre_distance - station.pass_height;
    let sides = finish(&mut wings, station, origin);
    let [left, right] = wings;
    let tops: Vec<RollElement> = left.top.mirrored().into_iter().chain(right.top.elements).collect();
    let bottoms: Vec<RollElement> = left.bottom.mirrored().into_iter().chain(right.bottom.elements).collect();
    let pair = [rolled(&tops, RollKind::Top, top_axis), rolled(&bottoms, RollKind::Bottom, -station.pass_height)];
    pair.into_iter().flatten().chain(sides).collect()
}

/// The left wing, in the mirror.
fn left_wing(before: &[Piece], driven: usize, start: Start, openings: Openings) -> Wing {
    let turned: Vec<Piece> = before.iter().rev().map(mirrored).collect();
    Wing::new(Side::Left, turned, driven, start.mirrored(), openings)
}

/// The strip at the left end of the piece with this index.
fn start(strip: &Strip, index: usize) -> Start {
    let left = |p: &Piece| Start { bottom: p.bottom.start(), top: p.top.start(), heading_rad: p.heading_rad };
    let right = |p: &Piece| Start { bottom: p.bottom.end(), top: p.top.end(), heading_rad: p.end_heading_rad() };
    strip.pieces.get(index).map(left).or_else(|| strip.pieces.last().map(right)).unwrap_or_default()
}

/// The mirror image of a piece, run from left to right again.
fn mirrored(piece: &Piece) -> Piece {
    let turned = |s: Segment| s.mirrored_at_z(0.0).reversed();
    Piece {
        heading_rad: -piece.end_heading_rad(),
        mean: turned(piece.mean),
        bottom: turned(piece.bottom),
        top: turned(piece.top),
        ..*piece
    }
}

/// What a station says about one side.
struct AtSide<'a> {
    tolerance: f64,
    extension: Option<&'a ExtensionContour>,
    roll: Option<&'a SideRoll>,
}

fn at_side(station: &Station, side: Side, origin: Origin) -> AtSide<'_> {
    // A symmetrical section says the right side for both where it says nothing of the left one.
    let symmetrical = origin == Origin::Symmetrical;
    let right = AtSide {
        tolerance: station.tolerance_right,
        extension: station.extension_right.first(),
        roll: station.side_right.as_ref(),
    };
    match side {
        Side::Right => right,
        Side::Left => AtSide {
            tolerance: station.tolerance_left,
            extension: station.extension_left.first().or(if symmetrical { right.extension } else { None }),
            roll: station.side_left.as_ref().or(if symmetrical { right.roll } else { None }),
        },
    }
}

/// Ends the faces of both wings; returns the side rolls.
fn finish(wings: &mut [Wing; 2], station: &Station, origin: Origin) -> Vec<DesignedRoll> {
    for wing in wings.iter_mut() {
        ends::prolong(wing, at_side(station, wing.side, origin).tolerance);
    }
    // A wing that reaches back over the other one is in the way of its rolls too.
    let outlines = wings.each_ref().map(|wing| {
        let outline = wing.outline();
        let reaches_over = outline.iter().any(|e| e.segment.bounds().min.z < wing.start_z() - REACHES_OVER_MM);
        if reaches_over { outline.iter().map(|e| e.mapped(|s| s.mirrored_at_z(0.0))).collect() } else { Vec::new() }
    });
    let [over_right, over_left] = outlines;
    let [left, right] = wings;
    let sides = [finish_wing(left, &over_left, station, origin), finish_wing(right, &over_right, station, origin)];
    sides.into_iter().flatten().collect()
}

/// Ends the faces of a wing, over or under which `foreign` may reach from the other side.
fn finish_wing(wing: &mut Wing, foreign: &[RollElement], station: &Station, origin: Origin) -> Option<DesignedRoll> {
    let at = at_side(station, wing.side, origin);
    let taken = at.roll.and_then(|roll| side::taken(wing, roll).map(|taken| (roll, taken)));
    if wing.overhangs() {
        let outline = [&wing.outline(), foreign].concat();
        overhang(wing, &outline, &outline, taken.as_ref().map(|(_, taken)| taken));
        if taken.is_none() {
            meet(wing);
            ends::extend(wing, at.extension, None);
        }
    } else {
        match &taken {
            Some((_, taken)) => side::give_way(wing, taken, at.tolerance),
            None => ends::close(wing, at.extension),
        }
        if !foreign.is_empty() || turns_back(&wing.top) || turns_back(&wing.bottom) {
            let upper = [wing.top.elements.as_slice(), foreign].concat();
            let lower = [wing.bottom.elements.as_slice(), foreign].concat();
            overhang(wing, &upper, &lower, taken.as_ref().map(|(_, taken)| taken));
        }
    }
    taken.and_then(|(roll, taken)| side::roll(&taken, roll, wing.side))
}

/// True if a face runs inwards somewhere, as a chord at a steep flank may.
fn turns_back(face: &Face) -> bool {
    face.elements.iter().any(|e| {
        let (start, end, bounds) = (e.segment.start().z, e.segment.end().z, e.segment.bounds());
        bounds.min.z < start - REACHES_OVER_MM || bounds.max.z > end + REACHES_OVER_MM
    })
}

/// Both faces become what their rolls can reach of these outlines.
fn overhang(wing: &mut Wing, for_top: &[RollElement], for_bottom: &[RollElement], taken: Option<&side::Taken>) {
    let most =
        |outline: &[RollElement]| outline.iter().map(|e| e.segment.bounds().max.z).fold(wing.start_z(), f64::max);
    let limit = |outline: &[RollElement], z: Option<f64>| z.map_or(most(outline), |z| z.min(most(outline)));
    let upper = reach::upper(for_top, wing.start_z(), limit(for_top, taken.map(|t| t.upper_end().z)));
    let upside_down: Vec<RollElement> = for_bottom.iter().map(turned_over).collect();
    let lower = reach::upper(&upside_down, wing.bottom.start.z, limit(for_bottom, taken.map(|t| t.lower_end().z)));
    wing.top = face(upper, wing.top.start);
    wing.bottom = face(lower.iter().map(turned_over).collect(), wing.bottom.start);
}

fn face(elements: Vec<RollElement>, start: Point) -> Face {
    Face { start: elements.first().map_or(start, |e| e.segment.start()), elements }
}

/// The mirror image at the height 0.
fn turned_over(element: &RollElement) -> RollElement {
    element.mapped(|s| mapped(s, |p| Point::new(p.z, -p.r), true))
}

/// The faces end at the widest point of the strip, one above the other: the roll on the inside of the turn closes the opening with
/// an upright line.
fn meet(wing: &mut Wing) {
    let upwards = ends::ends_upwards(wing.end_heading_rad());
    let (from, to) = if upwards { (&mut wing.bottom, &wing.top) } else { (&mut wing.top, &wing.bottom) };
    let name = from.elements.last().map(reach::upright_name);
    if let Some(name) = name {
        from.line_to(to.end(), name);
    }
}

/// A roll from its face in strip space, with merged elements and side faces.
fn rolled(elements: &[RollElement], kind: RollKind, axis: f64) -> Option<DesignedRoll> {
    let left = elements.first()?.segment.start().z;
    let frame = Frame { kind, face: left, axis };
    let in_roll = elements.iter().map(|e| e.mapped(|s| frame.to_roll(s))).collect();
    let travelled = if kind == RollKind::Bottom { merge::Travel::Backwards } else { merge::Travel::Forwards };
    Some(DesignedRoll { kind, elements: with_flanks(merge::merged(in_roll, travelled)), frame })
}

/// The contour between its side faces, which swallow upright lines at both ends.
pub(super) fn with_flanks(mut elements: Vec<RollElement>) -> Vec<RollElement> {
    /// Ends at the same place along the axis, mm.
    const SAME_MM: f64 = 1e-6;
    let upright =
        |e: &RollElement| (e.segment.start().z - e.segment.end().z).abs() <= SAME_MM && e.segment.radius().is_none();
    while elements.last().is_some_and(upright) {
        elements.pop();
    }
    let leading = elements.iter().take_while(|e| upright(e)).count();
    elements.drain(..leading);
    let (Some(first), Some(last)) = (elements.first(), elements.last()) else { return elements };
    let (start, end) = (first.segment.start(), last.segment.end());
    let flank = |from: Point, to: Point, side| RollElement::new(Segment::line(from, to), ElementName::Flank { side });
    let left = flank(Point::new(start.z, 0.0), start, Side::Left);
    let right = flank(end, Point::new(end.z, 0.0), Side::Right);
    [left].into_iter().chain(elements).chain([right]).collect()
}

/// Names of the pieces, for finding them on a face.
pub(super) fn names(pieces: &[Piece]) -> Vec<ElementName> {
    pieces.iter().map(name_of).collect()
}
