//! Strokes parallel to the spindle, one depth of cut below the other.

use super::fault::Fault;
use super::job::Job;
use super::level::first_crossing;
use crate::geometry::Point;

/// Way beyond the ends of the area, and above a finished stroke on the way back, mm.
pub(super) const CLEARANCE_MM: f64 = 2.0;

/// More strokes than any roll needs; a smaller depth is a slip.
const MOST_STROKES: f64 = 10_000.0;

/// Radius of the programmed point in every stroke: depth after depth below the blank, as long as the nose's centre stays
/// above `lowest_center`, mm.
pub(super) fn levels(job: &Job<'_>, lowest_center: f64) -> Result<Vec<f64>, Fault> {
    let depth = job.instruction.depth;
    let least = (job.blank.radius / MOST_STROKES).max(f64::MIN_POSITIVE);
    if !(depth.is_finite() && depth >= least) {
        let message = format!("The depth of cut is {depth} mm; it must be at least {least:.4} mm.");
        return Err(Fault::new("depth", message, "Enter the depth of one stroke on the radius."));
    }
    let tips = (1_u32..).map(|k| job.blank.radius - f64::from(k) * depth);
    Ok(tips.take_while(|tip| tip + job.tool.nose.y > lowest_center).collect())
}

/// Where a stroke from `start` ends (centre of the nose) and whether it went right through the area.
pub(super) fn stroke_end(job: &Job<'_>, start: Point) -> (Point, bool) {
    let wall = first_crossing(&job.contour, start.r, start.z, job.direction());
    let through = job.area.z_end + CLEARANCE_MM * job.sign();
    (Point::new(wall.unwrap_or(through), start.r), wall.is_none())
}
