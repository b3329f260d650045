//! Writing parts as files for other programs and for people.

mod any;
mod cad;
mod die;
mod dxf;
mod roll;
mod svg;
mod table;

pub use any::any;
pub use cad::cad;
pub use die::die_dxf;
pub(in crate::storage) use dxf::BORE;
pub use dxf::dxf;
pub use roll::{e_layout, roll_dxf};
pub use svg::svg;
pub use table::{COLUMNS, csv, tsv};
