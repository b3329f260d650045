//! Points, line and arc segments and contours in part space, in mm. Tolerances are arguments.
//!
//! Part space: `z` along the spindle, growing away from the chuck; `r` a radius, never negative on a part.
//! Counter-clockwise (`ccw`) is seen with z to the right and r upwards.

mod contour;
mod nearest;
mod point;
mod segment;

pub use contour::Contour;
pub use point::{Bounds, Point, Vector};
pub use segment::Segment;
