//! Flow-turning: shells formed over a former by a roller.
//!
//! | module | duty |
//! |---|---|
//! | `former`, `offset`, `chain` | former to exact contour, and the contour at a distance from it |
//! | `hollow`, `shape`, `law` | hollows that the roller spans, wall by the sine law, blank by constant volume |
//! | `rules`, [`material`](mod@material) | limits of process, material, roller and rig, one rule a file |
//! | [`published`] | the controller of 1988: ranges, tables, integer interpolation |
//! | [`interpolation`] | exact set points for any contour |
//! | [`rig`], [`control`], [`run`](mod@run) | rig and its simulation, the controller that watches its path, a run with its errors |
//! | [`path`](mod@path), [`roller`] | path of the roller's nose centre for every pass; outline of the roller |
//! | [`program`], [`proof`] | program for a CNC spinning lathe, and its proof by reading the text back |
//! | [`measurements`], [`reshape`] | published measurements; what a drag makes of a former |
//! | [`operator`] | the operator's sequence as a state machine |
//! | [`table`] | set points as CSV and C header |
//!
//! Part space: z = 0 at the chuck's face, growing towards the former's tip; r a radius. Contours run from the tip to the
//! base.

mod chain;
pub mod control;
mod fit;
mod former;
mod hollow;
pub mod interpolation;
mod law;
pub mod limits;
pub mod material;
pub mod measurements;
mod offset;
pub mod operator;
pub mod path;
pub mod program;
pub mod proof;
pub mod published;
pub mod reshape;
pub mod rig;
pub mod roller;
mod rules;
pub mod run;
mod shape;
pub mod table;

pub use crate::document::{Blank, Former, FormerShape, Forming, RigChoices, Roller, Shell, Speeds};
pub use former::{CONTOUR_TOLERANCE_MM, as_turned_part, contour};
pub use hollow::Hollow;
pub use law::{angle_after, disc_radius, reduction, wall};
pub use rules::check;
pub use shape::{ShellShape, Station, shape};
