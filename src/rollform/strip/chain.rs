//! The elements of a section as a chain of straight and bent pieces from left to right, not yet placed.

use super::{PieceKind, Side};
use crate::document::{Element, ElementKind, Origin, RollSet};
use crate::rollform::bends::BendState;
use std::collections::BTreeMap;

/// A piece without a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Link {
    /// Id of its element.
    pub element: u32,
    /// Side of the origin.
    pub side: Side,
    /// What it is of its element.
    pub kind: PieceKind,
    /// Length on the mean line, mm.
    pub length: f64,
    /// Angle, radians, positive upwards; the same seen from either end, for a mirror image run backwards turns alike.
    pub angle_rad: f64,
    /// Inside radius of an arc, mm.
    pub inside_radius: f64,
}

/// The links from left to right.
pub(super) struct Chain {
    /// All links.
    pub links: Vec<Link>,
    /// How many lie left of the origin.
    pub left_of_origin: usize,
    /// Direction of the strip at the origin, from left to right, radians.
    pub origin_heading_rad: f64,
}

/// The chain of a section with these bends.
pub(super) fn chain(set: &RollSet, bends: &BTreeMap<u32, BendState>) -> Chain {
    let section = &set.section;
    let outwards =
        |elements: &[Element], side| -> Vec<Link> { elements.iter().flat_map(|e| links(e, side, bends)).collect() };
    let first = |side| outwards(&section.elements, side);
    let other = |side| outwards(&section.other_side, side);
    let (left, right) = match section.origin {
        Origin::LeftToRight => (Vec::new(), first(Side::Right)),
        Origin::RightToLeft => (first(Side::Left), Vec::new()),
        Origin::CentreRightFirst => (other(Side::Left), first(Side::Right)),
        Origin::CentreLeftFirst => (first(Side::Left), other(Side::Right)),
        Origin::Symmetrical => (first(Side::Left), first(Side::Right)),
    };
    let slope = section.first_angle_deg.to_radians();
    let origin_heading_rad = match section.origin {
        Origin::LeftToRight | Origin::CentreRightFirst => slope,
        Origin::RightToLeft | Origin::CentreLeftFirst => -slope,
        Origin::Symmetrical => 0.0,
    };
    let left_of_origin = left.len();
    Chain { links: left.into_iter().rev().chain(right).collect(), left_of_origin, origin_heading_rad }
}

/// The links of an element on its way from the origin.
fn links(element: &Element, side: Side, bends: &BTreeMap<u32, BendState>) -> Vec<Link> {
    let straight = |kind, length| Link { element: element.id, side, kind, length, angle_rad: 0.0, inside_radius: 0.0 };
    match element.kind {
        ElementKind::Line { length } => vec![straight(PieceKind::Line, length)],
        ElementKind::Bend { .. } => {
            let Some(bend) = bends.get(&element.id) else { return Vec::new() };
            if bend.angle_rad == 0.0 {
                return vec![straight(PieceKind::Leading, bend.mean_length())];
            }
            let arc = Link {
                kind: PieceKind::Arc,
                length: bend.arc,
                angle_rad: bend.angle_rad,
                inside_radius: bend.inside_radius,
                ..straight(PieceKind::Arc, 0.0)
            };
            let (leading, trailing) =
                (straight(PieceKind::Leading, bend.leading), straight(PieceKind::Trailing, bend.trailing));
            let is_there = |link: &Link| link.kind == PieceKind::Arc || link.length > 0.0;
            [leading, arc, trailing].into_iter().filter(is_there).collect()
        }
    }
}
