//! Writing parts as files for other programs and for people.

mod any;
mod cad;
mod dxf;
mod svg;
mod table;

pub use any::any;
pub use cad::cad;
pub(in crate::storage) use dxf::BORE;
pub use dxf::dxf;
pub use svg::svg;
pub use table::{COLUMNS, csv, tsv};
