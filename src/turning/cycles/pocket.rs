//! Pocketing: strokes within a hollow, each entered along the cut-in line, then once along the contour.

use super::cut_in::CutInLine;
use super::fault::Fault;
use super::finish::contour_from;
use super::job::Job;
use super::strokes::{CLEARANCE_MM, levels, stroke_end};
use crate::document::CutIn;
use crate::geometry::{Point, Segment, Vector};
use crate::turning::CutMove;

/// Height of the nose's centre above the blank at which the tool stops coming at rapid, mm.
const APPROACH_R_MM: f64 = 10.0;

/// The moves of a pocket that is entered along `cut_in`.
pub(super) fn pocket(job: &Job<'_>, cut_in: &CutIn) -> Result<Vec<CutMove>, Fault> {
    let line = CutInLine::of(job, cut_in)?;
    let mut moves = job.moves();
    moves.rapid(job.tool.tip(line.at_radius(job.blank.radius + APPROACH_R_MM)));
    for tip in levels(job, line.entry.r)? {
        let start = line.at_radius(tip + job.tool.nose.y);
        moves.nose_to(start);
        moves.nose_to(stroke_end(job, start).0);
        moves.rapid(job.tool.tip(start) + Vector::new(0.0, CLEARANCE_MM));
        moves.nose_to(start);
    }
    moves.nose_to(line.entry);
    moves.follow(&contour_from(&job.contour, line.entry));
    let end = job.contour.last().map(Segment::end).unwrap_or_default();
    if end.r < job.blank.radius {
        moves.nose_to(Point::new(end.z, job.blank.radius));
    }
    Ok(moves.into_moves())
}
