//! Parting off with the blade, whose programmed point is its corner towards the chuck.

use super::link::{self, CLEARANCE_MM};
use super::path::Path;
use super::tool::Cutter;
use super::work::Work;
use crate::geometry::Point;

/// The moves of parting off at the groove that begins at `z`: to the axis at the feed of cutting, and out through air.
pub(super) fn cut(path: &mut Path<'_>, z: f64, work: &Work, cutter: &Cutter, ceiling: f64) {
    let air = work.air(cutter);
    let above = Point::new(z, air.at(z).unwrap_or(0.0).max(0.0) + CLEARANCE_MM);
    link::link(path, above, &air, ceiling);
    path.line(Point::new(z, 0.0));
    path.rapid(above);
}
