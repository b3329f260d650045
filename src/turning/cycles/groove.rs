//! Grooving: plunges with a blade, half its width apart.

use super::area::Direction;
use super::fault::Fault;
use super::job::Job;
use super::level::highest_between;
use crate::geometry::{Point, Segment};
use crate::turning::CutMove;

/// Height above the blank from which every plunge begins, mm.
const ABOVE_BLANK_MM: f64 = 3.0;

/// Share of the blade's width from one plunge to the next.
const STEP: f64 = 0.5;

/// Steps smaller than this are none, mm.
const NO_STEP_MM: f64 = 1e-6;

/// More plunges than any roll needs.
const MOST_PLUNGES: f64 = 10_000.0;

/// The moves of a blade of `width` mm.
pub(super) fn groove(job: &Job<'_>, width: f64) -> Result<Vec<CutMove>, Fault> {
    let above = job.blank.radius + ABOVE_BLANK_MM;
    let mut moves = job.moves();
    moves.rapid(job.approach());
    for z in positions(job, width)? {
        let bottom = highest_between(&job.contour, z, z + width).unwrap_or(above);
        moves.line(Point::new(z, above));
        moves.line(Point::new(z, bottom));
        moves.rapid(Point::new(z, above));
    }
    Ok(moves.into_moves())
}

/// Positions of the blade's corner towards the clamped end: from the area's start, with the far corner on it, to the end
/// of the contour; the last step may be shorter.
fn positions(job: &Job<'_>, width: f64) -> Result<Vec<f64>, Fault> {
    let end = job.contour.last().map_or(job.area.z_end, |last| Segment::end(last).z);
    let (from, to) = match job.direction() {
        Direction::TowardsClampedEnd => (job.area.z_start - width, end),
        Direction::TowardsFreeEnd => (job.area.z_start, end - width),
    };
    let way = (to - from) * job.sign();
    let steps = (way / (width * STEP)).floor();
    if way < -NO_STEP_MM {
        let message = format!("The area is {:.3} mm wide; the blade is {width:.3} mm.", (way + width).max(0.0));
        return Err(Fault::new("groove-narrow", message, "Use a narrower blade, or groove more elements."));
    }
    if !steps.is_finite() || steps >= MOST_PLUNGES {
        let message =
            format!("With a blade of {width} mm the area takes {steps} plunges; at most {MOST_PLUNGES} are made.");
        return Err(Fault::new("groove-blade", message, "Use a wider blade."));
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to MOST_PLUNGES")]
    let steps = steps.max(0.0) as u32;
    let mut all: Vec<f64> = (0..=steps).map(|k| from + job.sign() * f64::from(k) * width * STEP).collect();
    if all.last().is_none_or(|last| (to - last).abs() > NO_STEP_MM) {
        all.push(to);
    }
    Ok(all)
}
