//! Passes along the limit of a tool: cleaning after roughing, and finishing.

use super::chain::{Chain, Run};
use super::link::{self, CLEARANCE_MM, go};
use super::path::Path;
use super::piece::{Piece, SAME_MM};
use super::tool::{Cutter, Use};
use super::trace::{ArcRules, simplified, trace};
use super::work::{AIR_MM, Limit, Work};
use crate::geometry::{Point, Segment};

/// How far a pass begins and ends beyond what it must cut, mm.
const OVERLAP_MM: f64 = 0.3;

/// The same of blades, whose sides cannot cut the skin that rounding leaves on a wall.
const BLADE_OVERLAP_MM: f64 = 0.02;

/// Passes that are closer than this are made in one, mm; not those of blades.
const JOINED_MM: f64 = 3.0;

/// How often the limit is raised over what would be left beside the pass.
const MOST_RAISES: u32 = 4;

/// The limit is raised where something is more than this above it, mm.
const RAISED_MM: f64 = 1e-4;

/// How often a pass goes round something in its way before the rest of it is left out.
const MOST_PARTS: u32 = 8;

/// Distance that a pass keeps from what is in its way, mm.
const SHORTENED_MM: f64 = 0.01;

/// Parts of a pass shorter than this are left out, mm.
const SHORTEST_MM: f64 = 0.05;

/// A pass along the limit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Follow<'a> {
    pub(super) cutter: &'a Cutter,
    pub(super) limit: &'a Limit,
    /// What the limit leaves on the contour, mm.
    pub(super) allowance: f64,
    /// Stock lower than this over what the tool can reach is not worth a pass, mm.
    pub(super) worth: f64,
    pub(super) rules: ArcRules,
}

impl Follow<'_> {
    /// Cuts along the limit wherever it is worth it.
    pub(super) fn cut(&self, path: &mut Path<'_>) {
        let runs = self.runs(&path.work);
        if runs.is_empty() {
            // Above a raised limit there is even less to cut.
            return;
        }
        let Some(chain) = self.settled(&path.work.stock.chain()) else { return self.passes(path, &runs) };
        let limit = Limit { chain, ..*self.limit };
        let follow = Follow { limit: &limit, ..*self };
        follow.passes(path, &follow.runs(&path.work));
    }

    fn passes(&self, path: &mut Path<'_>, runs: &[Run]) {
        for run in runs {
            let rolled = self.cutter.nose + self.allowance;
            let way = trace(&self.limit.chain, run.z0, run.z1, rolled, self.rules);
            self.pass(path, if self.allowance > 0.0 { simplified(&way, self.allowance) } else { way });
        }
    }

    /// The limit raised over stock that would be left in the way of holder and back of the insert; `None` if there is none. What
    /// that does not find stops the pass.
    fn settled(&self, stock: &Chain) -> Option<Chain> {
        let Limit { chain, z0, z1 } = self.limit;
        let mut raised: Option<Chain> = None;
        let (first, last) = stock.ends()?;
        for _ in 0..MOST_RAISES {
            let low = raised.as_ref().unwrap_or(chain);
            let left = stock.min(&Work::left_by(&self.cutter.cutting, low)).clipped(first, last);
            let needed = self.cutter.guard.over_floor(&left, *z0, *z1, low);
            if needed.runs_over(low, RAISED_MM).is_empty() {
                break;
            }
            raised = Some(low.max(&needed));
        }
        raised
    }

    /// Stretches of programmed positions where the tool has something to cut, from right to left.
    fn runs(&self, work: &Work) -> Vec<Run> {
        let reached = Work::left_by(&self.cutter.edge, &self.limit.chain);
        let (from, to) = work.range();
        let (left, right) = self.cutter.contact();
        let is_blade = matches!(self.cutter.r#use, Use::Blade { .. });
        // A blade goes as far as its leading corner has to: what its other corner could cut is cut the other way round.
        let (joined, right, beyond) =
            if is_blade { (0.0, left, BLADE_OVERLAP_MM) } else { (JOINED_MM, right, OVERLAP_MM) };
        let mut runs: Vec<Run> = Vec::new();
        for full in work.stock.between(from, to).runs_over(&reached, self.worth) {
            let z0 = (full.z0 - right - beyond).max(self.limit.z0);
            let z1 = self.begun_at_the_wall(full.z1, (full.z1 - left + beyond).min(self.limit.z1));
            match runs.last_mut() {
                Some(last) if z0 - last.z1 < joined => last.z1 = last.z1.max(z1),
                _ => runs.push(Run { z0, z1 }),
            }
        }
        runs.retain(|r| r.width() > 0.0);
        runs.reverse();
        runs
    }

    /// A pass that would begin beyond a wall begins on the wall.
    fn begun_at_the_wall(&self, cut_to: f64, z1: f64) -> f64 {
        let wall = self
            .limit
            .chain
            .over(cut_to - SAME_MM, z1)
            .windows(2)
            .find(|w| w[1].left().r - w[0].right().r > self.cutter.nose && w[0].z1 >= cut_to - SAME_MM);
        wall.map_or(z1, |w| w[0].z1)
    }

    /// Makes a pass, in parts where something is in its way.
    fn pass(&self, path: &mut Path<'_>, mut way: Vec<Segment>) {
        for _ in 0..MOST_PARTS {
            let Some(blocked) = path.blocked(&way) else {
                self.make(path, &way);
                return;
            };
            let head = up_to(&way, blocked.index, blocked.zone.z1 + SHORTENED_MM);
            if path.blocked(&head).is_none() {
                self.make(path, &head);
            }
            way = beyond(&way, blocked.index, blocked.zone.z0 - SHORTENED_MM);
        }
    }

    fn make(&self, path: &mut Path<'_>, way: &[Segment]) {
        let Some(first) = way.first().filter(|_| way.iter().map(Segment::length).sum::<f64>() > SHORTEST_MM) else {
            return;
        };
        let start = self.lead_in(first, path);
        if path.blocked(&[Segment::line(start, first.start())]).is_some() {
            return;
        }
        go(path, start);
        path.line(first.start());
        for segment in way {
            path.along(segment);
        }
        lead_out(path, way.last());
    }

    /// A place in air from which the pass begins: behind its first direction if that is free, else above.
    fn lead_in(&self, first: &Segment, path: &Path<'_>) -> Point {
        let start = first.start();
        let behind = start - first.direction_at(0.0) * AIR_MM;
        let inside = (self.limit.z0..=self.limit.z1).contains(&behind.z) && behind.r >= start.r.min(0.0) - SAME_MM;
        let air = path.air(start.z.min(behind.z), start.z.max(behind.z), start.r.min(behind.r) - CLEARANCE_MM);
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
fn lead_out(path: &mut Path<'_>, last: Option<&Segment>) {
    let Some(last) = last else { return };
    let ahead = path.at + last.direction_at(1.0) * CLEARANCE_MM;
    let here = path.air_here(path.at.z.min(ahead.z), path.at.z.max(ahead.z), path.at.r);
    let (z0, z1) = (path.at.z.min(ahead.z), path.at.z.max(ahead.z));
    if ahead.r > path.at.r && !path.has_hanging(z0, z1) && link::leaves(path, ahead, &here) {
        path.rapid(ahead);
    }
}

/// The way up to a position on one of its segments.
fn up_to(way: &[Segment], index: usize, z: f64) -> Vec<Segment> {
    let cut = way.get(index).and_then(Piece::of).and_then(|p| p.clipped(z, f64::INFINITY));
    way.iter().take(index).copied().chain(cut.map(|p| p.towards_chuck())).collect()
}

/// The way from a position on or behind one of its segments. What lies behind it as a whole stays as it is: an upright line may run
/// away from the chuck by a rounding.
fn beyond(way: &[Segment], index: usize, z: f64) -> Vec<Segment> {
    let rest = way.iter().skip(index).filter_map(|s| {
        if s.start().z.max(s.end().z) < z {
            return Some(*s);
        }
        Piece::of(s).and_then(|piece| piece.clipped(f64::NEG_INFINITY, z)).map(|piece| piece.towards_chuck())
    });
    rest.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rest_of_a_way_hangs_together_over_an_upright_line() {
        let p = Point::new;
        for by in [-1e-8, 0.0, 1e-8] {
            let corners = [p(20.0, 5.0), p(17.0, 5.0), p(17.0 + by, 6.0), p(0.0, 6.0)];
            let way: Vec<Segment> = corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
            let rest = beyond(&way, 0, 19.0);
            assert_eq!((rest[0].start(), rest[1..].to_vec()), (p(19.0, 5.0), way[1..].to_vec()), "{by}");
        }
    }
}
