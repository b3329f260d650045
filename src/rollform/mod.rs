//! Form-rolls: the cross-section of a strip, its way through the stations of a forming line, and the rolls of every station.
//!
//! Everything here takes a [`RollSet`](crate::document::RollSet) in mm (scaled by the unit of its document) and is pure.
//! Strip space: `z` across the line, to the right; `r` the height. Seen along the line, upwards is positive.

pub mod bends;
pub mod design;
pub mod developed;
pub mod die;
pub mod drive;
pub mod editor;
pub mod flower;
pub mod loft;
pub mod part;
pub mod properties;
pub mod roll;
pub mod rules;
pub mod springback;
pub mod strain;
pub mod strip;
pub mod suggest;

#[cfg(test)]
pub(crate) mod fixtures;

pub use design::{Roll, RollDesign, StationDesign, design};
