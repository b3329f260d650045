//! Roughing with the right-hand tool, interval by interval.
//!
//! An interval is cut level by level until the surface splits it; the new intervals, the right one first, go to the end of
//! a queue, and the next one comes from its front. Equal strokes one below the other are written as a loop.

use super::plan::{Moves, Plan};
use super::surface::Run;
use crate::turning::CutMove;
use std::collections::VecDeque;

/// Equal strokes from which on a loop is written. The published parts have a loop of five and no shorter ones, so the
/// published number is not known; three is the first at which the loop's eight instructions are fewer than the strokes'.
const SHORTEST_LOOP: usize = 3;

/// Starts and lengths of strokes that differ less than this are equal, mm: half of the control's smallest step.
const EQUAL_MM: f64 = 0.0005;

/// One stroke towards the chuck at a level.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stroke {
    level: u32,
    run: Run,
}

/// An interval that is not finished: its extent and the next level.
struct Interval {
    run: Run,
    level: u32,
}

/// The moves of right-hand roughing, from the datum to the datum.
pub(super) fn rough_right(plan: &Plan) -> Vec<CutMove> {
    let strokes = strokes(plan);
    let mut moves = plan.moves();
    moves.travel_z(plan.face_z(), plan.rpm(plan.datum.r));
    for equal in strokes.chunk_by(continues) {
        if equal.len() >= SHORTEST_LOOP {
            cut_loop(plan, &mut moves, equal);
        } else {
            for stroke in equal {
                cut(plan, &mut moves, stroke);
            }
        }
    }
    let last = strokes.last().map_or(plan.datum.r, |s| plan.level(s.level));
    moves.travel_r(plan.datum.r, plan.rpm(last));
    moves.travel_z(plan.datum.z, plan.rpm(last));
    moves.done()
}

/// All strokes in the order of cutting.
fn strokes(plan: &Plan) -> Vec<Stroke> {
    let left_over = plan.right.surface.raised(plan.allowance());
    let whole = Run { z0: f64::NEG_INFINITY, z1: f64::INFINITY };
    let mut queue = VecDeque::from([Interval { run: whole, level: 0 }]);
    let mut strokes = Vec::new();
    while let Some(Interval { run, mut level }) = queue.pop_front() {
        let within = left_over.clipped(run.z0, run.z1);
        loop {
            match within.runs_below(plan.level(level)).as_slice() {
                [] => break,
                [run] => strokes.push(Stroke { level, run: *run }),
                split => {
                    queue.extend(split.iter().rev().map(|&run| Interval { run, level }));
                    break;
                }
            }
            level += 1;
        }
    }
    strokes
}

fn continues(upper: &Stroke, lower: &Stroke) -> bool {
    lower.level == upper.level + 1
        && (lower.run.z0 - upper.run.z0).abs() < EQUAL_MM
        && (lower.run.z1 - upper.run.z1).abs() < EQUAL_MM
}

fn cut(plan: &Plan, moves: &mut Moves, stroke: &Stroke) {
    let level = plan.level(stroke.level);
    let rpm = plan.rpm(level);
    moves.travel_z(stroke.run.z1, rpm);
    moves.cut_r(level, rpm);
    moves.cut_z(stroke.run.z0, rpm);
    moves.travel_z(stroke.run.z1, rpm);
    moves.travel_r(plan.datum.r, rpm);
}

fn cut_loop(plan: &Plan, moves: &mut Moves, strokes: &[Stroke]) {
    let [first, ..] = strokes else { return };
    let level = plan.level(first.level);
    let rpm = plan.rpm(level);
    let count = u32::try_from(strokes.len()).unwrap_or(u32::MAX);
    moves.travel_z(first.run.z1, rpm);
    moves.travel_r(level + plan.rough_depth, rpm);
    moves.repeat(count, -plan.rough_depth, |moves| {
        moves.cut_r(level, rpm);
        moves.cut_z(first.run.z0, rpm);
        moves.travel_z(first.run.z1, rpm);
    });
    moves.travel_r(plan.datum.r, rpm);
}
