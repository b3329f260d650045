//! Roughing: strokes along the spindle from in front of the area down to the contour, then once along the contour.

use super::fault::Fault;
use super::job::Job;
use super::strokes::{CLEARANCE_MM, levels, stroke_end};
use super::undercut::without_undercuts;
use crate::geometry::{Point, Segment, Vector};
use crate::turning::CutMove;

/// The tool comes to the contour from here, along the spindle and on the radius, mm: under 45° from in front of it.
const LEAD_IN_MM: f64 = 3.0;

/// The moves, and the radius down to which the strokes have cut all along the area.
pub(super) fn rough(job: &Job<'_>) -> Result<(Vec<CutMove>, f64), Fault> {
    let first = job.contour.first().map(Segment::start).unwrap_or_default();
    let start_z = job.area.z_start - CLEARANCE_MM * job.sign();
    let mut moves = job.moves();
    let mut through = job.blank.radius;
    moves.rapid(job.approach());
    for tip in levels(job, first.r)? {
        let start = Point::new(start_z, tip + job.tool.nose.y);
        let (end, is_through) = stroke_end(job, start);
        moves.nose_to(start);
        moves.nose_to(end);
        moves.rapid(job.tool.tip(start) + Vector::new(0.0, CLEARANCE_MM));
        if is_through {
            through = tip;
        }
    }
    moves.nose_to(first + Vector::new(-job.sign(), -1.0) * LEAD_IN_MM);
    moves.nose_to(first);
    moves.follow(&without_undercuts(&job.contour, job.direction()));
    Ok((moves.into_moves(), through))
}
