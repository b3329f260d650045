//! Finishing: once along the contour.

use super::cut_in::CutInLine;
use super::fault::Fault;
use super::job::Job;
use crate::geometry::{Point, Segment};
use crate::turning::CutMove;

/// The moves: straight to the contour, or along the instruction's cut-in line, then along all of it.
pub(super) fn finish(job: &Job<'_>) -> Result<Vec<CutMove>, Fault> {
    let mut moves = job.moves();
    moves.rapid(job.approach());
    if let Some(cut_in) = &job.instruction.cut_in {
        let line = CutInLine::of(job, cut_in)?;
        moves.nose_to(line.point);
        moves.nose_to(line.entry);
        moves.follow(&contour_from(&job.contour, line.entry));
    } else {
        moves.nose_to(job.contour.first().map(Segment::start).unwrap_or_default());
        moves.follow(&job.contour);
    }
    moves.rapid(job.retreat());
    Ok(moves.into_moves())
}

/// The contour from a point of its first element on.
pub(super) fn contour_from(contour: &[Segment], entry: Point) -> Vec<Segment> {
    let mut rest = contour.to_vec();
    if let Some(Segment::Line { start, .. } | Segment::Arc { start, .. }) = rest.first_mut() {
        *start = entry;
    }
    rest
}
