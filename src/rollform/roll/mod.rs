//! The rolls of a station: contours designed from the strip and from what the station says.
//!
//! The rules are those of the published rolls (Wong, "Computer aided design and manufacture of form-rolls", 1983, Fig. 6.17
//! from the input of Figs. 5.5 to 5.8), as far as their figures settle them. Everything below is seen from the drive surface
//! outwards, on the right; the left is built from the mirror image.
//!
//! **Opening** (`opening`, `relief`). On the drive surface the opening is the drive opening: the bottom roll has the bottom
//! face of the strip, what the opening exceeds the thickness by is on the top roll. Beyond, the opening is the clearance, and
//! one face is relieved. Bent arcs of one sign that follow one another form a group; the relief changes only in the last
//! arc of a group, to the outer face of that arc, and only where a group of the other sign follows, so that the inside
//! of the next group is relieved. The last group changes nothing.
//!
//! Settled here, for the published rolls do not show it: a straight piece longer than the thickness ends a group; the first
//! group opens the clearance even if no group follows, or there would be none; the opening stays that of the drive surface as
//! long as no bend comes in which it could change; without a drive surface in the document, the longest level line
//! drives; all between the outermost drive elements drives.
//!
//! **Transition** (`transition`). In the arc where the relief changes, the outer contour becomes the fillet that touches the
//! prolonged line before it and ends on the normal of the element's end, relieved. On the inner face, where a relief ends, the
//! published rolls add it once more: the arc is the outer one less the clearance, moved by the relief along the normal
//! of its start; its neighbours run to it as chords. That is kept, for it is in the metal, up to a right angle; beyond, it would cut into the strip. An arc that is too flat for the fillet
//! becomes a chord; it nowhere cuts into the strip.
//!
//! **End of the strip** (`ends`). The last line is prolonged by the tolerance. An end face square to it closes the opening; it
//! belongs to the roll that can reach it: the bottom roll if the strip ends level or downwards, the top roll if upwards.
//! Then both rolls share the extension contour. Spigot A: along the last line, outwards along the axis, back towards the pass
//! line, outwards along the axis. Spigot B (its diagram is lost): the same with the third part away from the pass
//! line. Then the side faces.
//!
//! **Inaccessible parts** (`reach`). A roll is what can come from its side: a top roll has the upper envelope of the whole
//! outline of the strip, a bottom roll the lower, a side roll the outer one. Where the envelope jumps, the contour is a straight
//! line square to the axis: upright in top and bottom rolls, level in side rolls. So whatever lies under an overhang
//! becomes a line at its edge.
//!
//! **Side rolls** (`side`). A side roll has the given run of elements on the given face; the top or bottom roll that has this
//! face otherwise ends there, its side face set back by the tolerance; the other one ends with the strip. The contour
//! goes on below and above with its extension contours (their diagram is lost): along the element, along the axis,
//! towards the axis, along the axis.
//!
//! **Elements** (`merge`). Pieces below 0.005 mm are absorbed. Concentric arcs become one, level lines too; inclined collinear
//! lines are joined in pairs in the direction of travel, clockwise round the pass (top roll from left to right, bottom
//! roll from right to left): that gives the published lists, which are not the same left and right.

pub(super) mod drive;
mod ends;
mod face;
mod frame;
mod merge;
mod opening;
mod pair;
mod reach;
mod relief;
pub(super) mod rules;
mod side;
mod transition;
mod wing;

#[cfg(test)]
mod published;
#[cfg(test)]
mod station_tests;
#[cfg(test)]
mod tests;

use super::bends::Stage;
use super::strip::{Strip, along};
use crate::document::{ElementName, RollKind, RollSet};
use crate::geometry::{Contour, Segment};
pub use drive::DriveZone;
pub use frame::Frame;
pub use opening::Openings;

/// An element of a roll contour, with the names of what made it: several if neighbours were merged.
#[derive(Debug, Clone, PartialEq)]
pub struct RollElement {
    /// The line or arc; `z` along the roll, `r` its radius, mm.
    pub segment: Segment,
    /// What made it, in the order of the contour.
    pub names: Vec<ElementName>,
}

impl RollElement {
    /// An element with one name.
    #[must_use]
    pub fn new(segment: Segment, name: ElementName) -> Self {
        Self { segment, names: vec![name] }
    }

    /// True if it was made, among others, by `name`.
    #[must_use]
    pub fn has(&self, name: ElementName) -> bool {
        self.names.contains(&name)
    }

    fn mapped(&self, map: impl Fn(&Segment) -> Segment) -> Self {
        Self { segment: map(&self.segment), names: self.names.clone() }
    }
}

/// A roll as designed: its contour from the left (of a side roll the lower) face to the other, both faces included.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignedRoll {
    /// Which roll of the station.
    pub kind: RollKind,
    /// Its elements in roll space.
    pub elements: Vec<RollElement>,
    /// Where the roll is in strip space.
    pub frame: Frame,
}

impl DesignedRoll {
    /// The contour in roll space.
    #[must_use]
    pub fn contour(&self) -> Contour {
        contour(&self.elements)
    }

    /// The contour in strip space.
    #[must_use]
    pub fn in_strip_space(&self) -> Contour {
        Contour::new(self.elements.iter().map(|e| self.frame.to_strip(&e.segment)).collect())
    }
}

/// The segments of elements.
#[must_use]
pub fn contour(elements: &[RollElement]) -> Contour {
    Contour::new(elements.iter().map(|e| e.segment).collect())
}

/// A station's strip and rolls.
#[derive(Debug, Clone, PartialEq)]
pub struct StationRolls {
    /// The strip.
    pub strip: Strip,
    /// The openings between its rolls.
    pub openings: Openings,
    /// Its rolls: top, bottom, left, right, as far as there are any.
    pub rolls: Vec<DesignedRoll>,
}

/// The strip and the rolls of the station with this index. The set is in mm. Without rolls if the station has none, or if there
/// is no strip that has an extent.
#[must_use]
pub fn station_rolls(set: &RollSet, index: usize) -> Option<StationRolls> {
    let station = set.stations.get(index)?;
    let strip = Strip::at(set, Stage::Station(index));
    let openings = Openings::of(station, strip.thickness);
    let usable = !strip.pieces.is_empty() && openings.are_usable() && strip.outline().bounds().is_some_and(is_finite);
    let rolls = if station.without_rolls || !usable {
        Vec::new()
    } else {
        pair::rolls(&strip, station, set.section.origin, openings)
    };
    Some(StationRolls { strip, openings, rolls })
}

fn is_finite(bounds: crate::geometry::Bounds) -> bool {
    bounds.min.is_finite() && bounds.max.is_finite()
}

/// The closed outline of a strip, `clearance` mm off its faces and edges. Empty without pieces.
pub(super) fn around(strip: &Strip, clearance: f64) -> Contour {
    let (Some(first), Some(last)) = (strip.pieces.first(), strip.pieces.last()) else { return Contour::default() };
    let side = |of: face::StripFace| {
        let mut chain = face::Face::at(transition::ends(first, of, clearance).0);
        for piece in &strip.pieces {
            transition::plain(&mut chain, piece, of, clearance);
        }
        let (back, on) = (along(first.heading_rad) * -clearance, along(last.end_heading_rad()) * clearance);
        (chain.start + back, chain.elements, chain.start, on)
    };
    let (bottom_start, bottom, bottom_first, on) = side(face::StripFace::Bottom);
    let (top_start, top, top_first, _) = side(face::StripFace::Top);
    let end = |elements: &[RollElement], start| elements.last().map_or(start, |e| e.segment.end()) + on;
    let (bottom_end, top_end) = (end(&bottom, bottom_first), end(&top, top_first));
    let there = [Segment::line(bottom_start, bottom_first)].into_iter().chain(bottom.iter().map(|e| e.segment));
    let back = top.iter().rev().map(|e| e.segment.reversed()).chain([Segment::line(top_first, top_start)]);
    let right = [
        Segment::line(bottom_end - on, bottom_end),
        Segment::line(bottom_end, top_end),
        Segment::line(top_end, top_end - on),
    ];
    let all = there.chain(right).chain(back).chain([Segment::line(top_start, bottom_start)]);
    Contour::new(all.filter(|s| s.length() > face::NOTHING_MM).collect())
}
