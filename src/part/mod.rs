//! Turned parts: the section table, its checks, and the exact profile made from it.

mod biarc;
mod bore;
mod check;
mod crossing;
mod curve;
mod envelope;
mod holding;
mod outside;
mod profile;
mod rules;
mod section;
mod section_row;
mod setup;
mod setups;
mod shape;
mod split;
mod stock;
mod thread;

#[cfg(test)]
pub(crate) mod fixtures;

pub use biarc::contour;
pub use check::check;
pub use profile::{Curve, Parabola, ParabolaAxis, PartContour, Piece, PieceRole, Profile};
pub use section::{STARTS, Section, SectionKind};
pub use setup::Setup;
pub use setups::{PART_OFF_WIDTH_MM, setups};
pub use shape::row_curve;
pub(crate) use shape::{ShapeFault, row_fault};
pub use thread::ThreadSpec;
