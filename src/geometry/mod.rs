//! Points, line and arc segments and contours in part space, in mm. Tolerances are arguments.
//!
//! Part space: `z` along the spindle, growing away from the chuck; `r` a radius, never negative on a part.
//! Counter-clockwise (`ccw`) is seen with z to the right and r upwards.

mod biarc;
mod contour;
mod inside;
mod intersection;
mod meeting;
mod nearest;
mod point;
mod segment;

#[cfg(test)]
mod properties;

pub use biarc::biarc;
pub use contour::Contour;
pub use inside::Location;
pub use intersection::Intersection;
pub use point::{Bounds, Point, Vector};
pub use segment::Segment;
