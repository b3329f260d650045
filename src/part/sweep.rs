//! A tool swept along a surface, on an even grid of positions: how low it can go, and what it leaves.
//!
//! The surface is a radius at every position, the tool the underside of its outline; what it leaves is the closing of
//! the surface by the tool (Serra, Image analysis and mathematical morphology, 1982).

use crate::geometry::{Contour, Point};
use std::collections::VecDeque;

/// Largest distance of the chords of a nose from its arc, mm: below the width of a cell.
const NOSE_TOLERANCE_MM: f64 = 0.002;

/// The underside of a tool.
pub(super) struct Underside {
    /// Straight stretches with z growing.
    stretches: Vec<[Point; 2]>,
}

impl Underside {
    /// The underside of a closed, counter-clockwise outline: what is travelled with z growing.
    pub(super) fn of(outline: &Contour) -> Self {
        let mut stretches = Vec::new();
        for segment in &outline.segments {
            let mut from = segment.start();
            for to in segment.polyline_points(NOSE_TOLERANCE_MM) {
                if to.z > from.z {
                    stretches.push([from, to]);
                }
                from = to;
            }
        }
        Self { stretches }
    }

    /// Largest distance along z from the programmed point, mm.
    pub(super) fn reach(&self) -> f64 {
        self.stretches.iter().flatten().map(|p| p.z.abs()).fold(0.0, f64::max)
    }

    fn mirrored(&self) -> Self {
        let mirrored = self.stretches.iter().map(|[from, to]| [to.mirrored_at_z(0.0), from.mirrored_at_z(0.0)]);
        Self { stretches: mirrored.collect() }
    }

    /// For every cell j the largest `surface[j + u] − underside(u)`: how low the tool can stand there. `step` is the
    /// width of a cell, mm.
    pub(super) fn lowest_positions(&self, surface: &[f64], step: f64) -> Vec<f64> {
        let mut lowest = vec![f64::NEG_INFINITY; surface.len()];
        for [from, to] in &self.stretches {
            let slope = (to.r - from.r) / (to.z - from.z);
            let cells = (cell((from.z / step).ceil()), cell((to.z / step).floor()));
            raise(&mut lowest, surface, cells, slope * step, from.r - slope * from.z);
        }
        // The corners between cells, at the nearest one.
        let corners = self.stretches.iter().flatten();
        let mut corners: Vec<(isize, f64)> = corners.map(|p| (cell((p.z / step).round()), p.r)).collect();
        corners.dedup();
        for (away, r) in corners {
            raise_by_one(&mut lowest, surface, away, r);
        }
        lowest
    }

    /// What the tool leaves at every cell if it stands as low as `positions` allow.
    pub(super) fn left_by(&self, positions: &[f64], step: f64) -> Vec<f64> {
        let upside_down: Vec<f64> = positions.iter().map(|r| -r).collect();
        self.mirrored().lowest_positions(&upside_down, step).into_iter().map(|r| -r).collect()
    }
}

/// A number of cells as an integer; outlines are some tens of mm wide.
fn cell(value: f64) -> isize {
    #[allow(clippy::cast_possible_truncation, reason = "clamped to what any outline spans")]
    {
        value.clamp(-1e9, 1e9) as isize
    }
}

/// Raises `lowest[j]` to the largest `surface[j + k] − (base + slope · k)` of `first <= k <= last`.
///
/// A sliding maximum: candidates wait in a queue in order of falling value, so that the work is linear.
fn raise(lowest: &mut [f64], surface: &[f64], (first, last): (isize, isize), slope: f64, base: f64) {
    /// Up to so many cells it is quicker to look at each of them.
    const FEW: isize = 24;
    if last - first < FEW {
        (first..=last).for_each(|away| raise_by_one(lowest, surface, away, base + slope * away as f64));
        return;
    }
    let mut queue: VecDeque<(isize, f64)> = VecDeque::new();
    let mut entering = first;
    for (j, low) in (0_isize..).zip(lowest.iter_mut()) {
        while entering <= j + last {
            let value = usize::try_from(entering).ok().and_then(|i| surface.get(i)).copied();
            if let Some(value) = value.filter(|v| v.is_finite()) {
                let value = value - slope * entering as f64;
                while queue.back().is_some_and(|&(_, waiting)| waiting <= value) {
                    queue.pop_back();
                }
                queue.push_back((entering, value));
            }
            entering += 1;
        }
        while queue.front().is_some_and(|&(i, _)| i < j + first) {
            queue.pop_front();
        }
        if let Some(&(_, value)) = queue.front() {
            *low = low.max(value + slope * j as f64 - base);
        }
    }
}

/// Raises `lowest[j]` to `surface[j + away] − base`.
fn raise_by_one(lowest: &mut [f64], surface: &[f64], away: isize, base: f64) {
    let ahead = usize::try_from(away).unwrap_or(0);
    let behind = usize::try_from(-away).unwrap_or(0);
    for (low, value) in lowest.iter_mut().skip(behind).zip(surface.iter().skip(ahead)) {
        let value = value - base;
        if value > *low {
            *low = value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pointed_tool_leaves_its_flank_beside_a_wall() {
        let tool = Contour::polygon(&[Point::new(0.0, 0.0), Point::new(4.0, 4.0), Point::new(0.0, 4.0)]);
        let mut surface = vec![0.0; 100];
        surface[60..].fill(3.0);
        let underside = Underside::of(&tool);
        let left = underside.left_by(&underside.lowest_positions(&surface, 0.1), 0.1);
        assert!(left[20].abs() < 1e-9 && (left[80] - 3.0).abs() < 1e-9);
        // One millimetre before the wall the 45° flank stands two millimetres above the ground.
        assert!((left[50] - 2.0).abs() < 0.11, "{}", left[50]);
    }
}
