//! Turned parts: the section table, its checks, and the exact profile made from it.

mod biarc;
mod check;
mod crossing;
mod curve;
mod envelope;
mod outside;
mod profile;
mod reach;
mod rules;
mod section;
mod section_row;
mod setups;
mod shape;
mod split;
mod sweep;

#[cfg(test)]
mod fixtures;

pub use biarc::contour;
pub use check::check;
pub use profile::{Curve, Parabola, ParabolaAxis, PartContour, Piece, PieceRole, Profile, Setup, ThreadSpec};
pub use reach::{IGNORED_HEIGHT_MM, UnreachableArea, unreachable};
pub use section::{Section, SectionKind};
pub use setups::{PART_OFF_WIDTH_MM, setups};
pub use shape::row_curve;
