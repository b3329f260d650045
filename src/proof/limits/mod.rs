//! What the machine cannot exceed: travels, feed, speed, radius, taper and pitch. One file a limit.

mod feed;
mod pages;
mod pitch;
mod radius;
mod speed;
mod taper;
mod thread;
mod travel;

use super::findings::{Findings, Place};
use super::step::Drive;
use crate::geometry::Segment;
use crate::machine::Machine;
pub(super) use pages::check as check_pages;
pub(super) use pitch::check as check_pass;
pub(super) use thread::check as check_thread;
pub(super) use travel::Travel;

/// Programs are rounded to 0.001; a limit is passed only by more than this, mm or mm/min.
const ROUNDING: f64 = 0.001;

/// Compares a move with the limits of feed, speed, radius and taper. With constant cutting speed the fastest place of the path
/// counts, which is the one nearest to the axis.
pub(super) fn check_move(path: &Segment, drive: &Drive, machine: &Machine, place: Place, findings: &mut Findings) {
    let bounds = path.bounds();
    let nearest =
        if bounds.min.r <= 0.0 && bounds.max.r >= 0.0 { 0.0 } else { bounds.min.r.abs().min(bounds.max.r.abs()) };
    speed::check(drive.speed.rpm_at(nearest), machine, place, findings);
    if !drive.rapid {
        feed::check(path, drive.feed_at(nearest), machine, place, findings);
    }
    match path {
        Segment::Arc { .. } => radius::check(path, machine, place, findings),
        Segment::Line { start, end } => taper::check(*start, *end, machine, place, findings),
    }
}

#[cfg(test)]
mod fixture {
    use super::super::findings::{Findings, Place};
    use super::super::report::Finding;

    /// What a check finds in the first block.
    pub(super) fn found<T>(check: impl FnOnce(Place, &mut Findings) -> T) -> Vec<Finding> {
        let mut findings = Findings::default();
        check(Place { program: 0, block: 1 }, &mut findings);
        findings.in_order(&["TEST".to_owned()])
    }
}
