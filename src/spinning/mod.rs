//! Flow-turning: shells formed over a former by a roller.
//!
//! | module | duty |
//! |---|---|
//! | `design` | the shell as data |
//! | `former`, `offset`, `shape`, `law` | former to exact contour, wall by the sine law, blank by constant volume |
//! | `rules`, [`material`](mod@material) | limits of process, material, roller and rig, one rule a file |
//! | [`path`](mod@path), [`roller`] | path of the roller's nose centre for every pass; outline of the roller |
//!
//! Part space: z = 0 at the chuck's face, growing towards the former's tip; r a radius. Contours run from the tip to the
//! base.

mod design;
mod fit;
mod former;
mod law;
pub mod material;
mod offset;
pub mod path;
pub mod roller;
mod rules;
mod shape;

pub use design::{Blank, Former, FormerShape, Forming, LARGEST_FIGURE, MOST_PASSES, RigChoices, Roller, Shell, Speeds};
pub use former::{CONTOUR_TOLERANCE_MM, as_turned_part, contour};
pub use law::{angle_after, disc_radius, reduction, wall};
pub use rules::check;
pub use shape::{ShellShape, Station, shape};
