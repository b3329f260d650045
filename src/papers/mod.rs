//! Papers: the dimensioned drawing of a finished part or shell and the setup sheet of a clamping, as pages and as files.
//!
//! A page is a list of lines, arcs and texts in mm on paper; writers turn the same page into PDF, SVG, DXF and HP-GL. No page
//! knows the date, so that the same document always prints the same paper.

mod arrow;
mod body;
mod crop;
mod drawing;
mod dxf;
mod file;
mod font;
mod frame;
mod hatch;
mod hpgl;
mod kind;
mod labels;
mod number;
mod page;
mod parts_list;
mod pdf;
mod setup_sheet;
mod shell;
mod strip;
mod svg;
mod tool_picture;
mod view;

pub use drawing::{DrawingChoice, drawing};
pub use dxf::dxf;
pub use file::save;
pub use hpgl::hpgl;
pub use kind::PaperKind;
pub use page::{Align, Ink, Item, Page, Paper, Pen, Stroke};
pub use parts_list::{RollLine, parts_list, parts_list_csv, roll_lines};
pub use pdf::pdf;
pub use svg::svg;
pub use view::View;
