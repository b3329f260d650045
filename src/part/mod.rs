//! Turned parts: the section table, its checks, and the exact profile made from it.

mod profile;
mod reach;
mod section;
mod section_row;

pub use profile::{Curve, Parabola, ParabolaAxis, PartContour, Piece, PieceRole, Profile, Setup, ThreadSpec};
pub use reach::UnreachableArea;
pub use section::{Section, SectionKind};
