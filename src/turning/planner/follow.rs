//! Passes along the limit of a tool: cleaning after roughing, and finishing.

use super::chain::{Chain, Run};
use super::link::{self, CLEARANCE_MM};
use super::path::Path;
use super::piece::SAME_MM;
use super::tool::Cutter;
use super::trace::{ArcRules, trace};
use super::work::{AIR_MM, Limit, Work};
use crate::geometry::{Point, Segment};

/// How far a pass begins and ends beyond what it must cut, mm.
const OVERLAP_MM: f64 = 0.3;

/// Passes that are closer than this are made in one, mm.
const JOINED_MM: f64 = 3.0;

/// A pass along the limit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Follow<'a> {
    pub(super) work: &'a Work,
    pub(super) cutter: &'a Cutter,
    pub(super) limit: &'a Limit,
    /// What the limit leaves on the contour, mm.
    pub(super) allowance: f64,
    /// Stock lower than this over what the tool can reach is not worth a pass, mm.
    pub(super) worth: f64,
    pub(super) rules: ArcRules,
}

impl Follow<'_> {
    /// Stretches of programmed positions where the tool has something to cut, from right to left.
    pub(super) fn runs(&self) -> Vec<Run> {
        let path = self.limit.chain.pieces.iter().map(super::piece::Piece::towards_chuck).collect::<Vec<_>>();
        let reached = Work::left_by(self.cutter, &path);
        let stock = self.work.stock.clipped(self.work.from_z, f64::INFINITY);
        let (left, right) = self.cutter.contact();
        let mut runs: Vec<Run> = Vec::new();
        for full in stock.runs_over(&reached, self.worth) {
            let z0 = (full.z0 - right - OVERLAP_MM).max(self.limit.z0);
            let z1 = self.begun_at_the_wall(full.z1, (full.z1 - left + OVERLAP_MM).min(self.limit.z1));
            match runs.last_mut() {
                Some(last) if z0 - last.z1 < JOINED_MM => last.z1 = last.z1.max(z1),
                _ => runs.push(Run { z0, z1 }),
            }
        }
        runs.retain(|r| r.width() > 0.0);
        runs.reverse();
        runs
    }

    /// A pass that would begin beyond a wall begins on the wall.
    fn begun_at_the_wall(&self, cut_to: f64, z1: f64) -> f64 {
        let pieces: Vec<_> = self.limit.chain.over(cut_to - SAME_MM, z1).collect();
        let wall = pieces
            .windows(2)
            .find(|w| w[1].left().r - w[0].right().r > self.cutter.nose && w[0].z1 >= cut_to - SAME_MM);
        wall.map_or(z1, |w| w[0].z1)
    }

    /// Cuts along the limit over `runs`.
    pub(super) fn cut(&self, path: &mut Path<'_>, runs: &[Run], air: &Chain, ceiling: f64) {
        for run in runs {
            let way = trace(&self.limit.chain, run.z0, run.z1, self.cutter.nose + self.allowance, self.rules);
            let Some(first) = way.first() else { continue };
            let start = first.start();
            link::link(path, self.lead_in(first, air), air, ceiling);
            path.line(start);
            for segment in &way {
                path.along(segment);
            }
            lead_out(path, way.last(), air);
        }
    }

    /// A place in air from which the pass begins: behind its first direction if that is free, else above.
    fn lead_in(&self, first: &Segment, air: &Chain) -> Point {
        let start = first.start();
        let behind = start - first.direction_at(0.0) * AIR_MM;
        let inside = (self.limit.z0..=self.limit.z1).contains(&behind.z) && behind.r >= start.r.min(0.0) - SAME_MM;
        let low = air.at(behind.z).unwrap_or(f64::NEG_INFINITY);
        if inside && behind.r >= low + CLEARANCE_MM.min(AIR_MM) / 2.0 && link::is_free(behind, start, &self.limit.chain)
        {
            return behind;
        }
        let low = air.at(start.z).unwrap_or(f64::NEG_INFINITY);
        Point::new(start.z, (low + CLEARANCE_MM).max(start.r))
    }
}

/// Leaves the contour the way it ends if air is there.
fn lead_out(path: &mut Path<'_>, last: Option<&Segment>, air: &Chain) {
    let Some(last) = last else { return };
    let ahead = path.at + last.direction_at(1.0) * CLEARANCE_MM;
    if ahead.r > path.at.r && link::is_free(path.at, ahead, air) {
        path.rapid(ahead);
    }
}
